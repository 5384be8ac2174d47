#include "hexoderm/solve/checks/calibration_check.h"

#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/error.h"
#include "hexoderm/skin/skin_graph.h"
#include "hexoderm/solve/checks/cell_change.h"
#include "hexoderm/solve/faults/cell_health.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <set>
#include <unordered_map>
#include <utility>

namespace hexoderm {
namespace {

/// What a calibrated skin has and the skin of today has not.
struct MissingParts {
  std::vector<CellId> cells;                       ///< ascending
  std::vector<std::pair<LinkEnd, LinkEnd>> links;  ///< of cells that are both there
};

using LinkEnds = std::pair<LinkEnd, LinkEnd>;

void requireSameCells(const CellModel& calibrated, const CellModel& today) {
  constexpr double kSame = 1e-6;  // of metres and of rotation matrices
  for (const Port& port : calibrated.ports) {
    const Port* other = today.findPort(port.number);
    if (other != nullptr && (other->vector_m - port.vector_m).norm() < kSame) continue;
    throw InvalidArgument(
        message("the calibration is of another kind of cell: port {} of its cell model {} is not where the cell model "
                "{} has it",
                port.number, calibrated.name, today.name));
  }
  const auto turn = [](const CellModel& model) { return model.accelerometer.T_u_a.R; };
  if (today.ports.size() == calibrated.ports.size() && (turn(calibrated) - turn(today)).norm() < kSame) return;
  throw InvalidArgument(
      message("the calibration is of another kind of cell: the ports or the accelerometer of its cell model {} are not "
              "those of "
              "the cell model {}",
              calibrated.name, today.name));
}

/// Compares the skin of a calibration with what is connected today. Throws InvalidArgument, naming what differs, if
/// that is another skin: a cell model with other ports or another accelerometer, cells or links that the calibration
/// does not have, or fewer than half of its cells.
MissingParts findMissingParts(const Reconstruction& calibration, const CellModel& model, const SkinGraph& today) {
  requireSameCells(*calibration.model, model);
  std::set<CellId> cells;
  std::set<LinkEnds> links;
  for (const PatchReconstruction& patch : calibration.patches) {
    for (const CellPlacement& cell : patch.cells) cells.insert(cell.cell);
    for (const LinkEstimate& link : patch.links) links.insert(std::minmax(link.source, link.target));
  }

  std::vector<CellId> added;
  for (const GraphCell& cell : today.cells()) {
    if (!cells.contains(cell.id)) added.push_back(cell.id);
  }
  if (!added.empty()) {
    throw InvalidArgument(message("the calibration is of another skin: {} of today is not in it",
                                  added.size() == 1 ? cellsText(added) : message("one of the {}", cellsText(added))));
  }
  for (const GraphLink& link : today.links()) {
    const LinkEnds ends = std::minmax(today.sourceEnd(link), today.targetEnd(link));
    if (link.muted() || links.contains(ends)) continue;
    throw InvalidArgument(
        message("the calibration is of another skin, or the cells were joined otherwise: {} is not in it",
                linkText(ends.first, ends.second)));
  }

  MissingParts missing;
  for (const CellId cell : cells) {
    if (!today.indexOf(cell)) missing.cells.push_back(cell);
  }
  if (2 * missing.cells.size() > cells.size()) {
    throw InvalidArgument(message("the calibration is of another skin: {} of its {} cells are not there today",
                                  missing.cells.size(), cells.size()));
  }
  for (const LinkEnds& ends : links) {
    const bool joins = today.indexOf(ends.first.cell) && today.indexOf(ends.second.cell);
    if (joins && !today.indexOf(ends.first, ends.second)) missing.links.push_back(ends);
  }
  return missing;
}

/// An explanation is ruled out if it leaves so much more of the chi-squared than the other: 2 ln 20.
constexpr double kRuledOut = 5.99;
/// A turn about an axis that is known no better than this may be larger than what is seen of it.
constexpr double kBlind_rad = 10 * kDegree;
/// A cell about which no smaller turn would be noticed, but for one axis, tells nothing.
constexpr double kTellsNothing_rad = 20 * kDegree;

/// Share of checks of unchanged skins that name a cell.
constexpr double kFalseAlarms = 0.005;

constexpr double square(double x) { return x * x; }

/// What the readings alone say against a sensor.
Message brokenText(FindingCode code) {
  switch (code) {
    case FindingCode::IdenticalReadings:
      return message("broken: it reads the same as another cell, digit for digit");
    case FindingCode::DeadSensor:
      return message("dead: it reads no gravity");
    case FindingCode::StuckSensor:
      return message("dead: it reads the same in all poses");
    case FindingCode::SaturatedSensor:
      return message("broken: it reads the end of its range");
    case FindingCode::DeadAxis:
      return message("broken: one of its axes is dead");
    case FindingCode::NoisySensor:
      return message("broken: it scatters far more than the other cells");
    default:
      return {};
  }
}

/// The calibration as the statistics need it: what is known of each of its cells.
class CalibratedCells {
 public:
  explicit CalibratedCells(const Reconstruction& calibration)
      : calibration_(calibration),
        model_(*calibration.model),
        joint_(calibration.solver == solverName(Solver::Global)) {
    for (std::size_t k = 0; k < calibration.poses.size(); ++k) place_of_.emplace(calibration.poses[k].pose, k);
  }

