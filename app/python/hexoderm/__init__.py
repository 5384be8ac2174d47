"""Finds where every cell of a robot's artificial skin is.

Lengths are in metres, angles in radians, accelerations in g, unless a name ends otherwise. Frames are right-handed. The
frame of a cell has its origin at the centre of the hexagon's front face and z out of the skin; the frame of a patch is
that of its origin cell. A position t and a rotation R map into the frame that is named: x_patch = R @ x_cell + t. How
several patches lie to each other is not known, so each has arrays of its own.

Where to look: a Session comes from read_session(), simulate(), Session.from_arrays() or a Capture; solve() makes a
Calibration of it, with patches, findings and a verdict; Calibration.export() writes it for other software. A page with
examples is README.md of python3-hexoderm, in /usr/share/doc/python3-hexoderm where Debian's package is installed.
"""

from ._core import *
from ._core import __version__ as __version__

__all__ = [
    "built_in_cell_models", "export_formats", "export_options", "read", "read_calibration", "read_session",
    "simulate", "simulate_robot", "solve", "Calibration", "Capture", "CellModel", "Comparison", "DeviceError",
    "Error", "Exported", "Finding", "FormatError", "InvalidArgument", "Link", "Lot", "Patch", "PatchOnLink", "Pose",
    "Sensor", "Session", "StorageError", "Verdict",
]
