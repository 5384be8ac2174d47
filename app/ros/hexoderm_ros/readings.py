"""Messages of ROS as readings: the same for ROS 1 and ROS 2, whose messages differ in the names of a time's fields."""

import math
from typing import NamedTuple

STANDARD_GRAVITY = 9.80665  # m/s^2 in 1 g

# Why readings are left out.
NO_ACCELERATION = "readings whose linear_acceleration_covariance begins with -1, which means that there is no acceleration"
NOT_FINITE = "readings with an acceleration that is not finite"
OTHER_FRAME = "readings of a frame_id that no cell has"
OTHER_CELL = "readings of cells that the description does not have"
OTHER_FIELDS = "messages without the fields that are looked for"


class Reading(NamedTuple):
    time_us: int
    cell: int
    acceleration_g: tuple


class FieldError(Exception):
    """A message lacks a field; the text says which there are."""


def time_us(stamp):
    """Microseconds of a stamp; 0 where none was given."""
    seconds, nanoseconds = (stamp.secs, stamp.nsecs) if hasattr(stamp, "secs") else (stamp.sec, stamp.nanosec)
    return seconds * 1_000_000 + nanoseconds // 1000


def _stamp_of(message, now_us):
    header = getattr(message, "header", None)
    return (time_us(header.stamp) if header is not None else 0) or now_us


def _is_finite(vector):
    return all(map(math.isfinite, vector))


def of_imu(message, cells, now_us, leave_out):
    """The reading of a sensor_msgs/Imu, in a list, or none. At rest it has +9.8 m/s^2 on the axis that points up, a cell
    +1 g. `cells` has the cell of each frame_id, or of "" for all; leave_out() is given the reason and the example."""
    frame = "" if "" in cells else message.header.frame_id.lstrip("/")
    cell = cells.get(frame)
    if cell is None:
        leave_out(OTHER_FRAME, f'"{frame}"')
        return []
    if message.linear_acceleration_covariance[0] == -1:
        leave_out(NO_ACCELERATION, f"cell {cell}")
        return []
    acceleration = message.linear_acceleration
    vector = tuple(value / STANDARD_GRAVITY for value in (acceleration.x, acceleration.y, acceleration.z))
    if not _is_finite(vector):
        leave_out(NOT_FINITE, f"cell {cell}")
        return []
    return [Reading(_stamp_of(message, now_us), cell, vector)]


def _type_of(message):
    """The name that ROS 1 or ROS 2 has for it."""
    kind = type(message)
    return getattr(message, "_type", f"{kind.__module__.partition('.')[0]}/{kind.__name__}")


def _fields_of(message):
    if hasattr(message, "get_fields_and_field_types"):
        return list(message.get_fields_and_field_types())
    return list(getattr(message, "__slots__", None) or getattr(message, "__dict__", {}))


def _field(message, path):
    """The field at a path with dots."""
    for name in path.split("."):
        try:
            message = getattr(message, name)
        except AttributeError:
            there = ", ".join(_fields_of(message)) or "none"
            raise FieldError(f'{_type_of(message)} has no field "{name}"; it has {there}') from None
    return message


def _vector(entry, path):
    found = _field(entry, path)
    try:
        values = (found.x, found.y, found.z) if hasattr(found, "x") else tuple(found)
        if len(values) == 3:
            return tuple(map(float, values))
    except (AttributeError, TypeError, ValueError):
        pass
    raise FieldError(f'the field "{path}" of {_type_of(entry)} is neither x, y, z nor an array of 3')


def _cell(entry, path):
    found = _field(entry, path)
    if isinstance(found, int):
        return found
    raise FieldError(f'the field "{path}" of {_type_of(entry)} is no whole number')


def _entries(message, array):
    if not array and not hasattr(message, "data"):
        return [message]
    path = array or "data"
    found = _field(message, path)
    if not hasattr(found, "__iter__") or isinstance(found, (str, bytes)):
        raise FieldError(f'the field "{path}" of {_type_of(message)} is no array')
    return found


def of_cell_data(message, names, cells, now_us, leave_out):
    """The readings of a message with an array of cells, in g; those of other cells than `cells` are left out."""
    readings = []
    try:
        at_us = _stamp_of(message, now_us)
        for entry in _entries(message, names.array):
            cell, vector = _cell(entry, names.cell), _vector(entry, names.acceleration)
            if cell not in cells:
                leave_out(OTHER_CELL, f"cell {cell}")
            elif not _is_finite(vector):
                leave_out(NOT_FINITE, f"cell {cell}")
            else:
                readings.append(Reading(_stamp_of(entry, at_us), cell, vector))
    except FieldError as error:
        leave_out(OTHER_FIELDS, str(error))
        return []
    return readings
