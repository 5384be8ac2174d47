"""The description of a skin whose readings are on ROS topics: its cells, their links, and the topic of each cell."""

import contextlib
import difflib
import json
import pathlib
from dataclasses import dataclass, field

from hexoderm_ros.errors import InputError

BUILT_IN_MODELS = ("hex-bma150",)  # those of Hexoderm
CELL_KEYS = ("id", "ports", "body_part", "imu", "frame_id")
PORT_KEYS = ("port", "cell", "cell_port")
CELL_DATA_KEYS = ("topic", "array", "cell", "acceleration", "type")
OWN_KEYS = ("device", "cell_model", "cells", "cell_data")
# A session can be a description once its topics are added; what else it holds is not looked at.
SESSION_KEYS = ("format", "version", "description", "description_message", "poses", "muted_links", "robot", "placements",
                "truth")


class SkinError(InputError):
    """Of the description of a skin."""


@dataclass(frozen=True)
class CellData:
    """A topic whose messages have the readings of several cells, found by the names of their fields. Names can be paths
    with dots."""

    topic: str
    array: str = ""  # of the message; without a name it is "data", and a message without that is a single cell
    cell: str = "cellId"
    acceleration: str = "acc"  # x, y, z in g
    type: str = ""  # needed by ROS 2 alone, "package/msg/Name"


@dataclass(frozen=True)
class Skin:
    device: str
    cell_model: str  # a built-in name, or the text of a JSON file
    cells: tuple  # as in the message Topology
    imus: dict = field(default_factory=dict)  # topic of sensor_msgs/Imu to the cell of each frame_id; "": whatever it is
    cell_data: tuple = ()

    @property
    def ids(self):
        return frozenset(cell["id"] for cell in self.cells)

    @property
    def cells_of_topics(self):
        """For each topic the cells whose readings may be on it."""
        topics = {topic: set(cells.values()) for topic, cells in self.imus.items()}
        others = self.ids.difference(*topics.values()) or self.ids
        topics.update({names.topic: set(others) for names in self.cell_data})
        return topics


def _whole(value, what, least):
    if isinstance(value, int) and not isinstance(value, bool) and least <= value < 2**32:
        return value
    raise SkinError(f"{what}: expected a whole number from {least}, found {json.dumps(value)}")


def _text(value, what):
    if isinstance(value, str) and value:
        return value
    raise SkinError(f"{what}: expected a text, found {json.dumps(value)}")


def _of_kind(value, kind, what):
    if isinstance(value, kind):
        return value
    raise SkinError(f"{what}: expected {'an object' if kind is dict else 'a list'}, found {json.dumps(value)}")


def _meant(key, keys):
    found = difflib.get_close_matches(key.lower(), keys, 1, 0.7)
    return found[0] if found else None


def _known_keys(document, keys, what):
    for key in document:
        if key not in keys:
            meant = _meant(key, keys)
            raise SkinError(f'{what}: "{key}" is not known, ' + (f'did you mean "{meant}"?' if meant else
                                                                 f"expected {', '.join(keys[:-1])} or {keys[-1]}"))


def _port(port, what):
    _known_keys(_of_kind(port, dict, what), PORT_KEYS, what)
    result = {"port": _whole(port.get("port"), f"{what}.port", 0), "cell": _whole(port.get("cell"), f"{what}.cell", 0)}
    if port.get("cell_port") is not None:
        result["cell_port"] = _whole(port["cell_port"], f"{what}.cell_port", 0)
    return result


def _cell(cell, what):
    _known_keys(_of_kind(cell, dict, what), CELL_KEYS, what)
    ports = _of_kind(cell.get("ports", []), list, f"{what}.ports")
    result = {"id": _whole(cell.get("id"), f"{what}.id", 1),
              "ports": [_port(port, f"{what}.ports[{k}]") for k, port in enumerate(ports)]}
    if cell.get("body_part"):
        result["body_part"] = _text(cell["body_part"], f"{what}.body_part")
    return result


