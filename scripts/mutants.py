#!/usr/bin/env python3
"""Holds that no file can crash or hang the reader or the renderer.

    python3 -B scripts/mutants.py [N [FOLDER...]]

Runs `sheer render` over every scene below the folders, and some of its own, as it is, and then over
N mutants of those that were drawn; with no N, of none. A file may stand for a folder. The mutants
depend on the seed and on the files alone. Each run is a process of its own, and must end in one of
two ways:

    accepted   exit code 0, a whole picture, and nothing on standard error
    refused    exit code 1 or 2, one line on standard error, and no file left behind

Anything else is a fault, and so is more time or memory than the limits: the file is kept, and the
command that shows the fault printed. Exit code 1 where there is one.
"""

import argparse
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from itertools import islice
from pathlib import Path
from urllib.parse import quote

from mutant_sources import write_sources
from mutations import CHANGES, mutate

SCENES = (".glb", ".gltf", ".obj", ".ply", ".stl", ".tfx")
COMPANIONS = (".bin", ".mtl", ".png", ".jpg", ".jpeg")
OPTIONS = "--size 64x64 --samples 4 --threads 1 --memory-limit 2048".split()
GIBIBYTES = 4  # of address space, or resident where a sanitizer has most of the address space
BY_THE_CLOCK = 6  # times the processor's time: other programs want it, too
REPORTED = 99  # a sanitizer's exit code


class Case:
    """A scene in a folder of its own, as the tool gets it."""

    def __init__(self, name, scene, files, changed):
        self.name = name
        self.scene = scene  # path within the folder
        self.files = files  # of these: what is in them, or the file they are a copy of
        self.changed = changed  # suffix of the file that was changed

    def write(self, folder):
        for path, content in self.files.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            if isinstance(content, bytes):
                (folder / path).write_bytes(content)
            else:
                shutil.copyfile(content, folder / path)


# ---- scenes and mutants -----------------------------------------------------------------------


def scenes_in(place):
    """A file is one whatever its name is."""
    if place.is_file():
        return [place.resolve()]
    paths = (p for p in place.rglob("*") if p.suffix.lower() in SCENES and p.is_file())
    return sorted(p.resolve() for p in paths)


def companions(scene):
    """What stands beside or below the scene and is named in it, or in a material file that is."""
    if scene.suffix.lower() not in (".gltf", ".obj"):
        return []
    beside = [p for p in scene.parent.rglob("*") if p.suffix.lower() in COMPANIONS and p.is_file()]
    text, found = scene.read_bytes(), []
    for path in sorted(beside, key=lambda p: (p.suffix.lower() != ".mtl", str(p))):
        name = path.relative_to(scene.parent).as_posix()
        if name.encode() in text or quote(name).encode() in text:
            found.append(path)
            text += path.read_bytes() if path.suffix.lower() == ".mtl" else b""
    return found


def case_of(number, scene):
    files = {p.relative_to(scene.parent): p for p in [scene, *companions(scene)]}
    return Case(f"scene-{number}", Path(scene.name), files, scene.suffix.lower())


def mutant(number, seed, originals):
    """One of the formats in turn; of a few files of that format the smallest, which is the quickest
    to draw and has the least in which no change matters."""
    dice = random.Random(f"{seed} {number}")
    formats = sorted(originals)
    some = dice.choices(originals[formats[number % len(formats)]], k=3)
    case, path = min(some, key=lambda original: original[2])[:2]
    content = case.files[path].read_bytes()
    changed = mutate(path.suffix.lower(), content, dice)
    return Case(f"mutant-{number}", case.scene, {**case.files, path: changed}, path.suffix.lower())


def originals_by_format(cases):
    """Of each suffix: the case, the path in it, and how much there is to read."""
    originals = {}
    for case in cases:
        size = sum(p.stat().st_size for p in case.files.values())
        for path in case.files:
            originals.setdefault(path.suffix.lower(), []).append((case, path, size))
    return {suffix: found for suffix, found in originals.items() if suffix in CHANGES}


# ---- one run ----------------------------------------------------------------------------------


def limited(command, settings):
    """The command, in a shell's limits: none of them is set in this process."""
    limits = f"ulimit -c 0; ulimit -S -t {settings.seconds}; ulimit -H -t {settings.seconds + 2}; "
    if not settings.sanitized:
        limits += f"ulimit -v {GIBIBYTES << 20}; "
    return ["sh", "-c", limits + 'exec "$@"', "sh", *command]


def environment():
    own = f"exitcode={REPORTED}:print_stacktrace=1:halt_on_error=1"
    return {
        **os.environ,
        "ASAN_OPTIONS": f"{own}:hard_rss_limit_mb={GIBIBYTES << 10}",
        "UBSAN_OPTIONS": own,
    }


def picture_is_whole(path):
    content = path.read_bytes() if path.is_file() else b""
    return content.startswith(b"\x89PNG\r\n\x1a\n") and content[-8:-4] == b"IEND"


def judge(code, message, folder):
    """'accepted', 'refused', or what is wrong."""
    lines = message.decode("utf-8", "replace").splitlines()
    left = sorted(p.name for p in folder.iterdir())
    if code == -signal.SIGXCPU:
        return "took too much of the processor's time"
    if code < 0:
        return f"ended by signal {-code} ({signal.Signals(-code).name}): {' '.join(lines)[:200]}"
    if code == 0 and not message and left == ["picture.png"]:
        whole = picture_is_whole(folder / "picture.png")
        return "accepted" if whole else "the picture is not whole"
    if code in (1, 2) and len(lines) == 1 and lines[0].startswith("sheer: ") and not left:
        return "refused" if lines[0].isprintable() else "the message has unprintable letters"
    said = next((line for line in lines if "rror" in line), " ".join(lines[:1]))[:200]
    return f"exit code {code}, {len(lines)} lines on standard error, files {left}: {said}"


