"""Exports are those of the command line."""

import os
import pathlib
import re
import unittest

import hexoderm
import numpy as np
from program import InFolder

# Formats that need nothing else, and are one file.
FORMATS = ("dot", "ply", "stl", "vtp", "urdf", "tf-ros1", "tf-ros2", "tf-yaml", "tum", "icub", "skinware", "obj",
           "gltf", "sdf", "mjcf")


class Exports(InFolder):
    def setUp(self):
        super().setUp()
        self.calibration = hexoderm.solve(hexoderm.simulate(poses=3))
        self.file = self.folder / "s.calibration.json"
        self.calibration.write(self.file)

    def test_every_format_is_known(self):
        self.assertEqual(set(hexoderm.export_formats()), {*FORMATS, "csv", "robot-urdf"})
        self.assertIn("model_name", hexoderm.export_options())

    def test_single_files(self):
        calibration = hexoderm.read_calibration(self.file)
        for name in FORMATS:
            with self.subTest(format=name):
                self.run_well("export", self.file, "--to", name, "-o", self.folder / "cli")
                exported = calibration.export(name, self.folder / "own")
                self.assertEqual([str(file) for file in exported.files], [str(self.folder / "own")])
                self.assertEqual((self.folder / "own").read_bytes(), (self.folder / "cli").read_bytes())

    def test_options_reach_the_format(self):
        calibration = hexoderm.read_calibration(self.file)
        self.run_well("export", self.file, "--to", "urdf", "--model-name", "arm", "--links", "patch", "--place",
                      "elbow:0.1,0,0.2,0,0,0", "-o", self.folder / "cli.urdf")
        place = hexoderm.PatchOnLink(calibration.patches[0].origin, "elbow", [0.1, 0, 0.2], np.eye(3))
        calibration.export("urdf", self.folder / "own.urdf", model_name="arm", links="patch", placements=[place])
        self.assertEqual((self.folder / "own.urdf").read_bytes(), (self.folder / "cli.urdf").read_bytes())
        self.assertIn(b"elbow", (self.folder / "own.urdf").read_bytes())
        with self.assertRaisesRegex(hexoderm.InvalidArgument, "stl_unit: expected one of mm, m, found \"inch\""):
            calibration.export("stl", self.folder / "x.stl", stl_unit="inch")
        with self.assertRaisesRegex(hexoderm.InvalidArgument, "colour: is no option of an export, expected one of "):
            calibration.export("stl", self.folder / "x.stl", colour="red")

    def test_an_option_of_another_format_is_refused(self):
        with self.assertRaisesRegex(hexoderm.InvalidArgument, "stl_unit: is an option of stl, found urdf, ply"):
            self.calibration.export(["urdf", "ply"], self.folder / "x", stl_unit="m")
        self.calibration.export(["urdf", "stl"], self.folder / "x", stl_unit="m")

    def test_tables_are_a_folder(self):
        with self.assertRaisesRegex(hexoderm.InvalidArgument, "path: expected a folder, or an archive"):
            self.calibration.export("csv", self.folder / "cells.csv")
        self.assertFalse((self.folder / "cells.csv").exists())

    def test_every_column_of_the_tables_is_on_the_page_of_the_formats(self):
        page = (pathlib.Path(os.environ["HEXODERM_SOURCE_DIR"]) / "resources/formats/README.md").read_text("utf-8")
        documented = {}
        for names, files in re.findall(r"^\| ((?:`\w+`(?:, )?)+) \| ((?:`\w+\.csv`(?:, )?)+) \|", page, re.MULTILINE):
            for file in re.findall(r"`(\w+\.csv)`", files):
                documented.setdefault(file, set()).update(re.findall(r"`(\w+)`", names))
        tables = [file for file in self.calibration.export("csv", self.folder / "tables").files if file.suffix == ".csv"]
        self.assertEqual(set(documented), {file.name for file in tables})
        self.assertIn("covariances", hexoderm.export_formats()["csv"])
        for file in tables:
            columns = set(file.read_text().split("\n", 1)[0].split(","))
            self.assertLessEqual(documented[file.name], columns, file.name)
            # Those that there are many of, of which one stands for the others.
            others = {name for name in columns - documented[file.name]
                      if not re.fullmatch(r"pose\d+_deg|cov_r?[xyz]_r?[xyz]_(m2|m_rad|rad2)", name)}
            self.assertEqual(others, set(), file.name)

    def test_several_formats(self):
        exported = self.calibration.export(["urdf", "csv"], self.folder / "all")
        names = {file.name for file in exported.files}
        self.assertTrue({"skin.urdf", "manifest.json"} <= names, names)
        self.assertTrue(all(file.is_file() for file in exported.files))
        self.assertTrue(any("uncertaint" in remark for remark in exported.remarks), exported.remarks)
        archive = self.calibration.export(["urdf", "csv"], self.folder / "all.zip")
        self.assertEqual([file.name for file in archive.files], ["all.zip"])

    def test_patches_that_are_left_out_are_named(self):
        session = hexoderm.simulate(poses=3)
        cell, port, other, other_port = map(int, session.links[0])
        session.set_link_muted((cell, port), (other, other_port), True)
        calibration = hexoderm.solve(session)
        remarks = calibration.export("ply", self.folder / "a.ply").remarks
        self.assertTrue(remarks[0].startswith("Not in the file: "), remarks)
