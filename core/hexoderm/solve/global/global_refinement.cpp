#include "hexoderm/solve/global/global_refinement.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/median.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/global/elimination_plan.h"
#include "hexoderm/solve/global/patch_evidence.h"
#include "hexoderm/solve/global/shape_covariance.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::size_t kCellsOfLargePart = 100;
// Angular accelerations are unknowns of the joint equations up to so many poses; and of many cells, far from the
// middle, up to so many multiplications a step. Of more, whose columns would make these too large, they are found in
// turn with the rest (MotionCompensatedReadings), which is a little less exact.
constexpr std::size_t kFewPoses = 50;
constexpr std::size_t kFewCellsPerPose = 12;
constexpr double kMaxWorkForAccelerations = 3e9;
// Error that a hand's translation leaves in a mean. The hand is far from the middle of a large patch, and near that of
// one of several patches at most: its turning, by a usual tremor's angular acceleration, acts at arms of 0.15 m.
constexpr double kForceSigma_g = 0.003;
constexpr double kForceSigmaFarFromHand_g = 0.01;

/// About how many multiplications a step of the solver takes: twelve errors of a sensor and six unknowns of a cell take
/// their products from the dense border, which is then factorised; the sparse part is small beside it.
double workOfStep(const GlobalProblem& problem) {
  const auto border = static_cast<double>(BorderLayout(problem).size());
  const auto cells = static_cast<double>(problem.cellCount());
  return 9 * cells * border * border + border * border * border / 6;
}

/// The covariance of any two cells from that of the whole patch.
class SolvedCovariance : public PlacementCovariance {
 public:
  SolvedCovariance(std::vector<CellId> ids, std::vector<SE3> cells, std::shared_ptr<const GlobalCovariance> covariance)
      : ids_(std::move(ids)), cells_(std::move(cells)), covariance_(std::move(covariance)) {}

  [[nodiscard]] Matrix6d relative(CellId a, CellId b) const override {
    const std::size_t at_a = indexOf(a);
    const std::size_t at_b = indexOf(b);
    if (at_a == at_b) return Matrix6d::Zero();
    const SE3 T_a_b = cells_[at_a].inverse() * cells_[at_b];
    // Errors (t, r) of both in the patch: t_a_b moves by R_a^T (t_b - t_a) + [t_a_b]x r_a, and R_a_b's right error is
    // r_b - R_a_b^T r_a.
    const Eigen::Matrix3d R_a_o = cells_[at_a].R.transpose();
    Matrix6d A = Matrix6d::Zero();
    A.topLeftCorner<3, 3>() = -R_a_o;
    A.topRightCorner<3, 3>() = skew(T_a_b.t);
    A.bottomRightCorner<3, 3>() = -T_a_b.R.transpose();
    Matrix6d B = Matrix6d::Zero();
    B.topLeftCorner<3, 3>() = R_a_o;
    B.bottomRightCorner<3, 3>().setIdentity();
    const Matrix6d mixed = A * covariance_->between(at_a, at_b) * B.transpose();
    return A * covariance_->cell(at_a) * A.transpose() + B * covariance_->cell(at_b) * B.transpose() + mixed +
           mixed.transpose();
  }

  [[nodiscard]] Matrix6d together(CellId a, CellId b) const override {
    const std::size_t at_a = indexOf(a);
    const std::size_t at_b = indexOf(b);
    return at_a == at_b ? covariance_->cell(at_a) : covariance_->between(at_a, at_b);
  }

 private:
  [[nodiscard]] std::size_t indexOf(CellId id) const {
    const auto found = std::ranges::lower_bound(ids_, id);
    if (found == ids_.end() || *found != id) throw InvalidArgument("cell " + toString(id) + " is not in this patch");
    return static_cast<std::size_t>(found - ids_.begin());
  }

  std::vector<CellId> ids_;  // ascending
  std::vector<SE3> cells_;
  std::shared_ptr<const GlobalCovariance> covariance_;
};

/// The covariance of the forces of any two poses from that of the whole patch.
class SolvedGravityCovariance : public GravityCovariance {
 public:
  using Solve = std::function<std::shared_ptr<const GlobalCovariance>()>;
  /// `solve_without_tremor`: empty where that is not known.
  SolvedGravityCovariance(std::shared_ptr<const GlobalCovariance> covariance, bool accelerations,
                          Solve solve_without_tremor)
      : covariance_(std::move(covariance)),
        accelerations_(accelerations),
        solve_without_tremor_(std::move(solve_without_tremor)) {}

