#!/usr/bin/env python3
"""Readers refuse what the schemas refuse, and take what they take, but for what a schema can't say.

Usage: readers_test.py ROOT HEXODERM_CLI DOCUMENT_READER
"""

import copy
import json
import math
import pathlib
import re
import subprocess
import sys
import unittest

from full_documents import full_documents
from schemas import Schemas, folder_of

READER = sys.argv.pop(3)
CLI = sys.argv.pop(2)
ROOT = pathlib.Path(sys.argv.pop(1)).resolve()

# Values that are put in the place of every key's own.
PROBES = (None, True, -1, 0, 1.5, 1e300, "", "?", [], [0], {}, [[]], [None], [{}], ["?"])

# What a schema can't say, by the end of a key's path: that numbers are a rotation, a unit vector or a covariance; that
# IDs name something of the same document, each once; that values of several keys agree; and how deep messages are.
BEYOND = re.compile(
    r"(^|[.\]_])(R|R_o_u|R_c_n|R_u|q_u_wxyz|q_o_u_wxyz|q_o_wxyz|cov_t_r|shape_cov_t_r|cov_g2|g_o|template|arguments"
    r"|predecessor|path|origin|origin_cell|from_cell|to_cell|source|source_port|target|target_port"
    r"|pose_residual_deg|(ports\[\]\.)?vector_m|forbidden_port_pairs|(shared_)?offset_sigma_g)$"
    r"|^(cell_model\.)?ports(\[\]\.port)?$|^patches(\[\]\.(id|cells\[\]\.id|cells|links))?$|^poses$")

# Optional keys that another one of a document relies on: each link's residuals are one for each of the poses.
JOINED = {("calibration", "poses")}


# Or what is said of an object as a whole, with the limit of a number in words.
OF_THE_WHOLE = r"|expected [a-z ]+ that makes? sense|expected a name and a folder"


def parents_of(document, path):
    """The objects of a document that may have the key at a path, and the key."""
    *steps, key = path.split(".")
    places = [document]
    for step in steps:
        name = step.rstrip("[]")
        places = [place[name] for place in places if isinstance(place, dict) and name in place]
        for _ in range(step.count("[]")):
            places = [item for place in places if isinstance(place, list) for item in place]
    return [place for place in places if isinstance(place, dict)], key


def named(path):
    """What a complaint about a key says of its place."""
    return "d.json: " + re.escape(path).replace(re.escape("[]"), r"\[\d+\]")


