"""Sessions: as arrays, as files, and changed."""

import pathlib
import tempfile
import unittest

import hexoderm
import numpy as np
from program import InFolder, as_arrays


class Arrays(unittest.TestCase):
    def test_shapes(self):
        session = hexoderm.simulate(patch="sheet:3x4", poses=5)
        self.assertEqual(session.readings.shape, (5, 12, 3))
        self.assertEqual(session.covariances.shape, (5, 12, 3, 3))
        self.assertEqual(session.counts.shape, (5, 12))
        self.assertEqual(session.links.shape[1], 4)
        np.testing.assert_allclose(np.linalg.norm(session.readings, axis=2), 1, atol=0.3)

    def test_a_session_of_arrays_gives_the_same_calibration(self):
        session = hexoderm.simulate(poses=4, seed=2)
        of_session, of_arrays = (hexoderm.solve(each).patches[0] for each in (session, as_arrays(session)))
        np.testing.assert_array_equal(of_arrays.positions, of_session.positions)
        np.testing.assert_array_equal(of_arrays.rotations, of_session.rotations)
        np.testing.assert_array_equal(of_arrays.covariances, of_session.covariances)

    def test_cells_without_a_reading_are_not_a_number(self):
        session = hexoderm.simulate(poses=3, faults=["no-samples:7"])
        again = as_arrays(session)
        for each in (session, again):
            self.assertTrue(np.isnan(each.readings[:, 6]).all())
            self.assertEqual(np.isnan(each.readings).sum(), 3 * 3)
            self.assertEqual(each.poses[0].cells.tolist(), [n for n in range(1, 18) if n != 7])

    def test_what_is_given_comes_back(self):
        session = hexoderm.Session.from_arrays(
            [[[0, 0, 1], [0, 1, 0]]], [[5, 2, 9, 3]], cells=[5, 9], labels=["lying"], body_parts=["arm", "hand"],
            counts=[[100, 50]], covariances=np.full((1, 2, 3, 3), np.eye(3) * 1e-6), description="by hand")
        self.assertEqual(session.cells.tolist(), [5, 9])
        self.assertEqual(session.links.tolist(), [[5, 2, 9, 3]])
        self.assertEqual(session.readings.tolist(), [[[0, 0, 1], [0, 1, 0]]])
        self.assertEqual(session.counts.tolist(), [[100, 50]])
        self.assertEqual(session.covariances[0, 1].tolist(), (np.eye(3) * 1e-6).tolist())
        self.assertEqual((session.poses[0].label, session.description), ("lying", "by hand"))
        self.assertIn('"hand"', session.to_json())
        self.assertIsNone(session.truth)

    def test_a_truth_that_is_given_is_compared_with(self):
        session = hexoderm.simulate(poses=3)
        cells, positions, rotations = session.truth
        again = as_arrays(session, truth=(cells[::-1], positions[::-1], rotations[::-1]))
        calibration = hexoderm.solve(session)
        np.testing.assert_allclose(calibration.compare(again)[0].positions, calibration.compare(session)[0].positions,
                                   atol=1e-12)
        for truth, words in (((cells[:2], positions[:3], rotations[:2]), r"truth\[1\]: expected the shape \(cells=2, 3\)"),
                             (([99], positions[:1], rotations[:1]), r"truth\[0\]\[0\]: expected each cell"),
                             (([1], positions[:1], 2 * rotations[:1]), r"truth\[2\]\[0\]: expected a rotation"),
                             (([1], [[0, np.inf, 0]], rotations[:1]), r"truth\[1\]\[0\]: expected finite")):
            with self.assertRaisesRegex(hexoderm.InvalidArgument, words):
                as_arrays(session, truth=truth)

    def test_arrays_that_do_not_fit_are_refused(self):
        readings, links = np.tile([0, 0, 1.0], (2, 3, 1)), [[1, 2, 2, 3], [2, 2, 3, 3]]
        good = hexoderm.Session.from_arrays(readings, links)
        self.assertEqual(len(good.poses), 2)
        for words, arguments, others in [
            ("readings: expected the shape (poses, cells, 3), found (2, 9)", (readings.reshape(2, 9), links), {}),
            ("links: expected the shape (links, 4), found (2,)", (readings, [1, 2]), {}),
            ("links: row 1 names cell 4, which is not among the cells", (readings, [links[0], [2, 2, 4, 3]]), {}),
            ("cells: cell 1 is named twice", (readings, links), dict(cells=[1, 1, 3])),
            ("counts: expected the shape (poses=2, cells=3), found (2, 2)", (readings, links),
             dict(counts=[[1, 2], [1, 2]])),
            ("counts: expected the shape (poses=2, cells=3), found ()", (readings, links), dict(counts=200)),
            ("covariances: expected the shape (poses=2, cells=3, 3, 3), found (2, 3, 3)", (readings, links),
             dict(covariances=np.zeros((2, 3, 3)))),
            ("readings: expected the shape (poses, cells, 3), found (2, 5, 3, 3); average the samples of each pose first",
             (np.zeros((2, 5, 3, 3)), links), {}),
            ("labels: expected one for each of the 2 poses, found 1", (readings, links), dict(labels=["a"])),
            ("body_parts: expected one for each of 3 cells, found 1", (readings, links), dict(body_parts=["a"])),
        ]:
            with self.assertRaises(hexoderm.InvalidArgument) as raised:
                hexoderm.Session.from_arrays(*arguments, **others)
            self.assertEqual(str(raised.exception), words)

    def test_numbers_that_make_no_sense_are_refused_as_in_files(self):
        readings, links = np.tile([0, 0, 1.0], (1, 2, 1)), [[1, 2, 2, 3]]
        with self.assertRaisesRegex(hexoderm.FormatError, r"are these m/s2\? Expected g"):
            hexoderm.Session.from_arrays(readings * 9.81, links)

    def test_numbers_that_make_no_sense_are_named_by_array_and_place(self):
        readings, links = np.tile([0, 0, 1.0], (2, 2, 1)), [[1, 2, 2, 3]]
        for bad in (np.nan, np.inf):
            half = readings.copy()
            half[1, 0, 1] = bad
            with self.assertRaisesRegex(hexoderm.InvalidArgument, r"readings\[1, 0\]: .* NaN for all three"):
                hexoderm.Session.from_arrays(half, links)
        good = hexoderm.Session.from_arrays(readings, links)
        for bad, words in ((-np.eye(3), "variances of at least 0"), (np.full((3, 3), np.nan), "finite numbers"),
                           ([[1, 0.5, 0], [0, 1, 0], [0, 0, 1]], "symmetric"),
                           ([[1, 2, 0], [2, 1, 0], [0, 0, 1]], "semidefinite")):
            covariances = np.zeros((2, 2, 3, 3))
            covariances[1, 0] = bad
            with self.assertRaisesRegex(hexoderm.InvalidArgument, rf"covariances\[1, 0\]: expected.*{words}"):
                hexoderm.Session.from_arrays(readings, links, covariances=covariances)
            with self.assertRaisesRegex(hexoderm.InvalidArgument, rf"covariances\[0\]: expected.*{words}"):
                good.add_pose(readings[0], covariances=covariances[1])

    def test_whole_numbers(self):
        readings = np.tile([0, 0, 1.0], (1, 2, 1))
        floating = hexoderm.Session.from_arrays(readings, np.array([[1.0, 2.0, 2.0, 3.0]]), counts=[[100.0, 100.0]])
        self.assertEqual((floating.links.tolist(), floating.counts.tolist()), ([[1, 2, 2, 3]], [[100, 100]]))
        for links in ([[np.nan, 2, 2, 3]], [[1e300, 2, 2, 3]], [[1.5, 2, 2, 3]], np.array([[1.5, 2, 2, 3]]), [["a", "b", "c", "d"]]):
            with self.assertRaisesRegex(hexoderm.InvalidArgument, "links: expected whole numbers"):
                hexoderm.Session.from_arrays(readings, links)


