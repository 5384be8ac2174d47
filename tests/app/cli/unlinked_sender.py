"""Plays a skin of cells that report no neighbours, held in three directions, on standard output; as fast as it is read.

Usage: unlinked_sender.py CELLS CELL_MODEL_FILE
"""
import json
import random
import sys

count = int(sys.argv[1])
with open(sys.argv[2], encoding="utf-8") as file:
    model = json.load(file)
model["interface_id"] = 2**31  # above all cells
random.seed(1)
IDS_PER_MESSAGE = 10_000


def send(kind, **fields):
    print(json.dumps({kind: fields}, separators=(",", ":")))


def groups():
    ids = range(1, count + 1)
    return [ids[start:start + IDS_PER_MESSAGE] for start in range(0, count, IDS_PER_MESSAGE)]


send("hello", device="cells without neighbours", cell_model=json.dumps(model))
for part, ids in enumerate(groups()):
    send("topology", id=1, part=part, parts=len(groups()), cells=[{"id": cell, "ports": []} for cell in ids])
time_us = 0
for up in ((0, 0, 1), (0, 1, 0), (1, 0, 0)):
    for _ in range(25):
        reading = [round(axis + random.gauss(0, 0.002), 4) for axis in up]
        for ids in groups():
            send("samples", time_us=time_us, cells=list(ids), acceleration_g=reading * len(ids))
        time_us += 100_000