  /// Covariance of the errors of a cell's attitude (accelerometer axes), offset and gains. `own_g2`: variance that the
  /// sensor's own noise leaves in a mean reading, as today's poses show it.
  [[nodiscard]] CellErrors errorsOf(const PatchReconstruction& patch, const CellPlacement& cell, double own_g2) const {
    const Eigen::Matrix3d R_u_a = model_.accelerometer.T_u_a.R;
    if (cell.placed_by == PlacedBy::Links) {
      CellErrors covariance =
          priorInformation(priorOfChips(model_, patch), elastomerInformation(model_, portsOf(patch, cell.cell)))
              .inverse();
      if (cell.cov_t_r) {
        covariance.topLeftCorner<3, 3>() = R_u_a.transpose() * cell.cov_t_r->bottomRightCorner<3, 3>() * R_u_a;
      }
      return covariance;
    }
    const CellErrors priors =
        priorInformation(priorOfChips(model_, patch), elastomerInformation(model_, portsOf(patch, cell.cell)));
    const std::vector<PlacingReading> readings = readingsOf(patch, cell, own_g2);
    const CellEstimate estimate = joint_ ? CellEstimate::GlobalNoCrossAxis : CellEstimate::Tree;
    return errorsOfCell(priors, readings, gainOf(cell), estimate);
  }

  [[nodiscard]] static Eigen::Matrix3d gainOf(const CellPlacement& cell) {
    return cell.accel_scale ? Eigen::Matrix3d(cell.accel_scale->asDiagonal()) : Eigen::Matrix3d::Identity();
  }
  [[nodiscard]] static Eigen::Vector3d offsetOf(const CellPlacement& cell) {
    return cell.accel_offset_g.value_or(Eigen::Vector3d::Zero());
  }

 private:
  [[nodiscard]] static std::vector<PortNumber> portsOf(const PatchReconstruction& patch, CellId cell) {
    std::vector<PortNumber> ports;
    for (const LinkEstimate& link : patch.links) {
      if (!link.used) continue;
      if (link.source.cell == cell) ports.push_back(link.source.port);
      if (link.target.cell == cell) ports.push_back(link.target.port);
    }
    return ports;
  }

  /// In which of the calibration's poses the cell was measured: its links have residuals there. A cell without any
  /// counts as measured in all.
  [[nodiscard]] std::vector<bool> measuredIn(const PatchReconstruction& patch, CellId cell) const {
    std::vector<bool> measured(calibration_.poses.size(), false);
    for (const LinkEstimate& link : patch.links) {
      if (link.source.cell != cell && link.target.cell != cell) continue;
      for (std::size_t k = 0; k < std::min(measured.size(), link.pose_residual_rad.size()); ++k) {
        measured[k] = measured[k] || link.pose_residual_rad[k].has_value();
      }
    }
    if (std::ranges::count(measured, true) == 0) measured.assign(measured.size(), true);
    return measured;
  }

