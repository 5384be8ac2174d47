"""The command line, a session with its truth as readings over time, and messages as those of ROS."""

import itertools
import json
import math
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from types import SimpleNamespace

from hexoderm_ros.readings import Reading

CLI = os.environ["HEXODERM_CLI"]
RATE_HZ = 50
GRAVITY = 9.80665


def run(*arguments):
    result = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=300)
    if result.returncode not in (0, 1):
        raise AssertionError(result.stderr)
    return result.stdout


def wait_until(condition, why, timeout_s=60):
    """Looks again and again whether the condition is there; `why` it is not, if it never is."""
    deadline = time.monotonic() + timeout_s
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(why)
        time.sleep(0.02)


class Listener:
    """Reads what a process says on standard error as it comes: who waits for a line loses none of the others."""

    def __init__(self, process):
        self.process = process
        self._said, self._is_over = [], False
        self._changed = threading.Condition()
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def _read(self):
        for line in self.process.stderr:
            with self._changed:
                self._said.append(line)
                self._changed.notify_all()
        with self._changed:
            self._is_over = True
            self._changed.notify_all()

    def wait_for(self, expected, timeout_s=60, after=""):
        """The first line that has it, of those already said too; `after` one that has that."""
        def found():
            later = itertools.dropwhile(lambda line: after not in line, self._said)
            return next((line for line in later if expected in line), None)

        with self._changed:
            self._changed.wait_for(lambda: found() or self._is_over, timeout_s)
            line = found()
            if line is None:
                raise AssertionError(f'"{expected}" was not said, but:\n{"".join(self._said)}')
            return line

    def end(self, number=signal.SIGINT):
        """All that it said, after Ctrl+C or another signal."""
        self.process.send_signal(number)
        self.process.wait(20)
        self._thread.join(20)
        return "".join(self._said)


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def simulate(self, *arguments):
        """A session with truth, as the document."""
        file = self.folder / "true.session.json"
        run("simulate", *arguments, "-o", file)
        return json.loads(file.read_text())

    def position_rms_mm(self, calibration):
        """Against the truth of that session."""
        said = run("evaluate", calibration, "--against", self.folder / "true.session.json", "--json")
        return json.loads(said)["against"][0]["position_rms_mm"]


def reading(time_s, cell, vector_g=(0, 0, 1)):
    """In a list, as those of a message."""
    return [Reading(round(time_s * 1e6), cell, tuple(vector_g))]


def held_and_turned(session, hold_s=4.0, turn_s=1.5):
    """(time in s, {cell: g}) of a part that is held in each pose of a session and turned in between."""
    poses = [{sample["cell"]: sample["mean_g"] for sample in pose["samples"]} for pose in session["poses"]]
    tick = 0
    for k, pose in enumerate(poses):
        for _ in range(int(hold_s * RATE_HZ)):
            # The last digit of a sensor: readings that never change are those of a broken one.
            yield tick / RATE_HZ, {cell: [value + 0.004 * ((tick * 7 + cell + axis) % 3 - 1) for axis, value in
                                          enumerate(vector)] for cell, vector in pose.items()}
            tick += 1
        for step in range(int(turn_s * RATE_HZ) if k + 1 < len(poses) else 0):
            share = (step + 1) / (turn_s * RATE_HZ + 1)
            turned = {}
            for cell, vector in pose.items():
                between = [(1 - share) * a + share * b for a, b in zip(vector, poses[k + 1][cell])]
                length = math.hypot(*between) or 1
                turned[cell] = [value / length for value in between]
            yield tick / RATE_HZ, turned
            tick += 1


def description(session, **others):
    """A description of the skin for hexoderm-ros, with a topic for each cell."""
    cells = [{**cell, "imu": f"/imu/cell{cell['id']}"} for cell in session["cells"]]
    return {"device": "skin of the test", "cells": cells, **others}


def imu(time_s, vector_g, seconds="secs", nanoseconds="nsecs", covariance=0.0, frame=""):
    """As a sensor_msgs/Imu of ROS 1, or with sec and nanosec of ROS 2."""
    whole = int(time_s)
    stamp = SimpleNamespace(**{seconds: whole, nanoseconds: round((time_s - whole) * 1e9)})
    x, y, z = (value * GRAVITY for value in vector_g)
    return SimpleNamespace(header=SimpleNamespace(stamp=stamp, frame_id=frame),
                           linear_acceleration=SimpleNamespace(x=x, y=y, z=z),
                           linear_acceleration_covariance=[covariance] + [0.0] * 8)
