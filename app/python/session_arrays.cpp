#include "app/python/session_arrays.h"

#include "app/python/bindings.h"

#include "hexoderm/io/session_json.h"
#include "hexoderm/util/error.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

constexpr const char* kArrays = "arrays";

Eigen::Matrix3d matrixAt(const double* values) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values);
}

std::uint32_t idFrom(std::int64_t value, const char* what) {
  if (value >= 0 && value <= UINT32_MAX) return static_cast<std::uint32_t>(value);
  throw InvalidArgument(std::string(what) + ": expected a whole number from 0 to 4294967295, found " +
                        std::to_string(value));
}

/// Both cells report the link, as after an exploration.
NeighborList neighborsFrom(const Numbers& cells, const Numbers& links, const std::vector<std::string>& parts) {
  requireShape(cells, {-1}, "cells");
  requireShape(links, {-1, 4}, "links");
  NeighborList neighbors;
  std::map<std::int64_t, std::size_t> index;
  for (py::ssize_t k = 0; k < cells.size(); ++k) {
    const std::int64_t id = cells.data()[k];
    if (!index.emplace(id, neighbors.size()).second) {
      throw InvalidArgument("cells: cell " + std::to_string(id) + " is named twice");
    }
    neighbors.push_back({CellId(idFrom(id, "cells")), "", {}});
  }
  if (!parts.empty() && parts.size() != neighbors.size()) {
    throw InvalidArgument("body_parts: expected one for each of " + std::to_string(neighbors.size()) +
                          " cells, found " + std::to_string(parts.size()));
  }
  for (std::size_t k = 0; k < parts.size(); ++k) neighbors[k].body_part = parts[k];
  for (py::ssize_t k = 0; k < links.shape(0); ++k) {
    const std::int64_t* const link = links.data(k, 0);
    for (const auto& [from, to] : {std::pair(0, 2), std::pair(2, 0)}) {
      const auto found = index.find(link[from]);
      if (found == index.end()) {
        throw InvalidArgument("links: row " + std::to_string(k) + " names cell " + std::to_string(link[from]) +
                              ", which is not among the cells");
      }
      neighbors[found->second].neighbors.push_back({PortNumber(idFrom(link[from + 1], "links")),
                                                    CellId(idFrom(link[to], "links")),
                                                    PortNumber(idFrom(link[to + 1], "links"))});
    }
  }
  for (CellReport& cell : neighbors) std::ranges::stable_sort(cell.neighbors, {}, &NeighborReport::port);
  return neighbors;
}

Numbers countedFromOne(py::ssize_t count) {
  Numbers cells(count);
  for (py::ssize_t k = 0; k < count; ++k) cells.mutable_data()[k] = k + 1;
  return cells;
}

/// One pose of arrays that begin with the poses.
template <class Array>
Array poseOf(const Array& all, py::ssize_t pose) {
  const py::object one = py::reinterpret_borrow<py::object>(all)[py::int_(pose)];
  return one.template cast<Array>();
}

template <class Array>
void requirePoses(const std::optional<Array>& array, py::ssize_t poses, const char* what) {
  if (!array || (array->ndim() > 0 && array->shape(0) == poses)) return;
  throw InvalidArgument(std::string(what) + ": expected one for each of the " + std::to_string(poses) + " poses");
}

std::optional<Numbers> wholeNumbersIfGiven(const std::optional<py::object>& given, const char* what) {
  return given ? std::optional(wholeNumbers(*given, what)) : std::nullopt;
}

