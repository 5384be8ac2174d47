#!/usr/bin/env python3
"""Checks that every source stands in a room that is known here and includes only what is before it, and no library that its
part of the project may not use (core/README.md).
A hall is a folder whose subfolders, its rooms, have an order. `a < {b, c} < d` says that a file of d may include those of
b, c and a; that one of b may include those of a, but none of c; and that rooms in one brace stay apart.

Every include in quotes is the path of a file in the tree: "hexoderm/..." lies under core/, all others under the root.

Usage: rooms.py ROOT   fails, naming file and line, for each violation
"""

import pathlib
import re
import sys

# The halls; a name such as main.cpp stands for the files with that stem at the root of the hall.
HALLS = {
    "": "core < {widgets, resources} < app < tests",
    "core/hexoderm": "base < {skin, robots} < device < session < solve < {mounting, io, sim} < capture",
    "core/hexoderm/device": "{sample_frame, ground_truth, protocol_violation} < {skin_source, pose_capture, cell_index} < gravity_accumulator"
                            " < {protocol_violation_log, plausibility, pose_average} < listening < skinwire < sources",
    "core/hexoderm/solve": "result < {tree, sparse} < global < faults < checks < metrics < estimate < explain < {solve}"
                           " < reconstructor < {hold_out, reconstruction_worker, sensor_statistics}",
    "core/hexoderm/mounting": "parts < attachment < place",
    "widgets": "style < words < {controls, coloring} < {tables, capture, graph, plot, scene} < {verify, patch} < robot",
    "app": "{cli, emulator, python, window}",
    "app/window": "{files, toolkit} < {settings, report} < session < {guide, dialogs, log} < views < presenters"
                  " < main_window < main",
}

# Folders with sources that are no part of the program's own tree.
SKIPPED = {"build", "out"}

INCLUDE = re.compile(r'\s*#\s*include\s*(([<"])([^">]*)[">])')

# Libraries that sources at a path may not include.
GUI = r'Q[A-Z][A-Za-z]*[>"/]|Qt[A-Z5-9]|vtk'
FOREIGN = (
    (r"(core|app/cli|app/emulator|app/python)/", GUI, "core, the programs without a window and Python have neither Qt nor VTK"),
    (r"widgets/", r"ceres/|sqlite3|boost/|google/protobuf|nlohmann/|pugixml|assimp/|zip\.h|urdf|kdl", "widgets show what core computed"),
    (r"core/.*\.h$", r"ceres/|sqlite3|google/protobuf|pugixml|assimp/|openssl/|CLI/|fmt/|zip\.h|urdf_|kdl|console_bridge",
     "headers of core carry no third-party types but Eigen's"),
    (r"(core|widgets|app/cli|app/emulator|app/window)/", r"pybind11|Python\.h|numpy", "only the Python module knows Python"),
)
def levels(order):
    """The level of each room in an order: 0 for those that include no other."""
    result = {}
    for level, names in enumerate(order.split("<")):
        for name in names.strip(" {}").split(","):
            result[name.strip()] = level
    return result


def sources(root):
    """All sources, as paths from the root."""
    for path in sorted(root.rglob("*")):
        relative = path.relative_to(root)
        if relative.parts[0] in SKIPPED or relative.parts[0].startswith("."):
            continue
        if path.name.endswith((".h", ".cpp", ".h.in", ".cpp.in")) and path.is_file():
            yield relative


def includes(path):
    """The line number of each include, its name as it is written, and without quotes; empty, where it has none."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match[1], match[3] if match[2] == '"' else ""
def target_of(name):
    """The path from the root of an included file."""
    return pathlib.PurePosixPath("core", name) if name.startswith("hexoderm/") else pathlib.PurePosixPath(name)


def is_in_tree(root, source, name):
    """Whether an include names a file of the tree by its full path, or one that is generated."""
    if name.startswith("core/") or any(part in ("", ".", "..") for part in name.split("/")):
        return False
    if name == source.stem + ".moc":
        return True  # Qt's moc writes it, for a class that is defined in a source
    path = root / target_of(name)
    if name.endswith(".pb.h"):
        path = path.with_name(path.name.replace(".pb.h", ".proto"))
    return "/" in name and path.is_file()


def room_of(hall, path):
    """The room of a file in a hall, the stem of one that stands at the hall's root, and None outside the hall."""
    rest = path.parts[len(pathlib.PurePosixPath(hall).parts):] if hall else path.parts
    if hall and not str(path).startswith(hall + "/"):
        return None
    return rest[0] if len(rest) > 1 else rest[0].split(".")[0]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1])
    order = {hall: levels(text) for hall, text in HALLS.items()}
    violations = []
    for source in sources(root):
        for hall, level in order.items():
            room = room_of(hall, source)
            if room is not None and room not in level:
                violations.append(f"{source} stands in no room of {hall or 'the project'}: {HALLS[hall]}")
        for number, written, name in includes(root / source):
            for where, libraries, why in FOREIGN:
                if re.match(where, str(source)) and re.match(f'[<"]({libraries})', written):
                    violations.append(f"{source}:{number}:{written} -- {why}")
            if not name:
                continue
            if not is_in_tree(root, source, name):
                violations.append(f'{source}:{number}:"{name}" -- no path in the tree; write "hexoderm/..." or'
                                  ' the path from the root')
            for hall, level in order.items():
                room, target = room_of(hall, source), room_of(hall, target_of(name))
                if room in level and target in level and room != target and level[target] >= level[room]:
                    violations.append(f'{source}:{number}:"{name}" -- {room} may not include {target} in'
                                      f" {hall or 'the project'}: {HALLS[hall]}")
    if violations:
        sys.exit("\n".join(violations))


if __name__ == "__main__":
    main()
