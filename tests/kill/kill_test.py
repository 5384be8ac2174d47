#!/usr/bin/env python3
"""Kills programs that capture, save and convert at random moments (kill -9), and looks at what they leave.

Usage: kill_test.py KILL_HELPER [--kills N] [--seed S]

After every kill: the database is whole (PRAGMA integrity_check), every capture that was confirmed is there bit for bit,
read by the library and by this program itself from the layout in core/hexoderm/session/README.md; nothing is there that was not
captured; a file that was being saved or converted is whole, the old or the new one; and what is left hidden in the folder
is of the last writer at most, and goes with the next file that is written. The number of kills is per kind.
"""

import argparse
import pathlib
import random
import shutil
import sqlite3
import struct
import subprocess
import sys
import tempfile
import time

SAMPLE = struct.Struct("<IIII3d6dd")  # cell, count, flags, nothing, mean, covariance (upper triangle), temperature


def fail(text):
    print(text)
    sys.exit(1)


def run_and_kill(helper, arguments, rng, first_line=None):
    """Starts the helper, lets it work for a random time, kills it; returns the lines that it said whole."""
    process = subprocess.Popen([helper, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    kill_while_starting = rng.random() < 0.2
    said = b""
    if first_line and not kill_while_starting:
        said = process.stdout.readline()
        if not said.startswith(first_line.encode()):
            fail(f"expected '{first_line}', the helper said: {said.decode()}")
    time.sleep(rng.uniform(0, 0.08))
    if process.poll() is not None:
        fail(f"the helper ended by itself: {(said + process.stdout.read()).decode()}")
    process.kill()
    said += process.stdout.read()
    process.wait()
    return said.decode().rpartition("\n")[0].splitlines()


def check(helper, path):
    """Number of poses that the library reads."""
    result = subprocess.run([helper, "check", str(path)], capture_output=True, text=True)
    if result.returncode != 0:
        fail(f"{path}: {result.stdout}{result.stderr}")
    return int(result.stdout.split()[1])


def hidden_in(folder):
    """What writers left, a database with what SQLite keeps beside it counted once."""
    return {path.name.removesuffix("-wal").removesuffix("-shm").removesuffix("-journal") for path in folder.glob(".*")}


def check_hidden(folder, kill):
    if len(hidden_in(folder)) > 1:
        fail(f"after kill {kill}, more is left than one writer makes: {sorted(hidden_in(folder))}")


def check_nothing_stays(helper, folder):
    subprocess.run([helper, "write", str(folder)], check=True)
    if hidden_in(folder):
        fail(f"what killed writers left is still there: {sorted(hidden_in(folder))}")


def bits(value):
    return struct.pack("<d", value)


def captures_in(path):
    """Pose number -> list of numbers as bytes, read without the library."""
    database = sqlite3.connect(path)
    try:
        whole = database.execute("PRAGMA integrity_check").fetchall()
        if whole != [("ok",)]:
            fail(f"{path}: integrity_check: {whole}")
        captures = {}
        rows = database.execute("SELECT json_extract(detail, '$.pose'), samples FROM journal WHERE kind = 'capture'")
        for pose, samples in rows:
            numbers = []
            for cell, count, flags, _, *values in SAMPLE.iter_unpack(samples):
                if count != 100 or flags != 1:
                    fail(f"{path}: pose {pose}, cell {cell}: count {count}, flags {flags}")
                numbers += [bits(v) for v in values[:4]] + [bits(values[9])]
            if pose in captures:
                fail(f"{path}: pose {pose} is there twice")
            captures[pose] = numbers
        return captures
    finally:
        database.close()


def kill_while_capturing(helper, folder, kills, rng):
    path = folder / "captured.hexo"
    confirmed = {}
    total = 0
    for _ in range(kills):
        for line in run_and_kill(helper, ["capture", str(path)], rng, "opened"):
            word, _, rest = line.partition(" ")
            if word == "captured":
                pose, *numbers = rest.split()
                total += 1
                confirmed[int(pose)] = [bits(float.fromhex(number)) for number in numbers]
            elif word != "opened":
                fail(f"the helper said: {line}")
        if not path.exists():
            if confirmed:
                fail("the file is gone")
            continue
        count = check(helper, path)  # before anybody repairs anything
        found = captures_in(path)
        if count != len(found):
            fail(f"the library reads {count} poses, there are {len(found)}")
        for pose, numbers in confirmed.items():
            if found.get(pose) != numbers:
                fail(f"pose {pose} was confirmed and is " + ("changed" if pose in found else "missing"))
        if sorted(found) != list(range(1, len(found) + 1)):
            fail(f"poses have gaps: {sorted(found)}")
        if len(found) > len(confirmed) + 2 * kills:
            fail("more poses than were captured")
        if len(found) > 2000:  # so that a long run does not become slower and slower
            for suffix in ("", "-wal", "-shm"):
                pathlib.Path(str(path) + suffix).unlink(missing_ok=True)
            confirmed.clear()
    return f"{kills} kills while capturing, {total} confirmed captures, all there"


def kill_while_saving(helper, folder, kills, rng):
    path = folder / "saved.session.json"
    seen = {3: 0, 40: 0}
    left = 0
    for kill in range(kills):
        run_and_kill(helper, ["save", str(folder)], rng, "saved")
        if path.exists():
            poses = check(helper, path)
            if poses not in seen:
                fail(f"{path}: {poses} poses, expected those of the old or of the new file")
            seen[poses] += 1
        check_hidden(folder, kill)
        left += len(hidden_in(folder))
    check_nothing_stays(helper, folder)
    return f"{kills} kills while saving, something hidden left {left} times, whole file of 3 poses {seen[3]} times, of 40 poses {seen[40]} times"


def kill_while_converting(helper, folder, kills, rng):
    whole = 0
    left = 0
    for kill in range(kills):
        for line in run_and_kill(helper, ["convert", str(folder)], rng, "converted"):
            path = pathlib.Path(line.partition(" ")[2])
            if not path.exists():
                fail(f"{path} was confirmed and is missing")
        for path in [*folder.glob("*.hexo"), *folder.glob("back.session.json")]:
            if check(helper, path) != 20:
                fail(f"{path} is not whole")
            whole += 1
            if path.suffix == ".hexo":
                if len(captures_in(path)) != 20:
                    fail(f"{path} is not whole")
                path.unlink()
        check_hidden(folder, kill)
        left += len(hidden_in(folder))
    check_nothing_stays(helper, folder)
    return f"{kills} kills while converting, something hidden left {left} times, {whole} files looked at, all whole"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("helper", help="the program kill_helper")
    parser.add_argument("--kills", type=int, default=20, help="of each kind (default: 20)")
    parser.add_argument("--seed", type=int, default=None, help="of the moments (default: another each time)")
    arguments = parser.parse_args()
    seed = arguments.seed if arguments.seed is not None else random.randrange(2**32)
    print(f"--kills {arguments.kills} --seed {seed}", flush=True)
    rng = random.Random(seed)
    for test in (kill_while_capturing, kill_while_saving, kill_while_converting):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="hexoderm-kill-"))
        print(test(arguments.helper, folder, arguments.kills, rng), flush=True)
        shutil.rmtree(folder)  # the folder of a failed run is kept for inspection


if __name__ == "__main__":
    main()
