#!/usr/bin/env python3
"""The page of the formats and the schemas beside it say the same, key by key.

Usage: page_test.py ROOT
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import jsonschema

from schemas import DOCUMENTS, HEADINGS, Schemas, folder_of, rows_by_heading

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
FOLDER = folder_of(ROOT)


class Page(unittest.TestCase):
    """The page beside the schemas."""

    @classmethod
    def setUpClass(cls):
        cls.page = (FOLDER / "README.md").read_text(encoding="utf-8")
        cls.schemas = Schemas(FOLDER)
        cls.tables = rows_by_heading(cls.page)

    def test_schemas_are_schemas(self):
        self.assertEqual(set(self.schemas.files), {name + ".schema.json" for name in (*DOCUMENTS, "parts")})
        for name, schema in self.schemas.files.items():
            with self.subTest(name):
                self.assertEqual(schema["$schema"], "https://json-schema.org/draft/2020-12/schema")
                jsonschema.Draft202012Validator.check_schema(schema)
                self.assertIn(f"`{name}`", self.page)

    def test_tables_are_those_of_the_schemas(self):
        self.assertEqual(set(self.tables), set(HEADINGS))

    def test_every_key_is_on_the_page_with_its_value_and_whether_it_is_required(self):
        for heading, reference in HEADINGS.items():
            documented = {}
            for key, value, unit, required, _ in self.tables[heading]:
                self.assertNotIn(key, documented, heading)
                documented[key.strip("`")] = (value, required)
                if re.search(r"(?<!whole )numbers?\b", value):
                    self.assertTrue(unit, f"{heading}: {key} has no unit")
            schema, file = self.schemas.at(reference)
            properties = self.schemas.properties(schema, file)
            self.assertEqual(list(documented), list(properties), heading)
            for path, each in properties.items():
                with self.subTest(heading=heading, key=path):
                    value, required = documented[path]
                    self.assertEqual(value, self.schemas.words(each.schema, each.file))
                    if each.required:
                        self.assertEqual(required, "yes")
                    elif each.required_with:
                        self.assertEqual(required, f"with `{each.required_with}`")
                    else:
                        self.assertIn(required, ("written", "no", "read"))

    def test_variances_are_the_diagonal_of_the_page(self):
        covariance = self.schemas.files["parts.schema.json"]["$defs"]["covariance_t_r"]["prefixItems"]
        variances = [k for k, item in enumerate(covariance, 1) if item["$ref"].endswith("/variance")]
        axes = ("tx", "ty", "tz", "rx", "ry", "rz")
        numbers = []
        for k, axis in enumerate(axes):
            row = re.search(rf"^  \| {axis} \|(.*)\|$", self.page, re.MULTILINE)[1].split("|")
            self.assertEqual([cell.strip() for cell in row[:k]], [""] * k)
            numbers.append([int(cell) for cell in row[k:]])
        self.assertEqual([row[0] for row in numbers], variances)
        self.assertEqual([n for row in numbers for n in row], list(range(1, len(covariance) + 1)))

    def test_built_in_cell_models_are_those_that_there_are(self):
        named = self.schemas.files["session.schema.json"]["properties"]["cell_model"]["anyOf"][0]["enum"]
        self.assertEqual(named, sorted(path.stem for path in (ROOT / "resources/cell_models").glob("*.json")))

    def test_the_example_of_the_page_tells_right_from_wrong(self):
        code = re.search(r"^```python\n(.*?)^```$", self.page, re.DOTALL | re.MULTILINE)[1]
        right = json.loads((ROOT / "tests/data/three_cells.session.json").read_text(encoding="utf-8"))
        wrong = json.loads(json.dumps(right))
        del wrong["poses"][1]["samples"][0]["mean_g"]
        with tempfile.TemporaryDirectory() as folder:
            for document, said in ((right, ""), (wrong, "poses/1/samples/0 'mean_g' is a required property\n")):
                path = pathlib.Path(folder) / "s.json"
                path.write_text(json.dumps(document), encoding="utf-8")
                run = subprocess.run([sys.executable, "-c", code, path], cwd=FOLDER, capture_output=True, text=True,
                                     check=True)
                self.assertEqual(run.stdout, said)


if __name__ == "__main__":
    unittest.main()
