"""Between ROS and Hexoderm: readings of ROS topics as a skin that speaks SkinWire, and calibrated frames for TF."""

__version__ = "0.1.0"
