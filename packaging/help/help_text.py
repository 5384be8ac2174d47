"""What a program says of itself with --help, taken apart: for man pages and for the completion of command lines."""

import dataclasses
import os
import re
import subprocess

HEADING = re.compile(r" *(Positionals|Arguments|Options|Subcommands):")
NAME_AND_TEXT = re.compile(r"( +)(\S.*?) {2,}(?=\S)")


@dataclasses.dataclass
class Entry:
    """An option, an argument or a command."""
    name: str
    text: str

    def spellings(self):
        """The ways to write an option: "-o", "--output"."""
        return re.findall(r"(?:^|[ ,])(--?[A-Za-z][\w-]*)", re.split(r" (?:Needs|Excludes):", self.name)[0])

    def takes_value(self):
        """Whether a word follows an option, and not only because the option needs another."""
        rest = re.split(r" (?:Needs|Excludes):", self.name)[0]
        for spelling in self.spellings():
            rest = rest.replace(spelling, "", 1)
        return bool(rest.strip(" ,"))

    def choices(self):
        """The values that an option takes, if it names them all."""
        match = re.search(r":\{([^}]*)\}", self.name)
        return match[1].split(",") if match else []


@dataclasses.dataclass
class Section:
    """Entries below a heading, with what is said of all of them."""
    title: str
    remarks: list = dataclasses.field(default_factory=list)
    entries: list = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class Help:
    """The help of a program, or of one of its commands."""
    words: list  # "hexoderm-cli", "solve"
    summary: str
    usage: str
    sections: list
    footer: list  # lines

    def entries(self, title):
        """All entries of the sections with a title."""
        return [entry for section in self.sections if section.title == title for entry in section.entries]

    def options(self):
        """All options, in whatever section."""
        return [entry for section in self.sections for entry in section.entries if entry.name.startswith("-")]


def text_column(lines):
    """Where the texts of a section's entries begin: one place for all of them."""
    for line in lines:
        match = NAME_AND_TEXT.match(line)
        if match:
            return match.end()
    return min((len(line) - len(line.lstrip()) for line in lines if line.startswith(" " * 8)), default=0)


def add_entries(lines, section):
    """Takes the lines below a heading apart. A name that is too long for its column has a line of its own."""
    column = text_column(lines)
    for line in lines:
        indent = len(line) - len(line.lstrip())
        if indent >= column:
            # A line that is indented further is one of a list; others go on with the one before.
            between = "\n" if indent > column else " "
            section.entries[-1].text = (section.entries[-1].text + between + line.strip()).strip()
        elif line[column - 1:column] == " " and not line[column:].startswith(("Needs:", "Excludes:")):
            section.entries.append(Entry(line[:column].strip(), line[column:].strip()))
        else:
            section.entries.append(Entry(line.strip(), ""))


def parse(words, text):
    """The help of CLI11 and of Qt: usage and summary, sections of entries, and what else is said."""
    lines = text.rstrip().splitlines()
    at = next(number for number, line in enumerate(lines) if line.startswith("Usage: "))
    usage = re.sub(r"\S*/", "", lines[at].removeprefix("Usage: "), count=1)
    head = []
    for number, line in enumerate(lines):
        if number == at:
            continue
        if not line and number > at:
            break
        head.append(line)
    result = Help(list(words), " ".join(head).strip().rstrip("."), usage, [], [])

    below = []
    remarks = []
    title = None

    def close():
        if title and below:
            section = Section(title, list(remarks))
            add_entries(below, section)
            result.sections.append(section)
            remarks.clear()
            below.clear()

    for position, line in enumerate(lines[len(head) + 1:], len(head) + 1):
        heading = HEADING.fullmatch(line)
        if line.startswith("[Option Group: "):
            close()
            title = None
            remarks.append(line.removeprefix("[Option Group: ").rstrip("]"))
        elif heading:
            close()
            title = heading[1]
        elif remarks and title is None and line.strip():
            remarks.append(line.strip(" []"))
        elif line and title is None:
            result.footer = lines[position:]
            break
        elif line:
            below.append(line)
        elif title:
            close()
            title = None
    close()
    return result


def asked(program, command=()):
    """The help of a program, or of one of its commands, in English."""
    environment = dict(os.environ, LC_ALL="C.UTF-8", LANGUAGE="en", COLUMNS="80")
    output = subprocess.run([program, *command, "--help"], check=True, capture_output=True, text=True, env=environment)
    return parse([os.path.basename(program), *command], output.stdout)


def version(program):
    """The first line of --version, and the lines after it."""
    output = subprocess.run([program, "--version"], check=True, capture_output=True, text=True,
                            env=dict(os.environ, LC_ALL="C.UTF-8"))
    first, *rest = output.stdout.strip().splitlines()
    return first, rest


def all_helps(program):
    """The help of a program, and then that of each of its commands."""
    first = asked(program)
    return [first] + [asked(program, [command.name]) for command in first.entries("Subcommands")]
