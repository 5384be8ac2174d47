#include "hexoderm/reconstruction/patch/attitude_faults.h"

#include "hexoderm/reconstruction/faults/attitude_search.h"
#include "hexoderm/reconstruction/faults/link_plausibility.h"
#include "hexoderm/reconstruction/faults/suspects.h"
#include "hexoderm/util/units.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace hexoderm {
namespace {

/// Per cell of the patch.
std::vector<SE3> placementsOf(const PatchSolver& patch) {
  std::vector<SE3> placements;
  placements.reserve(patch.cells().size());
  for (const std::size_t cell : patch.cells()) placements.push_back(patch.placementOf(cell));
  return placements;
}

/// The forces on a patch: of the joint estimate, or what its cells read on the average.
std::vector<PatchForce> forcesOn(const SkinLinks& skin, const PatchSolver& patch, std::span<const SE3> placements) {
  std::vector<PatchForce> forces;
  if (const JointRefinement* joint = patch.joint()) {
    const JointState& state = joint->solution().state;
    for (std::size_t k = 0; k < joint->poses().size(); ++k) {
      const Eigen::Vector3d swing = state.acceleration_o[k] / kStandardGravity;
      forces.push_back({joint->poses()[k], state.force_o[k] - swing.cross(state.middle_o), swing});
    }
    return forces;
  }
  for (const std::size_t pose : skin.table().enabledPoses()) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t place = 0; place < placements.size(); ++place) {
      const GravityTable::Entry& entry = skin.table().at(patch.cells()[place], pose);
      if (entry.usable) sum += placements[place].R * entry.mean_g.normalized();
    }
    constexpr double kNoDirection = 1e-6;
    if (sum.norm() > kNoDirection) forces.push_back({pose, sum.normalized()});
  }
  return forces;
}

/// Takes out of the readings what a hand that turned the part added to them, cell by cell, where that is beyond doubt:
/// the tree takes every pose's force as the same for all cells. Returns whether there was any.
bool freeFromSwings(GravityTable& table, std::span<const std::size_t> cells, std::span<const SE3> placements,
                    const OwnAttitudes& own) {
  constexpr double kBeyondDoubt = 30;  // chi-squared of three degrees of freedom: one in a million still poses
  std::vector<const PatchForce*> swung;
  double across_squared = 0;  // of swings, across the force
  for (const PatchForce& force : own.forces) {
    const Eigen::LDLT<Eigen::Matrix3d> covariance(force.swing_covariance_o);
    if (!covariance.isPositive() || !(force.swing_o.dot(covariance.solve(force.swing_o)) > kBeyondDoubt)) continue;
    swung.push_back(&force);
    across_squared += force.swing_o.cross(force.at_origin_o).squaredNorm() / 2;
  }
  for (const PatchForce* force : swung) {
    for (std::size_t place = 0; place < cells.size(); ++place) {
      GravityTable::Entry& entry = table.at(cells[place], force->pose);
      if (!entry.usable) continue;
      const Eigen::Vector3d& t_o = placements[place].t;
      entry.mean_g -= own.cells[place].R_o_u.transpose() * force->swing_o.cross(t_o);
      // How a hand turned the part about the force itself can't be told from a skin that is twisted: cells that are
      // turned about the way from the origin read the same. It is as large as across the force.
      const double along_squared = across_squared / static_cast<double>(swung.size());
      const Eigen::Matrix3d lever = skew(t_o);
      entry.variance_g2 += ((lever * force->swing_covariance_o * lever.transpose()).trace() +
                            along_squared * force->at_origin_o.cross(t_o).squaredNorm()) /
                           3;
    }
  }
  return !swung.empty();
}

/// What the suspects of a patch ask for.
class Faults {
 public:
  Faults(SkinLinks& skin, std::vector<Finding>& findings) : skin_(skin), findings_(findings) {}

  /// Returns whether anything was taken out.
  bool takeOut(const PatchSolver& patch, std::span<const AttitudeSuspect> suspects) {
    bool changed = false;
    for (const AttitudeSuspect& suspect : suspects) changed = takeOut(patch, suspect) || changed;
    for (const auto& [code, links] : links_) skin_.mute(links, code);
    links_.clear();
    return changed;
  }

 private:
  [[nodiscard]] CellId id(std::size_t cell) const { return skin_.graph().cells()[cell].id; }

