#!/usr/bin/env python3
"""Runs two programs that print lines "name figure", and fails where their figures differ.

Figures of the first program are the measure: of all that have one name, the largest is what a difference is compared
with. Returns 77 if this processor lacks one of the features, as /proc/cpuinfo names them, that the second one needs.

Usage: same_figures.py PROGRAM OTHER_PROGRAM [FEATURE...] [-- ARGUMENT_OF_BOTH...]
"""

import pathlib
import subprocess
import sys

LIMIT = 1e-9


def figures_of(program, arguments):
    """The names and figures, in their order."""
    run = subprocess.run([program, *arguments], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f"{program} ended with {run.returncode}: {run.stderr}")
    return [(name, float(figure)) for name, _, figure in (line.rpartition(" ") for line in run.stdout.splitlines())]


def main():
    end = sys.argv.index("--") if "--" in sys.argv else len(sys.argv)
    if end < 3:
        sys.exit(__doc__)
    processor = pathlib.Path("/proc/cpuinfo")
    known = set(processor.read_text(encoding="ascii", errors="replace").split()) if processor.exists() else set()
    missing = [feature for feature in sys.argv[3:end] if feature not in known]
    if missing:
        print(f"this processor has no {', '.join(missing)}")
        sys.exit(77)
    first = figures_of(sys.argv[1], sys.argv[end + 1:])
    second = figures_of(sys.argv[2], sys.argv[end + 1:])
    if not first or [name for name, _ in first] != [name for name, _ in second]:
        sys.exit(f"{len(first)} and {len(second)} figures, which are not of the same names")
    scale = {}
    for name, figure in first:
        scale[name] = max(scale.get(name, 0.0), abs(figure))
    different = [f"{name}: {a!r} and {b!r}" for (name, a), (_, b) in zip(first, second)
                 if not abs(a - b) <= LIMIT * max(scale[name], LIMIT)]
    if different:
        sys.exit("\n".join([f"{len(different)} of {len(first)} figures differ", *different[:20]]))
    print(f"{len(first)} figures agree")


if __name__ == "__main__":
    main()
