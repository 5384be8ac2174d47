"""What becomes of a message, whichever ROS it is of: readings for the device, and a note of it for the watch."""

import functools

from hexoderm_ros import readings


class Intake:
    """imu() and cell_data() make the functions that are given each message of a topic, and the time in microseconds."""

    def __init__(self, skin, device, watch):
        self._skin, self._device, self._watch = skin, device, watch

    def imu(self, topic):
        return self._taker(topic, lambda message, now_us, leave_out: readings.of_imu(
            message, self._skin.imus[topic], now_us, leave_out))

    def cell_data(self, names):
        return self._taker(names.topic, lambda message, now_us, leave_out: readings.of_cell_data(
            message, names, self._skin.ids, now_us, leave_out))

    def _taker(self, topic, readings_of):
        leave_out = functools.partial(self._watch.left_out, topic)

        def take(message, now_us):
            self._watch.came(topic)
            found = readings_of(message, now_us, leave_out)
            self._device.add(found)
            self._watch.took(found)

        return take