  /// The readings that the cell was placed by, as far as the calibration tells: their gravity, and the variance with
  /// which the solver weighed those of a pose, which holds more than the sensor's own noise (GravityTable). What
  /// offsets changed by from pose to pose counts as each cell's own.
  [[nodiscard]] std::vector<PlacingReading> readingsOf(const PatchReconstruction& patch, const CellPlacement& cell,
                                                       double own_g2) const {
    const Eigen::Matrix3d R_a_o = (cell.T_o_u.R * model_.accelerometer.T_u_a.R).transpose();
    const std::vector<bool> measured = measuredIn(patch, cell.cell);
    const Accelerometer& sensor = model_.accelerometer;
    const double scatter_g2 =
        own_g2 + square(sensor.offset_instability_sigma_g) + square(sensor.offset_instability_shared_sigma_g);
    std::vector<PlacingReading> readings;
    for (const GravityDirection& gravity : patch.gravity) {
      const auto place = place_of_.find(gravity.pose);
      if (place == place_of_.end() || !measured[place->second]) continue;
      const double noise_g = std::max(calibration_.poses[place->second].noise_g, kTremorFloor_g);
      readings.push_back({R_a_o * gravity.g_o, square(noise_g), std::min(square(noise_g), scatter_g2)});
    }
    return readings;
  }

  const Reconstruction& calibration_;
  const CellModel& model_;
  bool joint_;
  std::unordered_map<PoseId, std::size_t> place_of_;
};

class CalibrationChecker {
 public:
  CalibrationChecker(const Reconstruction& calibration, const SessionSnapshot& today)
      : calibration_(calibration),
        today_(withModel(today, calibration.model)),
        graph_(*today_.model, *today_.neighbors),
        missing_(findMissingParts(calibration, *today.model, graph_)),
        cells_(calibration),
        table_(today_, graph_, ignored_) {}

  CalibrationCheck run() {
    for (const std::size_t pose : table_.enabledPoses()) check_.poses.push_back(today_.poses[pose].capture->id);
    // Of each cell two numbers are looked at (ViewComparison::deviate()).
    const double tests = 2 * static_cast<double>(std::max<std::size_t>(1, graph_.cells().size()));
    check_.changed_from = quantile(complement(boost::math::normal(), kFalseAlarms / tests));
    judgeReadings();
    for (const PatchReconstruction& patch : calibration_.patches) checkPatch(patch);
    std::ranges::sort(check_.cells, {}, &CheckedCell::cell);
    sayWhatIsMissing();
    summarize();
    return std::move(check_);
  }

 private:
  static SessionSnapshot withModel(SessionSnapshot snapshot, std::shared_ptr<const CellModel> model) {
    snapshot.model = std::move(model);
    return snapshot;
  }

  /// Sensors that can't be compared. A norm beyond what the prior of an uncalibrated sensor excuses is one to explain.
  void judgeReadings() {
    std::vector<Finding> findings;
    judgeCells(today_, graph_, table_, findings);
    for (const Finding& finding : findings) {
      if (finding.code == FindingCode::PartMoved) check_.remarks.push_back(finding.message);
      if (finding.code == FindingCode::WrongNorm) allowAgain(finding);
      const Message words = brokenText(finding.code);
      if (words.empty()) continue;
      for (const CellId cell : finding.cells) broken_.try_emplace(cell, words);
    }
    for (const Finding& finding : calibration_.findings) {
      if (finding.code == FindingCode::TurnedGroup) turned_back_.insert(finding.cells.begin(), finding.cells.end());
    }
  }

  void allowAgain(const Finding& finding) {
    for (const std::size_t pose : table_.enabledPoses()) {
      if (std::ranges::find(finding.poses, today_.poses[pose].capture->id) == finding.poses.end()) continue;
      for (const CellId cell : finding.cells) table_.at(*graph_.indexOf(cell), pose).usable = true;
    }
  }

