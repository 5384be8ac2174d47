#include "hexoderm/reconstruction/faults/attitude_search.h"

#include "hexoderm/reconstruction/joint/pose_swings.h"
#include "hexoderm/util/units.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <utility>

namespace hexoderm {
namespace {

/// The weight of the cell model's scatter of twist, bend and yaw against what a patch's links show, in links. The
/// model's twist and bend include the part's curvature, which the shape explains, so they say little about the rest.
constexpr std::array<double, 3> kWeightOfModel = {1, 1, 4};
/// Prior deviation of a patch's curvature, as the bend of one link.
constexpr double kCurvatureSigma = 30 * kDegree;
/// Variance of an angle of which nothing is known.
constexpr double kUnknownVariance = kPi * kPi / 3;
/// A free angle is a costlier explanation than none: the logarithm of how much narrower readings fix it.
constexpr double kCostOfAngle = 3;

/// Patches to one false alarm: of the yaw of links and cells, of cells that moved, and of everything else. A mould lets
/// nothing turn in the surface, so that yaw shows a sensor that is mounted otherwise best; bend and twist scatter as
/// the part is curved.
constexpr double kPatchesPerFalseYaw = 200;
constexpr double kPatchesPerFalseMotion = 200;
constexpr double kPatchesPerOtherAlarm = 2000;

/// The deviation that a standard normal deviate exceeds once in `times`.
double deviateExceededOnceIn(double times) {
  // Inverse of the tail by its asymptotic series, twice refined; within 0.01 from 100 on.
  double z = std::sqrt(2 * std::log(times));
  for (int k = 0; k < 5; ++k)
    z = std::sqrt(2 * std::log(times / (z * std::sqrt(2 * kPi))) - 2 * std::log1p(1 / (z * z)));
  return z;
}

/// What a chi-squared with two or three degrees of freedom exceeds once in `times`. Misfit::deviate() asks for more
/// than that so far out: for two degrees and once in 5,000 for 17.7 where it is 17.0.
double chiSquaredExceededOnceIn(double times, double degrees) {
  const auto tail = [degrees](double x) {
    const double of_two = std::exp(-x / 2);
    return degrees <= 2 ? of_two : std::erfc(std::sqrt(x / 2)) + std::sqrt(2 * x / kPi) * of_two;
  };
  double low = 0;
  double high = 1000;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    (tail(middle) > 1 / times ? low : high) = middle;
  }
  return high;
}

/// Rows of bend and twist of a link with the given heading for (S_xx, S_yy, S_xy, antisymmetric part).
Eigen::Vector4d bendRow(double heading) {
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  return {c * c, s * s, 2 * c * s, 0};
}
Eigen::Vector4d twistRow(double heading) {
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  return {c * s, -c * s, -(c * c - s * s), -1};
}

/// Turns about each axis alone that explain a misfit best, and their deviations: with few poses the errors of different
/// axes go together, and a turn about one of them is known better than each angle by itself.
struct Turns {
  Eigen::Vector3d angle;
  Eigen::Vector3d sigma;
};
Turns likeliestTurns(const Eigen::Vector3d& off, const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix3d information = covariance.inverse();
  const Eigen::Vector3d diagonal = information.diagonal();
  return {(information * off).cwiseQuotient(diagonal), diagonal.cwiseSqrt().cwiseInverse()};
}

double headingOf(const Port& port) { return std::atan2(port.vector_m.y(), port.vector_m.x()); }

constexpr double kHuberThreshold = 1.5;
double huberWeight(double deviations) {
  return std::abs(deviations) <= kHuberThreshold ? 1 : kHuberThreshold / std::abs(deviations);
}

/// A link as the readings show it, and how its angles (twist, bend, yaw) follow from the shape.
struct SeenLink {
  Eigen::Vector3d angles;
  Eigen::Vector3d variance;  ///< of the readings
  std::array<Eigen::Vector4d, 3> rows;
};

/// Expected square of a link's own scatter, given its angle, for scatter of the given variance. Deviations beyond the
/// Huber threshold count as the threshold, lest a broken link hide itself and others.
double scatterOf(const SeenLink& link, int axis, double scatter, const Eigen::Vector4d& shape,
                 const Eigen::Matrix4d& covariance_of_shape) {
  constexpr double kClippedSquare = 0.7785;  // mean of a squared normal deviate, clipped at 1.5
  const Eigen::Vector4d& row = link.rows.at(static_cast<std::size_t>(axis));
  const double whole = scatter + link.variance[axis];
  const double off = link.angles[axis] - row.dot(shape);
  const double clipped = std::min(off * off, kHuberThreshold * kHuberThreshold * whole) / kClippedSquare;
  if (!(whole > 0)) return 0;
  const double share = scatter / whole;
  return share * share * (clipped + row.dot(covariance_of_shape * row)) + share * link.variance[axis];
}

/// One pose's force and swing, by least squares over the cells that read it.
class SwingFit {
 public:
  void add(const Eigen::Vector3d& f_o, const Eigen::Vector3d& t_o) {
    count_ += 1;
    force_ += f_o;
    squares_ += f_o.squaredNorm();
    place_ += t_o;
    places_ += t_o * t_o.transpose();
    turning_ += t_o.cross(f_o);
  }

