"""ROS 1 as it is: a master, bags that are played to hexoderm-cli through hexoderm-ros, and TF that is looked up."""

import contextlib
import http.client
import json
import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
import unittest
import xmlrpc.client
from unittest import mock

from program import CLI, GRAVITY, InFolder, Listener, description, held_and_turned, run, wait_until


def free_port():
    with socket.create_server(("localhost", 0)) as server:
        return server.getsockname()[1]


# Before rospy is imported. Nothing of the user's own ROS is touched.
os.environ.update(ROS_MASTER_URI=f"http://localhost:{free_port()}", ROS_HOSTNAME="localhost")
os.environ.pop("ROS_IP", None)

import genpy  # noqa: E402
import genpy.dynamic  # noqa: E402
import rosbag  # noqa: E402
import rosgraph  # noqa: E402
import rospy  # noqa: E402
import sensor_msgs.msg  # noqa: E402
import std_msgs.msg  # noqa: E402
import tf2_ros  # noqa: E402

from hexoderm_ros import ros1  # noqa: E402

ONE_CELL = {"cells": [{"id": 1, "imu": "/imu"}]}
DEFINITION = """Cell[] data
================================================================================
MSG: test_skin/Cell
int32 cellId
float32[] acc
"""


class Reasons(unittest.TestCase):
    """Why nothing comes, of a master that is made up."""

    TOPICS = ("/imu1", "/imu2", "/imu3", "/cells")

    def reasons(self, **answers):
        why = ros1._why_nothing_comes(mock.Mock(**answers), {"/imu1": {}, "/imu2": {}, "/imu3": {}})
        with mock.patch("rospy.get_name", return_value="/adapter"):
            return {topic: of_one for topic, (of_one, _) in why(self.TOPICS).items()}

    def state(self, subscribers):
        publishers = [["/imu1", []], ["/imu2", ["/a"]], ["/imu3", ["/a"]], ["/cells", ["/a"]]]
        return mock.Mock(return_value=(publishers, [[topic, subscribers] for topic in self.TOPICS], []))

    def test_the_master_is_asked_once_for_all_topics(self):
        state = self.state(["/other", "/adapter"])
        types = mock.Mock(return_value=[["/imu2", "a/B"], ["/imu3", "sensor_msgs/Imu"], ["/cells", "a/B"]])
        self.assertEqual(self.reasons(getSystemState=state, getTopicTypes=types),
                         {"/imu1": "nobody publishes it", "/imu2": "its type is a/B, and not sensor_msgs/Imu",
                          "/imu3": "its publisher sends nothing", "/cells": "its publisher sends nothing"})
        self.assertEqual((state.call_count, types.call_count), (1, 1))

    def test_a_master_that_was_started_anew(self):
        reasons = self.reasons(getSystemState=self.state(["/other"]), getTopicTypes=mock.Mock(return_value=[]))
        anew = "the ROS master was started anew: start hexoderm-ros anew, too"
        self.assertEqual(reasons, {"/imu1": "nobody publishes it", "/imu2": anew, "/imu3": anew, "/cells": anew})

    def test_a_master_that_does_not_answer(self):
        for error in (ConnectionRefusedError(), rosgraph.MasterError("no"), xmlrpc.client.Fault(1, "no"),
                      http.client.RemoteDisconnected(), http.client.BadStatusLine("")):
            self.assertEqual(self.reasons(getSystemState=mock.Mock(side_effect=error)),
                             dict.fromkeys(self.TOPICS, "the ROS master does not answer"))


