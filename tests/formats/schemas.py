"""The JSON Schemas of resources/formats, as the tests need them."""

import copy
import dataclasses
import json
import pathlib

import jsonschema

DOCUMENTS = ("session", "calibration", "cell_model", "placements", "robot_truth", "manifest")

PARTS = "parts.schema.json#/$defs/"

# Parts that the page describes in a table of their own: what the page calls each, and its anchor.
TABLES = {
    PARTS + "message": ("message", "message"),
    PARTS + "figure": ("figure", "figure"),
    PARTS + "joints": ("joint angles", "joint-angles"),
    PARTS + "robot": ("robot", "robot"),
    PARTS + "decision": ("decision", "decision"),
    "cell_model.schema.json": ("cell model", "cell-model"),
}


# What the tables of keys on the page describe.
HEADINGS = {
    "Session": "session.schema.json",
    "Calibration": "calibration.schema.json",
    "Cell model": "cell_model.schema.json",
    "Placements": "placements.schema.json",
    "Truth of a simulated robot": "robot_truth.schema.json",
    "Manifest": "manifest.schema.json",
    "Message": PARTS + "message",
    "Figure": PARTS + "figure",
    "Joint angles": PARTS + "joint",
    "Robot": PARTS + "robot",
    "Decision": PARTS + "decision",
}


@dataclasses.dataclass
class Property:
    """A key that an object may have."""
    parent: dict  # the object's schema
    schema: dict
    file: str
    required: bool
    required_with: str  # another key that it is required with; empty: none


def folder_of(root):
    """The folder of the schemas."""
    return pathlib.Path(root) / "resources" / "formats"


