#include "app/python/bindings.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/is_rotation.h"
#include "hexoderm/io/session_json.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

constexpr const char* kArrays = "arrays";
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Throws InvalidArgument naming `what` unless this can be an ID.
std::uint32_t idFrom(std::int64_t value, const char* what) {
  if (value >= 0 && value <= UINT32_MAX) return static_cast<std::uint32_t>(value);
  throw InvalidArgument(std::string(what) + ": expected a whole number from 0 to 4294967295, found " +
                        std::to_string(value));
}

/// Of cells (N,) and links (links, 4), which both cells report, as after an exploration. Throws InvalidArgument naming
/// what does not fit.
NeighborList neighborsFrom(const Numbers& cells, const Numbers& links, const std::vector<std::string>& parts) {
  requireShape(cells, {"cells"}, "cells");
  requireShape(links, {"links", 4}, "links");
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

/// Of (cells, positions, rotations), as Session.truth has it. Throws InvalidArgument, or TypeError for another type.
GroundTruth truthFrom(const py::object& truth, const NeighborList& skin) {
  const char* const expected = "(cells, positions, rotations), as Session.truth has it";
  if (!py::isinstance<py::sequence>(truth) || py::len(truth) != 3) failFor("truth", expected, truth);
  const auto parts = py::reinterpret_borrow<py::sequence>(truth);
  const Numbers cells = wholeNumbers(parts[0], "truth[0]");
  const auto positions = Doubles::ensure(parts[1]);
  const auto rotations = Doubles::ensure(parts[2]);
  if (!positions || !rotations) failFor("truth", expected, truth);
  requireShape(cells, {"cells"}, "truth[0]");
  const Axis each("cells", cells.size());
  requireShape(positions, {each, 3}, "truth[1]");
  requireShape(rotations, {each, 3, 3}, "truth[2]");
  GroundTruth known;
  std::set<CellId> named;
  for (py::ssize_t k = 0; k < cells.size(); ++k) {
    TrueCellPlacement placed;
    placed.id = CellId(idFrom(cells.data()[k], "truth[0]"));
    placed.T_b_u.t = Eigen::Map<const Eigen::Vector3d>(positions.data(k, 0));
    placed.T_b_u.R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotations.data(k, 0, 0));
    const std::string place = "[" + std::to_string(k) + "]";
    if (std::ranges::find(skin, placed.id, &CellReport::id) == skin.end() || !named.insert(placed.id).second) {
      throw InvalidArgument("truth[0]" + place + ": expected each cell of the session once, found cell " +
                            toString(placed.id));
    }
    if (!placed.T_b_u.t.allFinite()) throw InvalidArgument("truth[1]" + place + ": expected finite numbers");
    if (!isRotation(placed.T_b_u.R)) {
      throw InvalidArgument("truth[2]" + place + ": expected a rotation matrix (orthogonal to 1e-6, determinant +1)");
    }
    known.cells.push_back(placed);
  }
  return known;
}

/// (cells, positions, rotations), in the frame of the truth; None where it is not known.
py::object truthOf(const Session& session) {
  if (!session.truth()) return py::none();
  const auto& cells = session.truth()->cells;
  return py::make_tuple(numbersOf(cells, &TrueCellPlacement::id),
                        stacked(cells, [](const TrueCellPlacement& cell) { return cell.T_b_u.t; }),
                        stacked(cells, [](const TrueCellPlacement& cell) { return cell.T_b_u.R; }));
}

/// A pose as arrays, in the order of the session's cells.
struct PoseArrays {
  std::optional<std::size_t> index;    ///< its place in arrays of several poses, for errors
  Doubles readings;                    ///< (cells, 3); NaN: no reading
  std::optional<Doubles> covariances;  ///< (cells, 3, 3)
  std::optional<Numbers> counts;       ///< (cells,)
  std::string label;
  JointAngles joint_angles;
};

Eigen::Matrix3d matrixAt(const double* values) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values);
}

void requireReading(const Eigen::Vector3d& mean_g, const std::string& place) {
  if (mean_g.allFinite()) return;
  throw InvalidArgument(place +
                        ": expected three finite numbers, or NaN for all three where the cell has no reading, " +
                        "found " + std::string(py::repr(arrayOf(mean_g).attr("tolist")())));
}