  void checkPatch(const PatchReconstruction& patch) {
    std::vector<CellView> views;
    for (const CellPlacement& cell : patch.cells) {
      if (std::optional<CheckedCell> outcome = withoutComparison(cell)) {
        check_.cells.push_back(*std::move(outcome));
      } else {
        views.push_back(look(patch, cell));
      }
    }
    const Accelerometer& sensor = today_.model->accelerometer;
    const Consensus consensus(views, check_.poses.size(), check_.changed_from,
                              {std::hypot(sensor.offset_drift_shared_sigma_g, unknownOfLot_g(patch)),
                               sensor.offset_instability_shared_sigma_g});
    if (views.size() < 2) {
      for (const CellView& view : views) {
        check_.cells.push_back(
            notTold(view, message("can't be told: no other cell of its patch can be compared with it")));
      }
      return;
    }
    check_.compared = true;
    if (2 * consensus.size() <= views.size()) {
      contradictory_ = true;
      check_.changed = true;
      for (const CellView& view : views) {
        check_.cells.push_back(notTold(
            view, message("can't be told: the cells of its patch contradict each other, and no majority agrees")));
      }
      return;
    }
    for (std::size_t k = 0; k < views.size(); ++k) check_.cells.push_back(judge(views[k], consensus.compare(k)));
    // What the calibration does not know of its lot looks like a drift.
    if (const auto drift = consensus.commonDrift(); drift && drift->offset_g.norm() > 3 * unknownOfLot_g(patch)) {
      check_.remarks.push_back(message("The offsets of all sensors drifted together by {} +- {}; that is no change.",
                                       MilliG{drift->offset_g.norm()}, MilliG{drift->sigma_g}));
    }
  }

  /// A cell that does not take part in the comparison, if it is one.
  [[nodiscard]] std::optional<CheckedCell> withoutComparison(const CellPlacement& cell) const {
    CheckedCell checked;
    checked.cell = cell.cell;
    checked.change = CellChange::Broken;
    const std::optional<std::size_t> index = graph_.indexOf(cell.cell);
    const auto broken = broken_.find(cell.cell);
    if (!index) {
      checked.words = message("gone: it is no longer among the skin's cells");
    } else if (broken != broken_.end()) {
      checked.words = broken->second;
    } else if (turned_back_.contains(cell.cell)) {
      checked.change = CellChange::NotTold;
      checked.words = message("can't be told: its readings were turned back when it was calibrated");
    } else if (!table_.usablePoses(*index).empty()) {
      return std::nullopt;
    } else if (cell.placed_by == PlacedBy::Links) {
      checked.change = CellChange::NotTold;
      checked.words = message("can't be told: it has no usable reading, as when it was calibrated");
    } else {
      checked.words = message("dead: it sends no reading");
    }
    return checked;
  }

  [[nodiscard]] static CheckedCell notTold(const CellView& view, Message words) {
    CheckedCell checked;
    checked.cell = view.cell;
    checked.words = std::move(words);
    checked.poses = view.poses.size();
    return checked;
  }

  [[nodiscard]] CellView look(const PatchReconstruction& patch, const CellPlacement& cell) const {
    constexpr double kMin_g2 = 1e-12;  // a model may have neither noise nor steps
    const std::size_t index = *graph_.indexOf(cell.cell);
    const Eigen::Matrix3d R_a_u = today_.model->accelerometer.T_u_a.R.transpose();
    const Eigen::Matrix3d R_o_a = cell.T_o_u.R * R_a_u.transpose();
    const Eigen::Matrix3d gain = CalibratedCells::gainOf(cell);
    const Eigen::Matrix3d inverse = gain.inverse();
    CellView view;
    view.cell = cell.cell;
    view.at_o = cell.T_o_u.t;
    view.drift_o = R_o_a * inverse;
    const std::vector<std::size_t>& enabled = table_.enabledPoses();
    for (std::size_t k = 0; k < enabled.size(); ++k) {
      if (table_.at(index, enabled[k]).usable) view.poses.push_back(k);
    }
    const auto rows = 3 * static_cast<Eigen::Index>(view.poses.size());
    view.force_o_g.resize(rows);
    Eigen::MatrixXd jacobian(rows, kCellUnknowns);
    Eigen::VectorXd noise_g2(rows);
    for (std::size_t k = 0; k < view.poses.size(); ++k) {
      const auto row = 3 * static_cast<Eigen::Index>(k);
      const GravityTable::Entry& entry = table_.at(index, enabled[view.poses[k]]);
      const Eigen::Vector3d v = inverse * (R_a_u * entry.mean_g - CalibratedCells::offsetOf(cell));
      view.force_o_g.segment<3>(row) = R_o_a * v;
      jacobian.middleRows<3>(row) = view.drift_o * readingJacobian(gain, v.normalized());
      noise_g2.segment<3>(row).setConstant(std::max(entry.own_variance_g2, kMin_g2));
    }
    const Accelerometer& sensor = today_.model->accelerometer;
    CellErrors errors = cells_.errorsOf(patch, cell, noise_g2.mean());
    for (const int offset : kOffsets) errors(offset, offset) += square(sensor.offset_drift_sigma_g);
    view.covariance_g2 = jacobian * errors * jacobian.transpose();
    view.covariance_g2.diagonal() += noise_g2;
    view.covariance_g2.diagonal().array() += square(sensor.offset_instability_sigma_g);
    return view;
  }

