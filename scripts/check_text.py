#!/usr/bin/env python3
"""Checks what no formatter does: files stay short enough to read at a sitting, lines fit a screen,
no tabs, no blanks at the ends of lines, one line end at the end of the file.

Prints one line for each violation; exit code 1 when there is one.
"""

import sys
from pathlib import Path

MOST_LINES = 400  # CONTRIBUTING.md asks for 300; above this a file is to be split
MOST_COLUMNS = 100
FOLDERS = ["src", "include", "tests", "bench", "shaders", "examples", "web/report"]
SUFFIXES = {".cpp", ".h", ".glsl", ".comp", ".vert", ".frag", ".js", ".mjs", ".css"}


def faults_in(path):
    """Yields (line number, what is wrong)."""
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        yield 1, "is not UTF-8"
        return
    lines = text.split("\n")
    if lines[-1] != "":
        yield len(lines), "the last line has no end"
    elif len(lines) > 1 and lines[-2] == "":
        yield len(lines) - 1, "ends with an empty line"
    if len(lines) - 1 > MOST_LINES:
        yield len(lines) - 1, f"{len(lines) - 1} lines; split what is longer than {MOST_LINES}"
    for number, line in enumerate(lines, 1):
        if len(line) > MOST_COLUMNS:
            yield number, f"{len(line)} columns; {MOST_COLUMNS} fit"
        if "\t" in line:
            yield number, "a tab; use spaces"
        if line != line.rstrip():
            yield number, "blanks at the end of the line"


def faults(root):
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in SUFFIXES:
                continue
            for number, fault in faults_in(path):
                yield f"{path.relative_to(root)}:{number}: {fault}"


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent)
    found = list(faults(root))
    for fault in found:
        print(fault)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
