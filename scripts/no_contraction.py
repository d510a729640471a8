#!/usr/bin/env python3
"""no_contraction.py IN.spvasm OUT.spvasm: forbids a driver to rearrange floating-point arithmetic.

Drivers may fuse, reassociate and distribute what is not decorated with NoContraction; then a shader
gives other bits than the same text in C++. GLSL's `precise` reaches only what glslang traces back
from a marked variable, so the disassembly is decorated here: every result of floating-point
arithmetic. Extended instructions (sqrt, floor) are no arithmetic to SPIR-V and can't be decorated.
"""

import re
import sys
from pathlib import Path

# The arithmetic instructions of the SPIR-V specification whose results are floating-point.
ARITHMETIC = (
    "OpFNegate OpFAdd OpFSub OpFMul OpFDiv OpFRem OpFMod OpDot OpOuterProduct OpVectorTimesScalar "
    "OpMatrixTimesScalar OpVectorTimesMatrix OpMatrixTimesVector OpMatrixTimesMatrix"
).split()
RESULT = re.compile(r"\s*(%\w+)\s*=\s*(Op\w+)")
DECORATED = re.compile(r"\s*OpDecorate\s+(%\w+)\s+NoContraction\b")
# Annotations stand after the debug names and before the types.
ANNOTATIONS_OR_TYPES = re.compile(r"\s*(OpDecorat|OpMemberDecorate|OpGroup|%\w+\s*=\s*OpType)")


def decorated(lines):
    """The lines, with the decorations that they lack."""
    done = {found[1] for line in lines if (found := DECORATED.match(line))}
    results = [found.groups() for line in lines if (found := RESULT.match(line))]
    added = [
        f"OpDecorate {name} NoContraction"
        for name, operation in results
        if operation in ARITHMETIC and name not in done
    ]
    place = next(i for i, line in enumerate(lines) if ANNOTATIONS_OR_TYPES.match(line))
    return lines[:place] + added + lines[place:]


def main():
    if len(sys.argv) != 3:
        sys.exit("no_contraction.py: needs IN.spvasm and OUT.spvasm")
    source, target = map(Path, sys.argv[1:])
    lines = source.read_text(encoding="utf-8").splitlines()
    target.write_text("\n".join(decorated(lines)) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
