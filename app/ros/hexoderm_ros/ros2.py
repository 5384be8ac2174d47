"""The node of ROS 2 (rclpy). Debian 12 has no ROS 2: this file was run against a stand-in of rclpy only."""

import time

import geometry_msgs.msg
import rclpy
import sensor_msgs.msg
import tf2_ros
from rclpy.qos import qos_profile_sensor_data

from hexoderm_ros import readings
from hexoderm_ros.skin import SkinError


def _now_us(node):
    return node.get_clock().now().nanoseconds // 1000 or int(time.time() * 1e6)


def _spin(node):
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


def pass_on(skin, device):
    """Passes the readings of the topics on until ROS ends."""
    for names in skin.cell_data:
        if not names.type:
            raise SkinError(f"cell_data of {names.topic}: ROS 2 needs its type, \"package/msg/Name\"")
    rclpy.init()
    node = rclpy.create_node("hexoderm_ros")

    def subscribe_imu(topic, cell):
        node.create_subscription(sensor_msgs.msg.Imu, topic,
                                 lambda message: device.add(readings.of_imu(message, cell, _now_us(node))),
                                 qos_profile_sensor_data)

    def subscribe_cell_data(names):
        from rosidl_runtime_py.utilities import get_message

        node.create_subscription(
            get_message(names.type), names.topic,
            lambda message: device.add(readings.of_cell_data(message, names, skin.ids, _now_us(node))),
            qos_profile_sensor_data)

    for topic, cell in skin.imus.items():
        subscribe_imu(topic, cell)
    for names in skin.cell_data:
        subscribe_cell_data(names)
    _spin(node)


def publish(transforms):
    """Publishes static transforms until ROS ends."""
    rclpy.init()
    node = rclpy.create_node("hexoderm_transforms")
    messages = []
    for transform in transforms:
        message = geometry_msgs.msg.TransformStamped()
        message.header.stamp = node.get_clock().now().to_msg()
        message.header.frame_id, message.child_frame_id = transform.parent, transform.child
        translation, rotation = message.transform.translation, message.transform.rotation
        translation.x, translation.y, translation.z = transform.translation
        rotation.x, rotation.y, rotation.z, rotation.w = transform.rotation
        messages.append(message)
    broadcaster = tf2_ros.StaticTransformBroadcaster(node)
    broadcaster.sendTransform(messages)
    _spin(node)
