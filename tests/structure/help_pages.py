#!/usr/bin/env python3
"""Checks that no word of what a program says with --help is lost in its man pages, and that its completion knows them.

Usage: help_pages.py PROGRAM MAN_PAGES COMPLETION
"""

import gzip
import pathlib
import re
import subprocess
import sys

# Headings, which pages have otherwise.
HEADINGS = {"Usage", "Options", "Positionals", "Subcommands", "Arguments", "Option", "Group"}


def helped(program, *command):
    return subprocess.run([program, *command, "--help"], check=True, capture_output=True, text=True).stdout


def words(text):
    """The words of a text, without the punctuation around them and with small letters in front."""
    found = (word.strip(".,;:()[]\"'") for word in re.split(r"[\s,]+", text))
    return {word[:1].lower() + word[1:] for word in found if word}


def shown(page):
    """A page as it is read: without requests, changes of the font and escapes."""
    lines = [re.sub(r"^\.(?:SH|SS) ", "", line) for line in page.splitlines() if not line.startswith('.\\"')]
    text = "\n".join(line for line in lines if not re.match(r"\.[A-Za-z]", line))
    return re.sub(r"\\f[BIR]", "", text).replace("\\-", "-").replace("\\&", "").replace("\\e", "\\")


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    program, folder, completion = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    name = pathlib.Path(program).name
    listed = re.search(r"Subcommands:\n((?: .*\n)+)", helped(program))
    commands = re.findall(r"^  (\w\S*)", listed[1], re.MULTILINE) if listed else []
    pages = {(): name} | {(command,): f"{name}-{command}" for command in commands}
    script = completion.read_text(encoding="utf-8")

    problems = []
    for command, page in pages.items():
        said = helped(program, *command)
        text = shown(gzip.decompress((folder / f"{page}.1.gz").read_bytes()).decode())
        text += " ".join(re.findall(rf"{name}-(\w+)\(1\)", text))  # commands, as the names of their pages
        ignored = {word.lower() for word in HEADINGS} | words(program)
        problems += [f"{page}(1) lacks \"{word}\"" for word in sorted(words(said) - words(text) - ignored)]
        branch = re.search(rf'^    {command[0] if command else chr(34) * 2}\)\n      options="(.*)"', script, re.MULTILINE)
        offered = set(branch[1].split()) if branch else set()
        options = set(re.findall(r"^ +(?:-\w, ?)?(--[a-z][\w-]*)", said, re.MULTILINE))
        problems += [f"the completion of {' '.join((name, *command))} lacks {option}" for option in sorted(options - offered)]
        if not options:
            problems.append(f"{page}: the help has no options")
    if problems:
        sys.exit("\n".join(problems))


if __name__ == "__main__":
    main()
