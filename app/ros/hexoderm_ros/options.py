"""The command line of hexoderm-ros, whose help looks as that of Hexoderm's other programs; man pages are made of it."""

import argparse

from hexoderm_ros import __version__

EXAMPLE = """\
{
  "device": "left forearm",
  "cell_model": "hex-bma150",
  "cells": [
    {"id": 1, "imu": "/forearm/imu1", "ports": [{"port": 2, "cell": 2, "cell_port": 3}]},
    {"id": 2, "imu": "/forearm/imu2", "ports": [{"port": 3, "cell": 1, "cell_port": 2}]}
  ]
}
"""
EXPLAINED = """\
All keys, times and frames are explained in the package's README, beside an example:
  /usr/share/doc/hexoderm-ros/README.md
  /usr/share/doc/hexoderm-ros/examples/skin.json
"""
AFTER = {
    None: EXPLAINED,
    "skin": f"""\
A skin.json has the cells, the links of their ports and the topic of each:
{"".join(f"  {line}" for line in EXAMPLE.splitlines(keepends=True))}
Cells that share a topic have a "frame_id" each. For messages with many cells:
  "cell_data": {{"topic": "/skin/cells"}}

{EXPLAINED}
The window and the command line then connect to it:
  hexoderm-cli capture --source tcp://localhost:7700 -o live.hexo
""",
    "transforms": f"""\
Example:
  hexoderm-cli export arm.calibration.json --to tf-yaml -o arm.tf.yaml
  hexoderm-ros transforms arm.tf.yaml

{EXPLAINED}""",
}


class _Formatter(argparse.RawDescriptionHelpFormatter):
    def _format_action(self, action):
        if not isinstance(action, argparse._SubParsersAction):
            return super()._format_action(action)
        return "".join(map(self._format_action, action._get_subactions()))


class _Parser(argparse.ArgumentParser):
    """Says first what the program is for."""

    def __init__(self, **how):
        super().__init__(formatter_class=_Formatter, add_help=False, **how)
        self._positionals.title, self._optionals.title = "Arguments", "Options"
        self.add_argument("-h", "--help", action="help", help="print this help and exit")

    def error(self, message):
        self.exit(2, f"hexoderm-ros: {message} ({self.prog} --help says more)\n")

    def format_help(self):
        formatter = self._get_formatter()
        formatter.add_text(self.description)
        formatter.add_usage(self.usage, self._actions, self._mutually_exclusive_groups, "Usage: ")
        text = formatter.format_help().replace("\n\n", "\n")
        formatter = self._get_formatter()
        for group in self._action_groups:
            formatter.start_section(group.title)
            formatter.add_arguments(group._group_actions)
            formatter.end_section()
        formatter.add_text(self.epilog)
        return text + "\n" + formatter.format_help()


def _port(text):
    port = int(text) if text.isascii() and text.isdigit() else -1
    if not 0 <= port < 2**16:
        raise argparse.ArgumentTypeError(f'expected a port from 0 to 65535, found "{text}"')
    return port


def without_those_of_ros(arguments):
    """ROS 1 adds "__name:=..." and the like; ROS 2 all that is between "--ros-args" and "--"."""
    own, are_of_ros = [], False
    for each in arguments:
        if are_of_ros:
            are_of_ros = each != "--"
        elif each == "--ros-args":
            are_of_ros = True
        elif ":=" not in each:
            own.append(each)
    return own


def parsed(arguments):
    """Ends the program with 2 where they are wrong."""
    parser = _Parser(prog="hexoderm-ros", usage="hexoderm-ros [OPTIONS] SUBCOMMAND", epilog=AFTER[None],
                     description="Pass readings of ROS topics on to Hexoderm, and publish calibrated frames")
    parser.add_argument("--version", action="version", version=f"hexoderm-ros {__version__}",
                        help="print the version and exit")
    commands = parser.add_subparsers(dest="command", required=True, title="Subcommands", metavar="SUBCOMMAND",
                                     parser_class=_Parser)

    def add(name, argument, of_argument, what):
        command = commands.add_parser(name, description=what, help=what, prog=f"hexoderm-ros {name}",
                                      usage=f"hexoderm-ros {name} [OPTIONS] {argument}", epilog=AFTER[name])
        command.add_argument(argument, help=of_argument)
        return command

    skin = add("skin", "skin", "description of the skin (JSON), as below",
               "Pass readings of topics on to Hexoderm, at tcp://localhost:PORT")
    skin.add_argument("--port", type=_port, default=7700, help="TCP port; 0: any that is free (default: 7700)")
    skin.add_argument("--address", default="127.0.0.1",
                      help="whom it listens to: 0.0.0.0 for other computers too (default: 127.0.0.1)")
    transforms = add("transforms", "transforms", "file of hexoderm-cli export --to tf-yaml",
                     "Publish frames of a calibration as static transforms")
    for command in (skin, transforms):
        command.add_argument("--ros", type=int, choices=(1, 2), metavar="INT:{1,2}",
                             help="version of ROS (default: 1 where Python finds rospy, else 2)")
    return parser.parse_args(arguments)
