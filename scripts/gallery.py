#!/usr/bin/env python3
"""Makes the gallery: every method's picture of one scene, and a page that shows them all.

    scripts/gallery.py --tool build/release/sheer docs/gallery.md

writes the page, and beside it pictures/gallery/METHOD.png. What stands in it is the same on every
machine; times are not in it for that reason.
"""

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SCENE = "builtin:motor"
SAMPLES = 8
COLUMNS = 4
KILOBYTE = 1024
MOST_BYTES = 2 * 1024 * KILOBYTE  # of all pictures: whoever clones the project gets them

HEAD = """\
# Gallery

`{scene}` by every method with its usual parameters, {samples} samples a pixel, {size} pixels; of random methods
one seed. Made by `./dev gallery`, which is

    {command}

and this page of what it wrote. Below each picture: *rmse same S*, the root mean square error against the exact
picture at the same samples, in linear colour times 255; and *flip*, what someone sees who flips between the picture
and the truth, from 0 to 1. `sheer compare --help` says more of both.

The motor's surfaces have an opacity of 0.3 and lie dozens deep over one another; none is opaque. That is not what
each method is for: those that discard whole fragments (`alpha-test` and its kin) are for leaves and fences, and
`alpha-test` shows nothing of what is below its cutoff of 0.5.
"""


def run(words):
    done = subprocess.run(words, stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"gallery: '{' '.join(map(str, words))}' ended with {done.returncode}")
    return done.stdout


def cell(path, title, lines):
    return f"![{title}]({path})<br>" + "<br>".join(lines)


def table(cells):
    rows = [cells[i:i + COLUMNS] for i in range(0, len(cells), COLUMNS)]
    rows[-1] += [""] * (COLUMNS - len(rows[-1]))
    head = ["| " + " | ".join([""] * COLUMNS) + " |", "|" + " --- |" * COLUMNS]
    return "\n".join(head + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def make(tool, page, size):
    titles = {m["id"]: m["title"] for m in json.loads(run([tool, "methods", "--json"]))["methods"]}
    pictures = page.parent / "pictures" / "gallery"
    pictures.mkdir(parents=True, exist_ok=True)
    arguments = ["compare", SCENE, "--methods", "all", "--size", size, "--samples", str(SAMPLES),
                 "--seeds", "1", "-o"]
    with tempfile.TemporaryDirectory() as folder:
        run([tool, *arguments, folder])
        metrics = json.loads((Path(folder) / "metrics.json").read_text())
        shutil.copy(Path(folder) / "truth.png", pictures / "truth.png")
        cells = [cell("pictures/gallery/truth.png", "the truth",
                      ["**the truth**", f"exact, {metrics['truth']['samples']} samples"])]
        for row in metrics["results"]:
            name = row["method"]
            shutil.copy((Path(folder) / row["image"]).with_suffix(".png"), pictures / f"{name}.png")
            cells.append(cell(f"pictures/gallery/{name}.png", titles[name],
                              [f"**{name}**", titles[name],
                               f"rmse same S {row['rmse_same_s']:.1f}, flip {row['flip']:.3f}"]))
    head = HEAD.format(scene=SCENE, samples=SAMPLES, size=size,
                       command=f"sheer {' '.join(arguments)} out")
    page.write_text(head + "\n" + table(cells))
    return sum(path.stat().st_size for path in pictures.glob("*.png")), len(cells)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--tool", type=Path, required=True, help="the built tool")
    parser.add_argument("--size", default="192x192", help="of a picture (192x192)")
    parser.add_argument("page", type=Path, help="the page to write")
    given = parser.parse_args()
    size, count = make(given.tool.resolve(), given.page, given.size)
    print(f"{given.page}: {count} pictures, {size // KILOBYTE} KiB")
    if size > MOST_BYTES:
        sys.exit("gallery: the pictures are too large to keep")


if __name__ == "__main__":
    main()
