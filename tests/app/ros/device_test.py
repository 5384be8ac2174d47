"""What hexoderm-ros sends is a skin to the command line: captured, and without an offence. No ROS is needed for it."""

import contextlib
import json
import socket
import subprocess
import threading
import time
import unittest

from hexoderm_ros.device import Device
from hexoderm_ros.skin import skin_from
from program import CLI, InFolder, Listener, description, held_and_turned, reading, run, wait_until

FASTER = 5  # than time; poses are told apart by the readings' own times


class Devices(InFolder):
    def setUp(self):
        super().setUp()
        self.session = self.simulate("--poses", 3, "--patch", "ring5")
        self.device = Device(skin_from(description(self.session)), 0)
        self.addCleanup(self.device.close)
        self.over = threading.Event()
        self.addCleanup(self.over.set)

    @contextlib.contextmanager
    def host(self):
        """A connection that was greeted, and what reads a message of it."""
        with socket.create_connection(("localhost", self.device.port)) as connection, connection.makefile() as lines:
            self.assertIn("hello", json.loads(lines.readline()))
            yield connection, lambda: json.loads(lines.readline())

    def play(self):
        begin = time.monotonic()
        for time_s, cells in held_and_turned(self.session):
            while time.monotonic() - begin < time_s / FASTER:
                time.sleep(0.001)
            for cell, vector in cells.items():
                self.device.add(reading(1000 + time_s, cell, vector))
            if self.over.is_set():
                return

    def capture(self, *arguments):
        process = subprocess.Popen([CLI, "capture", "--source", f"tcp://localhost:{self.device.port}", "-o",
                                    self.folder / "live.hexo", *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True)
        self.addCleanup(process.__exit__, None, None, None)
        self.addCleanup(process.kill)
        return Listener(process)

    def test_a_calibration(self):
        player = threading.Thread(target=self.play)
        capture = self.capture("--poses", "3", "--json")
        capture.wait_for("skin of the test: 5 cells")  # it is connected
        player.start()
        capture.process.wait(60)
        said = json.loads(capture.process.stdout.read())
        player.join()
        self.assertEqual((said["poses"], said["offences"]), (3, []))
        self.assertEqual((said["lost_samples"], said["rejected_messages"]), (0, 0))
        self.assertEqual(said["device"], "skin of the test")
        run("solve", self.folder / "live.hexo", "-o", self.folder / "c.json")
        self.assertLess(self.position_rms_mm(self.folder / "c.json"), 5)

    def test_a_host_that_takes_nothing_does_not_hold_anything_up(self):
        with socket.create_connection(("localhost", self.device.port)):
            begin = time.monotonic()
            for k in range(60_000):
                self.device.add(reading(1000 + k * 0.02, 1))
            self.assertLess(time.monotonic() - begin, 30)
            wait_until(lambda: self.device.counts()["dropped"] > 0, "nothing was dropped")
        with self.host():  # the next one is welcome
            pass

    def test_what_comes_without_a_host_is_not_sent(self):
        self.device.add(reading(1000, 1) + reading(1001, 1))


        def is_first_taken():
            self.device.add(reading(1000, 1))
            return self.device.counts()["late"] > 0

        wait_until(is_first_taken, "the first was not taken")
        self.assertEqual(self.device.counts()["sent"], 0)
        with self.host() as (_, read):
            self.device.add(reading(1002, 1) + reading(1002, 2))
            came = []
            while not came or came[-1]["time_us"] < 1002e6:
                came += filter(None, [read().get("samples")])
            self.assertEqual(self.device.counts()["sent"], sum(len(each["cells"]) for each in came))

    def test_a_second_host_is_told_to_wait_and_then_connected(self):
        with self.host() as (first, _), self.host() as (_, read):
            self.assertIn("topology", read())
            self.assertIn("127.0.0.1 is connected already", read()["status"]["text"])
            with socket.create_connection(("localhost", self.device.port)):
                pass  # one that does not wait is forgotten
            first.shutdown(socket.SHUT_RDWR)
            while "hello" not in (message := read()):  # which comes again
                self.assertIn("is connected already", message["status"]["text"])
            self.assertIn("topology", read())

    def test_the_command_line_says_that_another_host_is_connected(self):
        with self.host():
            capture = self.capture()
            self.assertRegex(capture.wait_for("127.0.0.1 is connected already"), "No readings for [0-9]+ s. ")
            self.assertNotIn("wrong", capture.end())

    def test_commands_are_answered(self):
        with self.host() as (host, read):
            self.assertEqual(len(read()["topology"]["cells"]), 5)
            host.sendall(b'{"command":{"number":4,"set_led":{"cell":1,"red":255}}}\nno line\n'
                         b'{"command":{"describe":{}}}\n')
            found = [read() for _ in range(3)]
        ack = next(each["ack"] for each in found if "ack" in each)
        self.assertEqual((ack["command"], ack["done"]), (4, False))
        self.assertTrue(any("hello" in each for each in found))
