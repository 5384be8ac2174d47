"""Readings of many topics, which come in any order, as one stream of samples in the order of their times."""

import heapq


class Stream:
    """SkinWire wants times that don't go back. So readings are held until those of other topics have come, and sent
    together with those of the same time; what comes later than that is counted and left out. Where times go back for
    good, because a bag begins anew, the stream does too."""

    HOLD_US = 100_000  # how much later a topic may come than another
    RESTART_US = 500_000  # late readings in a row that span so much: the clock was set back

    def __init__(self, number=1):
        self.number = number  # of the stream, for Hello
        self.late = 0  # over all beginnings, as the next
        self.repeated = 0
        self.ended = []
        self._begin()

    def _begin(self):
        self._held = []  # a heap
        self._newest_us = None
        self._sent_us = None
        self._late_from_us = None
        self.sequence = 0

    def add(self, reading):
        """True if the stream began anew; `ended` then has the last messages of the one before."""
        if self._sent_us is not None and reading.time_us <= self._sent_us:
            if self._late_from_us is None or reading.time_us < self._late_from_us:
                self._late_from_us = reading.time_us
            if reading.time_us - self._late_from_us < self.RESTART_US:
                self.late += 1
                return False
            self.ended = self.take(everything=True)
            self.number += 1
            self._begin()
            self.add(reading)
            return True
        self._late_from_us = None
        heapq.heappush(self._held, reading)
        self._newest_us = reading.time_us if self._newest_us is None else max(self._newest_us, reading.time_us)
        return False

    def take(self, everything=False):
        """The messages that are due: one for each time."""
        messages = []
        while self._held and (everything or self._held[0].time_us <= self._newest_us - self.HOLD_US):
            at_us = self._held[0].time_us
            readings = {}
            while self._held and self._held[0].time_us == at_us:
                reading = heapq.heappop(self._held)
                self.repeated += reading.cell in readings
                readings.setdefault(reading.cell, reading.acceleration_g)
            messages.append({"samples": {"sequence": self.sequence, "time_us": at_us, "cells": list(readings),
                                         "acceleration_g": [value for each in readings.values() for value in each]}})
            self.sequence += len(readings)
            self._sent_us = at_us
        return messages