  [[nodiscard]] CheckedCell judge(const CellView& view, const ViewComparison& comparison) {
    CheckedCell checked;
    checked.cell = view.cell;
    checked.poses = view.poses.size();
    checked.deviate = comparison.deviate();
    const NoticedTurn noticed = noticedTurn(comparison, check_.changed_from);
    checked.noticed_turn_rad = noticed.any_axis_rad;
    checked.turn_information = comparison.turnInformation();
    if (checked.deviate > check_.changed_from) {
      explain(view, comparison, checked);
    } else if (noticed.two_axes_rad.value_or(kPi) > kTellsNothing_rad) {
      checked.words = message("can't be told: its calibration is too uncertain");
    } else {
      checked.change = CellChange::None;
      checked.words = message("as calibrated");
    }
    return checked;
  }

  void explain(const CellView& view, const ViewComparison& comparison, CheckedCell& checked) {
    const TurnFit turn = fitTurn(comparison);
    const DriftFit drift = fitDrift(view, comparison);
    if (std::min(turn.left.deviate(), drift.left.deviate()) > check_.changed_from) {
      checked.change = CellChange::Broken;
      checked.words = message("broken: neither a turn nor a drift of its offset explains what it reads");
      changed_meanwhile_ = changed_meanwhile_ || view.poses.size() > 1;
      return;
    }
    const double turn_leaves_more = turn.left.chi_squared - drift.left.chi_squared;
    if (turn_leaves_more < kRuledOut) {
      checked.turn = {turn.turn_o.norm(), turn.sigma_rad, turn.blind_sigma_rad > kBlind_rad};
    }
    if (turn_leaves_more > -kRuledOut) checked.drift = {drift.offset_g, drift.sigma_g};
    checked.change = !checked.drift  ? CellChange::Turned
                     : !checked.turn ? CellChange::Drifted
                                     : CellChange::TurnedOrDrifted;
    checked.words = explanationText(checked);
  }

  [[nodiscard]] static Message explanationText(const CheckedCell& checked) {
    Message turned;
    Message drifted;
    if (checked.turn) {
      const Degrees angle{checked.turn->angle_rad};
      const Degrees sigma{checked.turn->sigma_rad};
      turned = checked.turn->at_least ? message("turned by {} +- {} or more", angle, sigma)
                                      : message("turned by {} +- {}", angle, sigma);
    }
    if (checked.drift) {
      drifted = message("its sensor's offset drifted by {} +- {}", MilliG{checked.drift->offset_g.norm()},
                        MilliG{checked.drift->sigma_g});
    }
    if (!checked.drift) return turned;
    if (!checked.turn) return drifted;
    return message("changed: {}, or {}; these poses can't tell which", turned, drifted);
  }

  void sayWhatIsMissing() {
    for (const auto& [source, target] : missing_.links) {
      check_.changed = true;
      check_.remarks.push_back(message("The {} of the calibration is no longer reported.", linkText(source, target)));
    }
  }

  void summarize() {
    std::vector<CellId> changed;
    for (const CheckedCell& cell : check_.cells) {
      if (cell.change != CellChange::None && cell.change != CellChange::NotTold) changed.push_back(cell.cell);
    }
    check_.changed = check_.changed || !changed.empty();
    const std::size_t same = check_.count(CellChange::None);
    const std::size_t not_told = check_.count(CellChange::NotTold);
    std::vector<Message> words;
    if (!changed.empty()) {
      words.push_back(message("Not as calibrated: {}.", cellsText(changed)));
    } else if (contradictory_) {
      words.push_back(
          message("The skin is not as calibrated, and the cells contradict each other so much that none can "
                  "be named: calibrate it anew."));
    } else if (!check_.compared) {
      words.push_back(message("Nothing could be compared: no two cells of a patch have a usable reading."));
    } else if (same == 0) {
      words.push_back(message("Nothing can be told of any cell: the calibration is too uncertain."));
    } else if (not_told == 0) {
      words.push_back(message("All {} cells are as calibrated, as far as these poses show.", same));
    }
    if (same > 0 && not_told > 0) {
      words.push_back(
          message("{} of {} cells are as calibrated, as far as these poses show; of {} nothing can be told.", same,
                  check_.cells.size(), not_told));
    }
    check_.compared = same > 0 || !changed.empty();
    const bool too_many = 3 * changed.size() > check_.cells.size();
    if (too_many) words.push_back(message("So many cells changed that the skin should be calibrated anew."));
    const bool is_blind = std::ranges::any_of(check_.cells, [](const CheckedCell& cell) {
      return cell.change == CellChange::None && !cell.noticed_turn_rad;
    });
    if (is_blind) {
      words.push_back(
          message("These poses don't show every turn of a cell: take another one, with the part turned by 45° "
                  "or more."));
    }
    check_.summary = inRow(std::move(words));
    if (!check_.changed) {
      check_.advice = adviceWhereNothingChanged(is_blind || not_told > 0);
    } else if (!too_many && !(contradictory_ && changed.empty())) {  // else the summary says what to do
      check_.advice = adviceOnChanges(is_blind);
    }
  }