void requireCovariance(const Eigen::Matrix3d& cov_g2, const std::string& place) {
  if (isCovariance(cov_g2)) return;
  const char* wrong = "a positive semidefinite matrix";
  if (!cov_g2.allFinite()) {
    wrong = "finite numbers, or zeros where it is not known";
  } else if (cov_g2.diagonal().minCoeff() < 0) {
    wrong = "variances of at least 0 on the diagonal";
  } else if (isCovariance((cov_g2 + cov_g2.transpose()) / 2)) {
    wrong = "a symmetric matrix";
  }
  throw InvalidArgument(place + ": expected " + wrong);
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

std::optional<Numbers> wholeNumbersIfGiven(const std::optional<py::object>& given, const char* what) {
  return given ? std::optional(wholeNumbers(*given, what)) : std::nullopt;
}

constexpr const char* kNumbers = "an array of numbers";

/// The pose with the next ID of the session. Throws InvalidArgument naming the array that does not fit.
SessionPose poseFrom(const Session& session, const PoseArrays& arrays) {
  const auto cells = static_cast<py::ssize_t>(session.neighbors().size());
  const Axis each("cells", cells);
  requireShape(arrays.readings, {each, 3}, "readings");
  if (arrays.covariances) requireShape(*arrays.covariances, {each, 3, 3}, "covariances");
  if (arrays.counts) requireShape(*arrays.counts, {each}, "counts");
  PoseCapture capture;
  capture.id = session.nextPoseId();
  capture.label = Message::verbatim(arrays.label);
  for (py::ssize_t k = 0; k < cells; ++k) {
    const std::string place =
        "[" + (arrays.index ? std::to_string(*arrays.index) + ", " : std::string()) + std::to_string(k) + "]";
    GravitySample sample;
    sample.cell = session.neighbors()[static_cast<std::size_t>(k)].id;
    sample.mean_g = Eigen::Map<const Eigen::Vector3d>(arrays.readings.data(k, 0));
    if (sample.mean_g.array().isNaN().all()) continue;
    requireReading(sample.mean_g, "readings" + place);
    if (arrays.covariances) sample.cov_g2 = matrixAt(arrays.covariances->data(k, 0, 0));
    requireCovariance(sample.cov_g2, "covariances" + place);
    if (arrays.counts) sample.count = idFrom(arrays.counts->data()[k], "counts");
    capture.samples.push_back(sample);
  }
  return {std::make_shared<const PoseCapture>(std::move(capture)), false, {}, arrays.joint_angles};
}

/// Throws as if the session were read from a file: numbers that make no sense, readings in another unit than g.
void checkAsFile(const Session& session) { static_cast<void>(parseSessionJson(sessionToJson(session), kArrays)); }

Session fromArrays(const Argument<Doubles>& readings_given, const py::object& links_given,
                   const std::optional<py::object>& cells_given,
                   const Argument<std::optional<Doubles>>& covariances_given,
                   const std::optional<py::object>& counts_given,
                   const Argument<std::vector<std::string>>& labels_given,
                   const Argument<std::vector<std::string>>& parts_given, const Argument<ModelOrName>& cell_model,
                   const Argument<std::string>& description, const std::optional<py::object>& truth) {
  const Doubles readings = readings_given.as("readings", kNumbers);
  const std::optional<Doubles> covariances = covariances_given.as("covariances", kNumbers);
  const std::vector<std::string> labels = labels_given.as("labels", "a list of strings");
  const std::vector<std::string> body_parts = parts_given.as("body_parts", "a list of strings");
  const Numbers links = wholeNumbers(links_given, "links");
  const std::optional<Numbers> cells = wholeNumbersIfGiven(cells_given, "cells");
  const std::optional<Numbers> counts = wholeNumbersIfGiven(counts_given, "counts");
  requireShape(readings, {"poses", cells ? Axis("cells", cells->size()) : Axis("cells"), 3}, "readings",
               readings.ndim() == 4 ? "; average the samples of each pose first" : "");
  const py::ssize_t poses = readings.shape(0);
  const Axis each_pose("poses", poses);
  const Axis each_cell("cells", readings.shape(1));
  if (covariances) requireShape(*covariances, {each_pose, each_cell, 3, 3}, "covariances");
  if (counts) requireShape(*counts, {each_pose, each_cell}, "counts");
  if (!labels.empty() && labels.size() != static_cast<std::size_t>(poses)) {
    throw InvalidArgument("labels: expected one for each of the " + std::to_string(poses) + " poses, found " +
                          std::to_string(labels.size()));
  }
  Session session(modelFrom(cell_model),
                  neighborsFrom(cells ? *cells : countedFromOne(readings.shape(1)), links, body_parts),
                  {Message::verbatim(description.as("description")), "", ""});
  for (py::ssize_t k = 0; k < poses; ++k) {
    PoseArrays pose;
    pose.index = static_cast<std::size_t>(k);
    pose.readings = poseOf(readings, k);
    if (covariances) pose.covariances = poseOf(*covariances, k);
    if (counts) pose.counts = poseOf(*counts, k);
    if (!labels.empty()) pose.label = labels[static_cast<std::size_t>(k)];
    session.addPose(poseFrom(session, pose));
  }
  if (truth) session.setTruth(truthFrom(*truth, session.neighbors()));
  checkAsFile(session);
  return session;
}

void addPose(Session& session, const Doubles& readings, const std::optional<Doubles>& covariances,
             const std::optional<py::object>& counts, const std::string& label,
             const std::map<std::string, double>& joint_angles) {
  PoseArrays arrays;
  arrays.readings = readings;
  arrays.covariances = covariances;
  if (counts) arrays.counts = wholeNumbers(*counts, "counts");
  arrays.label = label;
  for (const auto& [joint, position] : joint_angles) arrays.joint_angles.positions[joint] = position;
  const SessionPose pose = poseFrom(session, arrays);
  Session with_pose = session;
  with_pose.addPose(pose);
  checkAsFile(with_pose);
  session = std::move(with_pose);
}

/// (poses, cells) and the shape of what `get` says of a sample; `lacking` where a cell has no reading.
template <class Number, class Get>
py::array_t<Number> ofSamples(const Session& session, std::vector<std::size_t> shape, Number lacking, const Get& get) {
  shape.insert(shape.begin(), {session.poses().size(), session.neighbors().size()});
  py::array_t<Number> array(shape);
  std::fill_n(array.mutable_data(), array.size(), lacking);
  std::map<CellId, std::size_t> index;
  for (const CellReport& cell : session.neighbors()) index.emplace(cell.id, index.size());
  for (std::size_t pose = 0; pose < session.poses().size(); ++pose) {
    for (const GravitySample& sample : session.poses()[pose].capture->samples) {
      const auto found = index.find(sample.cell);
      if (found != index.end()) get(sample, array.mutable_data(pose, found->second));
    }
  }
  return array;
}

Doubles readingsOf(const Session& session) {
  return ofSamples(session, {3}, kUnknown,
                   [](const GravitySample& sample, double* out) { copyTo(out, sample.mean_g); });
}
Doubles covariancesOf(const Session& session) {
  return ofSamples(session, {3, 3}, kUnknown,
                   [](const GravitySample& sample, double* out) { copyTo(out, sample.cov_g2); });
}
Numbers countsOf(const Session& session) {
  return ofSamples(session, {}, std::int64_t{0},
                   [](const GravitySample& sample, std::int64_t* out) { *out = sample.count; });
}

}  // namespace