  /// Returns by how much that changes what a usual cell reads, g. Leaves `force` as it was where the cells agree on
  /// nothing.
  double find(PatchForce& force) const {
    constexpr double kLeastAgreed = 0.5;  // g, as a sum
    constexpr int kRounds = 4;
    if (count_ == 0 || force_.norm() <= kLeastAgreed) return 0;
    const Eigen::Vector3d mean = force_ / count_;
    const Eigen::Vector3d middle = place_ / count_;
    // f(t) = mean + swing x (t - middle), the swing with a usual tremor as its prior, and an error of every f whose
    // variance is what is left.
    const Eigen::Matrix3d about_middle = places_ - count_ * middle * middle.transpose();
    const Eigen::Matrix3d levers = about_middle.trace() * Eigen::Matrix3d::Identity() - about_middle;
    const Eigen::Vector3d turning = turning_ - middle.cross(force_);
    const double squares = squares_ - count_ * mean.squaredNorm();
    const PatchForce before = force;
    double left = squares;
    for (int round = 0; round < kRounds; ++round) {
      const double variance = std::max(kLeastVariance, left / (3 * count_));
      Eigen::Matrix3d information = levers;
      information.diagonal().array() += variance * std::pow(kStandardGravity / kTremorAcceleration_rad_s2, 2);
      force.swing_o = information.ldlt().solve(turning);
      left = squares + force.swing_o.dot(levers * force.swing_o - 2 * turning);
    }
    force.at_origin_o = mean.normalized() - force.swing_o.cross(middle);
    const Eigen::Vector3d turned = force.swing_o - before.swing_o;
    return (force.at_origin_o - before.at_origin_o + turned.cross(middle)).norm() +
           turned.norm() * std::sqrt(about_middle.trace() / count_);
  }

 private:
  static constexpr double kLeastVariance = 1e-12;  // g^2: without noise too the algebra is finite
  double count_ = 0;
  double squares_ = 0;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d places_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d turning_ = Eigen::Vector3d::Zero();
};

/// Anderson's acceleration of x = g(x): the next x is what the last few, each with its g, say together.
class Acceleration {
 public:
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& g) {
    constexpr std::size_t kMemory = 5;
    const Eigen::VectorXd off = g - x;
    if (last_off_.size() == off.size()) {
      g_changes_.push_back(g - last_g_);
      off_changes_.push_back(off - last_off_);
      if (g_changes_.size() > kMemory) {
        g_changes_.erase(g_changes_.begin());
        off_changes_.erase(off_changes_.begin());
      }
    }
    last_g_ = g;
    last_off_ = off;
    if (g_changes_.empty()) return g;
    const auto count = static_cast<Eigen::Index>(g_changes_.size());
    Eigen::MatrixXd changes(off.size(), count);
    for (Eigen::Index k = 0; k < count; ++k) changes.col(k) = off_changes_[static_cast<std::size_t>(k)];
    const Eigen::VectorXd shares = changes.colPivHouseholderQr().solve(off);
    Eigen::VectorXd next = g;
    for (Eigen::Index k = 0; k < count; ++k) next -= shares[k] * g_changes_[static_cast<std::size_t>(k)];
    return next;
  }

 private:
  Eigen::VectorXd last_g_;
  Eigen::VectorXd last_off_;
  std::vector<Eigen::VectorXd> g_changes_;
  std::vector<Eigen::VectorXd> off_changes_;
};

/// All forces in one column, swings as what they change over a tenth of a metre.
Eigen::VectorXd packed(std::span<const PatchForce> forces) {
  constexpr double kLever_m = 0.1;
  Eigen::VectorXd all(static_cast<Eigen::Index>(6 * forces.size()));
  for (std::size_t k = 0; k < forces.size(); ++k) {
    all.segment<6>(static_cast<Eigen::Index>(6 * k)) << forces[k].at_origin_o, kLever_m * forces[k].swing_o;
  }
  return all;
}
void unpack(const Eigen::VectorXd& all, std::span<PatchForce> forces) {
  constexpr double kLever_m = 0.1;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    forces[k].at_origin_o = all.segment<3>(static_cast<Eigen::Index>(6 * k));
    forces[k].swing_o = all.segment<3>(static_cast<Eigen::Index>(6 * k + 3)) / kLever_m;
  }
}

/// Up to kLanes cells side by side, for the kernel that finds their own attitudes.
class OwnAttitudeBatch {
 public:
  OwnAttitudeBatch(const AccelerometerPrior& prior, std::size_t poses, int most_steps)
      : options_(attitudeKernelOptions(prior)),
        poses_(poses),
        f_o_(3 * kLanes * poses, 0),
        y_g_(3 * kLanes * poses, 0),
        precision_(kLanes * poses, 0),
        R_start_(9 * kLanes, 0) {
    options_.most_steps = most_steps;
  }