  [[nodiscard]] Eigen::Matrix3d forces(std::size_t a, std::size_t b) const override {
    return covariance_->forces(a, b);
  }
  [[nodiscard]] std::optional<Eigen::Matrix3d> swing(std::size_t pose) const override {
    if (!accelerations_) return std::nullopt;
    return covariance_->acceleration(pose) / (kStandardGravity * kStandardGravity);
  }
  [[nodiscard]] std::shared_ptr<const GravityCovariance> withoutTremor() const override {
    if (!solve_without_tremor_) return nullptr;
    std::call_once(solved_once_, [this] {
      without_tremor_ = std::make_shared<SolvedGravityCovariance>(solve_without_tremor_(), accelerations_, Solve());
    });
    return without_tremor_;
  }

 private:
  std::shared_ptr<const GlobalCovariance> covariance_;
  bool accelerations_;
  Solve solve_without_tremor_;
  mutable std::once_flag solved_once_;
  mutable std::shared_ptr<const GravityCovariance> without_tremor_;
};

/// Lives with a model of its own: what is asked of a result's covariances later needs both, when the skin may be gone.
std::shared_ptr<GlobalProblem> problemOf(const CellModel& model) {
  struct Owned {
    CellModel model;
    GlobalProblem problem;
  };
  const auto owned = std::make_shared<Owned>(Owned{model, {}});
  owned->problem.model = &owned->model;
  return {owned, &owned->problem};
}

}  // namespace

GlobalRefinement::GlobalRefinement(const CellModel& model, const SkinGraph& graph, const GravityTable& table,
                                   const SolverOptions& options, const std::vector<std::size_t>& cells,
                                   std::size_t origin, std::vector<SE3> placements)
    : cells_(cells), problem_(problemOf(model)), solver_(std::make_unique<GlobalSolver>()) {
  problem_->gap = gapShareOf(options.gap_model);
  problem_->link_sigma_m = model.link_sigma_m;
  GlobalState& state = solution_.state;
  state.cells = std::move(placements);
  for (const SE3& placement : state.cells) state.middle_o += placement.t / static_cast<double>(cells_.size());
  problem_->origin = localOf(origin);
  state.gap_share = problem_->gap.mean;

  problem_->readings.resize(cells_.size());
  noise_.resize(cells_.size());
  const Eigen::Matrix3d R_a_u = model.accelerometer.T_u_a.R.transpose();
  for (const std::size_t pose : table.enabledPoses()) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    bool any = false;
    for (std::size_t local = 0; local < cells_.size(); ++local) {
      const std::size_t cell = cells_[local];
      const GravityTable::Entry& entry = table.at(cell, pose);
      if (!entry.usable) continue;
      problem_->readings[local].push_back({poses_.size(), R_a_u * entry.mean_g, entry.variance_g2});
      noise_[local].push_back({entry.variance_g2, entry.own_variance_g2});
      sum += state.cells[local].R * entry.mean_g.normalized();
      any = true;
    }
    if (!any) continue;
    poses_.push_back(pose);
    state.force_o.push_back(sum.norm() > 1e-6 ? Eigen::Vector3d(sum.normalized()) : Eigen::Vector3d(0, 0, 1));
    state.acceleration_o.push_back(Eigen::Vector3d::Zero());
  }
  problem_->poses = poses_.size();
  const bool large = cells_.size() >= kCellsOfLargePart;
  const bool several = graph.patches().size() > 1;
  problem_->force_sigma_g = large || several ? kForceSigmaFarFromHand_g : kForceSigma_g;

  for (const std::size_t cell : cells_) {
    for (const std::size_t k : graph.linksAt(cell)) {
      if (!graph.links()[k].muted() && graph.links()[k].source == cell) links_.push_back(k);
    }
  }
  std::ranges::sort(links_);
  for (const std::size_t k : links_) {
    const GraphLink& link = graph.links()[k];
    const Port& source = model.port(link.source_port);
    const Port& target = model.port(link.target_port);
    problem_->links.push_back({localOf(link.source), localOf(link.target), source.vector_m, target.vector_m,
                               nominalAlignment(source, target)});
  }
  problem_->elimination = planElimination(*problem_);
  problem_->accelerations = cells_.size() > 1;
  const bool narrow = kFewCellsPerPose * poses_.size() <= cells_.size();
  if (poses_.size() > kFewPoses && !(narrow && workOfStep(*problem_) <= kMaxWorkForAccelerations)) {
    problem_->accelerations = false;
  }
  problem_->acceleration_sigma = kTremorAcceleration_rad_s2;
}