def _add_imu(cell, what, imus):
    """The topic of a cell, which it may share with others whose messages have another frame_id."""
    frame = _text(cell["frame_id"], f"{what}.frame_id").lstrip("/") if cell.get("frame_id") is not None else ""
    if cell.get("imu") is None:
        if frame:
            raise SkinError(f'{what}.frame_id: expected the topic too, as "imu"')
        return
    topic = _text(cell["imu"], f"{what}.imu")
    others = imus.setdefault(topic, {})
    if frame in others or (others and "" in (frame, *others)):
        other = others.get(frame, next(iter(others.values())))
        if frame and frame in others:
            raise SkinError(f'{what}.frame_id: "{frame}" on {topic} is that of cell {other} already')
        raise SkinError(f"{what}.imu: {topic} is that of cell {other} already; cells that share a topic are told apart by "
                        'a "frame_id" of each')
    others[frame] = cell["id"]


def _cell_data(entry, what):
    _known_keys(_of_kind(entry, dict, what), CELL_DATA_KEYS, what)
    _text(entry.get("topic"), f"{what}.topic")
    return CellData(**{key: _text(value, f"{what}.{key}") for key, value in entry.items()})


def _model(model, folder):
    """The name of a built-in model, or the text of one."""
    if isinstance(model, dict):  # that of a session
        return json.dumps(model)
    if not _text(model, "cell_model").endswith(".json"):
        if model in BUILT_IN_MODELS:
            return model
        raise SkinError(f'cell_model: "{model}" is not known, expected {", ".join(BUILT_IN_MODELS)} or the name of a JSON '
                        "file")
    try:
        text = (folder / model).read_text(encoding="utf-8")
        json.loads(text)
    except OSError as error:
        raise SkinError(f"cell_model: {folder / model}: cannot be read: {error.strerror}") from error
    except ValueError as error:
        raise SkinError(f"cell_model: {folder / model}: is no JSON: {error}") from error
    return text


def skin_from(document, folder=pathlib.Path()):
    """The skin of a JSON document. The file of a cell model is looked for beside it, in `folder`."""
    for key in _of_kind(document, dict, "skin"):
        # Newer programs may have added keys to a session.
        if key not in OWN_KEYS + SESSION_KEYS and _meant(key, OWN_KEYS):
            raise SkinError(f'skin: "{key}" is not known, did you mean "{_meant(key, OWN_KEYS)}"?')
    data = document.get("cell_data", [])
    data = tuple(_cell_data(entry, "cell_data") for entry in (data if isinstance(data, list) else [data]))
    cells, imus = [], {}
    for k, cell in enumerate(_of_kind(document.get("cells"), list, "cells")):
        what = f"cells[{k}]"
        cells.append(_cell(cell, what))
        number = cells[-1]["id"]
        if number in {other["id"] for other in cells[:-1]}:
            raise SkinError(f"{what}.id: cell {number} is named twice")
        _add_imu(cell, what, imus)
        if cell.get("imu") is None and not data:
            raise SkinError(f'{what}: nothing says where the readings of cell {number} are, expected an "imu", or '
                            '"cell_data" beside the cells')
    if not cells:
        raise SkinError("cells: expected one at least")
    return Skin(str(document.get("device", "skin on ROS topics")), _model(document.get("cell_model", "hex-bma150"), folder),
                tuple(cells), imus, data)


@contextlib.contextmanager
def errors_of(path):
    """A SkinError names the file."""
    try:
        yield
    except SkinError as error:
        raise SkinError(f"{path}: {error}") from error


def read_skin(path):
    """Throws SkinError, which names the file."""
    path = pathlib.Path(path)
    with errors_of(path):
        try:
            return skin_from(json.loads(path.read_text(encoding="utf-8")), path.parent)
        except OSError as error:
            raise SkinError(f"cannot be read: {error.strerror}") from error
        except ValueError as error:
            raise SkinError(f"is no JSON: {error}") from error
