"""The node of ROS 1 (rospy)."""

import time

import genpy.dynamic
import geometry_msgs.msg
import rospy
import sensor_msgs.msg
import tf2_ros

from hexoderm_ros import readings

QUEUE = 1000  # messages of a topic, while others are dealt with


def _now_us():
    return readings.time_us(rospy.Time.now()) or int(time.time() * 1e6)


class _OfAnyType:
    """Makes messages of a type that is not installed: their publisher says how they are made up."""

    def __init__(self, callback):
        self._callback = callback
        self._types = {}

    def __call__(self, raw):
        header = raw._connection_header
        name = header["type"]
        if name not in self._types:
            self._types[name] = genpy.dynamic.generate_dynamic(name, header["message_definition"])[name]
        message = self._types[name]()
        message.deserialize(raw._buff)
        self._callback(message)


def pass_on(skin, device):
    """Passes the readings of the topics on until ROS ends."""
    rospy.init_node("hexoderm_ros", anonymous=True)

    def subscribe_imu(topic, cell):
        def take(message):
            device.add(readings.of_imu(message, cell, _now_us()))

        rospy.Subscriber(topic, sensor_msgs.msg.Imu, take, queue_size=QUEUE, tcp_nodelay=True)

    def subscribe_cell_data(names):
        def take(message):
            device.add(readings.of_cell_data(message, names, skin.ids, _now_us()))

        rospy.Subscriber(names.topic, rospy.AnyMsg, _OfAnyType(take), queue_size=QUEUE, tcp_nodelay=True)

    for topic, cell in skin.imus.items():
        subscribe_imu(topic, cell)
    for names in skin.cell_data:
        subscribe_cell_data(names)
    rospy.spin()


def publish(transforms):
    """Publishes static transforms until ROS ends."""
    rospy.init_node("hexoderm_transforms", anonymous=True)
    messages = []
    for transform in transforms:
        message = geometry_msgs.msg.TransformStamped()
        message.header.stamp = rospy.Time.now()
        message.header.frame_id, message.child_frame_id = transform.parent, transform.child
        message.transform.translation = geometry_msgs.msg.Vector3(*transform.translation)
        message.transform.rotation = geometry_msgs.msg.Quaternion(*transform.rotation)
        messages.append(message)
    tf2_ros.StaticTransformBroadcaster().sendTransform(messages)
    rospy.spin()
