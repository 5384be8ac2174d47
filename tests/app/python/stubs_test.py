"""The stubs say what the module has, with the same arguments; and a script that uses it passes a strict type check."""

import ast
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import hexoderm
from hexoderm import _core

PACKAGE = pathlib.Path(hexoderm.__file__).parent
EXAMPLE = os.environ["HEXODERM_EXAMPLE"]
# pybind11's classes have a metaclass and an __init__ of their own.
OF_PYBIND11 = re.compile(r"metaclass differs|__init__ is inconsistent, stub does not have \*args")


def complaints():
    result = subprocess.run(["/usr/bin/stubtest", "--concise", "hexoderm"], capture_output=True, text=True, cwd="/")
    if "not checking stubs" in result.stdout + result.stderr or "Traceback" in result.stderr:
        raise AssertionError(result.stdout + result.stderr)
    return [line for line in result.stdout.splitlines() if line and not OF_PYBIND11.search(line)]


def names_of(arguments):
    """Of arguments in the syntax of Python, without self."""
    given = arguments.args + [ast.arg("*")] * bool(arguments.kwonlyargs) + arguments.kwonlyargs
    names = [argument.arg for argument in given if argument.arg != "self"]
    return names + ["**"] * (arguments.kwarg is not None)


def in_docstring(function):
    """The names that pybind11 writes in front of a docstring; values that are no syntax of Python are left out."""
    line = next(line for line in function.__doc__.splitlines() if "->" in line)
    line = re.sub(r"^\d+\. ", "", line)
    arguments = re.sub(r" = <[^>]*>", " = None", line[line.index("("):line.rindex(" -> ")])
    return names_of(ast.parse(f"def f{arguments}: ...").body[0].args)


class Stubs(unittest.TestCase):
    def test_everything_is_there(self):
        self.assertEqual(complaints(), [])

    def test_arguments_have_the_same_names(self):
        compared = 0
        for node in ast.parse((PACKAGE / "_core.pyi").read_text()).body:
            functions = [node] if isinstance(node, ast.FunctionDef) else getattr(node, "body", [])
            owner = getattr(_core, node.name) if isinstance(node, ast.ClassDef) else _core
            for function in functions:
                if not isinstance(function, ast.FunctionDef) or function.name == "__exit__":
                    continue
                found = getattr(owner, function.name)
                if isinstance(found, property):
                    continue
                self.assertEqual(in_docstring(found), names_of(function.args), f"{owner.__name__}.{function.name}")
                compared += 1
        self.assertGreater(compared, 30)

    def test_the_example_is_typed(self):
        with tempfile.NamedTemporaryFile("w", suffix=".ini") as config:
            # Newer versions of Matplotlib have types, which know nothing of 3D axes.
            config.write("[mypy]\n[mypy-matplotlib.*]\nfollow_imports = skip\n")
            config.flush()
            result = subprocess.run(["/usr/bin/mypy", "--strict", "--allow-untyped-calls", "--ignore-missing-imports",
                                     "--config-file", config.name, "--cache-dir=/dev/null", EXAMPLE],
                                    capture_output=True, text=True, cwd="/")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_every_public_name_is_described(self):
        for name in dir(_core):
            thing = getattr(_core, name)
            if not name.startswith("_"):
                self.assertTrue((thing.__doc__ or "").strip(), name)

    def test_every_member_is_described(self):
        of_their_own = 0
        for owner in (getattr(_core, name) for name in dir(_core) if not name.startswith("_")):
            if not isinstance(owner, type) or issubclass(owner, Exception):
                continue
            for name, member in vars(owner).items():
                if name.startswith("_"):
                    continue
                # pybind11 writes the signature of a function in front, and nothing of a property's.
                lines = [line for line in (member.__doc__ or "").splitlines() if line.strip() and "->" not in line]
                self.assertTrue(lines, f"{owner.__name__}.{name}")
                of_their_own += 1
        self.assertGreater(of_their_own, 90)

    def test_the_package_lists_what_it_has(self):
        self.assertEqual(set(hexoderm.__all__), {name for name in dir(_core) if not name.startswith("_")})
