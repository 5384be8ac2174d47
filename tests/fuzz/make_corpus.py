#!/usr/bin/env python3
"""Makes the inputs in tests/fuzz/corpus that are of Hexoderm's own formats, which may change: from tests/data and from a few
small sessions written out here. All other inputs are files like any others.

Usage: tests/fuzz/make_corpus.py [HEXODERM_CLI]      with the program also calibrations, which it solves
"""
import json
import pathlib
import sqlite3
import struct
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
DATA = HERE.parent / "data"
MODEL = json.loads((HERE.parent.parent / "resources/cell_models/hex-bma150.json").read_text())
LENGTH, COBS, LINES, DETECTED, RECORDING, GOOD_BODIES = 0, 1, 2, 3, 4, 8


def put(target, name, content):
    folder = HERE / "corpus" / target
    folder.mkdir(parents=True, exist_ok=True)
    (folder / ("seed_" + name)).write_bytes(content)


def skinwire():
    vectors = {p.stem: bytes.fromhex(p.read_text()) for p in sorted((DATA / "skinwire").glob("*.hex"))}
    lines = {p.stem: p.read_bytes().strip() for p in sorted((DATA / "skinwire").glob("*.json"))}
    order = ["hello", "topology", "samples_raw", "samples_float", "samples_mean", "status", "ack"]
    order += [name for name in vectors if name not in order]
    framed = b"".join(struct.pack("<I", len(vectors[name])) + vectors[name] for name in order)
    records = b"".join(struct.pack("<QI", k * 1000, len(vectors[name])) + vectors[name] for k, name in enumerate(order))
    bodies = b"".join(struct.pack("<BH", vectors[name][1], len(vectors[name]) - 6) + vectors[name][2:-4]
                      for name in order)
    put("skinwire", "length", bytes([LENGTH, 6]) + framed)
    put("skinwire", "detected_length", bytes([DETECTED, 0]) + framed)
    put("skinwire", "recording", bytes([RECORDING, 0]) + records)
    for name, stream in (("length", LENGTH), ("cobs", COBS), ("recording", RECORDING)):
        put("skinwire", "bodies_" + name, bytes([stream | GOOD_BODIES, 99]) + bodies)
    # The acknowledgement in core/hexoderm/device/skinwire/README.md.
    ack = bytes.fromhex("1d 01 06 08 02 1a 12 74 68 65 72 65 20 69 73 20 6e 6f 20 63 65 6c 6c 20 37 ff 4e ad fe 00")
    put("skinwire", "cobs", bytes([COBS, 3]) + b"garbage\0" + ack + ack)
    all_lines = b"\n".join(lines[name] for name in order) + b"\n"
    put("skinwire", "lines", bytes([LINES, 40]) + b"# not a message\r\n" + all_lines)
    put("skinwire", "detected_lines", bytes([DETECTED, 255]) + all_lines)


def cobs(body):
    blocks = b"".join(bytes([len(block) + 1]) + block for block in body.split(b"\0"))
    return blocks + b"\0"


def skinwire_device():
    """Commands, as a host sends them; no body has 254 bytes without a zero."""
    bodies = [bytes.fromhex(p.read_text()) for p in sorted((DATA / "skinwire").glob("command_*.hex"))]
    length, datagram, buffer_size = 1, 2, 64
    put("skinwire_device", "cobs", bytes([0, buffer_size]) + b"\0garbage\0" + b"".join(map(cobs, bodies)))
    put("skinwire_device", "small_buffer", bytes([0, 8]) + b"".join(map(cobs, bodies)))
    put("skinwire_device", "length", bytes([length, buffer_size]) +
        b"".join(struct.pack("<I", len(body)) + body for body in bodies))
    put("skinwire_device", "datagram", bytes([datagram, 0]) + bodies[-1])
    payloads = b"".join(struct.pack("<BH", body[1], len(body) - 6) + body[2:-4] for body in bodies)
    for name, framing in (("cobs", 0), ("length", length)):
        put("skinwire_device", "bodies_" + name, bytes([framing | GOOD_BODIES, buffer_size]) + payloads)
    # Two requests, one of them in two pieces; fields that are not known; a group.
    odd = [bytes.fromhex(text) for text in ("08 07 1a 02 08 05 12 09 09 00 00 00 00 00 40 7f 40", "1a 02 08 05 08 07 1a 04 10 09 18 80 01",
                                            "08 07 78 96 01 4a 02 01 02", "08 07 73 74 2a 00")]
    put("skinwire_device", "bodies_odd", bytes([GOOD_BODIES, buffer_size]) +
        b"".join(struct.pack("<BH", 5, len(payload)) + payload for payload in odd))


