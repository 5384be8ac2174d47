#include "app/python/bindings.h"

#include "hexoderm/base/error.h"
#include "hexoderm/solve/metrics/review_summary.h"

namespace hexoderm::python {
namespace {

namespace py = pybind11;

/// Of two cells, by `get`, which needs no lock.
Doubles covariance(const PatchReconstruction& self, std::uint32_t a, std::uint32_t b,
                   Matrix6d (PlacementCovariance::*get)(CellId a, CellId b) const) {
  const auto& known = self.covariance;
  if (!known) throw InvalidArgument("the covariance of two cells is known of a fresh result of the global solver only");
  const Matrix6d values = [&] {
    const GilRelease unlocked;
    return ((*known).*get)(CellId(a), CellId(b));
  }();
  return arrayOf(values);
}

std::vector<SensorPlacement> sensorsOf(const PatchReconstruction& self, std::uint32_t cell) {
  const CellPlacement* placed = self.findCell(CellId(cell));
  if (placed == nullptr) throw InvalidArgument("no cell " + std::to_string(cell) + " is in the patch");
  return placed->sensors;
}

void bindLink(py::module_& module) {
  py::class_<LinkEstimate>(module, "Link", "All that is known of one link between two cells.")
      .def_readonly("source", &LinkEstimate::source, "(cell, port), the smaller of both ends.")
      .def_readonly("target", &LinkEstimate::target, "(cell, port).")
      .def_readonly("rotation", &LinkEstimate::R_c_n,
                    "(3, 3): from the frame of the target's cell to that of the source's.")
      .def_readonly("quality", &LinkEstimate::quality,
                    "How well the poses determine the rotation: un, partially, fully or over.")
      .def_property_readonly("residual_rad", &LinkEstimate::knownResidual,
                             "Angle between both cells' readings, rms over the poses; None where it is not known.")
      .def_property_readonly("sigma_rad", &LinkEstimate::knownSigma,
                             "Predicted standard deviation about the worst axis; None where it is not known.")
      .def_readonly("bend_rad", &LinkEstimate::bend_rad,
                    "Of the target against how it would lie flat beside the source: about the axis across the link in\n"
                    "the surface. Positive where the two faces turn away from each other, as on the outside of a part\n"
                    "that is convex. The same from both ends.")
      .def_readonly("twist_rad", &LinkEstimate::twist_rad,
                    "About the axis along the link, from the source outwards: positive as a right-handed screw, from\n"
                    "both ends. Small on most parts.")
      .def_readonly("yaw_rad", &LinkEstimate::yaw_rad,
                    "About the source's z: positive counter-clockwise, seen from outside. Nearly 0.")
      .def_readonly("used", &LinkEstimate::used, "It is part of the solution; a muted one is not.")
      .def_readonly("in_tree", &LinkEstimate::in_tree, "It is on the shortest-path tree.")
      .def_readonly("muted_by", &LinkEstimate::muted_by,
                    "The code of the finding that it is muted by; None if there is none.")
      .def("__repr__", [](const LinkEstimate& link) {
        return "<Link " + hexoderm::inWords(link.source).english() + " to " + hexoderm::inWords(link.target).english() +
               ">";
      });
}

void bindSensor(py::module_& module) {
  py::class_<SensorPlacement>(module, "Sensor", "A sensor of a cell, placed in its patch's frame.")
      .def_readonly("name", &SensorPlacement::name, "As in the cell model.")
      .def_readonly("type", &SensorPlacement::type, "As in the cell model, for example temperature.")
      .def_property_readonly(
          "position", [](const SensorPlacement& sensor) { return sensor.T_o_s.t; }, "(3,), m.")
      .def_property_readonly(
          "rotation", [](const SensorPlacement& sensor) { return sensor.T_o_s.R; },
          "(3, 3): from the sensor's axes to the patch's.")
      .def("__repr__", [](const SensorPlacement& sensor) { return "<Sensor " + sensor.name + ">"; });
}

void bindLot(py::module_& module) {
  py::class_<LotEstimate>(module, "Lot", "The errors that all accelerometers of a patch have in common, in their axes.")
      .def_readonly("offset", &LotEstimate::offset_g, "(3,), g.")
      .def_readonly("offset_sigma", &LotEstimate::offset_sigma_g, "(3,): its standard deviation an axis, g.")
      .def_readonly("scale", &LotEstimate::scale, "Of all axes.")
      .def_readonly("scale_sigma", &LotEstimate::scale_sigma, "Its standard deviation, relative.")
      .def("__repr__", [](const LotEstimate& lot) { return "<Lot: " + lotText(lot).english() + ">"; });
}

}  // namespace

void bindPatch(py::module_& module) {
  bindLink(module);
  bindLot(module);
  bindSensor(module);
  const auto of_cells = [](auto get) {
    return [get](const PatchReconstruction& self) { return stacked(self.cells, get); };
  };
  py::class_<PatchReconstruction, std::shared_ptr<PatchReconstruction>>(
      module, "Patch",
      "Cells that are joined by links. All arrays are in the order of `cells`, and in the patch's frame,\n"
      "which is that of the origin cell.")
      .def_readonly("id", &PatchReconstruction::id, "A number from 0 on.")
      .def_readonly("origin", &PatchReconstruction::origin, "The origin cell.")
      .def_property_readonly(
          "cells", [](const PatchReconstruction& self) { return numbersOf(self.cells, &CellPlacement::cell); },
          "(N,): the cells' IDs, ascending.")
      .def_property_readonly("positions", of_cells([](const CellPlacement& cell) { return cell.T_o_u.t; }),
                             "(N, 3): the centres of the cells' front faces, m.")
      .def_property_readonly(
          "rotations", of_cells([](const CellPlacement& cell) { return cell.T_o_u.R; }),
          "(N, 3, 3): from each cell's frame to the patch's; the last column is where the cell faces.")
      .def_property_readonly(
          "covariances", of_cells(&CellPlacement::cov_t_r),
          "(N, 6, 6), relative to the origin: position (m, patch frame) before rotation (rad, right-multiplied error\n"
          "in the cell frame, R_true = R exp(e)). Zero for the origin; NaN where it is not stated.")
      .def_property_readonly(
          "shape_covariances", of_cells(&CellPlacement::shape_cov_t_r),
          "(N, 6, 6), likewise, relative to the patch as a whole: it does not depend on which cell is the origin. Of\n"
          "the global solver; NaN from the tree.")
      .def_property_readonly(
          "measured",
          [](const PatchReconstruction& self) {
            return row<bool>(self.cells, [](const CellPlacement& cell) { return cell.placed_by == PlacedBy::Samples; });
          },
          "(N,): placed by readings of its own; else by its links alone.")
      .def_property_readonly(
          "offsets", of_cells(&CellPlacement::accel_offset_g),
          "(N, 3): estimated offsets of the accelerometers, g, along their axes; NaN where there are none.")
      .def_property_readonly("scales", of_cells(&CellPlacement::accel_scale),
                             "(N, 3): their scales, reading = scale * force + offset; NaN where there are none.")
      .def_readonly("lot", &PatchReconstruction::lot,
                    "What its accelerometers have in common, which `offsets` and `scales` count too. None where it is\n"
                    "not estimated: the cell model says of no lot, or the tree solved.")
      .def_property_readonly(
          "gravity", [](const PatchReconstruction& self) { return stacked(self.gravity, &GravityDirection::g_o); },
          "(poses, 3): unit vectors that point up, in the order of `gravity_poses`.")
      .def_property_readonly(
          "gravity_poses",
          [](const PatchReconstruction& self) { return numbersOf(self.gravity, &GravityDirection::pose); },
          "(poses,): the IDs of the poses.")
      .def_readonly("links", &PatchReconstruction::links, "All links of its cells, muted ones too.")
      .def("sensors", &sensorsOf, py::arg("cell"), "The sensors of a cell.")
      .def(
          "covariance",
          [](const PatchReconstruction& self, std::uint32_t a, std::uint32_t b) {
            return covariance(self, a, b, &PlacementCovariance::relative);
          },
          py::arg("a"), py::arg("b"),
          "(6, 6): covariance of the placement of cell b in a's frame, position (m, frame of a) before rotation (rad,\n"
          "right-multiplied error in the frame of b). Of a fresh result of the global solver only.")
      .def(
          "covariance_together",
          [](const PatchReconstruction& self, std::uint32_t a, std::uint32_t b) {
            return covariance(self, a, b, &PlacementCovariance::together);
          },
          py::arg("a"), py::arg("b"),
          "(6, 6): covariance between the errors of two cells as `covariances` states them of each; rows a, columns b.")
      .def("__len__", [](const PatchReconstruction& self) { return self.cells.size(); })
      .def("__repr__", [](const PatchReconstruction& self) {
        return "<Patch " + toString(self.id) + ": " + std::to_string(self.cells.size()) + " cells, origin cell " +
               toString(self.origin) + ">";
      });
}

}  // namespace hexoderm::python
