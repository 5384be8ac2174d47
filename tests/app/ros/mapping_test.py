#!/usr/bin/env python3
"""What becomes of messages: the mapping that ROS 1 and ROS 2 share, without either."""

import json
import math
import unittest
from types import SimpleNamespace

from hexoderm_ros.readings import Reading, of_cell_data, of_imu, time_us
from hexoderm_ros.skin import CellData, SkinError, read_skin, skin_from
from hexoderm_ros.stream import Stream
from hexoderm_ros.transforms import TransformError, read_transforms
from program import InFolder, imu, run

CELLS = [{"id": 1, "imu": "/a", "ports": [{"port": 2, "cell": 2, "cell_port": 3}]},
         {"id": 2, "imu": "/b", "ports": [{"port": 3, "cell": 1, "cell_port": 2}]}]


class Readings(unittest.TestCase):
    def test_an_imu_is_in_g_and_has_its_own_time(self):
        for names in (("secs", "nsecs"), ("sec", "nanosec")):
            (reading,) = of_imu(imu(12.25, (0, 0.6, 0.8), *names), 7, now_us=5)
            self.assertEqual((reading.time_us, reading.cell), (12_250_000, 7))
            for found, expected in zip(reading.acceleration_g, (0, 0.6, 0.8)):
                self.assertAlmostEqual(found, expected, 12)

    def test_without_a_stamp_the_time_is_now(self):
        self.assertEqual(of_imu(imu(0, (0, 0, 1)), 7, now_us=5)[0].time_us, 5)
        self.assertEqual(time_us(SimpleNamespace(sec=2, nanosec=1999)), 2_000_001)

    def test_what_is_no_acceleration_is_left_out(self):
        self.assertEqual(of_imu(imu(1, (0, 0, 1), covariance=-1), 7, 5), [])
        self.assertEqual(of_imu(imu(1, (0, math.nan, 1)), 7, 5), [])

    def test_cell_data(self):
        def entry(cell, acceleration):
            return SimpleNamespace(cellId=cell, acc=acceleration)

        message = SimpleNamespace(data=[entry(1, [0, 0, 1]), entry(9, [0, 0, 1]), entry(2, [0, 1.0, math.inf]),
                                        entry(2, SimpleNamespace(x=1, y=0, z=0)), entry(1, [0, 1])])
        found = of_cell_data(message, CellData("/cells"), {1, 2}, 5)
        self.assertEqual(found, [Reading(5, 1, (0, 0, 1)), Reading(5, 2, (1, 0, 0))])
        # One cell by itself, other names, and a time.
        names = CellData("/cells", cell="id", acceleration="g")
        alone = SimpleNamespace(id=2, g=[0, 0, 1], header=imu(3, (0, 0, 1)).header)
        self.assertEqual(of_cell_data(alone, names, {1, 2}, 5), [Reading(3_000_000, 2, (0, 0, 1))])


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
        began = 0
        for _ in range(2):
            for k in range(100):
                began += stream.add(Reading(10_000_000 + 10_000 * k, 1, (0, 0, 1)))
                stream.take()
        self.assertEqual((began, stream.number), (1, 6))
        self.assertGreater(len(self.samples(stream, everything=True)), 0)


class Descriptions(InFolder):
    def test_topics_and_topology(self):
        skin = skin_from({"cells": CELLS, "cell_data": {"topic": "/cells", "array": "cells"}})
        self.assertEqual(skin.imus, {"/a": 1, "/b": 2})
        self.assertEqual(skin.cells[0], {"id": 1, "ports": [{"port": 2, "cell": 2, "cell_port": 3}]})
        self.assertEqual(skin.cell_data[0], CellData("/cells", "cells", "cellId", "acc", ""))

    def test_a_session_of_hexoderm_needs_topics_only(self):
        session = self.simulate("--poses", 1)
        skin = skin_from({**session, "cell_data": {"topic": "/cells"}})
        self.assertEqual(len(skin.ids), 17)

    def test_mistakes_are_named(self):
        for words, document in [
            ('cells: expected a list, found null', {}),
            ('cells[0].id: expected a whole number from 1, found "x"', {"cells": [{"id": "x"}]}),
            ("cells[1].id: cell 1 is named twice", {"cells": [{"id": 1}, {"id": 1}]}),
            ("cells[1].imu: /a is that of cell 1 already",
             {"cells": [{"id": 1, "imu": "/a"}, {"id": 2, "imu": "/a"}]}),
            ('skin: expected an "imu" of some cell, or "cell_data"; there is no topic', {"cells": [{"id": 1}]}),
            ("cells[0].ports[0].port: expected a whole number from 0, found null",
             {"cells": [{"id": 1, "ports": [{}]}]}),
            ("cell_data: topics is not known, expected topic, array, cell, acceleration or type",
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
            ("broken", "- {", "is no YAML"),
        ]:
            (self.folder / name).write_text(text)
            with self.assertRaisesRegex(TransformError, words):
                read_transforms(self.folder / name)
        with self.assertRaisesRegex(TransformError, "cannot be read"):
            read_transforms(self.folder / "none")


if __name__ == "__main__":
    unittest.main()
