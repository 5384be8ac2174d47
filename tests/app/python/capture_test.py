"""Live captures: from a simulated skin, over a wire and from a recording."""

import os
import re
import signal
import subprocess
import sys
import threading
import time
import unittest

import hexoderm
import numpy as np
from program import EMULATOR, InFolder


class Captures(InFolder):
    def test_poses_come_one_by_one(self):
        ids = []
        with hexoderm.Capture("sim:x17?speed=max", poses=4, auto=True) as capture:
            for pose in capture:
                ids.append(pose.id)
                self.assertEqual(pose.readings.shape, (17, 3))
                self.assertEqual(len(capture.session.poses), len(ids))
                np.testing.assert_array_equal(capture.session.poses[-1].readings, pose.readings)
                self.assertEqual(len(capture.calibration.patches[0].gravity), len(ids))
            self.assertEqual((capture.calibration.verdict.level, capture.remarks), ("good", []))
            # What was advised before the last pose is over.
            self.assertEqual((capture.advice, capture.advised_up), ("", None))
        self.assertEqual(ids, [1, 2, 3, 4])
        self.assertEqual(len(capture.session.poses), 4)
        # The result is that of the session.
        solved = hexoderm.solve(capture.session)
        np.testing.assert_allclose(capture.calibration.patches[0].positions, solved.patches[0].positions, atol=1e-5)
        self.assertLess(solved.compare(capture.session)[0].position_rms_m, 0.005)
        with self.assertRaises(StopIteration):
            next(capture)

    def test_a_file_keeps_the_poses(self):
        file = self.folder / "live.hexo"
        with hexoderm.Capture("sim:x17?speed=max", poses=3, auto=True, output=file) as capture:
            for pose in capture:
                # Captured is what is on disk.
                self.assertEqual(len(hexoderm.read_session(file).poses), pose.id)
        np.testing.assert_array_equal(hexoderm.read_session(file).readings, capture.session.readings)

    def test_it_may_be_left_early(self):
        with hexoderm.Capture("sim:x17?speed=max", auto=True, output=self.folder / "live.hexo") as capture:
            for _ in capture:
                break
        self.assertGreaterEqual(len(hexoderm.read_session(self.folder / "live.hexo").poses), 1)
        capture = hexoderm.Capture("sim:x17", auto=True)
        del capture

    def test_the_device_is_asked_to_turn(self):
        with hexoderm.Capture("sim:x17?speed=max", poses=2) as capture:
            self.assertIsNone(capture.calibration)
            first = next(capture)
            self.assertTrue(capture.advice.startswith("Turn the part so that"), capture.advice)
            self.assertAlmostEqual(np.linalg.norm(capture.advised_up), 1)
            capture.turn_to_next_pose()
            second = next(capture)
        cosines = np.sum(first.readings * second.readings, axis=1)
        self.assertLess(np.median(cosines), 0.7)

    def test_nothing_is_read_before_the_first_pose_is_waited_for(self):
        with hexoderm.Capture("sim:x17?speed=max", poses=1) as capture:
            time.sleep(0.3)
            self.assertEqual((capture.session, capture.calibration, capture.advice), (None, None, ""))
            with self.assertRaisesRegex(hexoderm.InvalidArgument, "no skin has described itself yet"):
                capture.turn_to_next_pose()

    def test_a_device_on_a_wire(self):
        for kind in ("tcp", "udp"):
            with self.subTest(kind=kind):
                emulator = subprocess.Popen([EMULATOR, f"--{kind}", "0", "--patch", "x17"], stdin=subprocess.PIPE,
                                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                self.addCleanup(emulator.stdout.close)
                self.addCleanup(emulator.stdin.close)
                self.addCleanup(emulator.wait)
                self.addCleanup(emulator.kill)
                emulator.stdin.write("break no-samples 5\n")
                emulator.stdin.flush()
                address = re.search(rf"{kind}://\S+:\d+", self.wait_for_line(emulator, f"{kind}://"))[0]
                with hexoderm.Capture(address, poses=2, auto=True, timeout=60) as capture:
                    poses = list(capture)
                self.assertEqual([pose.id for pose in poses], [1, 2])
                self.assertEqual(capture.session.cells.size, 17)
                self.assertEqual(poses[0].cells.size, 16)
                self.assertEqual(capture.remarks, ["silent 5"])

    def wait_for_line(self, process, text):
        for line in process.stdout:
            if text in line:
                return line
        self.fail(f"{text} was not said")

    def test_nothing_comes(self):
        with hexoderm.Capture("tcp://localhost:1", timeout=0.5) as capture:
            said = "tcp://localhost:1: the device did not describe itself for 0.5 s: "
            with self.assertRaisesRegex(hexoderm.DeviceError, said):
                next(capture)
            with self.assertRaises(StopIteration):
                next(capture)
            self.assertIsNone(capture.session)
        with self.assertRaisesRegex(hexoderm.DeviceError, "ended before a skin described itself"):
            (self.folder / "stream").write_bytes(b"SKINREC1")
            list(hexoderm.Capture(f"replay:{self.folder}/stream"))

    def test_python_goes_on_while_it_waits(self):
        with hexoderm.Capture("sim:x17", timeout=60) as capture:
            next(capture)  # the part lies there, and nobody turns it
            waiting = threading.Thread(target=lambda: list(capture))
            waiting.start()
            time.sleep(0.3)
            self.assertTrue(waiting.is_alive())
            self.assertIn("Turn the part", capture.status)
            self.assertEqual(len(capture.session.poses), 1)
            capture.turn_to_next_pose()
            deadline = time.monotonic() + 30
            while len(capture.session.poses) < 2 and time.monotonic() < deadline:
                time.sleep(0.05)
            self.assertEqual(len(capture.session.poses), 2)
            capture.close()
            waiting.join(10)
            self.assertFalse(waiting.is_alive())

    def test_an_interrupt_ends_the_wait(self):
        program = """
import hexoderm
capture = hexoderm.Capture("sim:x17")
print(next(capture).id, flush=True)
try:
    next(capture)
except KeyboardInterrupt:
    capture.close()
    print("interrupted,", len(capture.session.poses), "pose")
"""
        with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
            self.assertEqual(process.stdout.readline(), "1\n")
            time.sleep(0.3)
            os.kill(process.pid, signal.SIGINT)
            self.assertEqual(process.stdout.read(), "interrupted, 1 pose\n")

    def test_a_daemon_thread_that_is_left_behind_ends_nothing(self):
        # Python takes its lock away from such threads while they wait for it, wherever they are.
        program = """
import hexoderm, threading, time
capture = hexoderm.Capture("sim:x17")
session = hexoderm.simulate(poses=3)
calibration = hexoderm.solve(session)


def over_and_over(work):
    while True:
        work()


for work in (lambda: next(capture, None), lambda: hexoderm.solve(session), calibration.to_json, session.to_json):
    threading.Thread(target=over_and_over, args=(work,), daemon=True).start()
threading.Thread(target=lambda: (time.sleep(0.3), capture.close()), daemon=True).start()
time.sleep(0.3)
"""
        for _ in range(5):
            result = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