  void put(std::size_t lane, std::span<const CellReading> readings, std::span<const Eigen::Vector3d> f_o,
           const Eigen::Matrix3d& R_start) {
    for (std::size_t pose = 0; pose < poses_; ++pose) precision_[kLanes * pose + lane] = 0;
    for (std::size_t k = 0; k < readings.size(); ++k) {
      const std::size_t pose = readings[k].pose;
      precision_[kLanes * pose + lane] = 1 / readings[k].variance_g2;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t at = kLanes * (3 * pose + axis) + lane;
        f_o_[at] = f_o[k][static_cast<Eigen::Index>(axis)];
        y_g_[at] = readings[k].y_g[static_cast<Eigen::Index>(axis)];
      }
    }
    for (std::size_t k = 0; k < 9; ++k) {
      R_start_[kLanes * k + lane] = R_start(static_cast<Eigen::Index>(k / 3), static_cast<Eigen::Index>(k % 3));
    }
  }

  /// Lanes that nothing was put into do again what they did before.
  void run() {
    const OwnAttitudeKernelInput in{static_cast<int>(poses_), f_o_.data(), y_g_.data(), precision_.data(),
                                    R_start_.data()};
    (hasFourLanes() ? findAttitudesByFour : findAttitudesByOne)(options_, in, out_);
  }

  /// Nothing for a cell that needs a more careful look.
  [[nodiscard]] std::optional<OwnAttitude> found(std::size_t lane) const {
    if (out_.usual[lane] == 0) return std::nullopt;
    const auto at = [lane](const double* values, std::size_t k) { return values[kLanes * k + lane]; };
    OwnAttitude own;
    for (std::size_t k = 0; k < 9; ++k) {
      const auto row = static_cast<Eigen::Index>(k / 3);
      const auto column = static_cast<Eigen::Index>(k % 3);
      own.R(row, column) = at(out_.R, k);
      own.gain(row, column) = at(out_.gain, k);
    }
    for (std::size_t k = 0; k < 3; ++k) own.offset_g[static_cast<Eigen::Index>(k)] = at(out_.offset_g, k);
    const auto information = [&](std::size_t k) { return at(out_.information, k); };
    own.information << information(0), information(1), information(2), information(1), information(3), information(4),
        information(2), information(4), information(5);
    return own;
  }

 private:
  AttitudeKernelOptions options_;
  std::size_t poses_;
  std::vector<double> f_o_;
  std::vector<double> y_g_;
  std::vector<double> precision_;
  std::vector<double> R_start_;
  OwnAttitudeKernelOutput out_{};
};

}  // namespace

AttitudeSearch::AttitudeSearch(const SkinLinks& skin, std::span<const std::size_t> cells,
                               std::vector<PatchForce> forces, std::span<const SE3> placements, bool forces_are_rough)
    : skin_(skin), cells_(cells.begin(), cells.end()), own_(cells_.size()), at_(cells_.size()) {
  constexpr int kMostSteps = 15;
  for (std::size_t place = 0; place < cells_.size(); ++place) own_[place].R_o_u = placements[place].R;
  takeReadings(forces);
  if (forces_are_rough) settle(forces, placements);
  findOwnAttitudes(forces, placements, kMostSteps);
  for (Own& own : own_) {
    if (own.known) own.covariance = own.information.inverse();
  }
  measuring_ = static_cast<double>(std::ranges::count_if(own_, &Own::known));
  findJoints();
  findLimits();
  sigma_ = {skin.model().twist_sigma_rad, skin.model().bend_sigma_rad, skin.model().yaw_sigma_rad};
}

std::size_t AttitudeSearch::placeOf(std::size_t cell) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(cells_, cell) - cells_.begin());
}

/// Forces and own attitudes in turn, until they agree.
void AttitudeSearch::settle(std::vector<PatchForce>& forces, std::span<const SE3> placements) {
  constexpr int kRounds = 60;
  constexpr int kSteps = 2;  // of each attitude; the next round goes on
  Acceleration acceleration;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::VectorXd before = packed(forces);
    findOwnAttitudes(forces, placements, kSteps);
    if (refine(forces, placements)) return;
    unpack(acceleration.next(before, packed(forces)), forces);
  }
}

void AttitudeSearch::takeReadings(std::span<const PatchForce> forces) {
  const Eigen::Matrix3d& R_u_a = skin_.model().accelerometer.T_u_a.R;
  for (const PatchForce& force : forces) poses_.push_back(force.pose);
  for (std::size_t place = 0; place < cells_.size(); ++place) {
    Own& own = own_[place];
    for (std::size_t k = 0; k < poses_.size(); ++k) {
      const GravityTable::Entry& entry = skin_.table().at(cells_[place], poses_[k]);
      if (entry.usable) own.readings.push_back({k, R_u_a.transpose() * entry.mean_g, entry.variance_g2});
    }
    own.f_o.resize(own.readings.size());
    own.known = !own.readings.empty();
  }
}

void AttitudeSearch::findOwnAttitudes(std::span<const PatchForce> forces, std::span<const SE3> placements,
                                      int most_steps) {
  const AccelerometerPrior prior(skin_.model().accelerometer);
  const Eigen::Matrix3d& R_u_a = skin_.model().accelerometer.T_u_a.R;
  OwnAttitudeBatch batch(prior, forces.size(), most_steps);
  std::vector<std::size_t> places;  // in the batch
  const auto run = [&] {
    batch.run();
    for (std::size_t lane = 0; lane < places.size(); ++lane) {
      Own& own = own_[places[lane]];
      const std::optional<OwnAttitude> found = batch.found(lane);
      setOwn(own, found ? *found : findAttitude(prior, own.readings, own.f_o, own.R_o_u * R_u_a));
    }
    places.clear();
  };
  for (std::size_t place = 0; place < cells_.size(); ++place) {
    Own& own = own_[place];
    if (!own.known) continue;
    for (std::size_t k = 0; k < own.readings.size(); ++k) {
      const PatchForce& force = forces[own.readings[k].pose];
      own.f_o[k] = force.at_origin_o + force.swing_o.cross(placements[place].t);
    }
    batch.put(places.size(), own.readings, own.f_o, own.R_o_u * R_u_a);
    places.push_back(place);
    if (places.size() == kLanes) run();
  }
  run();
}