class Files(InFolder):
    def test_what_is_written_is_read(self):
        session = hexoderm.simulate(poses=3, seed=5)
        for name in ("a.session.json", "a.hexo"):
            session.write(self.folder / name)
            again = hexoderm.read_session(str(self.folder / name))
            self.assertIsInstance(hexoderm.read(self.folder / name), hexoderm.Session)
            np.testing.assert_array_equal(again.readings, session.readings)
            np.testing.assert_array_equal(again.covariances, session.covariances)
            self.assertEqual(again.to_json(), session.to_json())
        self.assertEqual(hexoderm.Session.from_json(session.to_json()).to_json(), session.to_json())
        with self.assertRaisesRegex(hexoderm.StorageError, "a.hexo"):
            session.write(self.folder / "a.hexo")

    def test_calibrations(self):
        calibration = hexoderm.solve(hexoderm.simulate(poses=3))
        calibration.write(self.folder / "a.calibration.json")
        for again in (hexoderm.read_calibration(self.folder / "a.calibration.json"),
                      hexoderm.read(self.folder / "a.calibration.json"),
                      hexoderm.Calibration.from_json(calibration.to_json())):
            self.assertEqual((again.verdict.reason, again.solver), (calibration.verdict.reason, "global"))
            np.testing.assert_array_equal(again.patches[0].positions, calibration.patches[0].positions)
            np.testing.assert_array_equal(again.patches[0].covariances, calibration.patches[0].covariances)
            # Files have quaternions.
            np.testing.assert_allclose(again.patches[0].rotations, calibration.patches[0].rotations, atol=1e-15)


