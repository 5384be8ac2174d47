#!/usr/bin/env python3
"""Checks that the sources that pages name, as `ROOM/NAME.h`, are there: below the page's folder or one of the roots.

Usage: named_paths.py ROOT   fails, naming page and path, for each that is not
"""

import pathlib
import re
import sys

ROOTS = ("", "core", "core/hexoderm", "widgets", "app/window")
NAMED = re.compile(r"`([\w./]+/\w+\.(?:h|cpp|inl|c|py|sh))`")
GENERATED = {"hexoderm/hexoderm.h"}


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1])
    missing = []
    for page in sorted(root.rglob("*.md")):
        relative = page.relative_to(root)
        if relative.parts[0] in ("build", "out"):
            continue
        folders = [page.parent, *(root / folder for folder in ROOTS)]
        for name in NAMED.findall(page.read_text(encoding="utf-8")):
            if name not in GENERATED and not any((folder / name).is_file() for folder in folders):
                missing.append(f"{relative} names {name}, which is not there")
    if missing:
        sys.exit("\n".join(missing))


if __name__ == "__main__":
    main()