Session fromArrays(const Doubles& readings, const py::object& links_given, const std::optional<py::object>& cells_given,
                   const std::optional<Doubles>& covariances, const std::optional<py::object>& counts_given,
                   const std::vector<std::string>& labels, const std::vector<std::string>& body_parts,
                   const ModelOrName& cell_model, const std::string& description) {
  const Numbers links = wholeNumbers(links_given, "links");
  const std::optional<Numbers> cells = wholeNumbersIfGiven(cells_given, "cells");
  const std::optional<Numbers> counts = wholeNumbersIfGiven(counts_given, "counts");
  requireShape(readings, {-1, cells ? cells->size() : -1, 3}, "readings");
  const py::ssize_t poses = readings.shape(0);
  requirePoses(covariances, poses, "covariances");
  requirePoses(counts, poses, "counts");
  if (!labels.empty() && labels.size() != static_cast<std::size_t>(poses)) {
    throw InvalidArgument("labels: expected one for each of the " + std::to_string(poses) + " poses");
  }
  Session session(modelFrom(cell_model),
                  neighborsFrom(cells ? *cells : countedFromOne(readings.shape(1)), links, body_parts),
                  {Message::verbatim(description), "", ""});
  for (py::ssize_t k = 0; k < poses; ++k) {
    PoseArrays pose;
    pose.readings = poseOf(readings, k);
    if (covariances) pose.covariances = poseOf(*covariances, k);
    if (counts) pose.counts = poseOf(*counts, k);
    if (!labels.empty()) pose.label = labels[static_cast<std::size_t>(k)];
    session.addPose(poseFrom(session, pose));
  }
  checkAsFile(session);
  return session;
}

/// Each link once, from the end that reports it first; -1 for a port that was not reported.
Numbers linksOf(const Session& session) {
  std::vector<std::array<std::int64_t, 4>> rows;
  std::set<std::array<std::int64_t, 4>> known;
  for (const CellReport& cell : session.neighbors()) {
    for (const NeighborReport& link : cell.neighbors) {
      if (link.cell == CellId()) continue;
      const std::int64_t other = link.cell_port ? static_cast<std::int64_t>(link.cell_port->value()) : -1;
      const std::array<std::int64_t, 4> row = {cell.id.value(), link.port.value(), link.cell.value(), other};
      if (known.contains({row[2], row[3], row[0], row[1]})) continue;
      if (known.insert(row).second) rows.push_back(row);
    }
  }
  Numbers array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{4}});
  std::int64_t* out = array.mutable_data();
  for (const auto& row : rows) out = std::ranges::copy(row, out).out;
  return array;
}

/// What `get` says of the sample of each pose and cell, in the order of poses and cells.
template <class Fill>
void forEachSample(const Session& session, const Fill& fill) {
  std::map<CellId, std::size_t> index;
  for (const CellReport& cell : session.neighbors()) index.emplace(cell.id, index.size());
  for (std::size_t pose = 0; pose < session.poses().size(); ++pose) {
    for (const GravitySample& sample : session.poses()[pose].capture->samples) {
      const auto found = index.find(sample.cell);
      if (found != index.end()) fill(pose * session.neighbors().size() + found->second, sample);
    }
  }
}

Doubles readingsOf(const Session& session) {
  Doubles array = unknowns({session.poses().size(), session.neighbors().size(), 3});
  double* const out = array.mutable_data();
  forEachSample(session, [&](std::size_t k, const GravitySample& sample) { copyTo(out + 3 * k, sample.mean_g); });
  return array;
}

Doubles covariancesOf(const Session& session) {
  Doubles array = unknowns({session.poses().size(), session.neighbors().size(), 3, 3});
  double* const out = array.mutable_data();
  forEachSample(session, [&](std::size_t k, const GravitySample& sample) { copyTo(out + 9 * k, sample.cov_g2); });
  return array;
}

Numbers countsOf(const Session& session) {
  Numbers array({session.poses().size(), session.neighbors().size()});
  std::int64_t* const out = array.mutable_data();
  std::fill_n(out, array.size(), 0);
  forEachSample(session, [&](std::size_t k, const GravitySample& sample) { out[k] = sample.count; });
  return array;
}

