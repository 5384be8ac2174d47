#!/usr/bin/env python3
"""What the programs write is as the schemas say, has no key that they don't name, and has all keys that the page says are
always written. The sessions of the tests and of the reference data are as the schemas say, too.

Usage: written_test.py ROOT HEXODERM_CLI REFERENCE_DATA
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from full_documents import full_documents
from schemas import DOCUMENTS, Schemas, folder_of

REFERENCE = pathlib.Path(sys.argv.pop(3))
CLI = sys.argv.pop(2)
ROOT = pathlib.Path(sys.argv.pop(1)).resolve()

# Arguments of simulate (patches, surfaces, what holds the skin, faults of cells, links and the whole skin), and those of solve
# by its session.
SESSIONS = {
    "plain": ("--poses 3", ["", "--solver tree", "--solver tree --centre off --support-axes off --class-threshold 1",
                             "--gap-model arc --without 3 --without 9", "--gap-model pivot --weights residual"]),
    "no_poses": ("--poses 0", [""]),
    "ideal": ("--ideal --poses 2", ["", "--solver tree"]),
    "ring": ("--patch ring12:closed --poses 3 --link-law surface", [""]),
    "sheet": ("--patch sheet:3x4 --surface sphere:r=0.1 --poses 2 --samples 1", [""]),
    "shaken": ("--motion robot --poses 2", [""]),
    "own_model": ("--cell-model own.json --poses 3 --patch sheet:2x2", [""]),
    "cells": ("--poses 4 --fault dead:2 --fault stuck:3 --fault saturated:4"
              " --fault noisy:5 --fault wrong-gain:6 --fault no-samples:7 --fault yawed:8 --fault reglued:9", ["", "--solver tree"]),
    "links": ("--poses 4 --fault cable:5:4 --fault joint:10:2 --fault wrong-port:3:1", ["", "--solver tree"]),
    "axes": ("--poses 4 --fault axes-permuted", [""]),
    "shuffled": ("--poses 4 --fault shuffled", [""]),
    "robot": ("--robot demo --poses 5", [""]),
    "motors": ("--robot demo --poses 3 --base motors", ["--solver tree"]),
    "hand": ("--robot demo --poses 3 --base hand", [""]),
}


class Written(unittest.TestCase):
    """Files beside the schemas."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        schemas = Schemas(folder_of(ROOT))
        cls.open_to_others = {name: schemas.validator(name) for name in DOCUMENTS}
        cls.page = (folder_of(ROOT) / "README.md").read_text(encoding="utf-8")
        cls.written = {name: schemas.as_written(cls.page).validator(name) for name in DOCUMENTS}
        cls.full = full_documents(ROOT, CLI)
        for name, document in cls.full.items():
            if name == "calibration":
                for cell in document["patches"][0]["cells"]:
                    cell.pop("path", None)  # of version 1
            ending = "json" if name == "cell_model" else name + ".json"
            (cls.folder / f"full.{ending}").write_text(json.dumps(document), encoding="utf-8")
        (cls.folder / "own.json").write_text(json.dumps(cls.full["cell_model"]), encoding="utf-8")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def run_cli(self, arguments, codes=(0, 1)):
        """Exit code 1 says that a result is not good enough; it is written all the same."""
        done = subprocess.run([CLI, *arguments.split(), "--quiet"], cwd=self.folder, capture_output=True, text=True,
                              check=False)
        self.assertIn(done.returncode, codes, f"{arguments}: {done.stderr}")
        return done.stdout

    def load(self, name):
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def assert_valid(self, validators, name, document):
        errors = [f"{error.json_path}: {error.message[:300]}" for error in validators[name].iter_errors(document)]
        self.assertEqual(errors[:5], [])

    def assert_written(self, name, file):
        self.assert_valid(self.written, name, self.load(file))

    def test_sessions_and_calibrations(self):
        codes = set()
        for name, (arguments, solves) in SESSIONS.items():
            with self.subTest(simulate=arguments):
                self.run_cli(f"simulate {arguments} -o {name}.session.json")
                self.assert_written("session", f"{name}.session.json")
                if "--robot" in arguments:
                    self.assert_written("robot_truth", f"{name}.truth.json")
            for k, options in enumerate(solves):
                with self.subTest(simulate=arguments, solve=options):
                    file = f"{name}{k}.calibration.json"
                    self.run_cli(f"solve {name}.session.json {options} -o {file}")
                    self.assert_written("calibration", file)
                    codes |= {finding["code"] for finding in self.load(file)["findings"]}
        self.assertGreater(len(codes), 10)

    def test_every_key_is_written_again(self):
        """The full session through a journal, and the full calibration."""
        self.run_cli("convert full.session.json -o full.hexo")
        self.run_cli("convert full.hexo -o again.session.json")
        again = self.load("again.session.json")
        self.assertEqual(again, self.full["session"])
        self.assert_written("session", "again.session.json")
        self.run_cli("convert full.calibration.json -o again.calibration.json")
        self.assert_written("calibration", "again.calibration.json")
        # Digits of angles may differ in the last place.
        self.assertEqual(json.dumps(self.load("again.calibration.json")).count('"'),
                         json.dumps(self.full["calibration"]).count('"'))
        self.run_cli("solve full.hexo -o placed.calibration.json")
        self.assert_written("calibration", "placed.calibration.json")

    def test_a_capture_and_a_model_with_estimated_sensors(self):
        self.run_cli("simulate --poses 6 --patch sheet:2x2 -o sensors.session.json")
        self.run_cli("sensors sensors.session.json -o estimated.json")
        self.assert_written("cell_model", "estimated.json")
        self.run_cli("capture --source sim:sheet:2x2 --auto --poses 1 -o live.hexo")
        self.run_cli("convert live.hexo -o live.session.json")
        self.assert_written("session", "live.session.json")

    def test_imports_of_tum_files(self):
        for source in (ROOT / "tests/data/two_patches.tum.xml", REFERENCE / "real/tum_skin_config.xml"):
            if source.exists():
                with self.subTest(source.name):
                    self.run_cli(f"convert {source} -o tum.calibration.json")
                    self.assert_written("calibration", "tum.calibration.json")
                    self.run_cli(f"convert {source} -o tum.session.json")
                    self.assert_written("session", "tum.session.json")

    def test_placements(self):
        self.run_cli("simulate --robot demo --poses 4 -o worn.session.json")
        self.run_cli("place worn.session.json --robot demo --link forearm --patch 18 --rotation links"
                     " -o worn.placements.json")
        self.assert_written("placements", "worn.placements.json")

    def test_manifests(self):
        self.run_cli("simulate --robot demo --poses 3 -o exported.session.json")
        self.run_cli("solve exported.session.json -o exported.calibration.json")
        every = "dot,ply,stl,vtp,urdf,tf-ros1,tf-ros2,tf-yaml,tum,icub,skinware,obj,gltf,sdf,mjcf"
        self.run_cli(f"export exported.calibration.json --to {every} -o exported")
        robot = ROOT / "resources/robot/demo_arm.urdf"
        self.run_cli(f"export exported.calibration.json --to {every},robot-urdf --robot {robot}"
                     " --place 1@forearm:0.02,0,0.1,0,1.5708,0 -o placed")
        self.run_cli("export full.calibration.json --to csv,urdf -o full")
        names = set()
        for folder in ("exported", "placed", "full"):
            self.assert_written("manifest", f"{folder}/manifest.json")
            names |= {key for file in self.load(f"{folder}/manifest.json")["files"] for key in file}
        self.assertEqual(names, set(self.written["manifest"].schema["properties"]["files"]["items"]["properties"]))

    def test_the_small_session_of_the_page(self):
        text = re.search(r"^```json\n(.*?)^```$", self.page, re.DOTALL | re.MULTILINE)[1]
        (self.folder / "small.session.json").write_text(text, encoding="utf-8")
        self.assert_written("session", "small.session.json")
        self.run_cli("solve small.session.json -o small.calibration.json")
        self.assertEqual(len(self.load("small.calibration.json")["patches"][0]["cells"]), 2)
        self.assertEqual({finding["severity"] for finding in self.load("small.calibration.json")["findings"]}, set())

    def test_sessions_and_models_that_others_wrote(self):
        sessions = [*(ROOT / "tests/data").rglob("*.session.json"), *REFERENCE.rglob("*.session.json")]
        self.assertTrue(sessions)
        for path in sessions:
            with self.subTest(path.name):
                self.assert_valid(self.open_to_others, "session", json.loads(path.read_text(encoding="utf-8")))
        for path in (ROOT / "resources/cell_models").glob("*.json"):
            self.assert_valid(self.open_to_others, "cell_model", json.loads(path.read_text(encoding="utf-8")))

    def test_table_of_joint_angles(self):
        self.run_cli("simulate --robot demo --poses 2 -o joints.session.json")
        title, *lines = (self.folder / "joints.joints.csv").read_text(encoding="utf-8").splitlines()
        self.assertRegex(title, r"^pose(,\w+\[(rad|m)\])+$")
        self.assertEqual(len(lines), 2)
        for line in lines:
            self.assertTrue(re.fullmatch(r"\d+(,-?[\d.e-]+)+", line), line)


if __name__ == "__main__":
    unittest.main()
