"""What becomes of messages: the mapping that ROS 1 and ROS 2 share, without either."""

import json
import math
import pathlib
import unittest
from types import SimpleNamespace

import hexoderm_ros
from hexoderm_ros.options import EXAMPLE
from hexoderm_ros.readings import (NO_ACCELERATION, NOT_FINITE, OTHER_CELL, OTHER_FIELDS, OTHER_FRAME, Reading, of_cell_data,
                                   of_imu, time_us)
from hexoderm_ros.skin import BUILT_IN_MODELS, CellData, SkinError, read_skin, skin_from
from hexoderm_ros.stream import Stream
from hexoderm_ros.transforms import TransformError, read_transforms
from program import InFolder, imu, run

CELLS = [{"id": 1, "imu": "/a", "ports": [{"port": 2, "cell": 2, "cell_port": 3}]},
         {"id": 2, "imu": "/b", "ports": [{"port": 3, "cell": 1, "cell_port": 2}]}]


class Readings(unittest.TestCase):
    def setUp(self):
        self.left_out = []

    def leave_out(self, *why):
        self.left_out.append(why)

    def of_imu(self, message, cells):
        return of_imu(message, cells, 5, self.leave_out)

    def of_cell_data(self, message, names):
        return of_cell_data(message, names, {1, 2}, 5, self.leave_out)

    def test_an_imu_is_in_g_and_has_its_own_time(self):
        for names in (("secs", "nsecs"), ("sec", "nanosec")):
            (reading,) = self.of_imu(imu(12.25, (0, 0.6, 0.8), *names), {"": 7})
            self.assertEqual((reading.time_us, reading.cell), (12_250_000, 7))
            for found, expected in zip(reading.acceleration_g, (0, 0.6, 0.8)):
                self.assertAlmostEqual(found, expected, 12)

    def test_without_a_stamp_the_time_is_now(self):
        self.assertEqual(self.of_imu(imu(0, (0, 0, 1)), {"": 7})[0].time_us, 5)
        self.assertEqual(time_us(SimpleNamespace(sec=2, nanosec=1999)), 2_000_001)

    def test_what_is_no_acceleration_is_left_out(self):
        self.assertEqual(self.of_imu(imu(1, (0, 0, 1), covariance=-1), {"": 7}), [])
        self.assertEqual(self.of_imu(imu(1, (0, math.nan, 1)), {"": 7}), [])
        self.assertEqual(self.left_out, [(NO_ACCELERATION, "cell 7"), (NOT_FINITE, "cell 7")])

    def test_cells_on_one_topic_are_told_apart_by_the_frame(self):
        cells = {"cell_1": 1, "cell_2": 2}
        found = [self.of_imu(imu(1, (0, 0, 1), frame=frame), cells) for frame in ("/cell_2", "cell_1", "cell_3")]
        self.assertEqual([[each.cell for each in those] for those in found], [[2], [1], []])
        self.assertEqual(self.left_out, [(OTHER_FRAME, '"cell_3"')])

    def test_cell_data(self):
        def entry(cell, acceleration):
            return SimpleNamespace(cellId=cell, acc=acceleration)

        message = SimpleNamespace(data=[entry(1, [0, 0, 1]), entry(9, [0, 0, 1]), entry(2, [0, 1.0, math.inf]),
                                        entry(2, SimpleNamespace(x=1, y=0, z=0))])
        found = self.of_cell_data(message, CellData("/cells"))
        self.assertEqual(found, [Reading(5, 1, (0, 0, 1)), Reading(5, 2, (1, 0, 0))])
        self.assertEqual(self.left_out, [(OTHER_CELL, "cell 9"), (NOT_FINITE, "cell 2")])
        # One cell by itself, other names, and a time.
        names = CellData("/cells", cell="id", acceleration="g")
        alone = SimpleNamespace(id=2, g=[0, 0, 1], header=imu(3, (0, 0, 1)).header)
        self.assertEqual(self.of_cell_data(alone, names), [Reading(3_000_000, 2, (0, 0, 1))])

    def test_fields_are_found_at_paths_with_dots(self):
        message = SimpleNamespace(skin=SimpleNamespace(cells=[
            SimpleNamespace(info=SimpleNamespace(id=2), imu=SimpleNamespace(acceleration=SimpleNamespace(x=0, y=0, z=1)))]))
        names = CellData("/cells", "skin.cells", "info.id", "imu.acceleration")
        self.assertEqual(self.of_cell_data(message, names), [Reading(5, 2, (0, 0, 1))])

    def test_a_wrong_name_of_a_field_is_named_with_those_that_are_there(self):
        class SkinCells:
            _type = "skin/SkinCells"
            __slots__ = ["header", "data"]

            def __init__(self, data):
                self.header, self.data = imu(1, (0, 0, 1)).header, data

        class Cell:
            _type = "skin/Cell"
            __slots__ = ["cellId", "acc"]

            def __init__(self, acc):
                self.cellId, self.acc = 1, acc

        message = SkinCells([Cell([0, 0, 1])])
        for words, names in [
            ('skin/SkinCells has no field "dat"; it has header, data', CellData("/c", "dat")),
            ('skin/SkinCells has no field "dat"; it has header, data', CellData("/c", "dat.cells")),
            ('the field "header" of skin/SkinCells is no array', CellData("/c", "header")),
            ('skin/Cell has no field "id"; it has cellId, acc', CellData("/c", cell="id")),
            ('skin/Cell has no field "g"; it has cellId, acc', CellData("/c", acceleration="g")),
            ('the field "acc" of skin/Cell is no whole number', CellData("/c", cell="acc")),
            ('the field "cellId" of skin/Cell is neither x, y, z nor an array of 3', CellData("/c", acceleration="cellId")),
        ]:
            self.left_out.clear()
            self.assertEqual(self.of_cell_data(message, names), [])
            self.assertEqual(self.left_out, [(OTHER_FIELDS, words)])
        for data in (1.5, "abc"):  # of another topic: std_msgs have a field of this name, too
            self.left_out.clear()
            self.assertEqual(self.of_cell_data(SkinCells(data), CellData("/c")), [])
            self.assertEqual(self.left_out, [(OTHER_FIELDS, 'the field "data" of skin/SkinCells is no array')])
        self.left_out.clear()
        self.assertEqual(self.of_cell_data(SkinCells([Cell([0, 1])]), CellData("/c")), [])
        self.assertEqual(self.left_out[0][1], 'the field "acc" of skin/Cell is neither x, y, z nor an array of 3')