void AttitudeSearch::setOwn(Own& own, const OwnAttitude& found) const {
  const Eigen::Matrix3d& R_u_a = skin_.model().accelerometer.T_u_a.R;
  own.R_o_u = found.R * R_u_a.transpose();
  own.information = R_u_a * (found.information + Eigen::Matrix3d::Identity() / kUnknownVariance) * R_u_a.transpose();
  own.offset_g = found.offset_g;
  own.gain = found.gain;
}

/// Every force as most cells, freed from the errors of their sensors, read it, and how it changes over the patch where
/// a hand swings it meanwhile. Returns whether that was known before.
bool AttitudeSearch::refine(std::vector<PatchForce>& forces, std::span<const SE3> placements) const {
  const Eigen::Matrix3d& R_u_a = skin_.model().accelerometer.T_u_a.R;
  std::vector<SwingFit> fits(forces.size());
  for (std::size_t place = 0; place < own_.size(); ++place) {
    const Own& own = own_[place];
    if (!own.known) continue;
    const Eigen::Matrix3d freed = own.R_o_u * R_u_a * own.gain.inverse();
    for (const CellReading& reading : own.readings) {
      fits[reading.pose].add(freed * (reading.y_g - own.offset_g), placements[place].t);
    }
  }
  constexpr double kSettled_g = 3e-4;  // far below what any attitude is known to
  double most_g = 0;
  for (std::size_t k = 0; k < forces.size(); ++k) most_g = std::max(most_g, fits[k].find(forces[k]));
  return most_g <= kSettled_g;
}

/// Headings of the cells' x axes in the sheet laid flat, from one of them.
std::vector<double> AttitudeSearch::headings() const {
  const SkinGraph& graph = skin_.graph();
  std::vector<std::optional<double>> heading(cells_.size());
  heading.front() = 0;
  std::deque<std::size_t> queue = {cells_.front()};
  while (!queue.empty()) {
    const std::size_t cell = queue.front();
    queue.pop_front();
    for (const std::size_t k : graph.linksAt(cell)) {
      const GraphLink& link = graph.links()[k];
      if (link.muted() || heading[placeOf(link.other(cell))]) continue;
      const double yaw = headingOf(skin_.sourcePort(link)) + kPi - headingOf(skin_.targetPort(link));
      heading[placeOf(link.other(cell))] = *heading[placeOf(cell)] + (link.source == cell ? yaw : -yaw);
      queue.push_back(link.other(cell));
    }
  }
  std::vector<double> all;
  for (const std::optional<double>& of_cell : heading) all.push_back(of_cell.value_or(0));
  return all;
}

void AttitudeSearch::findJoints() {
  const SkinGraph& graph = skin_.graph();
  const std::vector<double> heading = headings();
  for (std::size_t place = 0; place < cells_.size(); ++place) {
    for (const std::size_t k : graph.linksAt(cells_[place])) {
      const GraphLink& link = graph.links()[k];
      if (link.muted() || link.source != cells_[place]) continue;
      Joint joint;
      joint.link = k;
      joint.source = place;
      joint.target = placeOf(link.target);
      joint.R_nom = nominalAlignment(skin_.sourcePort(link), skin_.targetPort(link));
      const Eigen::Vector3d u = skin_.sourcePort(link).vector_m.normalized();
      joint.axes << u, Eigen::Vector3d::UnitZ().cross(u), Eigen::Vector3d::UnitZ();
      const double heading_rad = heading[place] + headingOf(skin_.sourcePort(link));
      joint.twist_row = twistRow(heading_rad);
      joint.bend_row = bendRow(heading_rad);
      at_[joint.source].push_back(joints_.size());
      at_[joint.target].push_back(joints_.size());
      joints_.push_back(joint);
    }
  }
}

bool AttitudeSearch::tested(const Joint& joint) const {
  return joint.open && own_[joint.source].known && own_[joint.target].known;
}

/// Twist, bend and yaw.
Eigen::Vector3d AttitudeSearch::anglesOf(const Joint& joint, const Own& source, const Own& target) const {
  return joint.axes.transpose() * logSO3(source.R_o_u.transpose() * target.R_o_u * joint.R_nom.transpose());
}

/// Covariance that the readings leave in a link's angles.
Eigen::Matrix3d AttitudeSearch::measured(const Joint& joint, const Own& source, const Own& target) const {
  const Eigen::Matrix3d R_c_n = source.R_o_u.transpose() * target.R_o_u;
  return joint.axes.transpose() * (source.covariance + R_c_n * target.covariance * R_c_n.transpose()) * joint.axes;
}

void AttitudeSearch::expect(const Shape& shape) {
  for (Joint& joint : joints_) {
    joint.expected = {joint.twist_row.dot(shape.parameters), joint.bend_row.dot(shape.parameters), 0};
    joint.R_c_n = expSO3(joint.axes * joint.expected) * joint.R_nom;
  }
}

