#!/usr/bin/env python3
"""Writes the man pages of a program and of each of its commands, made of what --help says, compressed.

Usage: man_pages.py PROGRAM FOLDER
"""

import gzip
import pathlib
import re
import sys

import help_text

TITLES = {"Positionals": "ARGUMENTS", "Arguments": "ARGUMENTS", "Options": "OPTIONS", "Subcommands": "COMMANDS"}


def escaped(text):
    """Text as roff takes it: a hyphen is one that can be copied, and no line begins with a request."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"(?m)^(?=[.'])", r"\\&", text)


def bold(text):
    return f"\\fB{escaped(text)}\\fR"


def sentence(text):
    """With a capital letter in front and a full stop at the end."""
    text = text[:1].upper() + text[1:]
    return text if text.endswith((".", "?", "!")) else text + "."


def usage(words, line):
    """The line of the usage, with the program and what is typed as it stands in bold."""
    rest = line.removeprefix(" ".join(words)).strip()
    return f"{bold(' '.join(words))} {escaped(rest)}"


def name_of(entry):
    """The name of an entry, its spellings in bold and its value in italics."""
    name = entry.name
    if not name.startswith("-"):
        first, _, rest = name.partition(" ")
        return bold(first) + (f" \\fI{escaped(rest)}\\fR" if rest else "")
    spellings = entry.spellings()
    rest = name
    for spelling in spellings:
        rest = rest.replace(spelling, "", 1)
    rest = rest.strip(" ,")
    return ", ".join(bold(spelling) for spelling in spellings) + (f" \\fI{escaped(rest)}\\fR" if rest else "")


def entry_lines(entry, first):
    """An entry with its text; the name of a command leads to its page."""
    name = name_of(entry)
    if first.words[1:] == [] and entry in first.entries("Subcommands"):
        name = f"{bold(first.words[0] + '-' + entry.name)}(1)"
    head, *listed = entry.text.split("\n")
    lines = [".TP", name, escaped(head) or "\\&"]
    for line in listed:
        lines += [".br", escaped(line)]
    return lines


def footer_lines(lines):
    """What stands below the options, line by line: lines that are indented are examples or tables."""
    result = []
    literal = False
    for line in lines:
        is_literal = line.startswith(" ")
        if is_literal != literal:
            result.append(".RS 4\n.nf" if is_literal else ".fi\n.RE")
            literal = is_literal
        if not line:
            result.append(".PP")
        else:
            result.append(escaped(line.removeprefix("  ") if is_literal else line))
            if not is_literal and line.endswith((":", ".", ";")):
                result.append(".br")
    return result + ([".fi\n.RE"] if literal else [])


def page(helped, all_helps, version):
    """The page of a program, or of one of its commands."""
    title = "-".join(helped.words)
    lines = [f'.\\" Made of what "{" ".join(helped.words)} --help" says.',
             f'.TH "{title.upper()}" 1 "" "{version}" "Hexoderm"', ".nh", ".ad l",
             ".SH NAME", f"{escaped(title)} \\- {escaped(helped.summary[:1].lower() + helped.summary[1:])}",
             ".SH SYNOPSIS", usage(helped.words, helped.usage),
             ".SH DESCRIPTION", escaped(sentence(helped.summary))]
    shown = None
    for section in helped.sections:
        heading = TITLES[section.title]
        if heading != shown:
            lines.append(f".SH {heading}")
            shown = heading
        if section.remarks:
            lines += [".SS " + escaped(section.remarks[0])] + [escaped(sentence(text)) for text in section.remarks[1:]]
        for entry in section.entries:
            lines += entry_lines(entry, helped)
    if helped.footer:
        lines += [".SH NOTES"] + footer_lines(helped.footer)
    others = ["-".join(other.words) for other in all_helps if other is not helped]
    programs = [name for name in ("hexoderm", "hexoderm-cli", "hexoderm-emulator", "hexoderm-ros") if name != title]
    see = [name for name in dict.fromkeys(programs + others) if name != title]
    lines += [".SH SEE ALSO", ",\n".join(f"{bold(name)}(1)" for name in see)]
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    helps = help_text.all_helps(program)
    version = help_text.version(program)[0]
    folder.mkdir(parents=True, exist_ok=True)
    for helped in helps:
        content = page(helped, helps, version).encode()
        (folder / ("-".join(helped.words) + ".1.gz")).write_bytes(gzip.compress(content, 9, mtime=0))


if __name__ == "__main__":
    main()