  [[nodiscard]] Message adviceWhereNothingChanged(bool with_gaps) const {
    if (!check_.compared) {
      return message("See that the cells send readings, and that the calibration was made of three poses or more.");
    }
    return with_gaps ? message("As far as it could be compared, the calibration still holds.")
                     : message("The calibration still holds: it can be used as before.");
  }

  [[nodiscard]] Message adviceOnChanges(bool is_blind) const {
    const bool is_either = check_.count(CellChange::TurnedOrDrifted) > 0;
    std::vector<Message> words;
    if (is_either || check_.count(CellChange::Turned) > 0) {
      words.push_back(
          message("A cell that turned came loose or was fixed anew: see that it sits firmly, then calibrate anew."));
    }
    if (is_either || check_.count(CellChange::Drifted) > 0) {
      words.push_back(
          message("A cell whose offset drifted is still where it was; its readings are off by that much until the skin "
                  "is calibrated anew."));
    }
    // Where the poses are blind, the summary asks for another one.
    if (is_either && !is_blind) {
      words.push_back(message("Another pose, with the part turned by 45° or more, tells a turn from a drift."));
    }
    if (check_.count(CellChange::Broken) > 0) {
      words.push_back(message("Check the sensor, plug and cable of a cell that is dead, broken or gone."));
    }
    if (changed_meanwhile_) {
      words.push_back(
          message("What neither a turn nor a drift explains may have happened between these poses: compare only those "
                  "that were taken since."));
    }
    if (!missing_.links.empty()) {
      words.push_back(message("See that the cells are still joined where a link is no longer reported."));
    }
    return inRow(std::move(words));
  }

  const Reconstruction& calibration_;
  SessionSnapshot today_;
  SkinGraph graph_;
  MissingParts missing_;
  CalibratedCells cells_;
  std::vector<Finding> ignored_;  ///< about the topology and the numbers of poses
  GravityTable table_;
  std::unordered_map<CellId, Message> broken_;
  std::set<CellId> turned_back_;    ///< of a group that reads turned
  bool contradictory_ = false;      ///< no majority of some patch agrees
  bool changed_meanwhile_ = false;  ///< as far as can be told, a cell may have changed between the poses
  CalibrationCheck check_;
};

}  // namespace

std::string_view cellChangeName(CellChange change) {
  constexpr EnumNames<CellChange> kNames = {{"none", "turned", "drifted", "turned_or_drifted", "broken", "not_told"}};
  return kNames.of(change);
}

std::size_t CalibrationCheck::count(CellChange change) const {
  return static_cast<std::size_t>(std::ranges::count(cells, change, &CheckedCell::change));
}

CalibrationCheck checkCalibration(const Reconstruction& calibration, const SessionSnapshot& today) {
  const bool is_ours =
      calibration.solver == solverName(Solver::Global) || calibration.solver == solverName(Solver::Tree);
  if (!is_ours) {
    throw InvalidArgument(
        message("the calibration was imported and does not say how its cells were measured: only one that Hexoderm "
                "made of poses "
                "can be checked"));
  }
  if (std::ranges::count(today.poses, false, &SessionPose::disabled) == 0) {
    throw InvalidArgument(message("there is no pose to check the calibration with: take one to three"));
  }
  return CalibrationChecker(calibration, today).run();
}

}  // namespace hexoderm