def documents():
    put("session_json", "three_cells", (DATA / "three_cells.session.json").read_bytes())
    session = {"format": "hexoderm-session", "version": 1, "cell_model": MODEL, "cells": [{"id": 1, "ports": []}],
               "poses": [{"id": 1, "taken_at_ms": 1, "disabled": True, "why_disabled": "moved",
                          "samples": [{"cell": 1, "mean_g": [0, 0, 1], "temperature_c": 21.5}]}]}
    put("session_json", "own_model", json.dumps(session).encode())


def hostile_documents():
    """One of each kind that readers must refuse, or take without harm."""
    text = (DATA / "three_cells.session.json").read_text()
    put("session_json", "key_twice", text.replace('"id": 2', '"id": 1, "id": 2').encode())
    put("session_json", "nested", text.replace('"poses": [', '"poses": [' + "[" * 3000, 1).encode())
    put("session_json", "huge_numbers", text.replace('"count": 100', '"count": 99999999999999999999').encode())
    put("session_json", "control_characters",
        text.replace('"description": "', '"description": "\\u001b]0;x\\u0007\\u009b2J', 1).encode())
    put("session_json", "no_utf8", text.encode().replace(b'"description": "', b'"description": "\xff\x9b', 1))
    session = json.loads(text)
    session["poses"][0]["samples"][0]["cov_g2"] = [1e-6, 2e-6, 0, 1e-6, 0, 1e-6]
    put("session_json", "indefinite", json.dumps(session).encode())
    put("session_json", "cells_minus_one", json.dumps({**session, "cells": -1}).encode())
    put("session_json", "cell_of_15_m", json.dumps({**session, "cell_model": {**MODEL, "side_m": 15}}).encode())


def calibrations(program):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "x.calibration.json"
        subprocess.run([program, "solve", "--quiet", "-o", path, DATA / "three_cells.session.json"],
                       stdout=subprocess.DEVNULL)
        text = path.read_text()
    put("calibration_json", "three_cells", text.encode())
    put("calibration_json", "key_twice", text.replace('"origin":', '"origin": 2, "origin":', 1).encode())
    put("calibration_json", "control_characters", text.replace('"text": "', '"text": "\\u001b[31m', 1).encode())
    calibration = json.loads(text)
    calibration["patches"][0]["cells"][1]["cov_t_r"] = [1e-6, 2e-6, 0, 0, 0, 0, 1e-6] + [0] * 14
    put("calibration_json", "indefinite", json.dumps(calibration).encode())


def entry(kind, detail, samples=None, raw=None):
    kinds = ["skin", "capture", "source", "truth", "remove", "restore", "disable", "enable", "options", "mute", "unmute", "joints"]
    flags = (0x10 if samples is not None else 0) | (0x20 if raw is not None else 0)
    pieces = [detail if isinstance(detail, bytes) else json.dumps(detail).encode()] + [piece for piece in (samples, raw) if piece is not None]
    return bytes([kinds.index(kind) | flags]) + b"".join(struct.pack("<H", len(piece)) + piece for piece in pieces)


def forged_database(schema):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "forged.hexo"
        database = sqlite3.connect(path)
        database.executescript(f"PRAGMA page_size=512; PRAGMA application_id={0x4845584F}; PRAGMA user_version=3; {schema}")
        database.close()
        return path.read_bytes()


