"""The node of ROS 1 (rospy)."""

import contextlib
import http.client
import os
import signal
import threading
import time
import xmlrpc.client

import genpy.dynamic
import geometry_msgs.msg
import rosgraph
import rospy
import sensor_msgs.msg
import tf2_ros

from hexoderm_ros import readings
from hexoderm_ros.console import say
from hexoderm_ros.errors import UsageError
from hexoderm_ros.watch import NOBODY, SENDS_NOTHING, watching

ANSWERS_S = 1  # a master that is there answers within it
QUEUE = 1000  # messages of a topic, while others are dealt with
ASK_EVERY_S = 0.5
LOOK_EVERY_S = 0.2  # whether it ended
LEAVES_S = 3  # as long as a master has for it


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


class _End:
    """Ctrl+C and SIGTERM: a KeyboardInterrupt, and known afterwards, since ROS swallows some exceptions. Its own handler
    would end the node in the middle of whatever is done at that moment, and can wait there for itself for ever."""

    def __init__(self):
        self.is_asked_for = False
        # Said even where a shell has what it puts behind it ignore the signal.
        for each in (signal.SIGINT, signal.SIGTERM):
            signal.signal(each, self._ask)
        threading.Thread(target=self._end_at_last, daemon=True).start()

    def _end_at_last(self):
        """Ends the process: while it begins, rospy swallows a KeyboardInterrupt and then waits for a silent master for ever."""
        while not self.is_asked_for:
            time.sleep(LOOK_EVERY_S)
        time.sleep(2 * LEAVES_S)
        os._exit(0)

    def _ask(self, *_):
        self.is_asked_for = True
        raise KeyboardInterrupt

    def wait(self):
        while not (self.is_asked_for or rospy.is_shutdown()):
            time.sleep(LOOK_EVERY_S)


def _wait_for_master(name):
    """Until it is there."""
    try:
        master = rosgraph.Master("/" + name)
    except ValueError as error:
        raise UsageError(f"ROS_MASTER_URI: {error}") from error
    is_there = threading.Event()

    def ask():
        while not master.is_online():
            time.sleep(ASK_EVERY_S)
        is_there.set()

    # It asks a computer that does not answer for minutes, and would swallow a KeyboardInterrupt: it has a thread of its own.
    threading.Thread(target=ask, daemon=True).start()
    if not is_there.wait(ANSWERS_S):
        say(f"no ROS master answers at {master.master_uri}; waiting (is roscore running? ROS_MASTER_URI says where it is)")
        is_there.wait()
    return master


def _leave(master_uri):
    """ROS is told that the node ends; a master that does not answer holds it up for a moment."""

    def leave():
        with contextlib.suppress(Exception):
            # A call that Ctrl+C broke off would be in the way of the next.
            rospy.core.xmlrpcapi(master_uri)("close")()
        rospy.signal_shutdown("ended")

    thread = threading.Thread(target=leave, daemon=True)
    thread.start()
    thread.join(LEAVES_S)


@contextlib.contextmanager
def _node(name):
    """The master and the end, with a node of that name. KeyboardInterrupt: the user ended it, or ROS while it began."""
    end = _End()
    master = _wait_for_master(name)
    try:
        rospy.init_node(name, anonymous=True, disable_signals=True)
        yield master, end
    except rospy.exceptions.ROSException:
        if not rospy.is_shutdown():
            raise
        raise KeyboardInterrupt from None  # somebody ended the node by ROS
    finally:
        _leave(master.master_uri)


def _why_nothing_comes(master, imus):
    """For a Watch: why nothing comes on topics, by what the master knows."""

    def reason(topic, publishers, subscribed, kinds):
        name = rospy.resolve_name(topic)
        if name not in publishers:
            return NOBODY
        if name not in subscribed:
            return ("the ROS master was started anew: start hexoderm-ros anew, too",) * 2
        if topic in imus and kinds.get(name) != sensor_msgs.msg.Imu._type:
            return (f"its type is {kinds.get(name)}, and not {sensor_msgs.msg.Imu._type}",) * 2
        return SENDS_NOTHING

    def why(topics):
        try:
            publishing, subscribing, _ = master.getSystemState()
            publishers = {each for each, nodes in publishing if nodes}
            subscribed = {each for each, nodes in subscribing if rospy.get_name() in nodes}
            kinds = dict(master.getTopicTypes())
        except (OSError, rosgraph.MasterException, xmlrpc.client.Error, http.client.HTTPException):
            return dict.fromkeys(topics, ("the ROS master does not answer",) * 2)
        return {topic: reason(topic, publishers, subscribed, kinds) for topic in topics}

    return why


def pass_on(skin, intake, watch, say_ready):
    """Passes the readings of the topics on until ROS ends, or the user ends it: KeyboardInterrupt."""

    def subscribe(topic, kind, callback):
        rospy.Subscriber(topic, kind, callback, queue_size=QUEUE, tcp_nodelay=True)

    def with_time(take):
        return lambda message: take(message, _now_us())

    with _node("hexoderm_ros") as (master, end):
        say_ready()
        for topic in skin.imus:
            subscribe(topic, sensor_msgs.msg.Imu, with_time(intake.imu(topic)))
        for names in skin.cell_data:
            subscribe(names.topic, rospy.AnyMsg, _OfAnyType(with_time(intake.cell_data(names))))
        with watching(watch, _why_nothing_comes(master, skin.imus)):
            end.wait()


def publish(transforms, say_ready):
    """Publishes static transforms until ROS ends, or the user ends it: KeyboardInterrupt."""
    with _node("hexoderm_transforms") as (_, end):
        messages = [each.put_in(geometry_msgs.msg.TransformStamped(), rospy.Time.now()) for each in transforms]
        tf2_ros.StaticTransformBroadcaster().sendTransform(messages)
        say_ready()
        end.wait()
