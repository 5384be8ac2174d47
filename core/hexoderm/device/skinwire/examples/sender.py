#!/usr/bin/env python3
"""A skin of three cells in the line dialect of SkinWire 1: one JSON object a line. Standard library only.

  sender.py | hexoderm-cli capture --source stdin ...        on standard output
  sender.py --port 7700                                      as a device on TCP, which also answers commands

The cells lie flat in a row and tremble a little. --port 0 takes any free port. What is listened to goes to stderr.
"""
import argparse
import json
import random
import select
import socket
import sys
import time

CELLS = [1, 2, 3]
RATE_HZ = 100


def description():
    """Hello and Topology: port 2 of each cell is joined to port 3 of the next."""
    yield {"hello": {"device": "three cells in Python", "cell_model": "hex-bma150", "rate_hz": RATE_HZ,
                     "can_light_cells": True, "stream": random.randrange(1, 2**32)}}
    cells = []
    for cell in CELLS:
        ports = []
        if cell + 1 in CELLS:
            ports.append({"port": 2, "cell": cell + 1, "cell_port": 3})
        if cell - 1 in CELLS:
            ports.append({"port": 3, "cell": cell - 1, "cell_port": 2})
        cells.append({"id": cell, "ports": ports})
    yield {"topology": {"id": 1, "cells": cells}}


def samples(sequence, time_us):
    """One tick of all cells, in g. `sequence` is how many samples were sent before."""
    acceleration_g = []
    for _ in CELLS:
        acceleration_g += [random.gauss(0, 0.005), random.gauss(0, 0.005), random.gauss(1, 0.005)]
    return {"samples": {"sequence": sequence, "time_us": time_us, "cells": CELLS, "acceleration_g": acceleration_g}}


def answer(line):
    """The Ack for a command, or None: Describe is answered by the description itself."""
    command = json.loads(line).get("command")
    if command is None or "describe" in command:
        return None
    number = command.get("number", 0)
    if "set_led" in command:
        print("light of cell", command["set_led"].get("cell"), file=sys.stderr, flush=True)
        return {"ack": {"command": number, "done": True}}
    return {"ack": {"command": number, "done": False, "text": "this example can only light its cells"}}


def stream(send, receive, end_s):
    """Describes the skin and samples until `end_s` (monotonic) or until the other side goes."""
    for message in description():
        send(message)
    start_s = time.monotonic()
    sequence = 0
    tick = 0
    while time.monotonic() < end_s:
        send(samples(sequence, tick * 1_000_000 // RATE_HZ))
        sequence += len(CELLS)
        tick += 1
        wait_s = start_s + tick / RATE_HZ - time.monotonic()
        for line in receive(max(wait_s, 0)):
            reply = answer(line)
            if reply:
                send(reply)


def on_standard_output(end_s):
    def send(message):
        print(json.dumps(message), flush=True)

    def receive(wait_s):
        time.sleep(wait_s)
        return []

    stream(send, receive, end_s)


def on_tcp(port, end_s):
    with socket.create_server(("127.0.0.1", port)) as server:
        print("listening on tcp://127.0.0.1:%d" % server.getsockname()[1], file=sys.stderr, flush=True)
        while time.monotonic() < end_s:
            if not select.select([server], [], [], 0.1)[0]:
                continue
            connection, _ = server.accept()
            pending = b""

            def send(message):
                connection.sendall(json.dumps(message).encode() + b"\n")

            def receive(wait_s):
                nonlocal pending
                if not select.select([connection], [], [], wait_s)[0]:
                    return []
                data = connection.recv(65536)
                if not data:
                    raise ConnectionError
                *lines, pending = (pending + data).split(b"\n")
                return [line for line in lines if line.strip()]

            with connection:
                try:
                    stream(send, receive, end_s)
                except ConnectionError:
                    pass  # the host went; wait for the next


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--port", type=int, help="TCP port to listen on; without it, standard output")
    parser.add_argument("--seconds", type=float, default=float("inf"), help="end after so many seconds")
    arguments = parser.parse_args()
    end_s = time.monotonic() + arguments.seconds
    try:
        if arguments.port is None:
            on_standard_output(end_s)
        else:
            on_tcp(arguments.port, end_s)
    except (BrokenPipeError, KeyboardInterrupt):
        sys.stderr.close()  # nobody listens any more


if __name__ == "__main__":
    main()
