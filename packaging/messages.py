#!/usr/bin/env python3
"""Prints the templates of all messages in the given folders as C++ that Qt's lupdate understands.

lupdate finds texts by the names of Qt's functions and takes their context from the class around them; core has neither.
A message is recognised by its call, message("template", ...), whose first argument is a literal.
Usage: messages.py FOLDER...
"""

import pathlib
import re
import sys

CONTEXT = "hexoderm::Message"
LITERAL = r'"(?:[^"\\\n]|\\.)*"'
CALL = re.compile(rf"\bmessage\(\s*({LITERAL}(?:\s*{LITERAL})*)")


def templates(folders):
    """Every template once, in the order of the sources."""
    found = {}
    for folder in folders:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            lines = path.read_text(encoding="utf-8").split("\n")
            code = "\n".join(line for line in lines if not line.lstrip().startswith("//"))
            for call in CALL.finditer(code):
                literals = re.findall(LITERAL, call.group(1))
                found.setdefault("".join(literal[1:-1] for literal in literals))
    return found


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    for template in templates(sys.argv[1:]):
        print(f'QT_TRANSLATE_NOOP("{CONTEXT}", "{template}")')
