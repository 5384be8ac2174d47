#!/usr/bin/env python3
"""Checks that public types are laid out alike, whatever vector instructions a program is compiled for.

Lists every class of the installed headers, asks the compiler for its size and alignment with no flags of its own, and
then compiles the answers as static assertions with flags under which Eigen aligns and vectorises otherwise. Also fails for
a matrix of dynamic size that a public class holds: with such flags, Eigen allocates it in another way.

Usage: abi.py COMPILER INCLUDE_FOLDER [COMPILER_ARGUMENT...]
"""

import pathlib
import re
import subprocess
import sys
import tempfile

# What programs are compiled with; those that a compiler does not know, as on another processor, are left out.
FLAGS = (["-mavx2", "-mfma"], ["-mavx512f", "-mfma"], ["-DEIGEN_DONT_VECTORIZE"])

TOKEN = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])+'|#[^\n]*(?:\\\n[^\n]*)*|\d(?:'?\w)*|\w+|"
                   r"::|[^\s\w]", re.S)
DYNAMIC = re.compile(r"\bEigen::(?:(?:Matrix|Array|Vector|RowVector)\w*X[a-z]*|\w*\bDynamic)\b(?!\s*&)")


def tokens(text):
    """The tokens of a header without comments, literals and directives."""
    return [token for token in TOKEN.findall(text) if not token.startswith(("//", "/*", "\"", "'", "#"))]


def classes(text):
    """The names, with their scopes, of all classes of a header that can be named from outside. No templates."""
    found = []
    scopes = []  # (kind, name, whether members can be named)
    words = tokens(text)
    statement = []  # tokens since the last ; { or }
    for index, word in enumerate(words):
        if word == "{":
            kind, name = "block", ""
            if "namespace" in statement:
                kind, name = "namespace", "".join(statement[statement.index("namespace") + 1:])
            elif "enum" not in statement and "=" not in statement and "(" not in statement:
                for keyword in ("class", "struct"):
                    if keyword in statement:
                        kind, name = keyword, statement[statement.index(keyword) + 1]
            is_template = "template" in statement
            is_visible = all(scope[2] for scope in scopes)
            if kind in ("class", "struct") and not is_template and is_visible:
                found.append("::".join([scope[1] for scope in scopes if scope[1]] + [name]))
            scopes.append([kind, name, kind in ("namespace", "struct") and not is_template])
            statement = []
        elif word == "}":
            if scopes:
                scopes.pop()
            statement = []
        elif word == ";":
            statement = []
        elif word == ":" and statement and statement[-1] in ("public", "private", "protected"):
            if scopes and scopes[-1][0] in ("class", "struct"):
                scopes[-1][2] = statement[-1] == "public"
            statement = []
        else:
            statement.append(word)
    return found


def aliases(text):
    """The types of Eigen that a header gives a name of its own, outside of classes."""
    return re.findall(r"^using (\w+) = Eigen::", text, re.M)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    compiler, folder, arguments = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    headers = sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*.h"))
    types = []
    violations = []
    for header in headers:
        text = (folder / header).read_text(encoding="utf-8")
        types += classes(text) + ["hexoderm::" + name for name in aliases(text)]
        for number, line in enumerate(text.splitlines(), 1):
            if DYNAMIC.search(line.split("//")[0]):
                violations.append(f"{header}:{number}: a matrix of dynamic size is no public member: {line.strip()}")
    types = sorted(set(types))
    if not types:
        sys.exit(f"no classes are in {folder}")
    includes = "".join(f'#include "{header}"\n' for header in headers)
    compile_only = [compiler, "-std=c++20", "-I", str(folder), *arguments]

    with tempfile.TemporaryDirectory() as scratch:
        source = pathlib.Path(scratch) / "layout.cpp"
        program = pathlib.Path(scratch) / "layout"
        prints = "".join(f'  std::printf("%zu %zu {name}\\n", sizeof({name}), alignof({name}));\n' for name in types)
        source.write_text(f"{includes}#include <cstdio>\nint main() {{\n{prints}}}\n", encoding="utf-8")
        subprocess.run([*compile_only, str(source), "-o", str(program)], check=True)
        layout = subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout

        assertions = "".join(
            f'static_assert(sizeof({name}) == {size} && alignof({name}) == {alignment}, "layout of {name}");\n'
            for size, alignment, name in (line.split(" ") for line in layout.splitlines()))
        empty = pathlib.Path(scratch) / "empty.cpp"
        empty.write_text("", encoding="utf-8")
        source.write_text(includes + assertions, encoding="utf-8")
        for flags in FLAGS:
            known = subprocess.run([*compile_only, *flags, "-fsyntax-only", str(empty)], capture_output=True, check=False)
            if known.returncode != 0:
                print(f"{' '.join(flags)}: the compiler does not know it")
                continue
            result = subprocess.run([*compile_only, *flags, "-fsyntax-only", str(source)], capture_output=True,
                                    text=True, check=False)
            if result.returncode == 0:
                continue
            changed = sorted(set(re.findall(r"layout of ([\w:]+)", result.stderr)))
            if not changed:
                violations.append(result.stderr)
            violations += [f"with {' '.join(flags)} {name} is laid out otherwise" for name in changed]
    print(f"{len(types)} classes")
    if violations:
        sys.exit("\n".join(violations))


if __name__ == "__main__":
    main()
