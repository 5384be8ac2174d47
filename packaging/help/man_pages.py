#!/usr/bin/env python3
"""Writes the man pages of a program and of each of its commands, made of what --help says, compressed.

Usage: man_pages.py PROGRAM FOLDER
"""

import gzip
import itertools
import os
import pathlib
import re
import subprocess
import sys

PROGRAMS = ("hexoderm", "hexoderm-cli", "hexoderm-emulator", "hexoderm-ros")
TITLES = {"Positionals": "ARGUMENTS", "Arguments": "ARGUMENTS", "Options": "OPTIONS", "Subcommands": "COMMANDS"}
HEADING = re.compile(r" *(%s):" % "|".join(TITLES))
END_OF_LISTS = re.compile(r"\n\n(?!\[Option Group: | *(?:%s):\n)" % "|".join(TITLES))
GROUP = re.compile(r"\[Option Group: (.*)\]")
NAME_AND_TEXT = re.compile(r" +\S.*? {2,}(?=\S)")


def said(*command):
    """What a program says in English, with a line break at the end."""
    environment = dict(os.environ, LC_ALL="C.UTF-8", LANGUAGE="en", COLUMNS="80")
    return subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout.rstrip() + "\n"


def commands_of(text):
    """The commands that a help lists."""
    listed = re.search(r"^Subcommands:\n((?: .*\n)+)", text, re.MULTILINE)
    return re.findall(r"^  (\w\S*)", listed[1], re.MULTILINE) if listed else []


def escaped(text):
    """Text as roff takes it: a hyphen is one that can be copied, and no line begins with a request."""
    return re.sub(r"^(?=[.'])", r"\\&", text.replace("\\", "\\e").replace("-", "\\-"))


def name_of(entry):
    """An option with its value, an argument or a command: what is typed as it stands in bold, the rest in italics."""
    typed, _, rest = entry.replace(", -", ",-").partition(" ")
    return rf"\fB{escaped(typed.replace(',-', ', -'))}\fR" + (rf" \fI{escaped(rest)}\fR" if rest else "")


def sections(lines, program):
    """The lists of options, arguments and commands."""
    title = ""
    column = 0  # where texts begin: one place for all of a list
    for at, line in enumerate(lines):
        heading, group = HEADING.fullmatch(line), GROUP.fullmatch(line)
        indent = len(line) - len(line.lstrip())
        if heading:
            if heading[1] != title:
                yield f".SH {TITLES[heading[1]]}"
            title = heading[1]
            column = next((match.end() for match in map(NAME_AND_TEXT.match, lines[at + 1:]) if match), 0)
        elif group:
            yield f".SS {escaped(group[1])}"
            column = 0
        elif not column:  # of a group
            yield escaped(line.strip(" []") + ".")
        elif line and indent < column:
            # A name that is too long for its column has a line of its own, or a single space after it.
            has_text = line[column - 1:column] == " " and not line[column:].startswith(("Needs:", "Excludes:"))
            name = line[:column].strip() if has_text else line.strip()
            yield ".TP"
            yield name_of(f"{program}-{name}") + "(1)" if title == "Subcommands" else name_of(name)
            if has_text:
                yield escaped(line[column:])
        elif line:
            yield (".br\n" if indent > column else "") + escaped(line.strip())


def notes(lines):
    """What is said at the end; lines that are indented are examples or tables."""
    for is_literal, part in itertools.groupby(lines, lambda line: line.startswith(" ")):
        if is_literal:
            yield from (".RS 4", ".nf", *(escaped(line[2:]) for line in part), ".fi", ".RE")
        else:
            yield from (escaped(line) + "\n.br" * line.endswith((":", ".", ";")) or ".PP" for line in part)


def page(words, text, version, others):
    """The page of a program, or of one of its commands: `words` are what is typed before --help, which says `text`."""
    head, body = text.split("\n\n", 1)
    usage = re.search(r"^Usage: (?:\S*/)?(.*)", head, re.MULTILINE)[1].removeprefix(" ".join(words))
    summary = escaped(" ".join(re.sub(r"^Usage: .*", "", head, flags=re.MULTILINE).split()).rstrip("."))
    lists, *end = END_OF_LISTS.split(body, maxsplit=1)
    title = "-".join(words)
    names = dict.fromkeys((*PROGRAMS, *others))
    lines = [f'.\\" Made of what "{" ".join(words)} --help" says.',
             f'.TH "{title.upper()}" 1 "" "{version}" "Hexoderm"', ".nh", ".ad l",
             ".SH NAME", escaped(title) + r" \- " + summary[0].lower() + summary[1:],
             ".SH SYNOPSIS", rf"\fB{escaped(' '.join(words))}\fR{escaped(usage)}",
             ".SH DESCRIPTION", summary + "." * (not summary.endswith("?")), *sections(lists.splitlines(), words[0])]
    if end:
        lines += [".SH NOTES", *notes(end[0].splitlines())]
    lines += [".SH SEE ALSO", ",\n".join(name_of(name) + "(1)" for name in names if name != title)]
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    name = os.path.basename(program)
    first = said(program, "--help")
    helps = {(name,): first} | {(name, command): said(program, command, "--help") for command in commands_of(first)}
    version = said(program, "--version").splitlines()[0]
    folder.mkdir(parents=True, exist_ok=True)
    for words, text in helps.items():
        content = page(words, text, version, map("-".join, helps)).encode()
        (folder / ("-".join(words) + ".1.gz")).write_bytes(gzip.compress(content, 9, mtime=0))


if __name__ == "__main__":
    main()
