"""Calibrated frames, as `hexoderm-cli export --to tf-yaml` writes them."""

import json
import math
from typing import NamedTuple

import yaml

from hexoderm_ros.errors import InputError


class Transform(NamedTuple):
    parent: str
    child: str
    translation: tuple  # x, y, z, m
    rotation: tuple  # x, y, z, w

    def put_in(self, message, stamp):
        """Returns the message, a geometry_msgs/TransformStamped of either ROS."""
        message.header.stamp = stamp
        message.header.frame_id, message.child_frame_id = self.parent, self.child
        for part, values in ((message.transform.translation, self.translation), (message.transform.rotation, self.rotation)):
            for name, value in zip("xyzw", values):
                setattr(part, name, value)
        return message


class TransformError(InputError):
    """Of a file of transforms."""


def _numbers(values, names, what):
    try:
        numbers = tuple(float(values[name]) for name in names)
    except (KeyError, TypeError, ValueError) as error:
        raise TransformError(f"{what}: expected {', '.join(names)}") from error
    if not all(map(math.isfinite, numbers)):
        raise TransformError(f"{what}: expected finite numbers")
    return numbers


def _frame(name, what):
    if isinstance(name, str) and name.strip("/ "):
        return name
    raise TransformError(f"{what}: expected the name of a frame, found {json.dumps(name, default=str)}")


def read_transforms(path):
    """Throws TransformError, which names the file."""
    try:
        with open(path, encoding="utf-8") as file:
            entries = yaml.safe_load(file)
    except OSError as error:
        raise TransformError(f"{path}: cannot be read: {error.strerror}") from error
    except yaml.MarkedYAMLError as error:
        where = f", line {error.problem_mark.line + 1}: {error.problem}" if error.problem_mark else ""
        raise TransformError(f"{path}: is no YAML{where}") from error
    except (yaml.YAMLError, UnicodeDecodeError) as error:
        raise TransformError(f"{path}: is no YAML: {str(error).splitlines()[0]}") from error
    if not isinstance(entries, list) or not entries:
        raise TransformError(f"{path}: expected a list of transforms, as hexoderm-cli export --to tf-yaml writes it")
    transforms, parents = [], {}
    for k, entry in enumerate(entries):
        what = f"{path}: [{k}]"
        try:
            parent, child, transform = entry["header"]["frame_id"], entry["child_frame_id"], entry["transform"]
            translation, rotation = transform["translation"], transform["rotation"]
        except (KeyError, TypeError) as error:
            raise TransformError(f"{what}: expected a geometry_msgs/TransformStamped") from error
        parent, child = _frame(parent, f"{what}.header.frame_id"), _frame(child, f"{what}.child_frame_id")
        if child == parent:
            raise TransformError(f'{what}.child_frame_id: expected another frame than frame_id, found "{child}" again')
        if child in parents:  # TF knows one parent of a frame: the later one would take it away from the other
            raise TransformError(f'{what}.child_frame_id: "{child}" is there already, in "{parents[child]}"')
        parents[child] = parent
        rotation = _numbers(rotation, "xyzw", f"{what}.transform.rotation")
        if abs(math.hypot(*rotation) - 1) > 1e-6:
            raise TransformError(f"{what}.transform.rotation: expected a quaternion of length 1")
        transforms.append(Transform(parent, child,
                                    _numbers(translation, "xyz", f"{what}.transform.translation"), rotation))
    return transforms