def options_of(case):
    """Animations are played where a file may have some."""
    playing = ["--time", "0.5"] if case.scene.suffix.lower() in (".gltf", ".glb") else []
    return [*OPTIONS, *playing]


def run(case, settings, work):
    """'accepted', 'refused', or what is wrong; the fault's files are kept then."""
    folder = work / case.name
    scene, output = folder / "in" / case.scene, folder / "out"
    output.mkdir(parents=True)
    case.write(folder / "in")
    command = [settings.tool, "render", scene, "-o", output / "picture.png", *options_of(case)]
    try:
        done = subprocess.run(
            limited(command, settings), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE, timeout=BY_THE_CLOCK * settings.seconds, env=environment())
        outcome = judge(done.returncode, done.stderr, output)
    except subprocess.TimeoutExpired:
        outcome = "does not end"
    if outcome not in ("accepted", "refused"):
        kept = settings.keep / case.name
        shutil.rmtree(kept, ignore_errors=True)
        shutil.copytree(folder / "in", kept)
        show = [settings.tool, "render", kept / case.scene, "-o", "picture.png", *options_of(case)]
        outcome = f"{case.name}: {outcome}\n    " + " ".join(f"'{word}'" for word in show)
    shutil.rmtree(folder)
    return outcome


# ---- all runs ---------------------------------------------------------------------------------


class Progress:
    """A line that changes on a terminal; elsewhere ten lines in all."""

    def __init__(self, what, total):
        self.what, self.total, self.done = what, total, 0

    def step(self):
        self.done += 1
        text = f"{self.what}: {self.done} of {self.total}"
        if sys.stdout.isatty():
            print(f"\r{text}", end="" if self.done < self.total else "\n", flush=True)
        elif self.done * 10 // self.total > (self.done - 1) * 10 // self.total:
            print(text, flush=True)


def run_all(what, cases, total, settings, work):
    """(case, outcome) of each. Cases are made as they are wanted, not all at once."""
    outcomes, progress, waiting = [], Progress(what, total), iter(cases)

    def work_off(pool):
        batch = list(islice(waiting, 50 * settings.jobs))
        for case, outcome in zip(batch, pool.map(lambda c: run(c, settings, work), batch)):
            if outcome not in ("accepted", "refused"):
                print(f"\nFAULT {outcome}", flush=True)
            case.files = case.files if what == "scenes" else {}
            outcomes.append((case, outcome))
            progress.step()
        return batch

    with ThreadPoolExecutor(settings.jobs) as pool:
        while work_off(pool):
            pass
    return outcomes


def print_table(what, outcomes):
    print(f"\n{what:<10}{'files':>8}{'accepted':>10}{'refused':>9}{'faults':>8}")
    for suffix in sorted({case.changed for case, _ in outcomes}) + ["all"]:
        row = [o for case, o in outcomes if suffix in (case.changed, "all")]
        accepted, refused = row.count("accepted"), row.count("refused")
        faults = len(row) - accepted - refused
        print(f"{suffix.lstrip('.'):<10}{len(row):>8}{accepted:>10}{refused:>9}{faults:>8}")
    print(flush=True)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("count", type=int, nargs="?", default=0, metavar="N")
    parser.add_argument("places", type=Path, nargs="*", metavar="FOLDER")
    parser.add_argument("--tool", type=Path, default=Path("build/release/sheer"))
    parser.add_argument("--sanitized", action="store_true", help="the tool has sanitizers")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=int, default=10, help="of a processor, for each file")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--largest", type=float, default=4, help="mebibytes a file")
    parser.add_argument("--keep", type=Path, default=Path("out/mutants"), help="for faulty files")
    return parser.parse_intermixed_args()


def main():
    settings = parse_arguments()
    settings.tool = settings.tool.absolute()
    if not os.access(settings.tool, os.X_OK):
        sys.exit(f"mutants.py: {settings.tool} can't be run")
    with tempfile.TemporaryDirectory(prefix="sheer-mutants-") as folder:
        own, work = Path(folder).resolve() / "own", Path(folder).resolve() / "work"
        own.mkdir()
        work.mkdir()
        write_sources(own)
        found = [scene for place in (own, *settings.places) for scene in scenes_in(place)]
        cases = [case_of(i, scene) for i, scene in enumerate(found)
                 if scene.stat().st_size <= settings.largest * 2**20]
        if len(cases) < len(found):
            print(f"passed over for their size: {len(found) - len(cases)}")
        scenes = run_all("scenes", cases, len(cases), settings, work)
        print_table("as it is", scenes)
        for case, outcome in scenes:
            if outcome == "refused" and case.files[case.scene].parent == own:
                sys.exit(f"mutants.py: {case.scene} should be drawn, but is refused")
        good = originals_by_format(case for case, outcome in scenes if outcome == "accepted")
        mutants = []
        if settings.count > 0 and good:
            made = (mutant(i, settings.seed, good) for i in range(settings.count))
            mutants = run_all("mutants", made, settings.count, settings, work)
            print_table("changed", mutants)
    faults = sum(o not in ("accepted", "refused") for _, o in scenes + mutants)
    if faults > 0:
        print(f"{faults} faults; their files are in {settings.keep}")
    return 1 if faults > 0 else 0


if __name__ == "__main__":
    sys.exit(main())
