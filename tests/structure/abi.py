#!/usr/bin/env python3
"""Checks that public types are laid out alike, whatever vector instructions a program is compiled for.

Asks g++ for the size and alignment of every class of the installed headers, with no flags of its own and with flags under
which Eigen aligns and vectorises otherwise. Also fails for a matrix of dynamic size that a public class holds: with such
flags, Eigen allocates it in another way.

Usage: abi.py COMPILER INCLUDE_FOLDER [COMPILER_ARGUMENT...]
"""

import pathlib
import re
import subprocess
import sys
import tempfile

# What programs are compiled with; those that a compiler does not know, as on another processor, are left out.
FLAGS = (["-mavx2", "-mfma"], ["-mavx512f", "-mfma"], ["-DEIGEN_DONT_VECTORIZE"])

LAYOUT = re.compile(r"^Class (hexoderm::.*)\n   (size=\d+ align=\d+)$", re.M)
ALIAS = re.compile(r"^using (\w+) = Eigen::", re.M)
DYNAMIC = re.compile(r"\bEigen::(?:(?:Matrix|Array|Vector|RowVector)\w*X[a-z]*|\w*\bDynamic)\b(?!\s*&)")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2])
    headers = {path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*.h"))}
    violations = [f"{header}:{number}: a matrix of dynamic size is no public member: {line.strip()}"
                  for header, text in headers.items() for number, line in enumerate(text.splitlines(), 1)
                  if DYNAMIC.search(line.split("//")[0])]
    # Types of Eigen that have a name of their own are looked at as members.
    source = "".join(f'#include "{header}"\n' for header in headers) + "namespace hexoderm {\n" + "".join(
        f"struct Of{name} {{ {name} value; }};\n" for text in headers.values() for name in ALIAS.findall(text)) + "}\n"

    with tempfile.TemporaryDirectory() as scratch:
        def compiled(flags, text):
            """Whether it compiles, and the layout of its classes."""
            dump = pathlib.Path(scratch) / "classes"
            run = subprocess.run([sys.argv[1], "-std=c++20", "-x", "c++", "-fsyntax-only", f"-fdump-lang-class={dump}", "-I",
                                  folder, *sys.argv[3:], *flags, "-"], input=text, text=True, check=False)
            return run.returncode == 0, dict(LAYOUT.findall(dump.read_text(encoding="utf-8")) if dump.exists() else [])

        is_compiled, layout = compiled([], source)
        if not is_compiled or not layout:
            sys.exit(f"no classes are in {folder}")
        for flags in FLAGS:
            if not compiled(flags, "")[0]:
                print(f"{' '.join(flags)}: the compiler does not know it")
                continue
            is_compiled, other = compiled(flags, source)
            changed = [name for name in layout if other.get(name) != layout[name]]
            if changed or not is_compiled:
                violations.append(f"with {' '.join(flags)} these are laid out otherwise: {', '.join(changed)}")
    print(f"{len(layout)} classes")
    if violations:
        sys.exit("\n".join(violations))


if __name__ == "__main__":
    main()