  [[nodiscard]] Finding describeContradiction(const PatchSolver& patch, double twist_rad) const {
    std::vector<CellId> cells;
    for (const std::size_t cell : patch.cells()) cells.push_back(id(cell));
    return makeFinding(
        FindingCode::ContradictsModel,
        message(
            "All links of the patch of cell {} are twisted one way, by {} degrees on the average, as on no surface: "
            "the axes of the accelerometers or the numbers of the ports are not as in the cell model {}.",
            id(patch.origin()), Number{toDegrees(twist_rad), 0}, skin_.model().name),
        std::move(cells));
  }

  bool takeOut(const PatchSolver& patch, const AttitudeSuspect& suspect) {
    switch (suspect.kind) {
      case AttitudeSuspect::Kind::Patch:
        addOnce(findings_, describeContradiction(patch, suspect.angle_rad));
        return false;
      case AttitudeSuspect::Kind::Link: {
        const GraphLink& link = skin_.graph().links()[suspect.link];
        findings_.push_back(describeUnexpectedAngle(suspect.angle, skin_.graph().sourceEnd(link),
                                                    skin_.graph().targetEnd(link), suspect.angle_rad,
                                                    suspect.lowest_rad, suspect.highest_rad));
        links_[suspect.angle].push_back(suspect.link);
        return true;
      }
      case AttitudeSuspect::Kind::Swapped:
        findings_.push_back(
            makeFinding(FindingCode::SwappedReadings,
                        message("The cells {} and {} fit into the skin with each other's readings, and not with their "
                                "own: their cables or IDs are probably swapped. Both are placed through their links.",
                                id(suspect.cell), id(suspect.other)),
                        {id(suspect.cell), id(suspect.other)}));
        skin_.dropCell(suspect.cell);
        skin_.dropCell(suspect.other);
        return true;
      case AttitudeSuspect::Kind::Cell:
      case AttitudeSuspect::Kind::Moved:
        break;
    }
    if (hasTooFewPoses(skin_.table(), suspect.cell)) {
      addOnce(findings_, describeSuspiciousSensor(skin_.graph(), skin_.table(), suspect.cell));
      return false;
    }
    if (suspect.kind == AttitudeSuspect::Kind::Moved) {
      findings_.push_back(
          describeMovedCell(skin_.graph(), skin_.snapshot(), suspect.cell, suspect.pose, suspect.angle_rad));
      skin_.dropCell(suspect.cell);
      return true;
    }
    findings_.push_back(
        makeFinding(FindingCode::TurnedSensor,
                    message("Cell {} reads as if it were turned by {} degrees against its neighbours: it is mounted "
                            "otherwise, or its axes are not as in the cell model. It is placed through its links.",
                            id(suspect.cell), Number{toDegrees(suspect.angle_rad), 0}),
                    {id(suspect.cell)}));
    skin_.dropCell(suspect.cell);
    return true;
  }

  SkinLinks& skin_;
  std::vector<Finding>& findings_;
  std::map<FindingCode, std::vector<std::size_t>> links_;  // to be muted
};

}  // namespace

bool AttitudeIsolation::isolate(std::span<const PatchSolver> patches, std::vector<Finding>& findings) {
  Faults faults(skin_, findings);
  bool found_faults = false;
  bool freed = false;
  if (!searched_) contradicting_.clear();  // patches may be others than at the last look
  for (const PatchSolver& patch : patches) {
    const bool is_tree = patch.joint() == nullptr;
    if (patch.cells().size() < 2 || (searched_ && !is_tree)) continue;
    const std::vector<SE3> placements = placementsOf(patch);
    OwnAttitudes own = findOwnAttitudes(skin_, patch.cells(), forcesOn(skin_, patch, placements), placements, is_tree);
    bool changed = false;
    if (!searched_) {
      // Only of a tree they are needed once more.
      const std::vector<AttitudeSuspect> suspects =
          AttitudeSearch(skin_, patch.cells(), is_tree ? own : std::move(own)).suspects();
      const auto fits_no_surface = [](const AttitudeSuspect& suspect) {
        return suspect.kind == AttitudeSuspect::Kind::Patch;
      };
      if (std::ranges::any_of(suspects, fits_no_surface)) contradicting_.insert(patch.cells().front());
      changed = faults.takeOut(patch, suspects);
      found_faults = found_faults || changed;
    }
    // What is no part of the skin must not tell how it was turned. The paper's own way takes readings as they are.
    if (!is_tree || changed || contradicting_.contains(patch.cells().front())) continue;
    if (skin_.options().centring == Centring::Off) continue;
    freed = freeFromSwings(skin_.table(), patch.cells(), placements, own) || freed;
  }
  searched_ = !found_faults;
  return found_faults || freed;
}

}  // namespace hexoderm