std::size_t GlobalRefinement::localOf(std::size_t cell) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(cells_, cell) - cells_.begin());
}

void GlobalRefinement::solve(const std::stop_token& stop) {
  shape_.clear();
  problem_->with_mounting = false;
  solveWithMotionCompensatedReadings(stop);
  if (!stop.stop_requested() && problem_->model->mounting_sigma_rad > 0) {
    problem_->with_mounting = true;
    solution_.covariance.reset();  // its factor's memory serves the next
    solution_.covariance = solver_->covarianceAt(*problem_, solution_.state);
  }
  solver_->releaseWorkspace();  // there may be many patches
}

void GlobalRefinement::solveWithMotionCompensatedReadings(const std::stop_token& stop) {
  GlobalSolverOptions options;
  options.stop = stop;
  solveWithSpreads(options);
  if (stop.stop_requested()) return;
  fitSensors();
  if (problem_->accelerations || cells_.size() < 2) return;
  if (!motion_compensated_readings_) motion_compensated_readings_.emplace(*problem_);
  const auto solveAgain = [&] {
    solveWithSpreads(options);
    if (!stop.stop_requested()) fitSensors();
    return !stop.stop_requested();
  };
  constexpr int kTurns = 6;
  for (int turn = 0; turn < kTurns; ++turn) {
    if (!motion_compensated_readings_->followAngularAccelerations(*problem_, solution_.state, sensors_)) break;
    if (!solveAgain()) return;
  }
  if (motion_compensated_readings_->widenNoise(*problem_, solution_.state, sensors_)) solveAgain();
}

/// Solves with the spread of the links and of the angular accelerations that the data themselves show, weighed against
/// what is known beforehand.
void GlobalRefinement::solveWithSpreads(const GlobalSolverOptions& options) {
  constexpr int kRounds = 3;
  constexpr double kSettled = 0.05;
  constexpr double kSettledNoise = 0.5;
  for (int round = 0;; ++round) {
    solution_.covariance.reset();  // of the round before: its factor's memory serves the next
    solution_ = solver_->solve(*problem_, solution_.state, options);
    if (round == kRounds || solution_.termination == GlobalTermination::Stopped) return;
    const double link_sigma_m = seenLinkSpread_m();
    const double acceleration_sigma = seenAccelerations_rad_s2();
    const double noise_share = seenNoise();
    const auto settled = [](double now, double next) {
      return std::abs(next * next - now * now) < kSettled * now * now;
    };
    if (settled(problem_->link_sigma_m, link_sigma_m) && settled(problem_->acceleration_sigma, acceleration_sigma) &&
        noise_share > kSettledNoise * noise_share_) {
      return;
    }
    takeNoise(noise_share);
    problem_->link_sigma_m = link_sigma_m;
    problem_->acceleration_sigma = acceleration_sigma;
  }
}

/// In closed loops, the end points of links show whether this mould keeps them together as well as the model says:
/// strongly curved surfaces do not. The estimate weighs that against the model, as if the model had been seen on so
/// many axes. It never goes below the model: cells that sit askew in the mould err alike on all their links, which
/// neighbouring loops don't show and distant cells feel.
double GlobalRefinement::seenLinkSpread_m() const {
  constexpr double kWeightOfModel = 30;
  const double links = static_cast<double>(problem_->links.size());
  const double redundancy = 3 * (links - static_cast<double>(cells_.size()) + 1) - 1;
  if (redundancy <= 0) return problem_->link_sigma_m;
  const double model_sq = std::pow(problem_->model->link_sigma_m, 2);
  const double closure_m2 = closureCost(*problem_, solution_.state) * std::pow(problem_->link_sigma_m, 2);
  const double seen_sq = (kWeightOfModel * model_sq + closure_m2) / (kWeightOfModel + redundancy);
  return std::sqrt(std::max(model_sq, seen_sq));
}

