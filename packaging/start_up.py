#!/usr/bin/env python3
"""Measures how long a program takes to start, on an idle computer: the median and the range of some runs.

Usage: start_up.py [--runs N] PROGRAM [ARGUMENT ...]            until it has ended
       start_up.py --window [--runs N] PROGRAM [ARGUMENT ...]   until its first window is painted; needs a display
A window counts as painted when it is shown and there are many colours in it. Before the first run that counts the program
is started once, which reads it from the disk.
"""

import argparse
import ctypes
import ctypes.util
import os
import statistics
import subprocess
import sys
import time

ENOUGH_COLOURS = 8  # a window that is not painted yet has one
SMALLEST_WINDOW = 300
IS_VIEWABLE = 2
Z_PIXMAP = 2
ALL_PLANES = 0xFFFFFFFF


class Attributes(ctypes.Structure):
    """XWindowAttributes, as far as it is looked at."""
    _fields_ = [("x", ctypes.c_int), ("y", ctypes.c_int), ("width", ctypes.c_int), ("height", ctypes.c_int),
                ("border_width", ctypes.c_int), ("depth", ctypes.c_int), ("visual", ctypes.c_void_p),
                ("root", ctypes.c_ulong), ("window_class", ctypes.c_int), ("gravities", ctypes.c_int * 3),
                ("planes", ctypes.c_ulong * 2), ("save_under", ctypes.c_int), ("colormap", ctypes.c_ulong),
                ("map_installed", ctypes.c_int), ("map_state", ctypes.c_int), ("rest", ctypes.c_long * 16)]


class Display:
    """What is shown on the X display."""

    def __init__(self):
        self.x11 = ctypes.CDLL(ctypes.util.find_library("X11") or "libX11.so.6")
        for name in ("XOpenDisplay", "XGetImage"):
            getattr(self.x11, name).restype = ctypes.c_void_p
        self.x11.XDefaultRootWindow.restype = ctypes.c_ulong
        self.x11.XGetPixel.restype = ctypes.c_ulong
        # A window may be gone when it is asked about.
        self.ignore = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(lambda display, error: 0)
        self.x11.XSetErrorHandler(self.ignore)
        self.display = ctypes.c_void_p(self.x11.XOpenDisplay(None))
        if not self.display:
            sys.exit("start_up: there is no display")
        self.root = ctypes.c_ulong(self.x11.XDefaultRootWindow(self.display))

    def windows(self):
        """The windows on the root window."""
        parent, root, count = ctypes.c_ulong(), ctypes.c_ulong(), ctypes.c_uint()
        children = ctypes.POINTER(ctypes.c_ulong)()
        self.x11.XQueryTree(self.display, self.root, ctypes.byref(root), ctypes.byref(parent), ctypes.byref(children),
                            ctypes.byref(count))
        found = [children[at] for at in range(count.value)]
        if children:
            self.x11.XFree(children)
        return found

    def is_painted(self, window):
        """Whether a window of some size is shown and is of many colours."""
        attributes = Attributes()
        window = ctypes.c_ulong(window)
        if not self.x11.XGetWindowAttributes(self.display, window, ctypes.byref(attributes)):
            return False
        width, height = attributes.width, attributes.height
        if attributes.map_state != IS_VIEWABLE or min(width, height) < SMALLEST_WINDOW:
            return False
        image = self.x11.XGetImage(self.display, window, 0, 0, width, height, ctypes.c_ulong(ALL_PLANES), Z_PIXMAP)
        if not image:
            return False
        image = ctypes.c_void_p(image)
        colours = {self.x11.XGetPixel(image, x, y) for x in range(0, width, 16) for y in range(0, height, 16)}
        self.x11.XDestroyImage(image)
        return len(colours) >= ENOUGH_COLOURS


def until_ended(command):
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


def until_painted(command, display, patience_s=60):
    before = set(display.windows())
    start = time.perf_counter()
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as program:
        try:
            while time.perf_counter() - start < patience_s and program.poll() is None:
                if any(display.is_painted(window) for window in display.windows() if window not in before):
                    return time.perf_counter() - start
                time.sleep(0.002)
        finally:
            program.kill()
    sys.exit(f"start_up: {command[0]} shows no window")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--window", action="store_true")
    parser.add_argument("--runs", type=int, default=11)
    parser.add_argument("command", nargs=argparse.REMAINDER)
    given = parser.parse_args()
    if not given.command or given.runs < 1:
        parser.error("a program is needed, and at least one run")
    if given.window:
        display = Display()
        measure = lambda: until_painted(given.command, display)
    else:
        measure = lambda: until_ended(given.command)
    measure()
    times_ms = [1000 * measure() for _ in range(given.runs)]
    print(f"{os.path.basename(given.command[0])}: {statistics.median(times_ms):.1f} ms"
          f" ({min(times_ms):.1f} to {max(times_ms):.1f}, {given.runs} runs)")


if __name__ == "__main__":
    main()
