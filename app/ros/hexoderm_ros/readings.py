"""Messages of ROS as readings: the same for ROS 1 and ROS 2, whose messages differ in the names of a time's fields."""

import math
from typing import NamedTuple

STANDARD_GRAVITY = 9.80665  # m/s^2 in 1 g


class Reading(NamedTuple):
    time_us: int
    cell: int
    acceleration_g: tuple


def time_us(stamp):
    """Microseconds of a stamp; 0 where none was given."""
    seconds, nanoseconds = (stamp.secs, stamp.nsecs) if hasattr(stamp, "secs") else (stamp.sec, stamp.nanosec)
    return seconds * 1_000_000 + nanoseconds // 1000


def _stamp_of(message, now_us):
    header = getattr(message, "header", None)
    return (time_us(header.stamp) if header is not None else 0) or now_us


def _is_finite(vector):
    return all(map(math.isfinite, vector))


def of_imu(message, cell, now_us):
    """The reading of a sensor_msgs/Imu, or none. At rest it has +9.8 m/s^2 on the axis that points up, a cell +1 g."""
    if message.linear_acceleration_covariance[0] == -1:  # by its definition: there is no acceleration
        return []
    acceleration = message.linear_acceleration
    vector = tuple(value / STANDARD_GRAVITY for value in (acceleration.x, acceleration.y, acceleration.z))
    return [Reading(_stamp_of(message, now_us), cell, vector)] if _is_finite(vector) else []


def of_cell_data(message, names, cells, now_us):
    """The readings of a message with an array of cells, in g; those of other cells than `cells` are left out."""
    at_us = _stamp_of(message, now_us)
    readings = []
    for entry in getattr(message, names.array, [message]):
        cell = getattr(entry, names.cell)
        acceleration = getattr(entry, names.acceleration)
        if hasattr(acceleration, "x"):
            acceleration = (acceleration.x, acceleration.y, acceleration.z)
        vector = tuple(map(float, acceleration))
        if cell in cells and len(vector) == 3 and _is_finite(vector):
            readings.append(Reading(_stamp_of(entry, at_us), cell, vector))
    return readings
