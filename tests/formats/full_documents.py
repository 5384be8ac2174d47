"""Documents with every key that their formats have, made from files that the command line writes."""

import json
import math
import pathlib
import subprocess
import tempfile


def message(text):
    """A message that has an argument of every kind, and its English."""
    return {"template": "{} {} {} {}", "arguments": [text, 7, {"value": 1.5, "decimals": 1, "unit": "mm"}, ["a", "b"]]}


def english(text):
    """What message() says."""
    return f"{text} 7 1.5 mm a and b"


COVARIANCE = [1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1]
TURNED = [0, -1, 0, 1, 0, 0, 0, 0, 1]  # a quarter turn about z
ROBOT = {"urdf": "arm.urdf", "sha256": "00", "packages": [{"name": "arm", "folder": "/arm"}]}


def decision(origin, others):
    """What was decided about the patch of a cell."""
    return {
        "origin_cell": origin, "link": "forearm", "link_chosen": True, "by_surface": True,
        "points": [{"cell": origin, "x_l_m": [0, 0, 0.1], "sigma_m": 0.001}],
        "distances": [{"from_cell": origin, "to_cell": others, "distance_m": 0.1, "sigma_m": 0.001}],
        "place": {"R": TURNED, "t_m": [0.02, 0, 0.1], "cov_t_r": COVARIANCE},
    }


def cell_model(root):
    """The built-in model with all that it leaves out, and rotations that no quaternion holds to the last digit."""
    model = json.loads((root / "resources/cell_models/hex-bma150.json").read_text(encoding="utf-8"))
    model["name"] = "own"
    c, s = math.cos(0.3), math.sin(0.3)
    placed = {"t_u_m": [0.001, 0, 0], "q_u_wxyz": [1, 0, 0, 0], "R_u": [c, -s, 0, s, c, 0, 0, 0, 1]}
    model["accelerometer"].update(
        offset_sigma_g=[0.04, 0.04, 0.06], offset_shared_sigma_g=0.03, scale_shared_sigma=0.1, cross_axis_sigma=0.005,
        offset_drift_sigma_g=0.006, offset_drift_shared_sigma_g=0.005, offset_instability_sigma_g=0.0005,
        offset_instability_shared_sigma_g=0.0025, **placed)
    model["sensors"] = [{"name": "t", "type": "temperature", **placed}]
    model.update(forbidden_port_pairs=[[1, 1]], mounting_sigma_rad=0.01, side_angle_rad=0.1,
                 bend_sigma_rad=0.5, twist_sigma_rad=0.2,
                 yaw_sigma_rad=0.05)
    return model


def placements():
    """Of two patches."""
    return {"format": "hexoderm-placements", "version": 1, "placements": [
        {"origin_cell": 1, "link": "forearm", "R": TURNED, "t_m": [0.02, 0, 0.1], "cov_t_r": COVARIANCE},
        {"origin_cell": 4, "link": "hand", "R": TURNED, "t_m": [0.02, 0, 0.1]},
    ]}


def full_documents(root, cli):
    """All documents that are read, by their names."""
    root = pathlib.Path(root)
    with tempfile.TemporaryDirectory() as folder:
        def run(*arguments, codes=(0,)):
            done = subprocess.run([cli, *arguments, "--quiet"], cwd=folder, capture_output=True, text=True, check=False)
            assert done.returncode in codes, (arguments, done.stderr)

        def load(name):
            return json.loads((pathlib.Path(folder) / name).read_text(encoding="utf-8"))

        model = cell_model(root)
        (pathlib.Path(folder) / "own.json").write_text(json.dumps(model), encoding="utf-8")
        run("simulate", "--patch", "sheet:2x2", "--poses", "3", "--cell-model", "own.json", "-o", "s.session.json")
        session = load("s.session.json")
        session.update(description=english("ring"), description_message=message("ring"), robot=ROBOT, surface="concave",
                       muted_links=[{"source": 3, "source_port": 4, "target": 9, "target_port": 2, "why": "a cable"}])
        for cell in session["cells"]:
            cell["body_part"] = "arm"
        for pose in session["poses"]:
            pose.update(label=english("pose"), label_message=message("pose"), taken_at_ms=1700000000000,
                        joint_angles=[{"joint": "elbow", "position": 0.5}])
        session["poses"][0]["samples"][0]["temperature_c"] = 20.5
        session["poses"].append({"id": 99, "disabled": True, "why_disabled": "bumped", "samples": []})
        (pathlib.Path(folder) / "s.session.json").write_text(json.dumps(session), encoding="utf-8")
        run("solve", "s.session.json", "--without", "2", "--goal", "4,3", "-o", "c.calibration.json",
            codes=(0, 1))
        calibration = load("c.calibration.json")

    patch = calibration["patches"][0]
    session["placements"] = calibration["placements"] = [decision(patch["origin"], 99)]
    # Of version 1; it is read where there is no predecessor.
    next(cell for cell in patch["cells"] if cell["id"] == patch["origin"])["path"] = [patch["origin"]]
    patch["links"][0].update(used=False, muted_by="implausible-bend")
    return {"session": session, "calibration": calibration, "cell_model": model, "placements": placements()}