/// A hand turns the part while it is sampled, and the readings show that the more, the further a cell is from the
/// middle. How hard it swings differs from hand to hand: the spread of all poses is estimated with them (expectation
/// maximisation), weighed against a usual tremor as if that had been seen on so many axes. Where the readings can't
/// tell a swing from a bend of the skin, the spread stays what it is beforehand, and so does the stated uncertainty: no
/// model switches on between one pose and the next.
double GlobalRefinement::seenAccelerations_rad_s2() const {
  if (!problem_->accelerations) return problem_->acceleration_sigma;
  std::vector<Eigen::Matrix3d> covariances;
  for (std::size_t pose = 0; pose < problem_->poses; ++pose) {
    covariances.push_back(solution_.covariance->acceleration(pose));
  }
  return accelerationSpread(solution_.state.acceleration_o, covariances);
}

/// Every mean is granted a hand's tremor that averaging does not take away. What the estimate leaves of the readings
/// shows whether there is any, as on a fixture: the share of the granted variances by restricted maximum likelihood,
/// weighed against them as if they had been seen on so many axes. It is never more than one: what fits worse than
/// granted is a fault's. With W = (V + B L B^T)^-1 of the sensors' errors, in units of V, residuals have the freedom
/// tr W, of which attitudes and forces take as much as of the readings.
double GlobalRefinement::seenNoise() {
  constexpr double kWeightOfModel = 3;
  constexpr double kLeast = 1.0 / 9;  // a mean is never better than a milligravity
  if (!problem_->accelerations) return 1;
  fitSensors();
  double seen = 0;
  double freedom = 0;
  double readings = 0;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    const SensorState& sensor = sensors_[cell];
    Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
    for (std::size_t k = 0; k < sensor.readings.size(); ++k) {
      const Eigen::Vector4d row(1, sensor.v_g[k].x(), sensor.v_g[k].y(), sensor.v_g[k].z());
      information += row * row.transpose() * sensor.fit.precision[k];
      seen += sensor.fit.residual_g[k].squaredNorm() * sensor.fit.precision[k];
      readings += 3;
    }
    freedom += 3 * static_cast<double>(sensor.readings.size());
    for (const Eigen::Matrix4d& root : sensor.fit.covariance_root) {
      freedom -= (root.transpose() * information * root).trace();
    }
  }
  const double unknowns = 3.0 * static_cast<double>(cells_.size() - 1 + problem_->poses);
  freedom *= std::max(0.0, 1 - unknowns / readings);
  return std::clamp((kWeightOfModel + noise_share_ * seen) / (kWeightOfModel + freedom), kLeast, 1.0);
}

void GlobalRefinement::takeNoise(double share) {
  noise_share_ = share;
  if (!problem_->accelerations) return;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    for (std::size_t k = 0; k < noise_[cell].size(); ++k) {
      problem_->readings[cell][k].variance_g2 = std::max(share * noise_[cell][k].granted_g2, noise_[cell][k].own_g2);
    }
  }
}

void GlobalRefinement::fitSensors() {
  const AccelerometerPrior prior = priorOfChips(*problem_, solution_.state);
  sensors_.resize(cells_.size());
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    fitCell(*problem_, prior, solution_.state, cell, sensors_[cell]);
  }
}

void GlobalRefinement::leaveOut(std::size_t cell) {
  problem_->readings[localOf(cell)].clear();
  if (motion_compensated_readings_) motion_compensated_readings_->leaveOut(localOf(cell));
  noise_[localOf(cell)].clear();
}

/// Of a reading as it is used, with a hand's tremor: faults are judged by that.
double GlobalRefinement::grantedVariance_g2(std::size_t local, std::size_t reading) const {
  return std::max(sensors_[local].readings[reading].variance_g2, noise_[local][reading].granted_g2);
}

