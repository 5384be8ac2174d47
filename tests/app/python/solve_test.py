"""Solutions: what they hold, and that Python goes on while they are made."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import hexoderm
import numpy as np
from program import as_arrays


class Solutions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.session = hexoderm.simulate(poses=4, seed=2, surface="cylinder:r=0.0501")
        cls.calibration = hexoderm.solve(cls.session)
        cls.patch = cls.calibration.patches[0]

    def test_placements_are_near_the_truth(self):
        cells, positions, rotations = self.session.truth
        self.assertEqual(cells.tolist(), self.patch.cells.tolist())
        at = cells.tolist().index(self.patch.origin)
        # Into the frame of the origin cell.
        expected = (positions - positions[at]) @ rotations[at]
        np.testing.assert_allclose(self.patch.positions, expected, atol=0.005)
        np.testing.assert_allclose(self.patch.rotations, rotations[at].T @ rotations, atol=0.1)
        comparison = self.calibration.compare(self.session)[0]
        self.assertLess(comparison.position_rms_m, 0.002)
        self.assertLess(comparison.position_rms_m, np.linalg.norm(self.patch.positions - expected) + 1e-9)
        self.assertEqual(comparison.orientations.shape, (17,))
        self.assertLess(self.calibration.compare(self.calibration)[0].position_rms_m, 1e-12)

    def test_covariances_of_any_two_cells(self):
        origin, other = self.patch.origin, int(self.patch.cells[7])
        np.testing.assert_allclose(self.patch.covariance(origin, other), self.patch.covariances[7], rtol=1e-6,
                                   atol=1e-15)
        np.testing.assert_allclose(self.patch.covariance_together(other, other), self.patch.covariances[7], rtol=1e-6,
                                   atol=1e-15)
        self.assertEqual(self.patch.covariance(other, other).tolist(), np.zeros((6, 6)).tolist())
        # Neighbours are known better than the ends of the patch.
        link = self.patch.links[0]
        near = self.patch.covariance(link.source[0], link.target[0])
        far = self.patch.covariance(6, 17)
        self.assertTrue((np.linalg.eigvalsh(near) > 0).all())
        self.assertLess(np.trace(near[:3, :3]), np.trace(far[:3, :3]))

    def test_the_verdict_is_that_of_the_worst_cell(self):
        each = 1.96 * np.sqrt(np.linalg.eigvalsh(self.patch.covariances[:, :3, :3])[:, -1])
        self.assertAlmostEqual(self.calibration.verdict.position_95_m, each.max(), places=12)

    def test_a_comparison_is_reference_less_fitted_patch(self):
        _, reference, _ = self.session.truth
        found = self.patch.positions
        u, _, vt = np.linalg.svd((found - found.mean(axis=0)).T @ (reference - reference.mean(axis=0)))
        turn = vt.T @ np.diag([1, 1, np.linalg.det(vt.T @ u.T)]) @ u.T
        fitted = (found - found.mean(axis=0)) @ turn.T + reference.mean(axis=0)
        np.testing.assert_allclose(self.calibration.compare(self.session)[0].positions, reference - fitted, atol=1e-12)

    def test_the_next_pose_is_a_direction_and_words(self):
        first = hexoderm.solve(hexoderm.simulate(poses=1))
        self.assertEqual(first.verdict.remedy, "take_pose")
        self.assertTrue(first.verdict.next_action.startswith(first.advice), first.verdict.next_action)
        self.assertAlmostEqual(np.linalg.norm(first.advised_up), 1)
        self.assertLess(abs(first.advised_up @ first.patches[0].gravity[0]), 0.9)
        none = hexoderm.solve(hexoderm.simulate(poses=0))
        self.assertEqual((none.advice, none.advised_up), ("", None))

    def test_the_tree_states_no_covariance_of_the_shape(self):
        tree = hexoderm.solve(self.session, solver="tree", gap_model="arc")
        self.assertTrue(np.isnan(tree.patches[0].shape_covariances).all())
        self.assertFalse(np.isnan(tree.patches[0].covariances).any())
        self.assertEqual(json.loads(tree.to_json())["gap_model"], "arc")

    def test_the_tree_states_what_the_mould_leaves_open(self):
        def stated(gap_model):
            return hexoderm.solve(self.session, solver="tree", gap_model=gap_model).verdict.position_95_m
        self.assertLess(stated("pivot"), stated("fit"))
        self.assertLess(stated("fit"), stated("arc"))

    def test_a_mean_is_no_better_than_a_hands_tremor(self):
        def of(covariances):
            calibration = hexoderm.solve(as_arrays(self.session, covariances=covariances))
            noise = [pose["noise_g"] for pose in json.loads(calibration.to_json())["poses"]]
            return calibration.verdict.position_95_m, min(noise)

        usual, exact, rough = (of(self.session.covariances * factor) for factor in (1, 0.01, 1e4))
        self.assertAlmostEqual(usual[0], exact[0], places=6)
        self.assertGreater(rough[0], 2 * usual[0])
        self.assertGreaterEqual(exact[1], 0.003)

    def test_a_calibration_of_a_file_has_no_covariances_of_two_cells(self):
        patch = hexoderm.Calibration.from_json(self.calibration.to_json()).patches[0]
        with self.assertRaisesRegex(hexoderm.InvalidArgument, "of a fresh result"):
            patch.covariance(1, 2)

    def test_a_patch_outlives_its_calibration(self):
        patch = hexoderm.solve(self.session).patches[0]
        self.assertEqual(patch.positions.shape, (17, 3))
        self.assertEqual(patch.sensors(1)[0].name, "accelerometer")

    def test_links_poses_and_sensors(self):
        self.assertEqual(len(self.patch.links), 16)
        self.assertEqual({link.quality for link in self.patch.links}, {"over"})
        self.assertTrue(all(link.used and link.muted_by is None for link in self.patch.links))
        self.assertEqual(self.patch.gravity_poses.tolist(), [1, 2, 3, 4])
        np.testing.assert_allclose(np.linalg.norm(self.patch.gravity, axis=1), 1)
        self.assertEqual(self.patch.offsets.shape, (17, 3))
        self.assertTrue(self.patch.measured.all())

    def test_what_chips_of_a_lot_share(self):
        chip = json.loads(hexoderm.CellModel.load("hex-bma150").to_json())
        chip["accelerometer"].update(offset_sigma_g=0.015, offset_shared_sigma_g=0.05, scale_shared_sigma=0.1)
        model = hexoderm.CellModel.from_json(json.dumps(chip))
        patch = hexoderm.solve(hexoderm.simulate(poses=6, cell_model=model)).patches[0]
        # The cells' own errors are those of the whole.
        np.testing.assert_allclose(patch.lot.offset, patch.offsets.mean(axis=0), atol=0.01)
        self.assertAlmostEqual(patch.lot.scale, patch.scales.mean(), delta=0.01)
        self.assertTrue((patch.lot.offset_sigma < 0.01).all() and (patch.lot.offset_sigma > 0).all())
        self.assertTrue(0 < patch.lot.scale_sigma < 0.02)
        self.assertRegex(repr(patch.lot), r"<Lot: offset .* mg, scale .* \(1 sigma\)>")
        self.assertIsNone(hexoderm.solve(self.session, solver="tree").patches[0].lot)

    def test_findings_and_verdict(self):
        self.assertEqual((self.calibration.verdict.level, self.calibration.findings), ("good", []))
        calibration = hexoderm.solve(hexoderm.simulate(poses=3, faults=["dead:5"]))
        found = next(finding for finding in calibration.findings if finding.code == "dead-sensor")
        self.assertEqual((found.cells, found.severity), ([5], "error"))
        self.assertIn("dead-sensor", str(found))
        self.assertFalse(calibration.patches[0].measured[4])
        self.assertTrue(np.isnan(calibration.patches[0].offsets[4]).all())
        without = hexoderm.solve(hexoderm.simulate(poses=0)).verdict
        self.assertEqual((without.level, without.limit, without.remedy), ("not_enough", "no_pose", "take_pose"))
        self.assertFalse(without.is_usable)
        self.assertGreater(without.position_95_m, 0.05)
        nothing = hexoderm.solve(hexoderm.Session.from_arrays(np.zeros((0, 0, 3)), np.zeros((0, 4), int)))
        self.assertEqual((nothing.patches, nothing.verdict.limit, nothing.verdict.position_95_m), ([], "no_skin", None))

    def test_options_are_kept(self):
        options = hexoderm.solve(self.session, solver="tree", centre="off", without=[3]).options
        self.assertEqual((options["solver"], options["centre"], options["without"]), ("tree", "off", [3]))

    def test_an_earlier_result_may_be_given(self):
        again = hexoderm.solve(self.session, earlier=self.calibration)
        np.testing.assert_allclose(again.patches[0].positions, self.patch.positions, atol=1e-6)


class Threads(unittest.TestCase):
    def test_other_threads_go_on(self):
        session = hexoderm.simulate(patch="sheet:40x40", poses=6)
        ticks = []
        over = threading.Event()

        def tick():
            while not over.wait(0.001):
                ticks.append(time.monotonic())

        ticker = threading.Thread(target=tick)
        ticker.start()
        begin = time.monotonic()
        hexoderm.solve(session)
        end = time.monotonic()
        over.set()
        ticker.join()
        meanwhile = sum(begin < tick < end for tick in ticks)
        # Held, the lock would leave a tick at the beginning and one at the end.
        self.assertGreater(meanwhile, 10, f"in {end - begin:.3f} s")

    def test_two_threads_solve_at_the_same_time(self):
        sessions = [hexoderm.simulate(poses=4, seed=seed) for seed in range(8)]
        expected = [hexoderm.solve(session).to_json() for session in sessions]
        found = [None] * len(sessions)

        def solve(k):
            for _ in range(5):
                found[k] = hexoderm.solve(sessions[k]).to_json()

        threads = [threading.Thread(target=solve, args=(k,)) for k in range(len(sessions))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, expected)

    def test_an_interrupt_ends_a_long_solution(self):
        program = """
