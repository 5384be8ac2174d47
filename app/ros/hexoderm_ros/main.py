"""hexoderm-ros skin: readings of ROS topics for Hexoderm; hexoderm-ros transforms: calibrated frames for TF."""

import argparse
import importlib.util
import sys

from hexoderm_ros.device import Device
from hexoderm_ros.skin import SkinError, read_skin
from hexoderm_ros.transforms import TransformError, read_transforms


def _ros(version):
    """The node's module of the version asked for, or of the one that is there."""
    if version == 1 or (version is None and importlib.util.find_spec("rospy")):
        from hexoderm_ros import ros1

        return ros1
    from hexoderm_ros import ros2

    return ros2


def _arguments(arguments):
    parser = argparse.ArgumentParser(prog="hexoderm-ros", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    skin = commands.add_parser("skin", help="pass readings of topics on to Hexoderm, at tcp://localhost:PORT")
    skin.add_argument("skin", help="description of the skin (JSON)")
    skin.add_argument("--port", type=int, default=7700, help="TCP port; 0: any that is free (default: 7700)")
    skin.add_argument("--address", default="127.0.0.1", help="whom it listens to: 0.0.0.0 for other computers too "
                      "(default: 127.0.0.1)")
    transforms = commands.add_parser("transforms", help="publish frames as static transforms")
    transforms.add_argument("transforms", help="file of hexoderm-cli export --to tf-yaml")
    for command in (skin, transforms):
        command.add_argument("--ros", type=int, choices=(1, 2), help="version of ROS (default: that which is there)")
    return parser.parse_args(arguments)


def main(arguments=None):
    # ROS adds arguments of its own, "__name:=..."
    given = [each for each in (sys.argv[1:] if arguments is None else arguments) if ":=" not in each]
    options = _arguments(given)
    try:
        if options.command == "transforms":
            transforms = read_transforms(options.transforms)
            print(f"hexoderm-ros: publishing {len(transforms)} static transforms", file=sys.stderr, flush=True)
            _ros(options.ros).publish(transforms)
            return 0
        skin = read_skin(options.skin)
        device = Device(skin, options.port, options.address)
        address = f"tcp://{options.address}:{device.port}"
        print(f"hexoderm-ros: {len(skin.cells)} cells on {address}", file=sys.stderr, flush=True)
        try:
            _ros(options.ros).pass_on(skin, device)
        finally:
            device.close()
            counts = ", ".join(f"{count} {what}" for what, count in device.counts().items())
            print(f"hexoderm-ros: {counts}", file=sys.stderr)
        return 0
    except (SkinError, TransformError) as error:
        print(f"hexoderm-ros: {error}", file=sys.stderr)
        return 3
    except OSError as error:
        print(f"hexoderm-ros: {error}", file=sys.stderr)
        return 4
