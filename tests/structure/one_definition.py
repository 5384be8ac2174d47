#!/usr/bin/env python3
"""Checks that no two headers define a class of the same name in the same namespace.

A program that links both would call the functions of one on objects of the other, and no tool says so.

Usage: one_definition.py ROOT   fails, naming both headers, for each such class
"""

import pathlib
import re
import sys

NAMESPACE = re.compile(r"^(?:inline )?namespace ([\w:]+) \{|^(\}  // namespace)")
CLASS = re.compile(r"^(?:class|struct|union|enum class) (\w+)\b(?!<|.*;$)")  # a specialisation is a class of its own


def classes(header):
    """The qualified names of the classes that a header defines outside other classes."""
    outer = []
    for line in header.read_text(encoding="utf-8").splitlines():
        if namespace := NAMESPACE.match(line):
            if namespace[1]:
                outer.append(namespace[1])
            elif outer:
                outer.pop()
        elif defined := CLASS.match(line):
            yield "::".join([*outer, defined[1]])


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1])
    where, violations = {}, []
    for folder in ("core", "widgets", "app", "tests"):
        for header in sorted((root / folder).rglob("*.h")):
            if header.stem.endswith("_text"):
                continue  # included within a namespace
            for name in classes(header):
                other = where.setdefault(name, header)
                if other != header:
                    violations.append(f"{header.relative_to(root)}: {name} is also in {other.relative_to(root)}")
    if not where:
        violations.append("no class was found")
    if violations:
        sys.exit("\n".join(violations))


if __name__ == "__main__":
    main()
