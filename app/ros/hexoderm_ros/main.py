"""hexoderm-ros skin: readings of ROS topics for Hexoderm; hexoderm-ros transforms: calibrated frames for TF."""

import contextlib
import errno
import importlib.util
import os
import socket
import sys

from hexoderm_ros.console import say
from hexoderm_ros.device import Device
from hexoderm_ros.errors import AddressError, InputError, UsageError
from hexoderm_ros.intake import Intake
from hexoderm_ros.options import parsed, without_those_of_ros
from hexoderm_ros.skin import errors_of, read_skin
from hexoderm_ros.watch import Watch


def _ros(version):
    """The node's module of the version asked for, or of the one that is there."""
    there = [each for each, module in ((1, "rospy"), (2, "rclpy")) if importlib.util.find_spec(module)]
    if not there and version is None:
        raise UsageError("Python finds neither ROS 1 (rospy) nor ROS 2 (rclpy): is its setup.bash sourced?")
    if version is not None and version not in there:
        raise UsageError(f"--ros {version}: Python does not find {'rospy' if version == 1 else 'rclpy'}: is the setup.bash "
                         f"of ROS {version} sourced?")
    try:
        if (version or there[0]) == 1:
            from hexoderm_ros import ros1

            return ros1
        from hexoderm_ros import ros2

        return ros2
    except ImportError as error:
        raise UsageError(f"a Python module of ROS is missing: {error}") from error


def _listen(skin, port, address):
    try:
        return Device(skin, port, address)
    except OSError as error:
        other = "; choose another by --port" if error.errno in (errno.EADDRINUSE, errno.EACCES) else ""
        # A server of Python names the address in its text too.
        why = error.strerror if isinstance(error, socket.gaierror) else os.strerror(error.errno)
        raise AddressError(f"{address}:{port}: {why}{other}") from error


def _publish(options):
    from hexoderm_ros.transforms import read_transforms  # the other command needs no PyYAML

    transforms = read_transforms(options.transforms)
    _ros(options.ros).publish(transforms, lambda: say(f"publishing {len(transforms)} static transforms"))


def _pass_on(options):
    skin = read_skin(options.skin)
    ros = _ros(options.ros)
    device = _listen(skin, options.port, options.address)
    watch = Watch(skin)
    cells = f"{len(skin.cells)} cell{'s' if len(skin.cells) > 1 else ''}"
    with contextlib.closing(device), contextlib.suppress(KeyboardInterrupt), errors_of(options.skin):
        ros.pass_on(skin, Intake(skin, device, watch), watch,
                    lambda: say(f"{cells} on tcp://{options.address}:{device.port}"))
    say(", ".join(f"{count} {what}" for what, count in device.counts().items()))
    for reason, count in watch.counts().items():
        say(f"left out: {count} {reason}")


def main(arguments=None):
    options = parsed(without_those_of_ros(sys.argv[1:] if arguments is None else arguments))
    try:
        (_publish if options.command == "transforms" else _pass_on)(options)
    except KeyboardInterrupt:
        pass
    except (UsageError, InputError, AddressError) as error:
        say(error)
        return error.code
    return 0