/// Readings by the chip's own errors alone, whatever the cell's attitude, as noisy as they may be.
std::vector<CellReading> GlobalRefinement::readingsByOwnErrors(std::size_t local) const {
  std::vector<CellReading> own = sensors_[local].readings;
  const double scale = lot().scale;
  for (std::size_t k = 0; k < own.size(); ++k) {
    own[k].y_g = (own[k].y_g + (scale - 1) * sensors_[local].v_g[k]) / scale;
    own[k].variance_g2 = grantedVariance_g2(local, k) / (scale * scale);
  }
  return own;
}

Misfit GlobalRefinement::misfitOf(std::size_t cell) const {
  const std::size_t at = localOf(cell);
  return testRigidity(AccelerometerPrior(problem_->model->accelerometer), readingsByOwnErrors(at), sensors_[at].v_g);
}

TurnBetweenPoses GlobalRefinement::turnOf(std::size_t cell) const {
  const std::size_t at = localOf(cell);
  return findTurn(AccelerometerPrior(problem_->model->accelerometer), readingsByOwnErrors(at), sensors_[at].v_g);
}

std::vector<double> GlobalRefinement::poseMisfits() const {
  std::vector<double> sums(poses_.size(), 0);
  std::vector<double> counts(poses_.size(), 0);
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    const std::vector<CellReading>& readings = sensors_[cell].readings;
    for (std::size_t k = 0; k < readings.size(); ++k) {
      sums[readings[k].pose] += sensors_[cell].fit.residual_g[k].squaredNorm() / (3 * grantedVariance_g2(cell, k));
      counts[readings[k].pose] += 1;
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = counts[k] == 0 ? 0 : std::sqrt(sums[k] / counts[k]);
  return sums;
}

std::optional<GlobalRefinement::OpenLink> GlobalRefinement::widestOpen() const {
  std::optional<OpenLink> widest;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const double opening_m = linkOpening_m(*problem_, solution_.state, k);
    if (!widest || opening_m > widest->opening_m) widest = OpenLink{links_[k], opening_m};
  }
  return widest;
}

const SE3& GlobalRefinement::placementOf(std::size_t cell) const { return solution_.state.cells[localOf(cell)]; }
const Matrix6d& GlobalRefinement::covarianceOf(std::size_t cell) const {
  finishCovariances();
  return solution_.covariance->cell(localOf(cell));
}

const std::vector<Matrix6d>& GlobalRefinement::shapeCovariances() const {
  finishCovariances();
  return shape_;
}

/// Those of the shape first: they are the last that take the factor, whose memory the rest takes.
void GlobalRefinement::finishCovariances() const {
  if (!shape_.empty()) return;
  const GlobalCovariance& covariance = *solution_.covariance;
  const auto times = [&](Eigen::MatrixXd B) {
    Eigen::MatrixXd product = covariance.timesCells(std::move(B));
    covariance.keepProblemInstead(problem_);
    return product;
  };
  shape_ = shapeCovariancesOf(solution_.state.cells, times, [&](std::size_t cell) { return covariance.cell(cell); });
}

Eigen::Vector3d GlobalRefinement::correctedReading(std::size_t cell, const Eigen::Vector3d& mean_g) const {
  const Eigen::Matrix3d& R_u_a = problem_->model->accelerometer.T_u_a.R;
  const AccelerometerFit& fit = sensorOf(cell);
  const SensorLot& of_lot = solution_.state.lot;
  return R_u_a * of_lot.gain(fit.gain).inverse() * (R_u_a.transpose() * mean_g - of_lot.offset_g - fit.offset_g);
}

CellReading GlobalRefinement::foretold(std::size_t local, std::size_t pose, const GlobalState& state) const {
  std::vector<double> variances;
  for (const CellReading& reading : problem_->readings[local]) variances.push_back(reading.variance_g2);
  const Eigen::Matrix3d R_o_a = state.cells[local].R * problem_->model->accelerometer.T_u_a.R;
  const Eigen::Vector3d v_g = R_o_a.transpose() * specificForce(*problem_, state, local, pose);
  const AccelerometerFit& fit = sensors_[local].fit;
  return {pose, state.lot.gain(fit.gain) * v_g + fit.offset_g + state.lot.offset_g, median(std::move(variances))};
}

