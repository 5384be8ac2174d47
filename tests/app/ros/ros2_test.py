"""The node of ROS 2 against a stand-in of rclpy: what it subscribes to and publishes. It was never run with ROS 2."""

import sys
import unittest
from types import ModuleType, SimpleNamespace

from program import imu


def module(name, **members):
    made = sys.modules[name] = ModuleType(name)
    made.__dict__.update(members)
    return made


class Clock:
    def now(self):
        return SimpleNamespace(nanoseconds=7_000_000, to_msg=lambda: "now")


class Node:
    def __init__(self, name):
        self.name = name
        self.subscriptions = {}

    def get_clock(self):
        return Clock()

    def create_subscription(self, kind, topic, callback, qos):
        assert qos == "sensor data"
        self.subscriptions[topic] = (kind, callback)

    def get_publishers_info_by_topic(self, topic):
        return [SimpleNamespace(topic_type=kind) for kind in published.get(topic, [])]

    def destroy_node(self):
        nodes.remove(self)


nodes = []
published = {}
spinning = []


def create_node(name):
    nodes.append(Node(name))
    return nodes[-1]


def spin(node):
    spinning.append(node)
    during[0](node)


during = [lambda node: None]
sent = []


def stamped():
    return SimpleNamespace(header=SimpleNamespace(stamp=None, frame_id=""), child_frame_id="",
                           transform=SimpleNamespace(translation=SimpleNamespace(), rotation=SimpleNamespace()))


class ExternalShutdownException(Exception):
    pass


def get_message(name):
    if name.startswith("none/"):
        raise ModuleNotFoundError(f"No module named '{name}'")
    return "class of " + name


running = []  # contexts of rclpy

module("rclpy", init=lambda: running.append(1), create_node=create_node, spin=spin, try_shutdown=running.clear)
module("rclpy.executors", ExternalShutdownException=ExternalShutdownException)
module("rclpy.qos", qos_profile_sensor_data="sensor data")
module("sensor_msgs").msg = module("sensor_msgs.msg", Imu="Imu")
module("geometry_msgs").msg = module("geometry_msgs.msg", TransformStamped=stamped)
module("tf2_ros", StaticTransformBroadcaster=lambda node: SimpleNamespace(sendTransform=sent.extend))
module("rosidl_runtime_py")
module("rosidl_runtime_py.utilities", get_message=get_message)

from hexoderm_ros import ros2  # noqa: E402
from hexoderm_ros.intake import Intake  # noqa: E402
from hexoderm_ros.skin import SkinError, skin_from  # noqa: E402
from hexoderm_ros.transforms import Transform  # noqa: E402
from hexoderm_ros.watch import Watch  # noqa: E402

CELLS = [{"id": 1, "imu": "/a"}, {"id": 2, "imu": "/b"}, {"id": 3, "imu": "/c"}]


class Ros2(unittest.TestCase):
    def pass_on(self, document, then):
        readings = []
        during[0] = then
        skin = skin_from(document)
        watch = Watch(skin)
        ready = []
        ros2.pass_on(skin, Intake(skin, SimpleNamespace(add=readings.extend), watch), watch, lambda: ready.append(1))
        self.assertEqual(ready, [1])
        self.assertEqual((nodes, running), ([], []))
        return readings

    def test_each_topic_is_that_of_its_cell(self):
        def then(node):
            kinds = {topic: kind for topic, (kind, _) in node.subscriptions.items()}
            self.assertEqual(kinds, {"/a": "Imu", "/b": "Imu", "/c": "Imu"})
            node.subscriptions["/b"][1](imu(2, (0, 0, 1), "sec", "nanosec"))
            node.subscriptions["/a"][1](imu(0, (0, 1, 0), "sec", "nanosec"))

        found = self.pass_on({"cells": CELLS}, then)
        self.assertEqual([(each.time_us, each.cell) for each in found], [(2_000_000, 2), (7_000, 1)])

    def test_cell_data(self):
        def then(node):
            kind, take = node.subscriptions["/cells"]
            self.assertEqual(kind, "class of skin/msg/Cells")
            take(SimpleNamespace(data=[SimpleNamespace(cellId=3, acc=[0, 0, 1])]))

        found = self.pass_on({"cells": CELLS, "cell_data": {"topic": "/cells", "type": "skin/msg/Cells"}}, then)
        self.assertEqual([(each.time_us, each.cell) for each in found], [(7_000, 3)])
        for kind, words in (({}, "ROS 2 needs its type"), ({"type": "none/msg/Cells"}, "is not there: No module named")):
            with self.assertRaisesRegex(SkinError, words):
                ros2.pass_on(skin_from({"cells": CELLS, "cell_data": {"topic": "/cells", **kind}}), None, None, None)
            self.assertEqual((nodes, running), ([], []))

    def test_ctrl_c_and_the_end_of_ros_end_it(self):
        for error in (KeyboardInterrupt, ExternalShutdownException):
            def then(node, error=error):
                raise error

            self.assertEqual(self.pass_on({"cells": CELLS}, then), [])

    def test_why_nothing_comes(self):
        published.update({"/b": ["std_msgs/msg/String"], "/c": ["sensor_msgs/msg/Imu"]})
        why = ros2._why_nothing_comes(Node("n"), dict.fromkeys(("/a", "/b", "/c"), ros2.IMU))
        self.assertEqual([of_one for of_one, _ in why(("/a", "/b", "/c")).values()],
                         ["nobody publishes it", "its type is std_msgs/msg/String, and not sensor_msgs/msg/Imu",
                          "its publisher sends nothing"])

    def test_transforms(self):
        during[0] = lambda node: None
        ros2.publish([Transform("base", "cell", (1, 2, 3), (0, 0, 0, 1))], lambda: None)
        self.assertEqual(len(sent), 1)
        self.assertEqual((sent[0].header.frame_id, sent[0].child_frame_id), ("base", "cell"))
        self.assertEqual(sent[0].header.stamp, "now")
        self.assertEqual((sent[0].transform.translation.z, sent[0].transform.rotation.w), (3, 1))
