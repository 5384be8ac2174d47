#!/usr/bin/env python3
"""Can people see which cell of a patch is bad, from the picture alone?

blind_test.py make DIR [--count N] [--seed N]
    Simulates N sessions (default 40), of which half have a bad cell or link of five kinds, and takes a picture of each
    as the window of 1280x800 draws it when the file is opened: the 3D view alone, without the words beside it. DIR gets
    a folder of pictures for each theme (DIR/light/07.png), and DIR/key.csv with what is bad. The programs are those of
    the preset release.
blind_test.py score DIR/key.csv ANSWERS.csv...
    Counts right answers. ANSWERS.csv has a line for each picture: its number, and the cell that the viewer takes for
    bad, or "none". Where a link is bad, either of its cells is right.
"""

import argparse
import csv
import json
import os
import random
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CLI = ROOT / "build/release/app/cli/hexoderm-cli"
PICTURES = ROOT / "build/release/tests/screenshots/hexoderm-screenshots"

PATCHES = [
    ("x17", "cylinder:r=0.05", 17),
    ("x17", "plane", 17),
    ("sheet:4x5", "cylinder:r=0.08", 20),
    ("sheet:5x6", "plane", 30),
    ("sheet:4x6", "sphere:r=0.12", 24),
    ("ring10", "cylinder:r=0.06", 10),
]
CHAINS = [patch for patch in PATCHES if patch[0] == "x17"]
OF_CELLS = ("dead", "noisy", "wrong-gain")
OF_LINKS = ("wrong-port", "joint")
KINDS = OF_CELLS + OF_LINKS


def simulate(path, patch, surface, poses, seed, faults):
    command = [CLI, "simulate", "--patch", patch, "--surface", surface, "--poses", str(poses), "--seed", str(seed)]
    for fault in faults:
        command += ["--fault", fault]
    return subprocess.run(command + ["-o", path, "--quiet"], capture_output=True, text=True, check=False)


def make_session(path, kind, chance):
    """Writes a session with a fault of this kind, or none; gives the cells that are right answers."""
    while True:
        # In a sheet a joint is a whole row of links that moves.
        patch, surface, cells = chance.choice(CHAINS if kind == "joint" else PATCHES)
        poses, seed = chance.randint(4, 8), chance.randint(1, 10**6)
        whole = simulate(path, patch, surface, poses, seed, [])
        if whole.returncode != 0:
            sys.exit(whole.stderr)
        if not kind:
            return ["none"]
        cell = chance.randint(1, cells)
        right, fault = [cell], f"{kind}:{cell}"
        if kind in OF_LINKS:
            ports = json.loads(path.read_text())["cells"][cell - 1]["ports"]
            link = chance.choice(ports)
            right, fault = [cell, link["cell"]], f"{fault}:{link['port']}"
        done = simulate(path, patch, surface, poses, seed, [fault])
        if done.returncode == 0:
            return [str(cell) for cell in right]
        if kind not in OF_LINKS:
            sys.exit(done.stderr)
        # Not every link can be broken so.


def make(folder, count, seed):
    chance = random.Random(seed)
    kinds = [KINDS[k % len(KINDS)] for k in range(count // 2)] + [None] * (count - count // 2)
    chance.shuffle(kinds)
    sessions = folder / "sessions"
    sessions.mkdir(parents=True)
    with (folder / "key.csv").open("w", newline="") as file:
        key = csv.writer(file)
        key.writerow(["picture", "kind", "right"])
        for number, kind in enumerate(kinds, 1):
            right = make_session(sessions / f"{number:02}.session.json", kind, chance)
            key.writerow([f"{number:02}", kind or "none", " ".join(right)])
    script = f'source "{ROOT}/packaging/environment.sh"; on_virtual_display "$@"'
    for theme in ("light", "dark"):
        files = sorted(sessions.glob("*.session.json"))
        environment = dict(os.environ, XDG_DATA_HOME=str(folder / "home"), XDG_CONFIG_HOME=str(folder / "home"))
        subprocess.run(["bash", "-c", script, "-", PICTURES, "--theme", theme, folder, *files], check=True,
                       env=environment)


def score(key_path, answer_paths):
    with open(key_path, newline="") as file:
        key = {row["picture"]: row for row in csv.DictReader(file)}
    for path in answer_paths:
        with open(path, newline="") as file:
            answers = {row[0].strip().zfill(2): row[1].strip().lower() for row in csv.reader(file) if len(row) > 1}
        right = defaultdict(int)
        of = defaultdict(int)
        wrong = []
        for number, row in key.items():
            of[row["kind"]] += 1
            if answers.get(number) in row["right"].split():
                right[row["kind"]] += 1
            else:
                wrong.append(f"{number} ({row['kind']} {row['right']}): {answers.get(number)}")
        bad = sum(count for kind, count in of.items() if kind != "none")
        named = sum(count for kind, count in right.items() if kind != "none")
        kinds = ", ".join(f"{kind} {right[kind]}/{of[kind]}" for kind in of)
        print(f"{path}: {sum(right.values())} of {len(key)} right; of the bad {named} of {bad} named ({kinds})")
        for line in wrong:
            print(f"  {line}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    making = commands.add_parser("make")
    making.add_argument("folder", type=Path)
    making.add_argument("--count", type=int, default=40)
    making.add_argument("--seed", type=int, default=1)
    scoring = commands.add_parser("score")
    scoring.add_argument("key")
    scoring.add_argument("answers", nargs="+")
    arguments = parser.parse_args()
    if arguments.command == "make":
        make(arguments.folder, arguments.count, arguments.seed)
    else:
        score(arguments.key, arguments.answers)


if __name__ == "__main__":
    main()
