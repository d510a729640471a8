#!/usr/bin/env python3
"""Checks that the folders under src/ include one another in one direction only.

The folders stand in the order in which data flows; a file includes nothing from a folder that comes
later. include/ and shaders/ are open to all. The reference, which everything else is measured
against, shares only the scene, the decoded images, the geometry and the sample positions.

Prints one line for each violation; exit code 1 when there is one.
"""

import re
import sys
from pathlib import Path

ORDER = [
    "support", "lanes", "image", "scene", "geometry", "raster", "shade", "methods",
    "cpu", "vulkan", "reference", "compare", "api", "cli",
]
REFERENCE_MAY = re.compile(r"(reference|geometry|scene|image)/|raster/sample_pattern\.h$")

# What a library must not show its users.
PUBLIC_MAY = re.compile(r"sheer/")

INCLUDE = re.compile(r'\s*#\s*include\s+(?:"([^"]+)"|<([^>]+)>)')
SUFFIXES = {".cpp", ".h"}


def includes(path):
    """Yields (line number, name, whether it stands in quotes)."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        found = INCLUDE.match(line)
        if found:
            yield number, found[1] or found[2], found[1] is not None


def fault_in_src(folder, name, quoted):
    """What is wrong with a file of src/folder including `name`, or None."""
    if not quoted or name.endswith(".glsl"):
        return None
    target = name.split("/")[0]
    if "/" not in name or target not in ORDER:
        return f'"{name}" is to be named from src/, as in "support/math.h"'
    if ORDER.index(target) > ORDER.index(folder):
        return f'{folder} includes "{name}", but {target} comes later in the order of the folders'
    if folder == "reference" and not REFERENCE_MAY.match(name):
        return f'the reference includes "{name}"; it must share nothing with what it judges'
    return None


def fault_in_public(name, quoted):
    if quoted or name.split("/")[0] in ORDER:
        return f"{name}: public headers include the standard library and <sheer/...> only"
    if "/" in name and not PUBLIC_MAY.match(name):
        return f"{name}: a public header must not ask for another library"
    return None


def faults(root):
    for path in sorted((root / "src").rglob("*")):
        if path.suffix not in SUFFIXES:
            continue
        place = path.relative_to(root)
        folder = place.parts[1]
        if folder not in ORDER or len(place.parts) < 3:
            yield f"{place}:1: is in none of the folders {', '.join(ORDER)}"
            continue
        for number, name, quoted in includes(path):
            fault = fault_in_src(folder, name, quoted)
            if fault:
                yield f"{place}:{number}: {fault}"
    for path in sorted((root / "include").rglob("*.h")):
        for number, name, quoted in includes(path):
            fault = fault_in_public(name, quoted)
            if fault:
                yield f"{path.relative_to(root)}:{number}: {fault}"


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent)
    found = list(faults(root))
    for fault in found:
        print(fault)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
