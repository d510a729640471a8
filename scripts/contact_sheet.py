#!/usr/bin/env python3
"""Draws every scene file below a folder and puts the pictures, with their names, on one sheet.

A picture of the expected result that lies beside a file, as glTF's Asset Generator has them, comes
right after the file's own. Prints a line for each file: what was drawn of it, or why it is refused.
Exit code 1 when the tool crashed, hung, or ended with an exit code that it does not have.
"""

import argparse
import json
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

SUFFIXES = {".gltf", ".glb", ".obj", ".ply", ".stl", ".tfx"}
EXIT_CODES = {0, 1, 2}  # done, the work failed, the input is wrong

COLUMNS = 8
WIDTH, HEIGHT = 192, 144  # of a picture
GAP = 4
PAPER, INK, REFUSED = (255, 255, 255), (0, 0, 0), (224, 208, 208)

# Letters of 3 x 5 dots: for each row from the top an octal digit, whose highest bit is at the left.
FONT = {
    "A": "25755", "B": "65656", "C": "34443", "D": "65556", "E": "74647", "F": "74644",
    "G": "34553", "H": "55755", "I": "72227", "J": "11152", "K": "55655", "L": "44447",
    "M": "57755", "N": "65555", "O": "25552", "P": "65644", "Q": "25563", "R": "65655",
    "S": "34216", "T": "72222", "U": "55557", "V": "55552", "W": "55775", "X": "55255",
    "Y": "55222", "Z": "71247", "0": "75557", "1": "26227", "2": "71747", "3": "71317",
    "4": "55711", "5": "74717", "6": "74757", "7": "71122", "8": "75757", "9": "75717",
    ".": "00002", "-": "00700", "_": "00007", "/": "11244", " ": "00000",
}
DOT = 2  # pixels
LETTER_WIDTH, LINE_HEIGHT = 4 * DOT, 6 * DOT
LETTERS = WIDTH // LETTER_WIDTH  # in a line
LINES = 2


class Picture:
    """Rows of RGB bytes."""

    def __init__(self, width, height, rows=None):
        self.width, self.height = width, height
        self.rows = rows or [bytearray(bytes(PAPER) * width) for _ in range(height)]

    def put(self, other, x, y):
        for i, row in enumerate(other.rows):
            self.rows[y + i][3 * x : 3 * (x + other.width)] = row

    def smaller(self, width, height):
        """That fits: every so many pixels of every so many rows, in the same shape."""
        step = max(self.width / width, self.height / height)
        columns, rows = int(self.width / step), int(self.height / step)
        picked = [3 * int(x * step) for x in range(columns)]
        taken = [self.rows[int(y * step)] for y in range(rows)]
        fewer = [bytearray(b"".join(row[i : i + 3] for i in picked)) for row in taken]
        return Picture(columns, rows, fewer)

    def fill(self, x, y, width, height, color):
        for row in self.rows[y : y + height]:
            row[3 * x : 3 * (x + width)] = bytes(color) * width

    def write(self, text, x, y):
        for letter in text.upper():
            for row, bits in enumerate(FONT.get(letter, FONT["-"])):
                for column in range(3):
                    if int(bits) >> (2 - column) & 1:
                        self.fill(x + column * DOT, y + row * DOT, DOT, DOT, INK)
            x += LETTER_WIDTH


def unfiltered(kind, row, above, step):
    """A row of a PNG as it was before its filter (PNG specification, 9.2)."""
    if kind == 0:
        return row
    if kind == 2:
        return bytearray((a + b) & 255 for a, b in zip(row, above))
    for i, value in enumerate(row):
        left = row[i - step] if i >= step else 0
        if kind == 1:
            guess = left
        elif kind == 3:
            guess = (left + above[i]) // 2
        else:
            corner = above[i - step] if i >= step else 0
            plane = left + above[i] - corner
            nearest = ((abs(plane - v), order, v) for order, v in enumerate((left, above[i], corner)))
            guess = min(nearest)[2]
        row[i] = (value + guess) & 255
    return row


def read_png(path):
    """The picture in an 8-bit RGB or RGBA PNG that is not interlaced: what the tool writes."""
    data = path.read_bytes()
    offset, packed = 8, b""
    while offset < len(data):
        length, kind = struct.unpack_from(">I4s", data, offset)
        content = data[offset + 8 : offset + 8 + length]
        offset += length + 12
        if kind == b"IHDR":
            width, height, bits, color, _, _, interlaced = struct.unpack(">IIBBBBB", content)
            if bits != 8 or color not in (2, 6) or interlaced:
                raise ValueError(f"{path}: a PNG of another kind than the tool's")
            step = 4 if color == 6 else 3
        elif kind == b"IDAT":
            packed += content
    filtered, stride = zlib.decompress(packed), 1 + width * step
    rows, above = [], bytearray(width * step)
    for start in range(0, height * stride, stride):
        row = bytearray(filtered[start + 1 : start + stride])
        above = unfiltered(filtered[start], row, above, step)
        rows.append(above)
    if step == 4:
        for row in rows:
            del row[3::4]
    return Picture(width, height, rows)