class Schemas:
    """All schema files of a folder, by their names."""

    def __init__(self, folder):
        self.files = {path.name: json.loads(path.read_text(encoding="utf-8")) for path in folder.glob("*.schema.json")}

    def absolute(self, reference, file):
        """A reference with the name of the file that it points into."""
        return file + reference if reference.startswith("#") else reference

    def at(self, reference):
        """The schema at an absolute reference, and its file."""
        file, _, pointer = reference.partition("#")
        schema = self.files[file]
        for step in pointer.strip("/").split("/") if pointer else []:
            schema = schema[step]
        return schema, file

    def follow(self, schema, file):
        """The schema that a reference, if it is one, leads to."""
        while "$ref" in schema:
            schema, file = self.at(self.absolute(schema["$ref"], file))
        return schema, file

    def objects_at(self, schema, file, expand):
        """The schemas of the objects that stand at a schema, each with what is behind its path."""
        if not expand and "$ref" in schema and self.absolute(schema["$ref"], file) in TABLES:
            return
        schema, file = self.follow(schema, file)
        for option in schema.get("anyOf", []):
            yield from self.objects_at(option, file, expand)
        if schema.get("type") == "array" and "items" in schema and "prefixItems" not in schema:
            for behind, found, found_file in self.objects_at(schema["items"], file, expand):
                yield "[]" + behind, found, found_file
        if "properties" in schema:
            yield "", schema, file

    def properties(self, schema, file, expand=False):
        """All properties below a schema by their paths, `poses[].samples[].cell`. Parts that have a table of their own
        are looked into if `expand` says so, arguments of messages never."""
        found = {}
        for behind, at, at_file in self.objects_at(schema, file, expand):
            with_others = {key: other for other, keys in at.get("dependentRequired", {}).items() for key in keys}
            for key in at.get("then", {}).get("required", []):
                with_others[key] = at["if"]["required"][0]
            for key, value in at["properties"].items():
                path = behind + "." + key if behind else key
                found[path] = Property(at, value, at_file, key in at.get("required", []), with_others.get(key, ""))
                if value.get("items") == {"$ref": "#/$defs/argument"}:
                    continue
                for below, each in self.properties(value, at_file, expand).items():
                    found[path + ("" if below.startswith("[]") else ".") + below] = each
        return found

    def as_written(self, page):
        """The same with no other keys in any object than those that are named, and all those that the page calls written."""

        def close(value):
            if isinstance(value, list):
                for item in value:
                    close(item)
            if isinstance(value, dict):
                for item in value.values():
                    close(item)
                if value.get("type") == "object" and "properties" in value:
                    value["additionalProperties"] = False

        result = copy.copy(self)
        result.files = copy.deepcopy(self.files)
        close(result.files)
        for heading, rows in rows_by_heading(page).items():
            properties = result.properties(*result.at(HEADINGS[heading]))
            for path in (key.strip("`") for key, _, _, required, _ in rows if required == "written"):
                properties[path].parent.setdefault("required", []).append(path.rpartition(".")[2])
        return result

    def validator(self, document):
        """Of a document, by its name."""
        store = {"file:///" + name: schema for name, schema in self.files.items()}
        name = document + ".schema.json"
        resolver = jsonschema.RefResolver("file:///" + name, self.files[name], store=store)
        return jsonschema.Draft202012Validator(self.files[name], resolver=resolver)

    def words(self, schema, file):
        """A value as the page describes it."""
        if "$ref" in schema:
            reference = self.absolute(schema["$ref"], file)
            if reference in TABLES:
                return "[{}](#{})".format(*TABLES[reference])
            if reference.endswith("/finding_code"):
                return "code of a finding"
            if reference == PARTS + "argument":
                return "argument"
        schema, file = self.follow(schema, file)
        if "const" in schema:
            return said(schema["const"])
        if "enum" in schema:
            return either([said(value) for value in schema["enum"]])
        if "anyOf" in schema:
            return either([self.words(option, file) for option in schema["anyOf"]])
        kind = schema["type"]
        if isinstance(kind, list):
            return either([self.words({**schema, "type": each}, file) for each in kind])
        if kind == "array":
            return self.words_of_array(schema, file)
        if kind in ("integer", "number"):
            return ("whole number" if kind == "integer" else "number") + bound(schema, kind)
        if kind == "string":
            return "text, not empty" if schema.get("minLength") else "text"
        return {"boolean": "true or false", "object": "object", "null": "null"}[kind]

    def words_of_array(self, schema, file):
        """An array as the page describes it."""
        length = schema.get("minItems") if schema.get("minItems") == schema.get("maxItems") else None
        if "prefixItems" in schema:
            return f"{length} numbers"
        items = self.words(schema["items"], file)
        if items == "object":
            return "array"
        if items.startswith("["):
            return "array of " + items.replace("](", "s](", 1)
        if items == "argument":
            return "array of arguments"
        if items.startswith(("number", "whole number")):
            numbers = items.replace("number", "numbers", 1)
            return f"{length} {numbers}" if length else numbers
        return "array of " + items


def rows_by_heading(page):
    """The rows of each heading's table of keys, as (key, value, unit, required, meaning)."""
    tables = {}
    heading, within = "", False
    for line in page.splitlines():
        if line.startswith("#"):
            heading = line.lstrip("# ")
        if line == "| key | value | unit | required | meaning |":
            within = True
        elif within and line.startswith("| `"):
            tables.setdefault(heading, []).append([cell.strip() for cell in line[1:-1].split("|")])
        elif not line.startswith("| ---"):
            within = False
    return tables


def said(value):
    """A value that stands for itself."""
    return f'`"{value}"`' if isinstance(value, str) else "null" if value is None else str(value)


def either(options):
    """Options in a row."""
    return ", ".join(options[:-1]) + " or " + options[-1] if len(options) > 1 else options[0]


def bound(schema, kind):
    """The end of the page's words for a number's least value. Whole numbers are 0 or more, as the page says of all."""
    if "exclusiveMinimum" in schema or schema.get("minimum", 0) > 0:
        return " > 0"
    return " >= 0" if kind == "number" and schema.get("minimum") == 0 else ""