class Changes(unittest.TestCase):
    def test_poses_are_added_and_removed(self):
        whole = hexoderm.simulate(poses=4, seed=3)
        session = whole.copy()
        session.remove_pose(3)
        self.assertEqual((len(session.poses), len(whole.poses)), (3, 4))
        session.add_pose(whole.readings[3], covariances=whole.covariances[3], counts=whole.counts[3], label="again",
                         joint_angles={"elbow": 0.5})
        self.assertEqual((session.poses[3].label, session.poses[3].joint_angles), ("again", {"elbow": 0.5}))
        np.testing.assert_array_equal(hexoderm.solve(session).patches[0].positions,
                                      hexoderm.solve(whole).patches[0].positions)
        with self.assertRaises(hexoderm.InvalidArgument):
            session.remove_pose(9)
        with self.assertRaises(hexoderm.InvalidArgument):
            session.add_pose(whole.readings[3], covariances=-whole.covariances[3])
        self.assertEqual(len(session.poses), 4)

    def test_a_disabled_pose_is_not_used(self):
        session = hexoderm.simulate(poses=3, seed=4)
        shorter = session.copy()
        shorter.remove_pose(2)
        session.set_pose_disabled(2, True, "bumped")
        self.assertEqual((session.poses[2].disabled, session.poses[2].why_disabled), (True, "bumped"))
        np.testing.assert_array_equal(hexoderm.solve(session).patches[0].positions,
                                      hexoderm.solve(shorter).patches[0].positions)

    def test_a_muted_link_parts_the_skin(self):
        session = hexoderm.simulate(poses=3)
        self.assertEqual(len(hexoderm.solve(session).patches), 1)
        cell, port, other, other_port = map(int, session.links[0])
        session.set_link_muted((other, other_port), (cell, port), True, "a cable")
        self.assertEqual(len(hexoderm.solve(session).patches), 2)
        session.set_link_muted((cell, port), (other, other_port), False)
        self.assertEqual(len(hexoderm.solve(session).patches), 1)
        with self.assertRaisesRegex(hexoderm.InvalidArgument, "no link of the session joins cell 1, port 1 and cell 1"):
            session.set_link_muted((1, 1), (17, 3), True)

    def test_cell_models(self):
        model = hexoderm.CellModel.load("hex-bma150")
        self.assertIn(model.name, hexoderm.built_in_cell_models())
        self.assertEqual(sorted(model.ports), [1, 2, 3, 4])
        self.assertEqual(model.outline.shape, (6, 3))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "model.json"
            path.write_text(model.to_json())
            self.assertEqual(hexoderm.CellModel.load(path).name, model.name)
            self.assertEqual(hexoderm.simulate(cell_model=path).cell_model.name, model.name)
        own = hexoderm.CellModel.from_json(model.to_json().replace('"hex-bma150"', '"own"'))
        self.assertEqual(hexoderm.simulate(cell_model=own).cell_model.name, "own")