void bindSessionArrays(py::class_<Session>& session) {
  session
      .def_static(
          "from_arrays", &fromArrays, py::arg("readings"), py::arg("links"), py::kw_only(),
          py::arg("cells") = py::none(), py::arg("covariances") = py::none(), py::arg("counts") = py::none(),
          py::arg("labels") = std::vector<std::string>(), py::arg("body_parts") = std::vector<std::string>(),
          py::arg("cell_model") = "hex-bma150", py::arg("description") = "", py::arg("truth") = py::none(),
          "A session of arrays.\n\n"
          "readings: (poses, cells, 3), mean readings in g along the axes of each accelerometer, +1 g on the axis\n"
          "that points up; NaN where a cell has none.\n"
          "links: (links, 4), each once: cell, port, cell, port.\n"
          "cells: (cells,), their IDs; 1, 2, ... without it.\n"
          "covariances: (poses, cells, 3, 3) of the means, g^2; zero: not known.\n"
          "counts: (poses, cells), samples averaged; 0: not known.\n"
          "labels: a name for each pose. body_parts: one for each cell.\n"
          "cell_model: a CellModel, a built-in name, or a JSON file.\n"
          "truth: (cells, positions, rotations) where they are known otherwise, as Session.truth has them, in any\n"
          "frame; for Calibration.compare().\n\n"
          "What is wrong with the numbers is said by array and place, or as for a file of the name \"arrays\".")
      .def("add_pose", &addPose, py::arg("readings"), py::kw_only(), py::arg("covariances") = py::none(),
           py::arg("counts") = py::none(), py::arg("label") = "",
           py::arg("joint_angles") = std::map<std::string, double>(),
           "Adds a pose: `readings` (cells, 3) in the order of `cells`, as in from_arrays().")
      .def_property_readonly(
          "cells", [](const Session& self) { return numbersOf(self.neighbors(), &CellReport::id); },
          "(cells,): the cells' IDs.")
      .def_property_readonly("links", &linksOf,
                             "(links, 4): cell, port, cell, port; a port that the skin does not report is -1.")
      .def_property_readonly("readings", &readingsOf, "(poses, cells, 3), g; NaN where a cell has no reading.")
      .def_property_readonly("covariances", &covariancesOf,
                             "(poses, cells, 3, 3), g^2; NaN where a cell has no reading.")
      .def_property_readonly("counts", &countsOf, "(poses, cells); 0 where it is not known.")
      .def_property_readonly(
          "truth", &truthOf,
          "Of a simulated skin, or as from_arrays() was given it, where its cells are in truth: cells\n"
          "(N,), positions (N, 3), m, and rotations (N, 3, 3), from each cell's frame to the body's. None\n"
          "where it is not known.");
  explainMisfits(session, "from_arrays");
}

}  // namespace hexoderm::python