class Streams(unittest.TestCase):
    def samples(self, stream, **how):
        return [(each["samples"]["time_us"], each["samples"]["cells"]) for each in stream.take(**how)]

    def test_topics_are_put_in_order(self):
        stream = Stream()
        for at_us, cell in ((10_000, 1), (20_000, 1), (10_000, 2), (15_000, 3), (200_000, 1)):
            self.assertFalse(stream.add(Reading(at_us, cell, (0, 0, 1))))
        self.assertEqual(self.samples(stream), [(10_000, [1, 2]), (15_000, [3]), (20_000, [1])])
        self.assertEqual(self.samples(stream), [])
        self.assertEqual(self.samples(stream, everything=True), [(200_000, [1])])
        self.assertEqual(stream.sequence, 5)

    def test_what_comes_late_or_twice_is_counted(self):
        stream = Stream()
        for at_us in (10_000, 10_000, 200_000):
            stream.add(Reading(at_us, 1, (0, 0, 1)))
        self.assertEqual(self.samples(stream), [(10_000, [1])])
        stream.add(Reading(5_000, 2, (0, 0, 1)))
        self.assertEqual((stream.late, stream.repeated), (1, 1))
        self.assertEqual(self.samples(stream, everything=True), [(200_000, [1])])

    def test_a_topic_that_lags_does_not_begin_the_stream_anew(self):
        stream = Stream(5)
        for k in range(400):
            stream.add(Reading(10_000_000 + 10_000 * k, 1, (0, 0, 1)))
            stream.take()
            stream.add(Reading(8_000_000 + 10_000 * k, 2, (0, 0, 1)))
        self.assertEqual(stream.number, 5)
        self.assertGreater(stream.late, 380)

    def test_a_bag_that_begins_anew_begins_the_stream_anew(self):
        stream = Stream(5)
        began = taken = 0
        for _ in range(2):
            for k in range(100):
                began += stream.add(Reading(10_000_000 + 10_000 * k, 1, (0, 0, 1)))
                taken += len(self.samples(stream))
        self.assertEqual((began, stream.number), (1, 6))
        rest = len(self.samples(stream, everything=True))
        self.assertGreater(rest, 0)
        # What showed that it began anew is lost, and counted.
        ended = sum(len(each["samples"]["cells"]) for each in stream.ended)
        self.assertEqual(ended, 10)
        self.assertEqual(taken + rest + ended + stream.late, 200)
        self.assertGreater(taken, 120)


