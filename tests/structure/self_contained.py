#!/usr/bin/env python3
"""Checks that the project's texts point only at what is in the project.

Fails, naming file and line, for a reference to a document that is not here, for a path of the project, in a comment or a
document, at which nothing stands, for a broken link of a Markdown page, and for a build rule that makes symbolic links:
a path that exists only in a build tree is found by no editor and no search.

Usage: self_contained.py ROOT
"""

import pathlib
import re
import sys

SKIPPED = {"build", "out"}
SHOWN = {".github"}  # names with a dot in front that are looked at all the same
TEXTS = {".h", ".cpp", ".in", ".c", ".py", ".sh", ".md", ".cmake", ".txt", ".proto", ".json", ".html", ".qrc"}

# The word is put together so that a search for it finds nothing but the licence.
ELSEWHERE = re.compile(r"\b%s\b|\b[A-Z]{3,}\.md\b" % ("SP" + "EC"))
LINKS = re.compile(r"\b(?:CREATE_LINK|create_symlink)\b")
# A path from the root, in which {a,b} and * may stand for several names.
PATH = re.compile(r"(?<![\w./$}>-])(?:core|widgets|app|tests|packaging|resources)/[\w./*{},-]*[\w/*}]")
# A source that a page names by its path below its own folder or one of these.
NAMED = re.compile(r"`([\w./]+/\w+\.(?:h|cpp|inl|c|py|sh))`")
FOLDERS = ("", "core", "core/hexoderm", "widgets", "app/window")
GENERATED = {"hexoderm/hexoderm.h"}
MARKDOWN_LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
COMMENT = re.compile(r"(?:^|\s)(?://|#\s|\*\s)(.*)")


def texts(root):
    """All texts, as paths from the root."""
    for path in sorted(root.rglob("*")):
        relative = path.relative_to(root)
        if relative.parts[0] in SKIPPED or any(part.startswith(".") and part not in SHOWN for part in relative.parts):
            continue
        if path.suffix in TEXTS and path.is_file():
            yield relative


def alternatives(path):
    """The paths that one with {a,b} stands for."""
    match = re.search(r"\{([^{}]*)\}", path)
    if not match:
        return [path]
    return [each for name in match[1].split(",")
            for each in alternatives(path[:match.start()] + name + path[match.end():])]


def stands(root, path):
    """Whether something stands at a path; a unit may be named without its suffix."""
    pattern = path.rstrip("/")
    return any(root.glob(pattern)) or any(root.glob(pattern + ".*"))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1])
    own = pathlib.PurePosixPath("tests/structure/self_contained.py")
    names = {path.name for path in texts(root)}
    violations = []
    for file in texts(root):
        if file == own:
            continue
        for number, line in enumerate((root / file).read_text(encoding="utf-8").splitlines(), 1):
            where = f"{file}:{number}"
            for match in ELSEWHERE.finditer(line):
                if match[0] in names:
                    continue
                violations.append(f"{where}: {match[0]} is no document of the project")
            if file.suffix in {".txt", ".cmake", ".in", ".sh"}:
                for match in LINKS.finditer(line):
                    violations.append(f"{where}: {match[0]} makes a path that is not in the tree")
            if file.suffix == ".md":
                for match in MARKDOWN_LINK.finditer(line):
                    target = match[1]
                    if "://" not in target and not (root / file.parent / target).exists():
                        violations.append(f"{where}: nothing stands at {target}")
                for name in set(NAMED.findall(line)) - GENERATED:
                    if not any((root / folder / name).is_file() for folder in (file.parent, *FOLDERS)):
                        violations.append(f"{where}: {name} is not there")
                prose = line
            else:
                comment = COMMENT.search(line)
                prose = comment[1] if comment else ""
            for match in PATH.finditer(prose):
                for path in alternatives(match[0]):
                    if not stands(root, path):
                        violations.append(f"{where}: nothing stands at {path}")
    if violations:
        sys.exit("\n".join(violations))


if __name__ == "__main__":
    main()