std::vector<Matrix6d> GlobalRefinement::covariancesWithPose(const Eigen::Vector3d& up_o) const {
  GlobalProblem with = *problem_;
  GlobalState state = solution_.state;
  const std::size_t pose = with.poses++;
  state.force_o.push_back(up_o);
  state.acceleration_o.push_back(Eigen::Vector3d::Zero());
  for (std::size_t local = 0; local < cells_.size(); ++local) {
    if (!with.readings[local].empty()) with.readings[local].push_back(foretold(local, pose, state));
  }
  return cellCovariancesAt(with, state);
}

std::vector<Matrix6d> GlobalRefinement::covariancesWithAllReadings() const {
  GlobalProblem with = *problem_;
  for (std::size_t local = 0; local < cells_.size(); ++local) {
    const std::vector<CellReading>& own = problem_->readings[local];
    for (std::size_t pose = 0; pose < with.poses && !own.empty(); ++pose) {
      if (std::ranges::find(own, pose, &CellReading::pose) != own.end()) continue;
      with.readings[local].push_back(foretold(local, pose, solution_.state));
    }
  }
  return cellCovariancesAt(with, solution_.state);
}

std::shared_ptr<const PlacementCovariance> GlobalRefinement::placementCovariance(const SkinGraph& graph) const {
  std::vector<CellId> ids;
  for (const std::size_t cell : cells_) ids.push_back(graph.cells()[cell].id);
  finishCovariances();
  return std::make_shared<SolvedCovariance>(std::move(ids), solution_.state.cells, solution_.covariance);
}

std::shared_ptr<const GravityCovariance> GlobalRefinement::gravityCovariance() const {
  SolvedGravityCovariance::Solve solve;
  if (!motion_compensated_readings_) {
    solve = [problem = std::shared_ptr<const GlobalProblem>(problem_), state = solution_.state, noise = noise_] {
      constexpr double kMinVariance_g2 = 1e-10;  // of readings that were simulated without noise
      GlobalProblem quiet = *problem;
      quiet.loss.threshold = std::numeric_limits<double>::infinity();  // readings are weighed by their noise alone
      for (std::size_t cell = 0; cell < quiet.readings.size(); ++cell) {
        for (std::size_t k = 0; k < quiet.readings[cell].size(); ++k) {
          double& variance_g2 = quiet.readings[cell][k].variance_g2;
          variance_g2 = std::min(variance_g2, std::max(kMinVariance_g2, noise[cell][k].own_g2));
        }
      }
      return GlobalSolver().covarianceAt(quiet, state);
    };
  }
  return std::make_shared<SolvedGravityCovariance>(solution_.covariance, problem_->accelerations, std::move(solve));
}

const AccelerometerFit& GlobalRefinement::sensorOf(std::size_t cell) const { return sensors_[localOf(cell)].fit; }
const SensorLot& GlobalRefinement::lot() const { return solution_.state.lot; }

std::span<const CellReading> GlobalRefinement::readingsOf(std::size_t cell) const {
  return sensors_[localOf(cell)].readings;
}

std::span<const Eigen::Vector3d> GlobalRefinement::forcesAt(std::size_t cell) const {
  return sensors_[localOf(cell)].v_g;
}

SensorEvidence GlobalRefinement::sensorEvidence() const {
  return evidenceOfPatch(*problem_, solution_.state, sensors_);
}

Eigen::Matrix3d GlobalRefinement::linkCovariance(std::size_t link_index) const {
  const auto at = static_cast<std::size_t>(std::ranges::lower_bound(links_, link_index) - links_.begin());
  const GlobalLink& link = problem_->links[at];
  const std::vector<SE3>& cells = solution_.state.cells;
  const Eigen::Matrix3d R_c_n = cells[link.c].R.transpose() * cells[link.n].R;
  finishCovariances();
  const GlobalCovariance& covariance = *solution_.covariance;
  const Matrix6d& mixed = covariance.link(at);
  // d = R_c_n e_n - e_c.
  const Eigen::Matrix3d between = mixed.bottomRightCorner<3, 3>() * R_c_n.transpose();
  const Eigen::Matrix3d own_c = covariance.cell(link.c).bottomRightCorner<3, 3>();
  const Eigen::Matrix3d own_n = covariance.cell(link.n).bottomRightCorner<3, 3>();
  return own_c + R_c_n * own_n * R_c_n.transpose() - between - between.transpose();
}

}  // namespace hexoderm
