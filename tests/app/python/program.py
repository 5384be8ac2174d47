"""The command line, for tests that compare the Python module with it."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import hexoderm
import numpy as np

CLI = os.environ["HEXODERM_CLI"]
EMULATOR = os.environ["HEXODERM_EMULATOR"]


def run(*arguments):
    """Runs hexoderm-cli. Exit code, standard output and standard error."""
    result = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=600)
    return result.returncode, result.stdout, result.stderr


class InFolder(unittest.TestCase):
    """A test with an empty folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_well(self, *arguments):
        """Runs hexoderm-cli, which must not fail; the verdict may be bad."""
        code, out, error = run(*arguments)
        self.assertIn(code, (0, 1), error)
        return out


def as_arrays(session, **others):
    """The same session, made of its arrays."""
    return hexoderm.Session.from_arrays(session.readings, session.links, cells=session.cells, counts=session.counts,
                                        **{"covariances": np.nan_to_num(session.covariances), **others})
