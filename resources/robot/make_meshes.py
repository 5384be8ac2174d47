#!/usr/bin/env python3
"""Makes the meshes of demo_arm.urdf, in metres, from formulas.

The upper arm is a box with rounded edges; the forearm is no body of revolution: its cross-sections are ovals that narrow,
turn and move aside from elbow to wrist, with a bulge where the muscle is. Both are closed; triangles are counter-clockwise
as seen from outside.

Usage: make_meshes.py FOLDER   writes upper_arm.obj and forearm.obj
"""

import math
import pathlib
import sys

AROUND = 48


def rounded_box_ring(z, length, half_x, half_y, edge):
    """The cross-section at height z of a box whose edges, those at its ends too, are rounded by the radius `edge`."""
    from_end = min(z, length - z)
    inset = edge - math.sqrt(max(edge * edge - (edge - from_end) ** 2, 0)) if from_end < edge else 0.0
    x, y, r = half_x - edge, half_y - edge, edge - inset
    ring = []
    for k in range(AROUND):
        angle = 2 * math.pi * (k + 0.5) / AROUND
        # A ray from the middle meets the outline of the rounded rectangle; found by halving.
        c, s = math.cos(angle), math.sin(angle)
        low, high = 0.0, 2 * (half_x + half_y)
        for _ in range(60):
            middle = (low + high) / 2
            out_x, out_y = max(abs(middle * c) - x, 0.0), max(abs(middle * s) - y, 0.0)
            if math.hypot(out_x, out_y) < r or (out_x == 0 and out_y == 0):
                low = middle
            else:
                high = middle
        ring.append((low * c, low * s, z))
    return ring


def forearm_ring(z, length):
    """An oval that narrows, turns and moves aside along the arm, with a muscle on one side."""
    part = z / length
    half_x = 0.056 - 0.020 * part
    half_y = 0.045 - 0.012 * part
    turn = math.radians(35) * part
    aside = 0.006 * math.sin(math.pi * part)
    end = min(z, length - z) / 0.02
    cap = math.sqrt(max(1 - (1 - end) ** 2, 0)) if end < 1 else 1.0
    ring = []
    for k in range(AROUND):
        angle = 2 * math.pi * k / AROUND
        muscle = 0.009 * math.exp(-((part - 0.3) / 0.2) ** 2) * math.exp(-2 * (1 - math.cos(angle - 1.0)))
        x, y = (half_x + muscle) * math.cos(angle), (half_y + muscle) * math.sin(angle)
        c, s = math.cos(turn), math.sin(turn)
        ring.append((cap * (c * x - s * y) + aside, cap * (s * x + c * y), z))
    return ring


def heights(length, cap, step):
    """Rings that stand closer where the ends are rounded."""
    near_end = [cap * (1 - math.cos(math.pi / 2 * k / 6)) for k in range(1, 7)]
    count = round((length - 2 * cap) / step)
    between = [cap + (length - 2 * cap) * k / count for k in range(1, count)]
    return near_end + between + [length - z for z in reversed(near_end)]


def write_obj(path, rings, bottom, top):
    """Rings of points from bottom to top, closed by a point at each end."""
    points = [bottom] + [point for ring in rings for point in ring] + [top]
    last = len(points)
    triangles = []
    for k in range(AROUND):
        after = (k + 1) % AROUND
        triangles.append((1, 2 + after, 2 + k))
        for row in range(len(rings) - 1):
            a, b = 2 + row * AROUND + k, 2 + row * AROUND + after
            triangles.append((a, b, a + AROUND))
            triangles.append((b, b + AROUND, a + AROUND))
        first = 2 + (len(rings) - 1) * AROUND
        triangles.append((first + k, first + after, last))
    lines = [f"# Made by make_meshes.py, in metres: {path.stem}"]
    lines += ["v %.6f %.6f %.6f" % point for point in points]
    lines += ["f %d %d %d" % triangle for triangle in triangles]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])

    length = 0.28
    edge = 0.035
    rings = [rounded_box_ring(z, length, 0.075, 0.065, edge) for z in heights(length, edge, 0.010)]
    write_obj(folder / "upper_arm.obj", rings, (0, 0, 0), (0, 0, length))

    length = 0.27
    rings = [forearm_ring(z, length) for z in heights(length, 0.02, 0.008)]
    write_obj(folder / "forearm.obj", rings, (0, 0, 0), (0, 0, length))


if __name__ == "__main__":
    main()