class Readers(unittest.TestCase):
    """The readers beside the schemas."""

    @classmethod
    def setUpClass(cls):
        cls.schemas = Schemas(folder_of(ROOT))
        cls.documents = full_documents(ROOT, CLI)
        cls.validators = {name: cls.schemas.validator(name) for name in cls.documents}
        cls.reader = subprocess.Popen([READER], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    @classmethod
    def tearDownClass(cls):
        cls.reader.stdin.close()
        cls.reader.stdout.close()
        cls.reader.wait()

    def read(self, request):
        """What the reader answers."""
        self.reader.stdin.write(json.dumps(request) + "\n")
        self.reader.stdin.flush()
        return json.loads(self.reader.stdout.readline())

    def complaint(self, name, document):
        """What the reader of a document says about one; None if it takes it."""
        return self.read({"as": name, "text": json.dumps(document)})

    def error(self, name, document):
        """What the schema of a document says about one; None if it takes it."""
        error = next(self.validators[name].iter_errors(document), None)
        return error and f"{error.json_path}: {error.message}"

    def places(self, name):
        """Each key of a format: its path, its property, and a copy of the document with an object that has it."""
        file = name + ".schema.json"
        for path, each in self.schemas.properties(self.schemas.files[file], file, expand=True).items():
            document = copy.deepcopy(self.documents[name])
            parents, key = parents_of(document, path)
            having = [parent for parent in parents if key in parent]
            self.assertTrue(having, f"{name}: the full document has no {path}")
            yield path, each, document, having[0], key

    def test_full_documents_are_taken_by_both(self):
        for name, document in self.documents.items():
            with self.subTest(name):
                self.assertIsNone(self.error(name, document))
                self.assertIsNone(self.complaint(name, document))

    def test_a_key_that_is_missing_or_null(self):
        count = 0
        for name in self.documents:
            for path, each, document, parent, key in self.places(name):
                with self.subTest(document=name, missing=path):
                    parent[key] = None
                    of_null = self.complaint(name, document)
                    del parent[key]
                    error, complaint = self.error(name, document), self.complaint(name, document)
                    self.assertEqual(error is not None, each.required or bool(each.required_with), error)
                    if (name, path) in JOINED:
                        continue
                    self.assertEqual(of_null is not None, error is not None, of_null)
                    self.assertEqual(complaint is not None, error is not None, complaint)
                    if complaint is not None:
                        self.assertRegex(complaint, "place" if each.required_with == "place" else named(path))
                    count += 1
        self.assertGreater(count, 250)

    def test_values_of_wrong_types_and_shapes(self):
        refused = taken = 0
        for name in self.documents:
            for path, each, document, parent, key in self.places(name):
                own = parent[key]
                probes = list(PROBES)
                if isinstance(own, list) and own:
                    probes += [own[:-1], own[:-1] + ["?"], own[:-1] + [None], own[:-1] + [[]]]
                    if not isinstance(own[0], dict):  # of objects each is there once
                        probes.append(own + own[-1:])
                if isinstance(own, (int, float)) and not isinstance(own, bool):
                    probes += [str(own), [own], -own - 1, 10_000_000 + own, own + 0.5]
                if isinstance(own, str):
                    probes += [own + "?", [own]]
                for probe in probes:
                    if probe is None and not each.required:
                        continue
                    parent[key] = probe
                    error, complaint = self.error(name, document), self.complaint(name, document)
                    with self.subTest(document=name, key=path, value=probe):
                        if error is not None:
                            self.assertIsNotNone(complaint, f"the schema says: {error}")
                            self.assertRegex(complaint, named(path) + OF_THE_WHOLE)
                            refused += 1
                        elif not BEYOND.search(path):
                            self.assertIsNone(complaint)
                            taken += 1
        self.assertGreater(refused, 3000)
        self.assertGreater(taken, 300)

    def test_a_key_that_nobody_knows(self):
        for name in self.documents:
            objects = {path.rpartition(".")[0] for path, *_ in self.places(name)}
            for at in objects:
                document = copy.deepcopy(self.documents[name])
                parents, key = parents_of(document, (at + "." if at else "") + "my_own_key")
                parents[0][key] = {"value": 1}
                with self.subTest(document=name, object=at):
                    error, complaint = self.error(name, document), self.complaint(name, document)
                    in_cell_model = name == "cell_model" or at.startswith("cell_model")
                    self.assertEqual(error is not None, in_cell_model, error)
                    self.assertEqual(complaint is not None, in_cell_model, complaint)

    def test_versions_that_are_read(self):
        for name, versions in (("session", 1), ("calibration", 2), ("placements", 1)):
            for version in range(0, 4):
                document = copy.deepcopy(self.documents[name])
                document["version"] = version
                with self.subTest(document=name, version=version):
                    read = 1 <= version <= versions
                    self.assertEqual(self.error(name, document) is None, read)
                    self.assertEqual(self.complaint(name, document) is None, read)

    def test_a_calibration_of_version_1(self):
        document = copy.deepcopy(self.documents["calibration"])
        document["version"] = 1
        for patch in document["patches"]:
            before = {cell["id"]: cell.pop("predecessor", None) for cell in patch["cells"]}
            for cell in patch["cells"]:
                path = [cell["id"]]
                while before[path[0]] is not None:
                    path.insert(0, before[path[0]])
                cell["path"] = path
        self.assertIsNone(self.error("calibration", document))
        self.assertIsNone(self.complaint("calibration", document))

    def test_the_example_and_the_units_of_joint_angles(self):
        page = (folder_of(ROOT) / "README.md").read_text(encoding="utf-8")
        section = page[page.index("## Table of joint angles"):]
        urdf = "<robot name='r'><link name='a'/><link name='b'/><link name='c'/><link name='d'/>"
        for name, kind, parent, child in (("elbow", "revolute", "a", "b"), ("wrist", "revolute", "b", "c"),
                                          ("lift", "prismatic", "c", "d")):
            urdf += (f"<joint name='{name}' type='{kind}'><parent link='{parent}'/><child link='{child}'/>"
                     "<axis xyz='0 0 1'/><limit lower='-4' upper='4' effort='1' velocity='1'/></joint>")
        urdf += "</robot>"

        def table(text):
            return self.read({"as": "joints", "text": text, "urdf": urdf})

        lines = re.findall(r"^    (.*)$", section, re.MULTILINE)
        rows = table("\n".join(lines) + "\n")
        self.assertEqual([row["pose"] for row in rows], [1, 2])
        self.assertAlmostEqual(rows[1]["angles"]["elbow"], math.radians(45))
        self.assertEqual(rows[1]["angles"]["lift"], 0.1)

        units = re.findall(r"^\| (`.*`) \| (joints that (?:turn|slide)|`time`) \| (.*) \|$", section, re.MULTILINE)
        names = {name: (of, float(eval(factor.replace("π", "math.pi")))) for names, of, factor in units
                 for name in re.findall(r"`([^`]*)`", names)}
        self.assertEqual(len(names), 11)
        for unit in (*names, "grad", "cm", "min", ""):
            for of, title in (("joints that turn", "elbow"), ("joints that slide", "lift"), ("`time`", "time")):
                titles = {"elbow": "elbow[rad]", "lift": "lift[m]", "time": "time[s]", title: f"{title}[{unit}]"}
                if not unit:
                    titles[title] = title
                with self.subTest(title=titles[title]):
                    rows = table(f"{titles['time']},wrist[rad],{titles['elbow']},{titles['lift']}\n2,0,2,2\n")
                    expected = names.get(unit, (None, None)) if unit or title != "time" else ("`time`", 1)
                    if expected[0] != of:
                        self.assertIsInstance(rows, str)
                        continue
                    self.assertIsInstance(rows, list, rows)
                    value = rows[0]["time_s"] if title == "time" else rows[0]["angles"][title]
                    self.assertAlmostEqual(value, 2 * expected[1], delta=1e-12)


if __name__ == "__main__":
    unittest.main()
