"""What is said of topics that bring nothing, of what is left out, and of clocks that differ. No ROS is needed for it."""

import unittest

from hexoderm_ros.readings import NOT_FINITE, OTHER_FIELDS
from hexoderm_ros.skin import skin_from
from hexoderm_ros.watch import NOBODY, SENDS_NOTHING, Watch, watching
from program import reading


class Watches(unittest.TestCase):
    def watch(self, document):
        self.now_s, self.said = 0, []
        self.watched = Watch(skin_from(document), self.said.append, lambda: self.now_s)
        self.watched.begin()
        return self.watched

    def imus(self, count):
        return self.watch({"cells": [{"id": k, "imu": f"/imu{k}"} for k in range(1, count + 1)]})

    def look(self, why=lambda topic: NOBODY):
        self.watched.look(lambda topics: {topic: why(topic) for topic in topics})
        said, self.said[:] = list(self.said), []
        return said

    def message(self, topic, *cells, ahead_s=None):
        self.watched.came(topic)
        for cell in cells:
            self.watched.took(reading(1000 + self.now_s + (ahead_s or {}).get(cell, 0), cell))

    def test_a_topic_that_brings_nothing_is_named_once(self):
        self.imus(2)
        for self.now_s in (0.5, 1, 2, 3):
            self.message("/imu1", 1)
            self.assertEqual(self.look(), [])
        self.now_s = 3.5
        self.message("/imu1", 1)
        self.assertEqual(self.look(), ["nothing on /imu2 (cell 2); nobody publishes it"])
        self.assertEqual(self.look(), [])

    def test_clocks_start_when_it_begins_to_watch(self):
        self.now_s, self.said = 0, []
        self.watched = Watch(skin_from({"cells": [{"id": 1, "imu": "/imu1"}]}), self.said.append, lambda: self.now_s)
        self.now_s = 60  # so long nobody listened, as there was no master
        with watching(self.watched, lambda topics: dict.fromkeys(topics, NOBODY)):
            self.assertEqual(self.look(), [])
        self.now_s = 63
        self.assertEqual(self.look(), [])
        self.now_s = 63.5
        self.assertEqual(self.look(), ["nothing on /imu1 (cell 1); nobody publishes it"])

    def test_why_nothing_comes_is_asked_once_for_all_topics(self):
        self.imus(3)
        asked = []
        self.now_s = 4
        for _ in range(2):
            self.watched.look(lambda topics: asked.append(topics) or dict.fromkeys(topics, NOBODY))
        self.assertEqual(asked, [["/imu1", "/imu2", "/imu3"]])

    def test_one_that_stops_and_comes_back_is_named_each_time(self):
        self.imus(1)
        self.message("/imu1", 1)
        for _ in range(2):
            self.now_s += 4
            self.assertEqual(self.look(lambda topic: SENDS_NOTHING),
                             ["nothing any more on /imu1 (cell 1); its publisher sends nothing"])
            self.message("/imu1", 1)
            self.assertEqual(self.look(), ["messages come on /imu1 (cell 1)"])

    def test_many_topics_have_a_line_for_each_reason(self):
        self.imus(10)
        self.now_s = 4
        self.assertEqual(self.look(lambda topic: ("its type is a/B, and not c/D",) * 2 if topic == "/imu1" else NOBODY),
                         ["nothing on /imu1 (cell 1); its type is a/B, and not c/D",
                          "nothing on /imu2 (cell 2), /imu3 (cell 3), /imu4 (cell 4), /imu5 (cell 5), /imu6 (cell 6), "
                          "/imu7 (cell 7) and 3 more; nobody publishes them"])

    def test_a_cell_that_is_not_in_the_messages_is_named(self):
        self.watch({"cells": [{"id": 1}, {"id": 2}, {"id": 3}], "cell_data": {"topic": "/cells"}})
        self.now_s = 10
        self.assertEqual(self.look(), ["nothing on /cells (cells 1, 2 and 3); nobody publishes it"])
        self.message("/cells", 1)  # the first that comes: others have their time
        self.assertEqual(self.look(), ["messages come on /cells (cells 1, 2 and 3)"])
        for self.now_s in (11, 12, 13, 14):
            self.message("/cells", 1)
        self.assertEqual(self.look(), ["no readings of cells 2 and 3, though messages come on /cells"])
        self.message("/cells", 3)
        self.assertEqual(self.look(), ["readings of cell 3 come"])

    def test_what_is_left_out_is_named_once_and_counted(self):
        watch = self.imus(2)
        for _ in range(1000):
            watch.left_out("/cells", OTHER_FIELDS, 'a/B has no field "dat"; it has header, data')
            watch.left_out("/imu1", NOT_FINITE, "cell 1")
        watch.left_out("/imu2", NOT_FINITE, "cell 2")
        self.assertEqual(self.said, ['cell_data /cells: a/B has no field "dat"; it has header, data',
                                     "/imu1: left out are readings with an acceleration that is not finite (cell 1)",
                                     "/imu2: left out are readings with an acceleration that is not finite (cell 2)"])
        self.assertEqual(watch.counts(), {OTHER_FIELDS: 1000, NOT_FINITE: 1001})

    def clocks(self, ahead_s, looks=6):
        self.imus(6)
        said = []
        for _ in range(looks):
            self.now_s += 0.5
            for cell in range(1, 7):
                self.message(f"/imu{cell}", cell, ahead_s=ahead_s)
            said += self.look()
        return said

    def test_a_clock_that_is_another_is_named_once(self):
        self.assertEqual(self.clocks({6: 3600}),
                         ["the stamps of cell 6 are 3600 s ahead of the others; readings are lost while clocks differ"])
        self.assertEqual(self.clocks({2: -5, 3: -5}),
                         ["the stamps of cells 2 and 3 are 5 s behind the others; readings are lost while clocks differ"])
        self.assertEqual(self.clocks({2: 0.4}), [])
        # For a moment topics may be apart.
        self.assertEqual(self.clocks({6: 3600}, looks=2), [])