def hexo():
    cells = [{"id": 1, "ports": [{"port": 2, "cell": 2, "cell_port": 3}]},
             {"id": 2, "body_part": "arm", "ports": [{"port": 3, "cell": 1}]}]
    samples = b"".join(struct.pack("<4I10d", cell, 100, 1, 0, 0, 0, 1, 1e-6, 0, 0, 1e-6, 0, 1e-6, 21.5)
                       for cell in (1, 2))
    raw = struct.pack("<2Id3I", 4, 1, 0.5, 1, 1, 1)
    raw += struct.pack("<I3f", 1, 0, 0, 1) + struct.pack("<2I6f", 2, 10, 0, 0, 1, 0, 0, 0) + struct.pack("<If", 1, 20)
    raw_long = struct.pack("<2Id3I", 8, 1, 0.5, 1, 0, 0) + struct.pack("<I3d", 1, 0, 0, 0.1)
    skin = entry("skin", {"cell_model": MODEL, "cells": cells})
    truth = {"frame": "body", "cells": [{"id": 1, "R": [1, 0, 0, 0, 1, 0, 0, 0, 1], "t_m": [0, 0, 0.1]}]}
    captures = (entry("capture", {"pose": 1, "place": 0, "cells": 2, "label": "table", "raw_sha256": "$RAW"}, samples, raw) +
                entry("capture", {"pose": 2, "place": 1, "cells": 2, "taken_at_ms": 5, "raw_sha256": "$RAW"}, samples,
                      raw_long))
    put("hexo", "journal", b"J" + skin + entry("source", {"text": "by hand", "file": "", "sha256": ""}) +
        entry("truth", truth) + captures + entry("disable", {"capture": 4, "why": "moved"}) +
        entry("enable", {"capture": 4}) + entry("remove", {"capture": 4}) +
        entry("restore", {"capture": 4, "place": 1}) +
        entry("mute", {"source": 1, "source_port": 2, "target": 2, "target_port": 3, "why": "cable"}) +
        entry("unmute", {"source": 1, "source_port": 2, "target": 2, "target_port": 3}) + entry("options", {"solver": "tree"}))
    joints = [{"joint": "elbow", "position": 0.5}, {"joint": "lift", "position": -1e-3}]
    put("hexo", "journal_joints", b"J" + skin + captures + entry("joints", {"capture": 2, "joint_angles": joints}) +
        entry("joints", {"capture": 2, "joint_angles": []}))
    put("hexo", "journal_without_skin", b"J" + captures)
    # Journals whose digests are right, by somebody who means harm.
    twice = json.dumps({"cell_model": MODEL, "cells": cells}).encode()[:-1] + b', "cells": []}'
    put("hexo", "journal_key_twice", b"J" + entry("skin", twice))
    put("hexo", "journal_nested", b"J" + skin + entry("options", b"[" * 3000))
    put("hexo", "journal_cells_minus_one", b"J" + entry("skin", {"cell_model": MODEL, "cells": -1}))
    put("hexo", "journal_cell_of_15_m", b"J" + entry("skin", {"cell_model": {**MODEL, "side_m": 15}, "cells": cells}))
    put("hexo", "journal_control_characters",
        b"J" + skin + entry("source", {"text": "\x1b[2J\x9b", "file": "\n\r", "sha256": "\x07"}) +
        entry("mute", {"source": 1, "source_port": 2, "target": 2, "target_port": 3, "why": "\x1b]0;x\x07"}) +
        entry("options", b'{"\x1b[31m": }'))
    indefinite = struct.pack("<4I10d", 1, 100, 0, 0, 0, 0, 1, 1e-6, 2e-6, 0, 1e-6, 0, 1e-6, 0)
    put("hexo", "journal_indefinite",
        b"J" + skin + entry("capture", {"pose": 1, "place": 0, "cells": 1}, indefinite))
    for name, schema in (("view", "CREATE VIEW journal AS SELECT 1 AS entry"),
                         ("trigger", "CREATE TABLE journal (entry); CREATE TRIGGER t BEFORE INSERT ON journal BEGIN "
                                     "SELECT load_extension('x'); END"),
                         ("control_characters", 'CREATE TABLE "\x1b[31m\n" (x)'),
                         ("generated", "CREATE TABLE journal (entry, at_ms AS (zeroblob(1000000000)))")):
        put("hexo", "forged_" + name, b"R" + forged_database(schema))
    put("hexo", "changes", b"P" + struct.pack("<HBHB", 68, 0x48, 5000, 0x31))
    put("hexo", "unchanged", b"P")
    put("hexo", "no_database", b"R" + b"SQLite format 3\0" + bytes(84))


skinwire()
skinwire_device()
documents()
hostile_documents()
hexo()
if len(sys.argv) > 1:
    calibrations(sys.argv[1])