def write_png(path, picture):
    def chunk(kind, content):
        checksum = zlib.crc32(kind + content)
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", checksum)

    header = struct.pack(">IIBBBBB", picture.width, picture.height, 8, 2, 0, 0, 0)
    rows = b"".join(b"\0" + row for row in picture.rows)
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(rows))
        + chunk(b"IEND", b"")
    )


def draw(tool, scene, png, seconds):
    """(whether the tool behaved, what it said): the picture is at `png` if it drew one."""
    size = f"{WIDTH}x{HEIGHT}"
    command = [tool, "render", scene, "-o", png, "--size", size, "--samples", "4", "--json"]
    start = time.monotonic()
    try:
        run = subprocess.run(command, capture_output=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return False, f"HUNG: nothing after {seconds:g} s"
    if run.returncode < 0:
        return False, f"CRASHED: signal {-run.returncode}"
    if run.returncode not in EXIT_CODES:
        return False, f"CRASHED: exit code {run.returncode}"
    if run.returncode > 0:
        text = run.stderr.decode(errors="replace").strip().removeprefix("sheer: ")
        return True, "refused: " + text.removeprefix(f"{scene}: ")
    stats = json.loads(run.stdout)
    took = time.monotonic() - start
    return True, f"{stats['triangles']:,} triangles, {stats['fragments']:,} fragments, {took:.1f} s"


def expected_picture(scene):
    """Where glTF's Asset Generator has it."""
    return scene.parent / "Figures" / "SampleImages" / f"{scene.stem}.png"


def label_lines(name):
    """The end of the name, which tells more than its beginning."""
    name = name[-LETTERS * LINES :]
    return [name[i : i + LETTERS] for i in range(0, len(name), LETTERS)]


def make_sheet(names, pictures):
    cell_width, cell_height = WIDTH + GAP, HEIGHT + LINES * LINE_HEIGHT + 2 * GAP
    columns = min(COLUMNS, len(names))
    row_count = -(-len(names) // columns)
    sheet = Picture(GAP + columns * cell_width, GAP + row_count * cell_height)
    for i, name in enumerate(names):
        x, y = GAP + i % columns * cell_width, GAP + i // columns * cell_height
        if name in pictures:
            sheet.put(pictures[name], x, y)
        else:
            sheet.fill(x, y, WIDTH, HEIGHT, REFUSED)
        for line, text in enumerate(label_lines(name)):
            sheet.write(text, x, y + HEIGHT + GAP + line * LINE_HEIGHT)
    return sheet


def main():
    root = Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=root / "out/sheet.png")
    parser.add_argument("--tool", type=Path, default=root / "build/release/sheer")
    parser.add_argument("--seconds", type=float, default=10, help="for a file; 10")
    given = parser.parse_args()
    tool = given.tool.resolve()  # a bare name would be looked for elsewhere
    if not tool.is_file():
        sys.exit(f"{given.tool}: there is no such tool")

    below = given.folder.rglob("*")
    files = sorted(p for p in below if p.suffix.lower() in SUFFIXES and p.is_file())
    if not files:
        sys.exit(f"{given.folder}: there is no scene file below it")
    names, pictures, drawn, misbehaved = [], {}, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        png = Path(folder) / "picture.png"
        for path in files:
            name = str(path.relative_to(given.folder))
            names.append(name)
            png.unlink(missing_ok=True)
            behaved, said = draw(tool, path, png, given.seconds)
            misbehaved += not behaved
            if png.exists():
                pictures[name] = read_png(png)
                drawn += 1
            print(f"{name}: {said}", flush=True)
            if expected_picture(path).is_file():
                names.append(f"{name} expected")
                pictures[names[-1]] = read_png(expected_picture(path)).smaller(WIDTH, HEIGHT)
    given.output.parent.mkdir(parents=True, exist_ok=True)
    write_png(given.output, make_sheet(names, pictures))
    refused = len(files) - drawn - misbehaved
    print(f"{given.output}: {drawn} drawn, {refused} refused, {misbehaved} crashed or hung")
    sys.exit(1 if misbehaved else 0)


if __name__ == "__main__":
    main()
