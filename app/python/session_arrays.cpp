#include "app/python/session_arrays.h"

#include "app/python/bindings.h"
#include "app/python/given.h"
#include "app/python/skin_arrays.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/error.h"
#include "hexoderm/io/session_json.h"

#include <algorithm>
#include <map>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

constexpr const char* kArrays = "arrays";
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

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

void checkAsFile(const Session& session) { static_cast<void>(parseSessionJson(sessionToJson(session), kArrays)); }

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
