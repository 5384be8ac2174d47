"""A device on TCP that speaks SkinWire in lines of JSON: what Hexoderm connects to as tcp://HOST:PORT."""

import contextlib
import json
import random
import select
import socket
import threading
import time

from hexoderm_ros.console import say
from hexoderm_ros.stream import Stream

MOST_WAITING_BYTES = 1 << 20  # for a host that takes nothing; samples beyond are dropped
IDLE_S = 0.3  # when nothing comes any more, what is held is sent
STATUS_EVERY_S = 0.5
MOST_IN_LINE = 8  # hosts that wait for the one that is connected


def _as_lines(messages):
    return b"".join(json.dumps(message).encode() + b"\n" for message in messages)


class Device:
    """Serves one host at a time on a thread of its own, and tells others that they have to wait; add() can be called from
    any thread and never waits."""

    def __init__(self, skin, port, address="127.0.0.1"):
        self._skin = skin
        self._lock = threading.Lock()
        self._stream = Stream(random.randrange(1, 2**31))
        self._waiting = bytearray()
        self._host = None
        self._in_line = {}  # sockets of those who wait, and what they have not taken yet
        self._heard = bytearray()
        self._sent = 0  # to hosts, in readings; without one they go nowhere
        self._dropped = 0
        self._came_s = self._said_s = time.monotonic()
        self._server = socket.create_server((address, port))
        self.port = self._server.getsockname()[1]
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def add(self, readings):
        with self._lock:
            self._came_s = time.monotonic()
            for reading in readings:
                if self._stream.add(reading):
                    self._say_samples(self._stream.ended)
                    self._say_what_it_is()

    def counts(self):
        with self._lock:
            return {"sent": self._sent, "late": self._stream.late, "repeated": self._stream.repeated,
                    "dropped": self._dropped}

    def close(self):
        self._over.set()
        self._thread.join()
        self._server.close()
        for host in filter(None, [self._host, *self._in_line]):
            host.close()

    def _say(self, message):
        if self._host is not None:
            self._waiting += _as_lines([message])

    def _what_it_is(self):
        return [{"hello": {"minor": 1, "device": self._skin.device, "cell_model": self._skin.cell_model,
                           "stream": self._stream.number}},
                {"topology": {"id": 1, "cells": list(self._skin.cells)}}]

    def _say_what_it_is(self):
        for message in self._what_it_is():
            self._say(message)

    def _say_samples(self, messages):
        for message in messages:
            self._said_s = time.monotonic()
            if self._host is None:
                continue
            count = len(message["samples"]["cells"])
            if len(self._waiting) < MOST_WAITING_BYTES:
                self._say(message)
                self._sent += count
            else:
                self._dropped += count

    def _say_what_is_due(self):
        is_idle = time.monotonic() - self._came_s > IDLE_S
        self._say_samples(self._stream.take(everything=is_idle))
        if time.monotonic() - self._said_s > STATUS_EVERY_S:
            self._said_s = time.monotonic()
            self._say({"status": {"text": "no readings come on the topics", "samples_sent": self._stream.sequence,
                                  "samples_dropped": self._dropped}})

    def _serve(self):
        told_s = 0
        while not self._over.is_set():
            with self._lock:
                self._say_what_is_due()
                sockets = [self._server, *filter(None, [self._host, *self._in_line])]
                writing = [self._host] if self._host is not None and self._waiting else []
            readable, writable, _ = select.select(sockets, writing, [], 0.02)
            with self._lock:
                try:
                    if self._host in readable:
                        self._hear()
                    if self._host in writable:
                        del self._waiting[: self._host.send(self._waiting)]
                except BlockingIOError:
                    pass
                except OSError:
                    self._part()
                self._keep_in_line(readable)
                if self._server in readable:
                    self._welcome()
                if self._in_line and time.monotonic() - told_s > STATUS_EVERY_S:
                    told_s = time.monotonic()
                    self._tell_who_is_in_line()

    def _welcome(self):
        host, (address, *_) = self._server.accept()
        host.setblocking(False)
        if self._host is None:
            self._connect(host, b"")
        elif len(self._in_line) < MOST_IN_LINE:
            # It knows what it waits for: a device that does not describe itself would seem to be broken.
            self._in_line[host] = bytearray(_as_lines(self._what_it_is()))
            say(f"{address} waits: {self._address_of_host()} is connected, and readings go to one host at a time")
        else:
            host.close()

    def _connect(self, host, begun):
        self._host = host
        self._waiting[:] = begun
        self._heard.clear()
        self._say_what_it_is()

    def _part(self):
        self._host.close()
        self._host = None
        self._waiting.clear()
        if self._in_line:
            host = next(iter(self._in_line))
            self._connect(host, self._in_line.pop(host))

    def _address_of_host(self):
        with contextlib.suppress(OSError):
            return self._host.getpeername()[0]
        return "another host"

    def _keep_in_line(self, readable):
        """Commands of those who wait are not looked at, only whether they are still there."""
        for host in [each for each in self._in_line if each in readable]:
            try:
                if host.recv(65536):
                    continue
            except BlockingIOError:
                continue
            except OSError:
                pass
            del self._in_line[host]
            host.close()

    def _who_is_connected(self):
        return {"status": {"text": f"{self._address_of_host()} is connected already, and readings go to one host at a time"}}

    def _tell_who_is_in_line(self):
        for host, waiting in self._in_line.items():
            if not waiting:
                waiting += _as_lines([self._who_is_connected()])
            with contextlib.suppress(OSError):  # that it is gone is heard
                del waiting[: host.send(waiting)]

    def _hear(self):
        data = self._host.recv(65536)
        if not data:
            raise ConnectionResetError
        self._heard += data
        *lines, self._heard = self._heard.split(b"\n")
        for line in lines:
            self._answer(line)
        if len(self._heard) > MOST_WAITING_BYTES:
            raise ConnectionResetError  # this is no host

    def _answer(self, line):
        try:
            command = json.loads(line).get("command")
        except (ValueError, AttributeError):
            return
        if not isinstance(command, dict):
            return
        if "describe" in command:
            self._say_what_it_is()
            return
        self._say({"ack": {"command": command.get("number", 0), "done": False,
                           "text": "hexoderm-ros passes readings on, and nothing back"}})