Eigen::Matrix3d AttitudeSearch::scatter() const { return sigma_.cwiseAbs2().asDiagonal(); }

double AttitudeSearch::squaredMisfit(const Joint& joint, const Own& source, const Own& target) const {
  const Eigen::Vector3d off = anglesOf(joint, source, target) - joint.expected;
  const Eigen::Matrix3d covariance = scatter() + measured(joint, source, target);
  return off.dot(covariance.ldlt().solve(off));
}

/// The shape operator that fits most links, and the scatter about it.
///
/// The scatter's variance is found by expectation maximisation: of each link's deviation from the shape, that part
/// counts as scatter which the errors of the readings and of the shape itself don't explain. A link that the readings
/// show poorly says little about it in this way, and leaves it to the model.
AttitudeSearch::Shape AttitudeSearch::fitShape(bool with_antisymmetric) {
  constexpr int kRounds = 30;
  constexpr double kSettled_rad = 1e-6;  // far below any scatter
  const CellModel& model = skin_.model();
  const Eigen::Vector3d model_sigma(model.twist_sigma_rad, model.bend_sigma_rad, model.yaw_sigma_rad);
  sigma_ = model_sigma;
  Shape shape;
  std::vector<SeenLink> links;
  for (const Joint& joint : joints_) {
    if (!tested(joint)) continue;
    const Own& source = own_[joint.source];
    const Own& target = own_[joint.target];
    links.push_back({anglesOf(joint, source, target),
                     measured(joint, source, target).diagonal(),
                     {joint.twist_row, joint.bend_row, Eigen::Vector4d::Zero()}});
  }
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Identity() / (kCurvatureSigma * kCurvatureSigma);
    if (!with_antisymmetric) normal(3, 3) = 1e12;
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const SeenLink& link : links) {
      for (const int axis : {0, 1}) {
        const Eigen::Vector4d& row = link.rows.at(static_cast<std::size_t>(axis));
        const double variance = sigma_[axis] * sigma_[axis] + link.variance[axis];
        const double off = link.angles[axis] - row.dot(shape.parameters);
        const double weight = (round == 0 ? 1 : huberWeight(off / std::sqrt(variance))) / variance;
        normal += weight * row * row.transpose();
        right += weight * link.angles[axis] * row;
      }
    }
    const Eigen::LDLT<Eigen::Matrix4d> factor(normal);
    const Eigen::Vector4d parameters_before = std::exchange(shape.parameters, factor.solve(right));
    const Eigen::Vector3d sigma_before = sigma_;
    const Eigen::Matrix4d covariance = factor.solve(Eigen::Matrix4d::Identity());
    shape.antisymmetric_sigma = std::sqrt(covariance(3, 3));
    for (int axis = 0; axis < 3; ++axis) {
      const double before = sigma_[axis] * sigma_[axis];
      const double weight_of_model = kWeightOfModel.at(static_cast<std::size_t>(axis));
      double sum = weight_of_model * model_sigma[axis] * model_sigma[axis];
      for (const SeenLink& link : links) sum += scatterOf(link, axis, before, shape.parameters, covariance);
      const double after = sum / (weight_of_model + static_cast<double>(links.size()));
      sigma_[axis] = axis == 2 ? std::max(model_sigma[axis], std::sqrt(after)) : std::sqrt(after);
    }
    if ((shape.parameters - parameters_before).norm() + (sigma_ - sigma_before).norm() < kSettled_rad) break;
  }
  return shape;
}

/// A surface's normal turns towards the way that it bends: links twist one way along one direction as much as they
/// twist the other way across it. A twist that is the same in all directions belongs to no surface.
std::optional<AttitudeSuspect> AttitudeSearch::judgePatch() {
  constexpr double kLimit = 5;
  constexpr double kLeast = 4 * kDegree;
  const Shape shape = fitShape(true);
  if (shape.antisymmetric_sigma <= 0) return std::nullopt;
  const double deviate = std::abs(shape.parameters.w()) / shape.antisymmetric_sigma;
  if (deviate < strictness() * kLimit || std::abs(shape.parameters.w()) < kLeast) return std::nullopt;
  AttitudeSuspect suspect{AttitudeSuspect::Kind::Patch};
  suspect.angle_rad = std::abs(shape.parameters.w());
  return suspect;
}

Eigen::Matrix3d AttitudeSearch::Belief::covariance() const {
  return (information + Eigen::Matrix3d::Identity() / kUnknownVariance).inverse();
}

void AttitudeSearch::Belief::operator+=(const Belief& other) {
  information += other.information;
  weighted += other.weighted;
}

AttitudeSearch::Belief AttitudeSearch::ownBelief(std::size_t place) const {
  Belief own;
  if (own_[place].known) own.information = own_[place].information;
  return own;
}

/// What all links of a cell but one say about it.
AttitudeSearch::Belief AttitudeSearch::beliefBeside(std::size_t place, const Joint* but) const {
  Belief belief;
  for (const std::size_t k : at_[place]) {
    const Joint& joint = joints_[k];
    if (!joint.open || &joint == but) continue;
    belief += joint.source == place ? joint.to_source : joint.to_target;
  }
  return belief;
}

