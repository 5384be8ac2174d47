"""Calls that do not fit: which argument is to blame, and what is expected."""

import pathlib
import unittest

import hexoderm
import numpy as np


class Arguments(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.session = hexoderm.simulate(poses=2)

    def expect(self, words, call, *arguments, **named):
        with self.assertRaises(TypeError) as raised:
            call(*arguments, **named)
        self.assertEqual(str(raised.exception), words)

    def test_of_another_type(self):
        solve, simulate, from_arrays = hexoderm.solve, hexoderm.simulate, hexoderm.Session.from_arrays
        readings, links = np.tile([0, 0, 1.0], (1, 2, 1)), [[1, 2, 2, 3]]
        self.expect("session: expected a Session, as read_session() reads it from a file, found str: 'arm.json'", solve,
                    "arm.json")
        self.expect("without: expected a list of cells' IDs, found int: 7", solve, self.session, without=7)
        self.expect("support_axes: expected auto, on or off, found bool: True", solve, self.session, support_axes=True)
        self.expect("earlier: expected a Calibration, found int: 1", solve, self.session, earlier=1)
        self.expect("poses: expected a whole number of at least 0, found int: -1", simulate, poses=-1)
        self.expect("faults: expected a list of strings, found str: 'dead:1'", simulate, faults="dead:1")
        self.expect("seed: expected a whole number of at least 0, found float: 1.5", hexoderm.simulate_robot, seed=1.5)
        self.expect("readings: expected an array of numbers, found str: 'x'", from_arrays, "x", links)
        self.expect("labels: expected a list of strings, found int: 1", from_arrays, readings, links, labels=1)
        self.expect("poses: expected a whole number of at least 0, found int: -1", hexoderm.Capture, "sim:x17", poses=-1)
        self.expect("source: expected a string, found NoneType: None", hexoderm.Capture, None)
        with self.assertRaisesRegex(TypeError, r"cell_model: expected a CellModel, .*from_json.*, found dict: {'a': 1}"):
            from_arrays(readings, links, cell_model={"a": 1})
        self.assertRaisesRegex(TypeError, "cell_model: expected a CellModel", hexoderm.read, "none", cell_model=3)

    def test_names_that_there_are_not(self):
        self.expect("solve() has no argument solvr; did you mean solver?", hexoderm.solve, self.session, solvr="tree")
        self.expect("simulate() has no argument psoes; did you mean poses?", hexoderm.simulate, psoes=1)
        self.expect("Capture() has no argument file; it has source, poses, auto, output, keep_raw, record, timeout",
                    hexoderm.Capture, "sim:x17", file="a.hexo")
        self.expect("from_arrays() has no argument cel_model; did you mean cell_model?", hexoderm.Session.from_arrays,
                    [], [], cel_model="a")

    def test_too_many_and_too_few(self):
        self.expect("solve() needs session", hexoderm.solve)
        self.expect("Capture() needs source", hexoderm.Capture, poses=3)
        self.expect("from_arrays() needs links", hexoderm.Session.from_arrays, [])
        self.expect("solve() takes at most 1 argument without a name, found 2", hexoderm.solve, self.session, "tree")
        self.expect("simulate() takes no argument without a name, found 1", hexoderm.simulate, "x17")

    def test_help_is_about_the_function(self):
        for function in (hexoderm.solve, hexoderm.simulate, hexoderm.simulate_robot, hexoderm.Session.from_arrays,
                         hexoderm.Capture.__init__):
            self.assertNotIn("Overloaded", function.__doc__)
            self.assertTrue(function.__doc__.startswith(function.__name__ + "("), function.__doc__[:80])

    def test_what_fits_is_taken(self):
        self.assertEqual(len(hexoderm.simulate(poses=np.int64(3)).poses), 3)
        self.assertEqual(hexoderm.solve(self.session, without=np.array([3])).options["without"], [3])
        self.assertRaises(hexoderm.StorageError, hexoderm.simulate, cell_model=pathlib.Path("none"))
