"""A thousand solutions leave nothing behind: the memory of the process stays as it is."""

import gc
import os
import unittest

import hexoderm

SOLVED_BEFORE = 200  # until the allocator has what it needs
SOLVED = 1000
MOST_GROWTH_BYTES = 1 << 20


def resident_bytes():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def use(session):
    """What a script does with a session: everything that crosses from C++ to Python."""
    calibration = hexoderm.solve(session)
    patch = calibration.patches[0]
    return (patch.positions, patch.rotations, patch.covariances, patch.covariance(1, 2), patch.links, patch.sensors(1),
            calibration.findings, calibration.verdict.reason, calibration.to_json(), session.readings, calibration)


class Memory(unittest.TestCase):
    def test_a_thousand_solutions(self):
        session = hexoderm.simulate(poses=3)
        for _ in range(SOLVED_BEFORE):
            use(session)
        before = resident_bytes()
        for _ in range(SOLVED):
            use(session)
        gc.collect()
        growth = resident_bytes() - before
        print(f"{SOLVED} solutions: {before / 2**20:.1f} MiB before, {growth / 1024:+.0f} KiB")
        self.assertLess(growth, MOST_GROWTH_BYTES)