/// What the far side of a link says about the cell at the near one.
AttitudeSearch::Belief AttitudeSearch::along(const Joint& joint, bool to_source) const {
  const std::size_t near = to_source ? joint.source : joint.target;
  const std::size_t far = to_source ? joint.target : joint.source;
  Belief of_far = ownBelief(far);
  of_far += beliefBeside(far, &joint);
  const Eigen::Matrix3d covariance_far = of_far.covariance();
  const Eigen::Matrix3d& R_c_n = joint.R_c_n;
  const Eigen::Matrix3d R_far_near = to_source ? Eigen::Matrix3d(R_c_n.transpose()) : R_c_n;
  const Eigen::Matrix3d elastomer = joint.axes * scatter() * joint.axes.transpose();
  const Eigen::Matrix3d of_link = to_source ? elastomer : Eigen::Matrix3d(R_c_n.transpose() * elastomer * R_c_n);
  const Eigen::Vector3d mean = logSO3(own_[near].R_o_u.transpose() * own_[far].R_o_u * R_far_near) +
                               R_far_near.transpose() * covariance_far * of_far.weighted;
  Belief belief;
  belief.information = (of_link + R_far_near.transpose() * covariance_far * R_far_near).inverse();
  belief.weighted = belief.information * mean;
  return belief;
}

void AttitudeSearch::passBeliefs() {
  // Round a loop what a cell says would come back to it as another's word.
  const bool has_loops = joints_.size() >= cells_.size();
  const int reach = has_loops ? 1 : 4;  // links
  for (Joint& joint : joints_) joint.to_source = joint.to_target = Belief{};
  for (int k = 0; k < reach; ++k) {
    std::vector<std::pair<Belief, Belief>> next;
    for (const Joint& joint : joints_) next.emplace_back(along(joint, true), along(joint, false));
    for (std::size_t link = 0; link < joints_.size(); ++link) {
      joints_[link].to_source = next[link].first;
      joints_[link].to_target = next[link].second;
    }
  }
}

/// The options' misfit stands for all limits here: 1 for its default.
double AttitudeSearch::strictness() const { return skin_.options().max_misfit / SolverOptions{}.max_misfit; }

/// The angle of a link that is furthest beyond its limit.
std::optional<AttitudeSuspect> AttitudeSearch::judgeLink(const Joint& joint) const {
  constexpr std::array kCodes = {FindingCode::ImplausibleTwist, FindingCode::ImplausibleBend,
                                 FindingCode::ImplausibleYaw};
  // Both cells as all but this link have them.
  const auto withoutThis = [&](std::size_t place) {
    Belief belief = ownBelief(place);
    belief += beliefBeside(place, &joint);
    Own all;
    all.covariance = belief.covariance();
    all.R_o_u = own_[place].R_o_u * expSO3(all.covariance * belief.weighted);
    return all;
  };
  const Own source = withoutThis(joint.source);
  const Own target = withoutThis(joint.target);
  const Eigen::Vector3d& expected = joint.expected;
  const Turns turns =
      likeliestTurns(anglesOf(joint, source, target) - expected, scatter() + measured(joint, source, target));
  const Eigen::Vector3d limits = turns.sigma.cwiseProduct(Eigen::Vector3d(other_limit_, other_limit_, yaw_limit_));
  Eigen::Index worst = 0;
  if (turns.angle.cwiseQuotient(limits).cwiseAbs().maxCoeff(&worst) <= 1) return std::nullopt;
  AttitudeSuspect suspect{AttitudeSuspect::Kind::Link};
  suspect.link = joint.link;
  suspect.angle = kCodes.at(static_cast<std::size_t>(worst));
  suspect.angle_rad = expected[worst] + turns.angle[worst];
  suspect.lowest_rad = expected[worst] - limits[worst];
  suspect.highest_rad = expected[worst] + limits[worst];
  suspect.evidence = squaredMisfit(joint, source, target) / 2 - kCostOfAngle * 3;
  return suspect;
}

/// What the covariance of a cell by its links lacks: half of each link's scatter is how askew this very cell sits in
/// the mould, which is the same for all of them and does not average out.
Eigen::Matrix3d AttitudeSearch::ownScatter(std::size_t place) const {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  double links = 0;
  for (const std::size_t k : at_[place]) {
    const Joint& joint = joints_[k];
    if (!tested(joint)) continue;
    Eigen::Matrix3d axes = joint.axes;
    if (joint.target == place) axes = (joint.R_nom.transpose() * axes).eval();
    sum += axes * scatter() * axes.transpose();
    ++links;
  }
  return links == 0 ? sum : Eigen::Matrix3d((1 - 1 / links) / 2 * sum / links);
}