class Ros1(InFolder):
    def setUp(self):
        super().setUp()
        os.environ.update(ROS_HOME=str(self.folder / "ros"), ROS_LOG_DIR=str(self.folder / "ros/log"))
        port = os.environ["ROS_MASTER_URI"].rpartition(":")[2]
        self.start_master(port)
        wait_until(rosgraph.Master("/test").is_online, "the ROS master does not answer")
        rospy.init_node("test", anonymous=True, disable_signals=True)

    def start_master(self, port):
        """The master of roscore, without its log and launcher, which take seconds to start and to end."""
        return self.start("rosmaster", "--core", "-p", port)

    def start(self, *command, **how):
        process = subprocess.Popen([*map(str, command)], stdout=how.pop("stdout", subprocess.DEVNULL),
                                   stderr=how.pop("stderr", subprocess.DEVNULL), text=True, **how)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        for stream in (process.stdout, process.stderr):
            if stream is not None:
                stream.close()

    def begin_adapter(self, document, **how):
        (self.folder / "skin.json").write_text(json.dumps(document))
        return Listener(self.start(sys.executable, "-m", "hexoderm_ros", "skin", self.folder / "skin.json", "--port", "0",
                                   stderr=subprocess.PIPE, **how))

    def end_adapter(self, adapter):
        """All that it said."""
        said = adapter.end()
        self.assertEqual(adapter.process.returncode, 0, said)
        return said

    def start_adapter(self, document):
        adapter = self.begin_adapter(document)
        line = adapter.wait_for(" on tcp://")
        self.assertRegex(line, r"hexoderm-ros: \d+ cells? on tcp://127.0.0.1:\d+")
        return adapter, re.search(r"tcp://\S+", line)[0]

    @staticmethod
    def wait_for_reading(address):
        host, port = address.removeprefix("tcp://").split(":")
        deadline = time.monotonic() + 60
        with socket.create_connection((host, int(port)), timeout=60) as connection:
            for line in connection.makefile():
                if "samples" in json.loads(line):
                    return
                if time.monotonic() > deadline:
                    raise AssertionError("no reading came")
        raise AssertionError("the adapter ended the connection")

    def wait_for_subscribers(self, topics):
        wait_until(lambda: topics <= {topic for topic, _ in rosgraph.Master("/test").getSystemState()[1]},
                   f"not all of {topics} are subscribed to")

    def capture_while_played(self, address, bag, topics, rate=4):
        self.wait_for_subscribers(topics)
        capture = Listener(self.start(CLI, "capture", "--source", address, "--poses", "3", "-o", self.folder / "live.hexo",
                                      "--json", stdout=subprocess.PIPE, stderr=subprocess.PIPE))
        capture.wait_for(": 5 cells")  # it is connected
        self.start("rosbag", "play", "--quiet", "--delay", "1", "--rate", rate, bag)
        capture.process.wait(120)
        said = json.loads(capture.process.stdout.read())
        self.assertEqual((said["poses"], said["offences"], said["rejected_messages"]), (3, [], 0))
        run("solve", self.folder / "live.hexo", "-o", self.folder / "c.json")
        self.assertLess(self.position_rms_mm(self.folder / "c.json"), 5)

    def test_a_bag_of_imus_becomes_a_calibration(self):
        session = self.simulate("--poses", 3, "--patch", "ring5")
        with rosbag.Bag(str(self.folder / "imu.bag"), "w") as bag:
            for time_s, cells in held_and_turned(session):
                stamp = genpy.Time.from_sec(1000 + time_s)
                for cell, vector in cells.items():
                    message = sensor_msgs.msg.Imu()
                    message.header.stamp = stamp
                    acceleration = message.linear_acceleration
                    acceleration.x, acceleration.y, acceleration.z = (value * GRAVITY for value in vector)
                    bag.write(f"/imu/cell{cell}", message, stamp)
        adapter, address = self.start_adapter(description(session))
        self.capture_while_played(address, self.folder / "imu.bag", {f"/imu/cell{k}" for k in range(1, 6)})
        self.assertRegex(self.end_adapter(adapter), r"hexoderm-ros: [1-9]\d* sent, 0 late, 0 repeated, 0 dropped")

    def test_a_bag_of_cell_data_becomes_a_calibration(self):
        types = genpy.dynamic.generate_dynamic("test_skin/Cells", DEFINITION)
        session = self.simulate("--poses", 3, "--patch", "ring5")
        with rosbag.Bag(str(self.folder / "cells.bag"), "w") as bag:
            for time_s, cells in held_and_turned(session):
                message = types["test_skin/Cells"]()
                message.data = [types["test_skin/Cell"](cell, vector) for cell, vector in cells.items()]
                bag.write("/skin/cells", message, genpy.Time.from_sec(1000 + time_s))
        document = {"cells": session["cells"], "cell_data": {"topic": "/skin/cells"}}
        _, address = self.start_adapter(document)
        # The messages have no time of their own: it is that at which they come.
        self.capture_while_played(address, self.folder / "cells.bag", {"/skin/cells"}, rate=1)

    def publish(self, topic, kind, make, rate_hz=50):
        """Publishes until the test is over: make() makes a message."""
        over = threading.Event()
        publisher = rospy.Publisher(topic, kind, queue_size=10)

        def run():
            while not over.wait(1 / rate_hz):
                publisher.publish(make())

        thread = threading.Thread(target=run)
        thread.start()

        def end():
            over.set()
            thread.join()
            publisher.unregister()

        self.addCleanup(end)
        return end

    @staticmethod
    def imu(frame="", ahead_s=0.0):
        message = sensor_msgs.msg.Imu()
        message.header.frame_id = frame
        message.header.stamp = rospy.Time.from_sec(time.time() + ahead_s)
        message.linear_acceleration.z = GRAVITY
        return message

    def test_cells_on_one_topic_and_one_whose_clock_is_another(self):
        for k, ahead_s in ((1, 0), (2, 0), (3, 3600), (5, 0)):
            self.publish("/imu", sensor_msgs.msg.Imu, lambda k=k, ahead_s=ahead_s: self.imu(f"cell_{k}", ahead_s))
        adapter, _ = self.start_adapter({"cells": [{"id": k, "imu": "/imu", "frame_id": f"cell_{k}"} for k in (1, 2, 3, 4)]})
        adapter.wait_for('/imu: left out are readings of a frame_id that no cell has ("cell_5")\n')
        adapter.wait_for("the stamps of cell 3 are 3600 s ahead of the others")
        adapter.wait_for("no readings of cell 4, though messages come on /imu\n")
        said = self.end_adapter(adapter)
        self.assertRegex(said, r"left out: \d+ readings of a frame_id that no cell has\n")
        for once in ("left out are", "the stamps of", "no readings of"):
            self.assertEqual(said.count(once), 1, said)

    def test_a_topic_that_stops_and_comes_back_is_named(self):
        end = self.publish("/imu1", sensor_msgs.msg.Imu, self.imu)
        adapter, address = self.start_adapter({"cells": [{"id": 1, "imu": "/imu1"}]})
        self.wait_for_reading(address)
        end()
        gone = "nothing any more on /imu1 (cell 1); nobody publishes it"
        adapter.wait_for(gone)
        self.publish("/imu1", sensor_msgs.msg.Imu, self.imu)
        adapter.wait_for("messages come on /imu1 (cell 1)", after=gone)
        self.assertEqual(self.end_adapter(adapter).count(gone), 1)

    def test_why_nothing_comes(self):
        self.publish("/imu3", std_msgs.msg.String, std_msgs.msg.String)
        silent = rospy.Publisher("/imu2", sensor_msgs.msg.Imu, queue_size=1)
        self.addCleanup(silent.unregister)
        adapter, _ = self.start_adapter({"cells": [{"id": k, "imu": f"/imu{k}"} for k in (1, 2, 3)]})
        for line in ("nothing on /imu1 (cell 1); nobody publishes it\n", "nothing on /imu2 (cell 2); its publisher sends nothing\n",
                     "nothing on /imu3 (cell 3); its type is std_msgs/String, and not sensor_msgs/Imu\n"):
            adapter.wait_for(line)
        self.assertEqual(self.end_adapter(adapter).count("nothing on"), 3)

    def test_a_wrong_name_of_a_field_is_said_once(self):
        types = genpy.dynamic.generate_dynamic("test_skin/Cells", DEFINITION)
        adapter, _ = self.start_adapter({"cells": [{"id": 1}], "cell_data": {"topic": "/skin/cells", "array": "dat"}})
        several, published = threading.Event(), []

        def make():
            published.append(1)
            if len(published) >= several_from[0]:
                several.set()
            return types["test_skin/Cells"]()

        several_from = [sys.maxsize]
        end = self.publish("/skin/cells", types["test_skin/Cells"], make)
        line = 'cell_data /skin/cells: test_skin/Cells has no field "dat"; it has data\n'
        adapter.wait_for(line)
        several_from[0] = len(published) + 20
        self.assertTrue(several.wait(60))
        end()
        adapter.wait_for("nothing any more on /skin/cells")  # so that all have come
        said = self.end_adapter(adapter)
        self.assertEqual(said.count(line), 1, said)
        self.assertGreater(int(re.search(r"left out: (\d+) messages without the fields", said)[1]), 1)
        self.assertNotIn("Traceback", said)

    def test_without_a_master_it_waits(self):
        there = dict(os.environ, ROS_MASTER_URI=f"http://localhost:{free_port()}")
        adapter = self.begin_adapter(ONE_CELL, env=there)
        adapter.wait_for(f"no ROS master answers at {there['ROS_MASTER_URI']}; waiting (is roscore running?")
        self.assertEqual(self.end_adapter(adapter).splitlines()[1:], ["hexoderm-ros: 0 sent, 0 late, 0 repeated, 0 dropped"])
        adapter = self.begin_adapter(ONE_CELL, env=there)
        adapter.wait_for("no ROS master")
        self.start_master(there["ROS_MASTER_URI"].rpartition(":")[2])
        adapter.wait_for("1 cell on tcp://")
        self.end_adapter(adapter)

    def test_ctrl_c_ends_it_while_a_master_does_not_answer(self):
        with socket.create_server(("localhost", 0)) as silent:
            uri = f"http://localhost:{silent.getsockname()[1]}"
            adapter = self.begin_adapter(ONE_CELL, env=dict(os.environ, ROS_MASTER_URI=uri))
            adapter.wait_for(f"no ROS master answers at {uri}")
            self.end_adapter(adapter)

    def wait_until_no_adapter_is_known(self):
        wait_until(lambda: not any("/hexoderm_ros" in node for _, nodes in sum(rosgraph.Master("/test").getSystemState(), [])
                                   for node in nodes), "the master still knows the node")

    def test_ctrl_c_ends_it_at_any_moment_of_its_beginning(self):
        document = {"cells": [{"id": k, "imu": f"/imu{k}"} for k in range(1, 60)]}
        for delay_s in (0, 0.01, 0.02, 0.05, 0.1, 0.2):
            adapter, _ = self.start_adapter(document)
            time.sleep(delay_s)
            self.assertNotIn("Traceback", self.end_adapter(adapter))
            self.wait_until_no_adapter_is_known()

    def test_signals_end_it_while_it_begins(self):
        (self.folder / "skin.json").write_text(json.dumps(ONE_CELL))
        for number, delay_s in ((signal.SIGINT, 0), (signal.SIGTERM, 0), (signal.SIGINT, 0.05), (signal.SIGTERM, 0.1)):
            port = free_port()
            adapter = Listener(self.start(sys.executable, "-m", "hexoderm_ros", "skin", self.folder / "skin.json", "--port",
                                          port, stderr=subprocess.PIPE))
            wait_until(lambda: self.listens(port), "it does not listen")  # and has not yet begun with ROS, or not for long
            time.sleep(delay_s)
            said = adapter.end(number)
            self.assertIn(adapter.process.returncode, (0, -signal.SIGTERM) if number == signal.SIGTERM else (0,), said)
            self.assertNotIn("Traceback", said)

    @staticmethod
    def listens(port):
        with contextlib.suppress(ConnectionRefusedError), socket.create_connection(("localhost", port)):
            return True

    def test_a_master_that_falls_silent_holds_ctrl_c_up_for_a_moment_only(self):
        master = self.start_master(port := str(free_port()))
        there = dict(os.environ, ROS_MASTER_URI=f"http://localhost:{port}")
        adapter = self.begin_adapter(ONE_CELL, env=there)
        adapter.wait_for(" on tcp://")
        master.send_signal(signal.SIGSTOP)
        try:
            self.end_adapter(adapter)
        finally:
            master.send_signal(signal.SIGCONT)

    def test_transforms_are_published(self):
        self.simulate("--poses", 3)
        run("solve", self.folder / "true.session.json", "-o", self.folder / "c.json")
        run("export", self.folder / "c.json", "--to", "tf-yaml", "--place", "forearm:0.02,0,0.1,0,1.57,0", "-o",
            self.folder / "tf.yaml")
        self.start(sys.executable, "-m", "hexoderm_ros", "transforms", self.folder / "tf.yaml")
        buffer = tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer)
        patch = json.loads((self.folder / "c.json").read_text())["patches"][0]
        for cell in patch["cells"]:
            found = buffer.lookup_transform("skin_patch0", f"skin_cell{cell['id']}", rospy.Time(0),
                                            rospy.Duration(20)).transform
            for name, value in zip("xyz", cell["t_o_u_m"]):
                self.assertAlmostEqual(getattr(found.translation, name), value, 12)
            quaternion = [getattr(found.rotation, name) for name in "wxyz"]
            dot = sum(a * b for a, b in zip(quaternion, cell["q_o_u_wxyz"]))
            self.assertAlmostEqual(abs(dot), 1, 12)
        placed = buffer.lookup_transform("forearm", "skin_patch0", rospy.Time(0), rospy.Duration(20)).transform
        self.assertAlmostEqual(placed.translation.z, 0.1)
        listener.unregister()
