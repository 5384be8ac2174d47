"""Calibrated frames, as `hexoderm-cli export --to tf-yaml` writes them."""

import math
from typing import NamedTuple

import yaml


class Transform(NamedTuple):
    parent: str
    child: str
    translation: tuple  # x, y, z, m
    rotation: tuple  # x, y, z, w


class TransformError(Exception):
    """A file holds no transforms; the text says where, and what was expected."""


def _numbers(values, names, what):
    try:
        numbers = tuple(float(values[name]) for name in names)
    except (KeyError, TypeError, ValueError) as error:
        raise TransformError(f"{what}: expected {', '.join(names)}") from error
    if not all(map(math.isfinite, numbers)):
        raise TransformError(f"{what}: expected finite numbers")
    return numbers


def read_transforms(path):
    """Throws TransformError, which names the file."""
    try:
        with open(path, encoding="utf-8") as file:
            entries = yaml.safe_load(file)
    except OSError as error:
        raise TransformError(f"{path}: cannot be read: {error.strerror}") from error
    except (yaml.YAMLError, UnicodeDecodeError) as error:
        raise TransformError(f"{path}: is no YAML") from error
    if not isinstance(entries, list) or not entries:
        raise TransformError(f"{path}: expected a list of transforms, as hexoderm-cli export --to tf-yaml writes it")
    transforms = []
    for k, entry in enumerate(entries):
        what = f"{path}: [{k}]"
        try:
            parent, child, transform = entry["header"]["frame_id"], entry["child_frame_id"], entry["transform"]
            translation, rotation = transform["translation"], transform["rotation"]
        except (KeyError, TypeError) as error:
            raise TransformError(f"{what}: expected a geometry_msgs/TransformStamped") from error
        rotation = _numbers(rotation, "xyzw", f"{what}.transform.rotation")
        if abs(math.hypot(*rotation) - 1) > 1e-6:
            raise TransformError(f"{what}.transform.rotation: expected a quaternion of length 1")
        transforms.append(Transform(str(parent), str(child),
                                    _numbers(translation, "xyz", f"{what}.transform.translation"), rotation))
    return transforms