/// A cell whose own attitude is not what all its links say together. Nothing for one with fewer than two links to say
/// so.
std::optional<AttitudeSuspect> AttitudeSearch::judgeCell(std::size_t place) const {
  const auto witnesses = std::ranges::count_if(at_[place], [&](std::size_t k) { return tested(joints_[k]); });
  if (witnesses < 2) return std::nullopt;
  const Belief links = beliefBeside(place, nullptr);
  const Eigen::Matrix3d of_links = links.covariance();
  const Eigen::Vector3d turn = of_links * links.weighted;
  const Eigen::Matrix3d covariance = of_links + ownScatter(place) + own_[place].covariance;
  const double squared = turn.dot(covariance.ldlt().solve(turn));
  const bool is_turned = Misfit{squared, 3}.deviate() > other_limit_;
  const Turns turns = likeliestTurns(turn, covariance);
  const bool is_yawed = std::abs(turns.angle.z()) > yaw_limit_ * turns.sigma.z();
  if (!is_turned && !is_yawed) return std::nullopt;
  AttitudeSuspect suspect{AttitudeSuspect::Kind::Cell};
  suspect.cell = cells_[place];
  suspect.angle_rad = turn.norm();
  suspect.evidence = squared / 2 - kCostOfAngle * 3;
  return suspect;
}

/// A cell whose readings before and after a pose belong to two attitudes.
std::optional<AttitudeSuspect> AttitudeSearch::judgeMotion(std::size_t place) const {
  constexpr double kLeastTurn = 2 * kDegree;  // what a cell does in a soft mould
  const Own& own = own_[place];
  if (own.readings.size() < 2) return std::nullopt;
  const Eigen::Matrix3d& R_u_a = skin_.model().accelerometer.T_u_a.R;
  std::vector<Eigen::Vector3d> v_g;
  for (const Eigen::Vector3d& f_o : own.f_o) v_g.emplace_back(R_u_a.transpose() * own.R_o_u.transpose() * f_o);
  const Belief links = beliefBeside(place, nullptr);
  const Eigen::Matrix3d of_links = links.covariance();
  const Eigen::Matrix3d information = (of_links + ownScatter(place)).inverse();
  const AttitudePrior attitude{R_u_a.transpose() * information * R_u_a,
                               R_u_a.transpose() * information * of_links * links.weighted};
  TurnBetweenPoses turn = findTurn(AccelerometerPrior(skin_.model().accelerometer), own.readings, v_g, attitude);
  // The forces are what all cells agree on, and the cell's own share in them hides as much of its turn.
  turn.gain.chi_squared *= measuring_ / std::max(1.0, measuring_ - 1);
  const auto tests = static_cast<double>(cells_.size() * (own.readings.size() - 1));
  const double limit =
      strictness() * strictness() * chiSquaredExceededOnceIn(kPatchesPerFalseMotion * tests, turn.gain.degrees);
  if (!(turn.angle_rad >= kLeastTurn && turn.gain.chi_squared > limit)) return std::nullopt;
  AttitudeSuspect suspect{AttitudeSuspect::Kind::Moved};
  suspect.cell = cells_[place];
  suspect.angle_rad = turn.angle_rad;
  suspect.pose = poses_[own.readings[turn.first_after].pose];
  suspect.evidence = turn.gain.chi_squared / 2 - kCostOfAngle * turn.gain.degrees;
  return suspect;
}

/// Squared misfit of the own attitudes of two neighbours, together, with what all their links say. `source`, `target`:
/// whose readings count at the ends of the link.
double AttitudeSearch::pairMisfit(const Joint& joint, const Own& source, const Own& target) const {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  // The errors (e_source, e_target) of both attitudes as the links have them.
  Matrix6 information = Matrix6::Identity() / kUnknownVariance;
  Vector6 weighted = Vector6::Zero();
  const auto addBeside = [&](std::size_t place, const Own& own, Eigen::Index at) {
    const Belief beside = beliefBeside(place, &joint);
    const Eigen::Matrix3d R_believed = own_[place].R_o_u * expSO3(beside.covariance() * beside.weighted);
    information.block<3, 3>(at, at) += beside.information;
    weighted.segment<3>(at) += beside.information * logSO3(own.R_o_u.transpose() * R_believed);
  };
  addBeside(joint.source, source, 0);
  addBeside(joint.target, target, 3);
  const Eigen::Matrix3d& R_c_n = joint.R_c_n;
  const Eigen::Vector3d off = logSO3(source.R_o_u.transpose() * target.R_o_u * R_c_n.transpose());
  Eigen::Matrix<double, 3, 6> J;  // of the link's angle, off - e_source + R_c_n e_target
  J << -Eigen::Matrix3d::Identity(), R_c_n;
  const Eigen::Matrix3d precision = joint.axes * scatter().inverse() * joint.axes.transpose();
  information += J.transpose() * precision * J;
  weighted -= J.transpose() * precision * off;

  Matrix6 covariance = information.inverse();
  const Vector6 mean = covariance * weighted;
  covariance.topLeftCorner<3, 3>() += source.covariance;
  covariance.bottomRightCorner<3, 3>() += target.covariance;
  return mean.dot(covariance.ldlt().solve(mean));
}

/// No less than pairMisfit() of the cells' own readings: what it would be if the links' errors were none.
double AttitudeSearch::mostPairMisfit(const Joint& joint) const {
  const auto beside = [&](std::size_t place) {
    const Belief belief = beliefBeside(place, &joint);
    const Eigen::Vector3d turn = belief.covariance() * belief.weighted;
    return turn.dot(belief.information * turn);
  };
  const Own& source = own_[joint.source];
  const Own& target = own_[joint.target];
  const Eigen::Matrix3d& R_c_n = joint.R_c_n;
  const Eigen::Vector3d off = logSO3(source.R_o_u.transpose() * target.R_o_u * R_c_n.transpose());
  const Eigen::Vector3d deviations = (joint.axes.transpose() * off).cwiseQuotient(sigma_);
  return deviations.squaredNorm() + beside(joint.source) + beside(joint.target);
}

