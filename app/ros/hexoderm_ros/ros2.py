"""The node of ROS 2 (rclpy). Debian 12 has no ROS 2: this file was run against a stand-in of rclpy only."""

import contextlib
import time

import geometry_msgs.msg
import rclpy
import sensor_msgs.msg
import tf2_ros
from rclpy.executors import ExternalShutdownException
from rclpy.qos import qos_profile_sensor_data

from hexoderm_ros.errors import UsageError
from hexoderm_ros.skin import SkinError
from hexoderm_ros.watch import NOBODY, SENDS_NOTHING, watching

IMU = "sensor_msgs/msg/Imu"


def _now_us(node):
    return node.get_clock().now().nanoseconds // 1000 or int(time.time() * 1e6)


def _spin(node, during=contextlib.nullcontext()):
    try:
        with during:
            rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


def _message_type(names):
    if not names.type:
        raise SkinError(f'cell_data of {names.topic}: ROS 2 needs its type, "package/msg/Name"')
    try:
        from rosidl_runtime_py.utilities import get_message
    except ImportError as error:
        raise UsageError(f"cell_data needs the Python module rosidl_runtime_py: {error}") from error
    try:
        return get_message(names.type)
    except (AttributeError, ImportError, ValueError) as error:
        raise SkinError(f'cell_data of {names.topic}: the type "{names.type}" is not there: {error}') from error


def _why_nothing_comes(node, wanted):
    """For a Watch: why nothing comes on topics, of which `wanted` has the types."""

    def reason(topic):
        kinds = [publisher.topic_type for publisher in node.get_publishers_info_by_topic(topic)]
        if not kinds:
            return NOBODY
        if wanted[topic] not in kinds:
            return (f"its type is {kinds[0]}, and not {wanted[topic]}",) * 2
        return SENDS_NOTHING

    return lambda topics: {topic: reason(topic) for topic in topics}


def pass_on(skin, intake, watch, say_ready):
    """Passes the readings of the topics on until ROS ends."""
    kinds = [_message_type(names) for names in skin.cell_data]  # before there is a node: it may throw
    rclpy.init()
    node = rclpy.create_node("hexoderm_ros")

    def subscribe(topic, kind, take):
        # Best effort, which takes what either kind of publisher sends.
        node.create_subscription(kind, topic, lambda message: take(message, _now_us(node)), qos_profile_sensor_data)

    wanted = dict.fromkeys(skin.imus, IMU)
    for topic in skin.imus:
        subscribe(topic, sensor_msgs.msg.Imu, intake.imu(topic))
    for names, kind in zip(skin.cell_data, kinds):
        wanted[names.topic] = names.type
        subscribe(names.topic, kind, intake.cell_data(names))
    say_ready()
    _spin(node, watching(watch, _why_nothing_comes(node, wanted)))


def publish(transforms, say_ready):
    """Publishes static transforms until ROS ends."""
    rclpy.init()
    node = rclpy.create_node("hexoderm_transforms")
    messages = [each.put_in(geometry_msgs.msg.TransformStamped(), node.get_clock().now().to_msg()) for each in transforms]
    broadcaster = tf2_ros.StaticTransformBroadcaster(node)
    broadcaster.sendTransform(messages)
    say_ready()
    _spin(node)
