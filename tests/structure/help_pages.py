#!/usr/bin/env python3
"""Checks that a program and each of its commands has a man page in which no word is lost of what it says with --help.

Usage: help_pages.py PROGRAM MAN_PAGES
"""

import gzip
import pathlib
import re
import subprocess
import sys

# Headings, which pages have otherwise.
HEADINGS = {"usage", "options", "positionals", "subcommands", "arguments", "option", "group"}


def words(text):
    """The words of a text, without the punctuation around them and with small letters in front."""
    found = (word.strip(".,;:()[]\"'") for word in re.split(r"[\s,]+", text))
    return {word[:1].lower() + word[1:] for word in found if word}


def shown(page):
    """A page as it is read: without requests, changes of the font and escapes, and with the commands that pages are named after."""
    text = re.sub(r"^\.(?:\\\".*|\S+)|\\f[BIR]|\\&", "", page, flags=re.MULTILINE).replace("\\-", "-").replace("\\e", "\\")
    return text + re.sub(r"-(\w+)\(1\)", r" \1", text)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, folder = sys.argv[1:]
    problems = []
    commands = [""]
    for command in commands:
        said = subprocess.run([program, *command.split(), "--help"], check=True, capture_output=True, text=True).stdout
        listed = re.search(r"Subcommands:\n((?: .*\n)+)", said)
        commands += re.findall(r"^  (\w\S*)", listed[1], re.MULTILINE) if listed else []
        page = "-".join([pathlib.Path(program).name, *command.split()])
        text = shown(gzip.decompress((pathlib.Path(folder) / f"{page}.1.gz").read_bytes()).decode())
        problems += [f'{page}(1) lacks "{word}"' for word in words(said) - words(text) - words(program) - HEADINGS]
    if problems:
        sys.exit("\n".join(sorted(problems)))


if __name__ == "__main__":
    main()