/// By how much two neighbours fit their links better with each other's readings: the logarithm of the likelihood ratio.
/// Nothing if that can't be more than `limit`.
std::optional<double> AttitudeSearch::gainOfSwap(const Joint& joint, double limit) const {
  // With each other's readings the misfit is 0 at least.
  if (mostPairMisfit(joint) <= 2 * limit) return std::nullopt;
  const Own& source = own_[joint.source];
  const Own& target = own_[joint.target];
  const double as_it_is = pairMisfit(joint, source, target);
  if (as_it_is <= 2 * limit) return std::nullopt;
  const double gain = (as_it_is - pairMisfit(joint, target, source)) / 2;
  return gain > limit ? std::optional(gain) : std::nullopt;
}

void AttitudeSearch::findLimits() {
  const auto joints = static_cast<double>(joints_.size());
  const auto cells = static_cast<double>(cells_.size());
  yaw_limit_ = strictness() * deviateExceededOnceIn(2 * kPatchesPerFalseYaw * (joints + cells));
  other_limit_ = strictness() * deviateExceededOnceIn(2 * kPatchesPerOtherAlarm * (2 * joints + cells));
}

std::vector<AttitudeSuspect> AttitudeSearch::candidates() {
  passBeliefs();
  const double swap_limit =
      strictness() * strictness() * std::log(kPatchesPerOtherAlarm * static_cast<double>(joints_.size()));
  std::vector<AttitudeSuspect> found;
  for (const Joint& joint : joints_) {
    if (!tested(joint)) continue;
    if (const auto suspect = judgeLink(joint)) found.push_back(*suspect);
    if (const std::optional<double> gain = gainOfSwap(joint, swap_limit)) {
      AttitudeSuspect suspect{AttitudeSuspect::Kind::Swapped};
      suspect.cell = cells_[joint.source];
      suspect.other = cells_[joint.target];
      suspect.evidence = *gain;
      found.push_back(suspect);
    }
  }
  for (std::size_t place = 0; place < cells_.size(); ++place) {
    if (!own_[place].known) continue;
    if (const auto suspect = judgeCell(place)) found.push_back(*suspect);
    if (const auto suspect = judgeMotion(place)) found.push_back(*suspect);
  }
  std::ranges::sort(found, std::greater<>(), &AttitudeSuspect::evidence);
  return found;
}

std::vector<std::size_t> AttitudeSearch::placesOf(const AttitudeSuspect& suspect) const {
  if (suspect.kind == AttitudeSuspect::Kind::Cell || suspect.kind == AttitudeSuspect::Kind::Moved)
    return {placeOf(suspect.cell)};
  if (suspect.kind == AttitudeSuspect::Kind::Swapped) return {placeOf(suspect.cell), placeOf(suspect.other)};
  const GraphLink& link = skin_.graph().links()[suspect.link];
  return {placeOf(link.source), placeOf(link.target)};
}

void AttitudeSearch::explain(const AttitudeSuspect& suspect) {
  switch (suspect.kind) {
    case AttitudeSuspect::Kind::Link:
      for (Joint& joint : joints_) joint.open = joint.open && joint.link != suspect.link;
      break;
    case AttitudeSuspect::Kind::Swapped:
      std::swap(own_[placeOf(suspect.cell)], own_[placeOf(suspect.other)]);
      break;
    case AttitudeSuspect::Kind::Cell:
    case AttitudeSuspect::Kind::Moved:
      own_[placeOf(suspect.cell)].known = false;
      break;
    case AttitudeSuspect::Kind::Patch:
      break;
  }
}

namespace {

/// Both say the same of the same cells or of the same link.
bool isOfTheSame(const AttitudeSuspect& a, const AttitudeSuspect& b) {
  return a.kind == b.kind && a.cell == b.cell && a.other == b.other && a.link == b.link;
}

}  // namespace

std::vector<AttitudeSuspect> AttitudeSearch::suspects() {
  if (std::ranges::none_of(joints_, [this](const Joint& joint) { return tested(joint); })) return {};
  if (const auto patch = judgePatch()) return {*patch};
  expect(fitShape(false));
  std::vector<AttitudeSuspect> named;
  for (;;) {
    // What is beside a clearer fault may be its work and waits for the next round.
    std::vector<bool> waits(own_.size(), false);
    const std::size_t before = named.size();
    for (const AttitudeSuspect& suspect : candidates()) {
      const std::vector<std::size_t> places = placesOf(suspect);
      if (std::ranges::any_of(places, [&](std::size_t place) { return waits[place]; })) continue;
      // With absurd sigmas a swap can seem to gain both ways.
      if (std::ranges::any_of(named, [&](const AttitudeSuspect& other) { return isOfTheSame(other, suspect); }))
        continue;
      for (const std::size_t place : places) {
        waits[place] = true;
        for (const std::size_t k : at_[place]) waits[joints_[k].source] = waits[joints_[k].target] = true;
      }
      named.push_back(suspect);
      explain(suspect);
    }
    if (named.size() == before) return named;
  }
}

}  // namespace hexoderm
