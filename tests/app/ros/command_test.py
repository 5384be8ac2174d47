"""The command line of hexoderm-ros: its help, its exit codes, and one line for whatever is wrong. No ROS is needed."""

import json
import os
import pathlib
import re
import socket
import subprocess
import sys
import unittest

import hexoderm_ros
from program import InFolder

PROGRAM = pathlib.Path(hexoderm_ros.__file__).parents[1] / "hexoderm-ros"
CELLS = [{"id": 1, "imu": "/a"}]


class Commands(InFolder):
    def ros(self, *arguments, modules=()):
        """With stand-ins of `modules` in front of what is installed; rospy and rclpy are found nowhere else."""
        for name in modules:
            (self.folder / f"{name}.py").write_text("")
        hidden = ("import importlib.util as u, sys; f = u.find_spec\n"
                  f"u.find_spec = lambda n, *a: None if n in ('rospy', 'rclpy') and n not in {modules!r} else f(n, *a)\n"
                  "from hexoderm_ros.main import main; sys.exit(main(sys.argv[1:]))")
        found = subprocess.run([sys.executable, "-c", hidden, *map(str, arguments)], capture_output=True, text=True,
                               timeout=60, cwd=self.folder)
        return found.returncode, found.stderr

    def skin(self, **document):
        file = self.folder / "skin.json"
        file.write_text(json.dumps({"cells": CELLS, **document}))
        return file

    def assertEnds(self, found, code, words):
        self.assertEqual(found[0], code, found[1])
        self.assertEqual(len(found[1].splitlines()), 1, found[1])
        self.assertIn(words, found[1])

    def test_the_version_is_that_of_the_project(self):
        said = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(said, f"hexoderm-ros {os.environ['HEXODERM_VERSION']}\n")

    def test_no_option_names_a_file_to_write(self):
        for command, known in (("skin", {"skin", "--help", "--port", "--address", "--ros"}),
                               ("transforms", {"transforms", "--help", "--ros"})):
            said = subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True, check=True).stdout
            entries = "\n".join(said.split("\n\n")[1:3])
            self.assertEqual(set(re.findall(r"^  (?:-\w, )?(--\w+|\w+)", entries, re.MULTILINE)), known, said)

    def test_the_help_of_skin_has_an_example(self):
        said = subprocess.run([PROGRAM, "skin", "--help"], capture_output=True, text=True, check=True).stdout
        example = said[said.index("  {\n"):said.index("\n  }") + 4]
        self.assertEqual(list(json.loads(example)), ["device", "cell_model", "cells"])

    def test_wrong_usage(self):
        self.assertEnds(self.ros("skin", "s.json", "--port", "70000"), 2, 'a port from 0 to 65535, found "70000"')
        self.assertEnds(self.ros("skin", "s.json", "--port", "x"), 2, 'a port from 0 to 65535, found "x"')
        self.assertEnds(self.ros(), 2, "SUBCOMMAND")
        self.assertEnds(self.ros("skin", self.skin(), "--ros", "1"), 2, "--ros 1: Python does not find rospy")
        self.assertEnds(self.ros("skin", self.skin(), "--ros", "2"), 2, "--ros 2: Python does not find rclpy")
        self.assertEnds(self.ros("skin", self.skin()), 2, "neither ROS 1 (rospy) nor ROS 2 (rclpy)")

    def test_arguments_of_ros_are_left_to_it(self):
        for arguments in (["__name:=arm"], ["--ros-args", "-p", "use_sim_time:=true"],
                          ["--ros-args", "-r", "a:=b", "--log-level", "info", "--", "--address", "127.0.0.1"]):
            self.assertEnds(self.ros("skin", self.skin(), "--ros", "2", *arguments), 2, "Python does not find rclpy")
        self.assertEnds(self.ros("skin", "s.json", "--ros-args", "-p", "a:=1", "--", "--port", "x"), 2, 'found "x"')

    def test_files_that_are_not_as_expected(self):
        self.assertEnds(self.ros("skin", "none.json"), 3, "none.json: cannot be read: No such file")
        self.assertEnds(self.ros("skin", self.skin(cell_model="x")), 3, 'skin.json: cell_model: "x" is not known')
        self.assertEnds(self.ros("transforms", "none.yaml"), 3, "none.yaml: cannot be read")

    def stand_in(self, *names, text=""):
        """Of modules in packages. A node is never made, so that it is enough."""
        for name in names:
            package, module = name.split("/")
            (self.folder / package).mkdir(exist_ok=True)
            (self.folder / package / "__init__.py").write_text("")
            (self.folder / package / f"{module}.py").write_text(text)

    def test_what_ros_2_needs_of_a_description(self):
        self.stand_in("geometry_msgs/msg", "sensor_msgs/msg")
        self.stand_in("rclpy/executors", "rclpy/qos", text="ExternalShutdownException = qos_profile_sensor_data = OSError")
        file = self.skin(cell_data={"topic": "/cells"})
        self.assertEnds(self.ros("skin", file, "--port", "0", "--ros", "2", modules=("rclpy", "tf2_ros")), 3,
                        f'{file}: cell_data of /cells: ROS 2 needs its type, "package/msg/Name"')

    def test_a_port_that_is_taken(self):
        self.stand_in("genpy/dynamic", "geometry_msgs/msg", "sensor_msgs/msg")
        with socket.create_server(("127.0.0.1", 0)) as server:
            port = server.getsockname()[1]
            self.assertEnds(self.ros("skin", self.skin(), "--port", port, modules=("rospy", "rosgraph", "tf2_ros")), 4,
                            f"127.0.0.1:{port}: Address already in use; choose another by --port")
        self.assertEnds(self.ros("skin", self.skin(), "--address", "nowhere.invalid", modules=("rospy", "rosgraph", "tf2_ros")), 4,
                        "nowhere.invalid:7700: ")
