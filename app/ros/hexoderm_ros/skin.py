"""The description of a skin whose readings are on ROS topics: its cells, their links, and the topic of each cell."""

import json
import pathlib
from dataclasses import dataclass, field


class SkinError(Exception):
    """A description is not as it should be; the text says where, and what was expected."""


@dataclass(frozen=True)
class CellData:
    """A topic whose messages have the readings of several cells, found by the names of their fields."""

    topic: str
    array: str = "data"  # of the message; one without it is a single cell
    cell: str = "cellId"
    acceleration: str = "acc"  # x, y, z in g
    type: str = ""  # needed by ROS 2 alone, "package/msg/Name"


@dataclass(frozen=True)
class Skin:
    device: str
    cell_model: str  # a built-in name, or the text of a JSON file
    cells: tuple  # as in the message Topology
    imus: dict = field(default_factory=dict)  # topic of sensor_msgs/Imu to the cell's ID
    cell_data: tuple = ()

    @property
    def ids(self):
        return frozenset(cell["id"] for cell in self.cells)


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


def _port(port, what):
    _of_kind(port, dict, what)
    result = {"port": _whole(port.get("port"), f"{what}.port", 0), "cell": _whole(port.get("cell"), f"{what}.cell", 0)}
    if port.get("cell_port") is not None:
        result["cell_port"] = _whole(port["cell_port"], f"{what}.cell_port", 0)
    return result


def _cell(cell, what):
    _of_kind(cell, dict, what)
    ports = _of_kind(cell.get("ports", []), list, f"{what}.ports")
    result = {"id": _whole(cell.get("id"), f"{what}.id", 1),
              "ports": [_port(port, f"{what}.ports[{k}]") for k, port in enumerate(ports)]}
    if cell.get("body_part"):
        result["body_part"] = _text(cell["body_part"], f"{what}.body_part")
    return result


def _cell_data(entry, what):
    _of_kind(entry, dict, what)
    unknown = set(entry) - {"topic", "array", "cell", "acceleration", "type"}
    if unknown:
        raise SkinError(f"{what}: {sorted(unknown)[0]} is not known, expected topic, array, cell, acceleration or type")
    _text(entry.get("topic"), f"{what}.topic")
    return CellData(**{key: _text(value, f"{what}.{key}") for key, value in entry.items()})


def skin_from(document, folder=pathlib.Path()):
    """The skin of a JSON document. The file of a cell model is looked for beside it, in `folder`."""
    _of_kind(document, dict, "skin")
    cells, imus = [], {}
    for k, cell in enumerate(_of_kind(document.get("cells"), list, "cells")):
        what = f"cells[{k}]"
        cells.append(_cell(cell, what))
        if cells[-1]["id"] in {other["id"] for other in cells[:-1]}:
            raise SkinError(f"{what}.id: cell {cells[-1]['id']} is named twice")
        if cell.get("imu") is not None:
            topic = _text(cell["imu"], f"{what}.imu")
            if topic in imus:
                raise SkinError(f"{what}.imu: {topic} is that of cell {imus[topic]} already")
            imus[topic] = cells[-1]["id"]
    data = document.get("cell_data", [])
    data = tuple(_cell_data(entry, "cell_data") for entry in (data if isinstance(data, list) else [data]))
    if not imus and not data:
        raise SkinError('skin: expected an "imu" of some cell, or "cell_data"; there is no topic')
    model = document.get("cell_model", "hex-bma150")  # of a session also a whole model
    model = json.dumps(model) if isinstance(model, dict) else _text(model, "cell_model")
    if model.endswith(".json"):
        model = (folder / model).read_text(encoding="utf-8")
    return Skin(str(document.get("device", "skin on ROS topics")), model, tuple(cells), imus, data)


def read_skin(path):
    """Throws SkinError, which names the file."""
    path = pathlib.Path(path)
    try:
        return skin_from(json.loads(path.read_text(encoding="utf-8")), path.parent)
    except OSError as error:
        raise SkinError(f"{path}: cannot be read: {error.strerror}") from error
    except ValueError as error:
        raise SkinError(f"{path}: is no JSON: {error}") from error
    except SkinError as error:
        raise SkinError(f"{path}: {error}") from error
