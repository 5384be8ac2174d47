"""The module and the command line make the same sessions and the same calibrations, to the last bit."""

import unittest

import hexoderm
from program import InFolder

# Sessions, and how each is solved.
SESSIONS = [
    (dict(poses=3, surface="cylinder:r=0.0501"), {}),
    (dict(poses=2, seed=2), {}),
    (dict(poses=1, seed=3), {}),
    (dict(poses=0), {}),
    (dict(poses=3, ideal=True), {}),
    (dict(patch="ring8", poses=4, seed=4), dict(gap_model="arc")),
    (dict(patch="ring12:closed", poses=3, link_law="surface"), dict(gap_model="pivot")),
    (dict(patch="sheet:1x1", poses=3), {}),
    (dict(patch="sheet:3x4", surface="sphere:r=0.1", poses=2, samples=1), {}),
    (dict(patch="sheet:6x6", surface="torus:R=0.3,r=0.1", poses=5, seed=7), dict(centre="on")),
    (dict(patch="sheet:10x10", surface="cone:r=0.2,angle=0.3", poses=6, seed=8), dict(support_axes="on")),
    (dict(patch="sheet:16x16", poses=6, seed=9), {}),
    (dict(poses=3, motion="robot", seed=10), {}),
    (dict(poses=4, seed=11, faults=["dead:2", "saturated:4", "noisy:5", "no-samples:7"]), dict(without=[9])),
    (dict(poses=4, seed=12, faults=["cable:5:4", "joint:10:2"]), {}),
    (dict(poses=4, seed=13, faults=["axes-permuted"]), {}),
    (dict(poses=3, seed=14, offset_sigma_g=0.03), dict(class_threshold=1.0)),
    (dict(poses=3, seed=15), dict(solver="tree", centre="off", support_axes="off")),
    (dict(patch="sheet:5x5", poses=4, seed=16), dict(solver="tree", weights="residual")),
    (dict(patch="ring31", poses=7, seed=17, samples=20), dict(without=[3, 4], gap_model="fit")),
]


def simulate_arguments(given):
    for name, value in given.items():
        if name == "ideal":
            yield "--ideal"
        elif name == "offset_sigma_g":
            yield from ("--offset-sigma", value * 1000)
        else:
            for each in value if name == "faults" else [value]:
                yield from ("--" + name.replace("_", "-").replace("faults", "fault"), each)


def solve_arguments(given):
    for name, value in given.items():
        for each in value if name == "without" else [value]:
            yield from ("--" + name.replace("_", "-"), each)


class SameNumbers(InFolder):
    def test_twenty_sessions(self):
        self.assertEqual(len(SESSIONS), 20)
        for number, (simulation, options) in enumerate(SESSIONS):
            with self.subTest(simulation=simulation, options=options):
                session_file = self.folder / f"{number}.session.json"
                calibration_file = self.folder / f"{number}.calibration.json"
                self.run_well("simulate", *simulate_arguments(simulation), "-o", session_file)
                self.run_well("solve", session_file, *solve_arguments(options), "-o", calibration_file)

                self.assertEqual(hexoderm.simulate(**simulation).to_json().encode(), session_file.read_bytes())
                session = hexoderm.read_session(session_file)
                calibration = hexoderm.solve(session, **options)
                self.assertEqual(calibration.to_json().encode(), calibration_file.read_bytes())
                calibration.write(self.folder / "own.json")
                self.assertEqual((self.folder / "own.json").read_bytes(), calibration_file.read_bytes())

    def test_a_robot(self):
        self.run_well("simulate", "--robot", "demo", "--poses", 5, "--seed", 3, "-o", self.folder / "r.session.json")
        session = hexoderm.simulate_robot(poses=5, seed=3)
        self.assertEqual(session.to_json().encode(), (self.folder / "r.session.json").read_bytes())

    def test_a_session_store(self):
        self.run_well("simulate", "--poses", 3, "-o", self.folder / "s.hexo")
        self.run_well("solve", self.folder / "s.hexo", "-o", self.folder / "s.json")
        calibration = hexoderm.solve(hexoderm.read_session(self.folder / "s.hexo"))
        self.assertEqual(calibration.to_json().encode(), (self.folder / "s.json").read_bytes())
