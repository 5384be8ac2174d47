"""Plays a table of raw accelerometer counts (time, x, y, z; a heading first) as a skin of one cell, on standard output.

Usage: csv_sender.py FILE ZERO COUNTS_PER_G [EVERY]: of every how many rows the first is sent
"""
import csv
import itertools
import json
import sys

path, zero, counts_per_g = sys.argv[1], float(sys.argv[2]), float(sys.argv[3])
every = int(sys.argv[4]) if len(sys.argv) > 4 else 1


def send(kind, **fields):
    print(json.dumps({kind: fields}))


send("hello", device="a table of counts", cell_model="hex-bma150")
send("topology", id=1, cells=[{"id": 1, "ports": []}])
with open(path, newline="") as table:
    rows = csv.reader(table)
    next(rows)
    for count, (time_s, *axes) in enumerate(itertools.islice(rows, 0, None, every)):
        reading = [(float(axis) - zero) / counts_per_g for axis in axes]
        send("samples", sequence=count, time_us=round(float(time_s) * 1e6), cells=[1], acceleration_g=reading)