class Descriptions(InFolder):
    def test_topics_and_topology(self):
        skin = skin_from({"cells": CELLS, "cell_data": {"topic": "/cells", "array": "cells"}})
        self.assertEqual(skin.imus, {"/a": {"": 1}, "/b": {"": 2}})
        self.assertEqual(skin.cells[0], {"id": 1, "ports": [{"port": 2, "cell": 2, "cell_port": 3}]})
        self.assertEqual(skin.cell_data[0], CellData("/cells", "cells", "cellId", "acc", ""))

    def test_a_session_of_hexoderm_needs_topics_only(self):
        session = self.simulate("--poses", 1)
        skin = skin_from({**session, "cell_data": {"topic": "/cells"}})
        self.assertEqual(len(skin.ids), 17)
        self.assertEqual(skin.cells_of_topics, {"/cells": set(range(1, 18))})

    def test_cells_that_share_a_topic(self):
        skin = skin_from({"cells": [{"id": 1, "imu": "/imu", "frame_id": "cell_1"}, {"id": 2, "imu": "/imu", "frame_id": "/b"},
                                    {"id": 3}], "cell_data": {"topic": "/cells"}})
        self.assertEqual(skin.imus, {"/imu": {"cell_1": 1, "b": 2}})
        self.assertEqual(skin.cells_of_topics, {"/imu": {1, 2}, "/cells": {3}})

    def test_the_example_is_one_and_that_of_the_help_and_the_page(self):
        example = pathlib.Path(hexoderm_ros.__file__).parents[1] / "skin.json"
        self.assertEqual(len(read_skin(example).imus), 2)
        self.assertEqual(example.read_text(), EXAMPLE)
        page = example.with_name("README.md").read_text()
        self.assertEqual(page[page.index("```json\n") + 8:].partition("```")[0], EXAMPLE)

    def test_built_in_cell_models_are_those_of_the_program(self):
        files = (pathlib.Path(__file__).parents[3] / "resources/cell_models").glob("*.json")
        self.assertEqual(sorted(BUILT_IN_MODELS), sorted(each.stem for each in files))
        for name in BUILT_IN_MODELS:
            self.simulate("--cell-model", name)

    def test_mistakes_are_named(self):
        for words, document in [
            ('cells: expected a list, found null', {}),
            ('cells[0].id: expected a whole number from 1, found "x"', {"cells": [{"id": "x"}]}),
            ("cells[1].id: cell 1 is named twice", {"cells": [{"id": 1, "imu": "/a"}, {"id": 1}]}),
            ('cells[1].imu: /a is that of cell 1 already; cells that share a topic are told apart by a "frame_id" of each',
             {"cells": [{"id": 1, "imu": "/a"}, {"id": 2, "imu": "/a"}]}),
            ('cells[1].imu: /a is that of cell 1 already; cells that share a topic are told apart by a "frame_id" of each',
             {"cells": [{"id": 1, "imu": "/a"}, {"id": 2, "imu": "/a", "frame_id": "b"}]}),
            ('cells[1].imu: /a is that of cell 1 already; cells that share a topic are told apart by a "frame_id" of each',
             {"cells": [{"id": 1, "imu": "/a", "frame_id": "b"}, {"id": 2, "imu": "/a"}]}),
            ('cells[1].frame_id: "b" on /a is that of cell 1 already',
             {"cells": [{"id": 1, "imu": "/a", "frame_id": "b"}, {"id": 2, "imu": "/a", "frame_id": "/b"}]}),
            ('cells[0].frame_id: expected the topic too, as "imu"', {"cells": [{"id": 1, "frame_id": "b"}]}),
            ('cells[0]: nothing says where the readings of cell 1 are, expected an "imu", or "cell_data" beside the cells',
             {"cells": [{"id": 1}, {"id": 2, "imu": "/a"}]}),
            ("cells: expected one at least", {"cells": []}),
            ('cells[0]: "Imu" is not known, did you mean "imu"?', {"cells": [{"id": 1, "Imu": "/a"}]}),
            ('cells[0]: "led" is not known, expected id, ports, body_part, imu or frame_id', {"cells": [{"id": 1, "led": 1}]}),
            ('cells[0].ports[0]: "cellport" is not known, did you mean "cell_port"?',
             {"cells": [{"id": 1, "ports": [{"cellport": 1}]}]}),
            ('skin: "celldata" is not known, did you mean "cell_data"?', {"cells": [], "celldata": {}}),
            ('cell_model: "hex-bma151" is not known, expected hex-bma150 or the name of a JSON file',
             {"cells": CELLS, "cell_model": "hex-bma151"}),
            ("cell_model: no.json: cannot be read: No such file or directory", {"cells": CELLS, "cell_model": "no.json"}),
            ("cells[0].ports[0].port: expected a whole number from 0, found null",
             {"cells": [{"id": 1, "ports": [{}]}]}),
            ('cell_data: "topics" is not known, did you mean "topic"?',
             {"cells": [], "cell_data": {"topics": "/a"}}),
        ]:
            with self.assertRaises(SkinError) as raised:
                skin_from(document)
            self.assertEqual(str(raised.exception), words)
        with self.assertRaisesRegex(SkinError, "none.json: cannot be read: No such file"):
            read_skin(self.folder / "none.json")
        (self.folder / "half.json").write_text('{"cells"')
        with self.assertRaisesRegex(SkinError, "half.json: is no JSON"):
            read_skin(self.folder / "half.json")


