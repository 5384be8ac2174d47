#!/usr/bin/env python3
"""Where is every cell, and how well is that known? From a session to a picture, in cells that a notebook takes over.

Usage: calibrate_a_skin.py [PICTURE]
"""

# %% What is needed, beside Hexoderm: NumPy and Matplotlib.
import sys

import matplotlib

matplotlib.use("Agg")  # a picture in a file; leave it out in a notebook
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import hexoderm

picture = sys.argv[1] if len(sys.argv) > 1 else "skin.png"

# %% The measurements: a simulated skin here. A file is hexoderm.read_session("arm.session.json"), a device
# hexoderm.Capture("tcp://HOST:PORT"), and arrays of your own hexoderm.Session.from_arrays(readings, links).
session = hexoderm.simulate(patch="x17", surface="cylinder:r=0.0501", poses=4, seed=1)
print(session.description)
norms_g = np.linalg.norm(session.readings, axis=2)
print(f"readings {session.readings.shape}: poses, cells, axes; norm {np.median(norms_g):.3f} g in the median")

# %% One pose after the other: what each adds.
poses = range(1, len(session.poses) + 1)
worst_mm = []
for count in poses:
    part = session.copy()
    while len(part.poses) > count:
        part.remove_pose(len(part.poses) - 1)
    verdict = hexoderm.solve(part).verdict
    worst_mm.append(np.nan if verdict.position_95_m is None else verdict.position_95_m * 1000)
    print(f"{count} pose{'s'[:count > 1]}: {verdict.reason}")

# %% The result: placements of all cells in the frame of the patch's origin cell, with their covariances.
calibration = hexoderm.solve(session)
patch = calibration.patches[0]
sigma_mm = 1000 * np.sqrt(np.trace(patch.shape_covariances[:, :3, :3], axis1=1, axis2=2))
for finding in calibration.findings:
    print(finding)
comparison = calibration.compare(session)[0]
error_mm = 1000 * np.linalg.norm(comparison.positions, axis=1)
orientation_deg = np.degrees(comparison.orientation_rms_rad)
print(f"against the truth: {comparison.position_rms_m * 1000:.2f} mm, {orientation_deg:.2f}° rms")

# %% How two cells lie to each other, and how well that is known.
first, last = int(patch.cells[0]), int(patch.cells[-1])
distance = np.linalg.norm(patch.positions[-1] - patch.positions[0])
deviation = np.sqrt(np.linalg.eigvalsh(patch.covariance(first, last)[:3, :3])[-1])
print(f"cells {first} and {last}: {distance * 1000:.1f} mm apart, 1 sigma {deviation * 1000:.2f} mm on the worst axis")

# %% The picture: the cells where they are, coloured by how well that is known, and what the poses brought.
figure = plt.figure(figsize=(11, 5))
axes = figure.add_subplot(1, 2, 1, projection="3d")
outlines = calibration.cell_model.outline @ patch.rotations.transpose(0, 2, 1) + patch.positions[:, np.newaxis]
colors = plt.get_cmap("viridis")(sigma_mm / sigma_mm.max())
axes.add_collection3d(Poly3DCollection(outlines * 1000, facecolors=colors, edgecolors="black", linewidths=0.5))
for cell, x, y, z in zip(patch.cells, *patch.positions.T * 1000):
    axes.text(x, y, z, str(cell), fontsize=7, ha="center")
low, high = outlines.min(axis=(0, 1)) * 1000, outlines.max(axis=(0, 1)) * 1000
axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
axes.set(xlabel="x, mm", ylabel="y, mm", zlabel="z, mm")
axes.set_box_aspect(high - low)
axes.set_title(f"17 cells in the frame of cell {patch.origin}")
shades = plt.cm.ScalarMappable(plt.Normalize(0, sigma_mm.max()), "viridis")
figure.colorbar(shades, ax=axes, shrink=0.6, pad=0.12, label="stated deviation, mm")

plot = figure.add_subplot(2, 2, 2)
plot.plot(poses, worst_mm, "o-")
plot.set(xlabel="poses", ylabel="mm", xticks=list(poses), ylim=(0, None), title="Worst cell, 95 %")
plot = figure.add_subplot(2, 2, 4)
plot.bar(comparison.cells - 0.2, error_mm, 0.4, label="error against the truth")
plot.bar(patch.cells + 0.2, sigma_mm, 0.4, label="stated deviation")
plot.set(xlabel="cell", ylabel="mm", xticks=patch.cells, title="Positions")
plot.legend(fontsize=7)
figure.tight_layout()
figure.savefig(picture, dpi=120)
print(f"written: {picture}")