/// (cells,) and the placements, in the frame of the truth; None where it is not known.
py::object truthOf(const Session& session) {
  if (!session.truth()) return py::none();
  const auto& cells = session.truth()->cells;
  return py::make_tuple(numbersOf(cells, [](const TrueCellPlacement& cell) { return cell.id.value(); }),
                        stacked(cells, [](const TrueCellPlacement& cell) { return std::optional(cell.T_b_u.t); }),
                        stacked(cells, [](const TrueCellPlacement& cell) { return std::optional(cell.T_b_u.R); }));
}

}  // namespace

SessionPose poseFrom(const Session& session, const PoseArrays& arrays) {
  const auto cells = static_cast<py::ssize_t>(session.neighbors().size());
  requireShape(arrays.readings, {cells, 3}, "readings");
  if (arrays.covariances) requireShape(*arrays.covariances, {cells, 3, 3}, "covariances");
  if (arrays.counts) requireShape(*arrays.counts, {cells}, "counts");
  PoseCapture capture;
  capture.id = session.nextPoseId();
  capture.label = Message::verbatim(arrays.label);
  for (py::ssize_t k = 0; k < cells; ++k) {
    GravitySample sample;
    sample.cell = session.neighbors()[static_cast<std::size_t>(k)].id;
    sample.mean_g = Eigen::Map<const Eigen::Vector3d>(arrays.readings.data(k, 0));
    if (sample.mean_g.array().isNaN().all()) continue;
    if (arrays.covariances) sample.cov_g2 = matrixAt(arrays.covariances->data(k, 0, 0));
    if (arrays.counts) sample.count = idFrom(arrays.counts->data()[k], "counts");
    capture.samples.push_back(sample);
  }
  return {std::make_shared<const PoseCapture>(std::move(capture)), false, {}, arrays.joint_angles};
}

void checkAsFile(const Session& session) { static_cast<void>(parseSessionJson(sessionToJson(session), kArrays)); }

void bindSessionArrays(py::class_<Session>& session) {
  session
      .def_static(
          "from_arrays", &fromArrays, py::arg("readings"), py::arg("links"), py::kw_only(),
          py::arg("cells") = py::none(), py::arg("covariances") = py::none(), py::arg("counts") = py::none(),
          py::arg("labels") = std::vector<std::string>(), py::arg("body_parts") = std::vector<std::string>(),
          py::arg("cell_model") = "hex-bma150", py::arg("description") = "",
          "A session of arrays.\n\n"
          "readings: (poses, cells, 3), mean readings in g along the axes of each accelerometer, +1 g on the axis\n"
          "that points up; NaN where a cell has none.\n"
          "links: (links, 4), each once: cell, port, cell, port.\n"
          "cells: (cells,), their IDs; 1, 2, ... without it.\n"
          "covariances: (poses, cells, 3, 3) of the means, g^2; zero: not known.\n"
          "counts: (poses, cells), samples averaged; 0: not known.\n"
          "labels: a name for each pose. body_parts: one for each cell.\n"
          "cell_model: a CellModel, a built-in name, or a JSON file.\n\n"
          "What is wrong with the numbers is said as for a file of the name \"arrays\".")
      .def_property_readonly(
          "cells",
          [](const Session& self) {
            return numbersOf(self.neighbors(), [](const CellReport& cell) { return cell.id.value(); });
          },
          "(cells,): the cells' IDs.")
      .def_property_readonly("links", &linksOf,
                             "(links, 4): cell, port, cell, port; a port that the skin does not report is -1.")
      .def_property_readonly("readings", &readingsOf, "(poses, cells, 3), g; NaN where a cell has no reading.")
      .def_property_readonly("covariances", &covariancesOf,
                             "(poses, cells, 3, 3), g^2; NaN where a cell has no reading.")
      .def_property_readonly("counts", &countsOf, "(poses, cells); 0 where it is not known.")
      .def_property_readonly("truth", &truthOf,
                             "Of a simulated skin, where its cells are in truth: cells (N,), positions (N, 3), m, and\n"
                             "rotations (N, 3, 3), from each cell's frame to the body's. None where it is not known.");
}

}  // namespace hexoderm::python