def placed(parent, child):
    return (f'- {{header: {{frame_id: "{parent}"}}, child_frame_id: "{child}", transform: {{translation: {{x: 0, y: 0, z: 0}},'
            " rotation: {x: 0, y: 0, z: 0, w: 1}}}\n")


class Transforms(InFolder):
    def test_those_of_an_export(self):
        self.simulate("--poses", 3)
        run("solve", self.folder / "true.session.json", "-o", self.folder / "c.json")
        run("export", self.folder / "c.json", "--to", "tf-yaml", "-o", self.folder / "tf.yaml")
        transforms = {each.child: each for each in read_transforms(self.folder / "tf.yaml")}
        self.assertEqual(len(transforms), 1 + 2 * 17)
        cells = json.loads((self.folder / "c.json").read_text())["patches"][0]["cells"]
        for cell in cells:
            found = transforms[f"skin_cell{cell['id']}"]
            self.assertEqual(found.parent, "skin_patch0")
            for a, b in zip(found.translation, cell["t_o_u_m"]):
                self.assertAlmostEqual(a, b, 12)

    def test_mistakes_are_named(self):
        for name, text, words in [
            ("empty", "", "expected a list of transforms"),
            ("other", "- {a: 1}", r"\[0\]: expected a geometry_msgs/TransformStamped"),
            ("zero", "- {header: {frame_id: a}, child_frame_id: b, transform: {translation: {x: 0, y: 0, z: 0},"
             " rotation: {x: 0, y: 0, z: 0, w: 0}}}", "rotation: expected a quaternion of length 1"),
            ("broken", "- a: 1\n- {", "is no YAML, line 2: expected the node content"),
            ("twice", placed("a", "b") + placed("c", "b"), r'\[1\].child_frame_id: "b" is there already, in "a"'),
            ("empty name", placed("", "b"), r'\[0\].header.frame_id: expected the name of a frame, found ""'),
            ("in itself", placed("a", "a"), r'\[0\].child_frame_id: expected another frame than frame_id, found "a" again'),
        ]:
            (self.folder / name).write_text(text)
            with self.assertRaisesRegex(TransformError, words):
                read_transforms(self.folder / name)
        with self.assertRaisesRegex(TransformError, "cannot be read"):
            read_transforms(self.folder / "none")