import hexoderm, sys
session = hexoderm.simulate(patch="sheet:150x150", poses=6)
print("solving", flush=True)
try:
    hexoderm.solve(session)
except KeyboardInterrupt:
    print("interrupted")
print(hexoderm.solve(hexoderm.simulate(poses=3)).verdict.level)
"""
        with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
            self.assertEqual(process.stdout.readline(), "solving\n")
            time.sleep(0.3)
            os.kill(process.pid, signal.SIGINT)
            self.assertEqual(process.stdout.read(), "interrupted\ngood\n")


def turned_by(degrees):
    """The cell model with its chip turned about z."""
    model = json.loads(hexoderm.CellModel.load("hex-bma150").to_json())
    half = np.radians(degrees) / 2
    model["accelerometer"]["q_u_wxyz"] = [np.cos(half), 0, 0, np.sin(half)]
    return hexoderm.CellModel.from_json(json.dumps(model))


class WrongAxes(unittest.TestCase):
    """A chip that is turned by 90 degrees where the cell model says otherwise."""

    def solved(self, degrees, skin):
        session = hexoderm.simulate(poses=4, cell_model=turned_by(90), **skin)
        seen = as_arrays(session, cell_model=turned_by(degrees), truth=session.truth)
        return hexoderm.solve(seen), seen

    def test_the_signs_of_bends_tell_what_is_not_found(self):
        curved = [dict(patch="sheet:5x5", surface="cylinder:r=0.06"), dict(patch="sheet:5x5", surface="sphere:r=0.08"), {}]
        chains = [dict(patch="ring9"), dict(patch="sheet:1x8", surface="cylinder:r=0.06")]
        # On a convex part bends are positive; half a turn makes them negative, a quarter turn makes chains twist.
        for degrees, skins in ((90, [*curved, chains[0]]), (-90, curved), (0, chains)):
            for skin in skins:
                with self.subTest(degrees=degrees, **skin):
                    calibration, seen = self.solved(degrees, skin)
                    bends, twists = (np.degrees([getattr(link, name) for link in calibration.patches[0].links])
                                     for name in ("bend_rad", "twist_rad"))
                    codes = [finding.code for finding in calibration.findings]
                    # Chains that twist are found, but not by what.
                    self.assertIn(codes, [["poor-fit"], ["contradicts-model"]] if degrees == 0 else
                                  [["inside-out"] if degrees < 0 else []])
                    self.assertGreater((twists if degrees == 0 else np.sign(degrees) * bends).min(), 10)
                    if degrees >= 0:
                        self.assertLess(abs((bends if degrees == 0 else twists).mean()), 2)
                    error_m = calibration.compare(seen)[0].position_rms_m
                    self.assertTrue(error_m < 0.005 if degrees == 90 else error_m > 0.01, error_m)
        found = [finding.code for finding in self.solved(0, curved[0])[0].findings]
        self.assertIn("contradicts-model", found)
