"""What a person is told of topics while they are passed on: which bring nothing, what of them is left out, and cells
whose clock is another."""

import contextlib
import statistics
import threading
import time

from hexoderm_ros.console import say
from hexoderm_ros.readings import OTHER_FIELDS

NOBODY = ("nobody publishes it", "nobody publishes them")
SENDS_NOTHING = ("its publisher sends nothing", "their publishers send nothing")
SILENT_S = 3  # as long as Hexoderm waits for a device
LOOK_EVERY_S = 0.5
APART_S = 1.0
APART_LOOKS = 3  # in a row: topics that come one after the other are apart for a moment
MOST_NAMED = 6
MOST_SAID = 100  # lines on what is left out


def listed(names):
    """"a, b and c", or the first few and how many more."""
    names = list(names)
    if len(names) > MOST_NAMED:
        names = [*names[:MOST_NAMED], f"{len(names) - MOST_NAMED} more"]
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _cells(cells):
    return ("cell " if len(cells) == 1 else "cells ") + listed(map(str, sorted(cells)))


class Watch:
    """came(), took() and left_out() can be called from any thread, look() from one. Until begin() nothing is silent."""

    def __init__(self, skin, tell=say, clock=time.monotonic):
        self._tell, self._clock = tell, clock
        self._cells_of = skin.cells_of_topics
        self._lock = threading.Lock()
        self._came_s = {}
        self._began_s = {}  # of topics: since when messages come
        self._ids = skin.ids
        self._cell_came_s = {}
        self._silent = set()  # topics and cells of which it was said
        self._stamps_us = {}  # of each cell, since the last look
        self._apart = {}  # how often in a row the clock of a cell was another
        self._said_apart = set()
        self._left_out = {}  # how many, by reason
        self._said_left_out = set()

    def begin(self):
        """Starts the clocks, once the topics are subscribed to: a master may be waited for before that."""
        now_s = self._clock()
        with self._lock:
            self._came_s.update(dict.fromkeys(self._cells_of, now_s))
            self._cell_came_s.update(dict.fromkeys(self._ids, now_s))

    def came(self, topic):
        """A message."""
        now_s = self._clock()
        with self._lock:
            if topic not in self._began_s or now_s - self._came_s[topic] > SILENT_S:
                self._began_s[topic] = now_s
            self._came_s[topic] = now_s
            is_back = topic in self._silent
            self._silent.discard(topic)
        if is_back:
            self._tell(f"messages come on {self._named(topic)}")

    def took(self, readings):
        now_s = self._clock()
        with self._lock:
            for reading in readings:
                self._cell_came_s[reading.cell] = now_s
                self._stamps_us[reading.cell] = reading.time_us
            back = self._silent.intersection(reading.cell for reading in readings)
            self._silent -= back
        if back:
            self._tell(f"readings of {_cells(back)} come")

    def left_out(self, topic, reason, example):
        """Counted, and said the first time for each topic and example."""
        with self._lock:
            self._left_out[reason] = self._left_out.get(reason, 0) + 1
            what = (topic, reason, example)
            if what in self._said_left_out or len(self._said_left_out) >= MOST_SAID:
                return
            self._said_left_out.add(what)
        self._tell(f"cell_data {topic}: {example}" if reason == OTHER_FIELDS else
                   f"{topic}: left out are {reason} ({example})")

    def counts(self):
        """How many readings or messages were left out, by the reason."""
        with self._lock:
            return dict(self._left_out)

    def look(self, why):
        """Says what is new. `why` says of each of the topics given why nothing comes on it: of one, and of several."""
        now_s = self._clock()
        with self._lock:
            quiet = {topic for topic, came_s in self._came_s.items() if now_s - came_s > SILENT_S}
            topics = [topic for topic in self._cells_of if topic in quiet - self._silent]
            cells = self._quiet_cells(now_s, quiet) - self._silent
            self._silent.update(topics, cells)
            began = set(self._began_s)
            apart = self._newly_apart()
        by_reason = {}
        for topic, reason in (why(topics) if topics else {}).items():
            by_reason.setdefault((topic in began, reason), []).append(topic)
        for (had_come, (of_one, of_several)), named in by_reason.items():
            self._tell(f"nothing{' any more' if had_come else ''} on {listed(map(self._named, named))}; "
                       f"{of_one if len(named) == 1 else of_several}")
        if cells:
            on = listed(sorted(topic for topic, those in self._cells_of.items() if those & cells and topic not in quiet))
            self._tell(f"no readings of {_cells(cells)}, though messages come on {on}")
        for seconds, those in apart.items():
            self._tell(f"the stamps of {_cells(those)} are {abs(seconds)} s {'ahead of' if seconds > 0 else 'behind'} the "
                       "others; readings are lost while clocks differ")

    def _named(self, topic):
        return f"{topic} ({_cells(self._cells_of[topic])})"

    def _quiet_cells(self, now_s, quiet_topics):
        """Those of which nothing comes although something comes on their topics."""
        cells = set()
        for topic, those in self._cells_of.items():
            if topic not in quiet_topics and topic in self._began_s:
                cells.update(cell for cell in those
                             if now_s - max(self._cell_came_s[cell], self._began_s[topic]) > SILENT_S)
        return cells

    def _newly_apart(self):
        """Cells whose stamps are not those of the others, by the whole seconds between them."""
        stamps_us, self._stamps_us = self._stamps_us, {}
        middle_us = statistics.median_low(stamps_us.values()) if stamps_us else 0
        apart_s = {cell: (us - middle_us) / 1e6 for cell, us in stamps_us.items() if abs(us - middle_us) > APART_S * 1e6}
        self._apart = {cell: self._apart.get(cell, 0) + 1 for cell in apart_s}
        found = {}
        for cell, seconds in apart_s.items():
            if self._apart[cell] >= APART_LOOKS and cell not in self._said_apart:
                self._said_apart.add(cell)
                found.setdefault(round(seconds), set()).add(cell)
        return found


@contextlib.contextmanager
def watching(watch, why):
    """Has it look on a thread of its own, twice a second."""
    watch.begin()
    over = threading.Event()

    def run():
        while not over.wait(LOOK_EVERY_S):
            watch.look(why)

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join(SILENT_S)  # a master of ROS that does not answer holds nothing up
