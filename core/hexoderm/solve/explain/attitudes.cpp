#include "hexoderm/base/units.h"
#include "hexoderm/solve/explain/explainer.h"
#include "hexoderm/solve/faults/attitude_search.h"
#include "hexoderm/solve/faults/link_plausibility.h"
#include "hexoderm/solve/faults/suspects.h"
#include "hexoderm/solve/metrics/pose_coverage.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <iterator>
#include <set>
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
  if (const GlobalRefinement* joint = patch.joint()) {
    const GlobalState& state = joint->solution().state;
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

/// How a cell is turned about the one line of gravity that was seen, no reading tells: angles beyond any limit mean
/// nothing then.
bool seesOneLine(std::span<const PatchForce> forces) {
  std::vector<Eigen::Vector3d> directions;
  for (const PatchForce& force : forces) directions.push_back(force.at_origin_o.normalized());
  return lieAlongOneLine(directions);
}

/// What a hand that turned the part added to the readings, cell by cell, where that is beyond doubt: the tree takes
/// every pose's force as the same for all cells.
std::vector<ReadingCorrection> swingsOf(const GravityTable& table, std::span<const std::size_t> cells,
                                        std::span<const SE3> placements, const OwnAttitudes& own) {
  constexpr double kBeyondDoubt = 30;  // chi-squared of three degrees of freedom: one in a million still poses
  std::vector<const PatchForce*> swung;
  double across_squared = 0;  // of swings, across the force
  for (const PatchForce& force : own.forces) {
    const Eigen::LDLT<Eigen::Matrix3d> covariance(force.swing_covariance_o);
    if (!covariance.isPositive() || !(force.swing_o.dot(covariance.solve(force.swing_o)) > kBeyondDoubt)) continue;
    swung.push_back(&force);
    across_squared += force.swing_o.cross(force.at_origin_o).squaredNorm() / 2;
  }
  std::vector<ReadingCorrection> corrections;
  for (const PatchForce* force : swung) {
    for (std::size_t place = 0; place < cells.size(); ++place) {
      if (!table.at(cells[place], force->pose).usable) continue;
      const Eigen::Vector3d& t_o = placements[place].t;
      // How a hand turned the part about the force itself can't be told from a skin that is twisted: cells that are
      // turned about the way from the origin read the same. It is as large as across the force.
      const double along_squared = across_squared / static_cast<double>(swung.size());
      const Eigen::Matrix3d lever = skew(t_o);
      const double variance_g2 = ((lever * force->swing_covariance_o * lever.transpose()).trace() +
                                  along_squared * force->at_origin_o.cross(t_o).squaredNorm()) /
                                 3;
      corrections.push_back(
          {cells[place], force->pose, own.cells[place].R_o_u.transpose() * force->swing_o.cross(t_o), variance_g2});
    }
  }
  return corrections;
}

Finding describeContradiction(const SkinLinks& skin, const PatchSolver& patch, double twist_rad) {
  const auto id = [&](std::size_t cell) { return skin.graph().cells()[cell].id; };
  std::vector<CellId> cells;
  for (const std::size_t cell : patch.cells()) cells.push_back(id(cell));
  return makeFinding(
      FindingCode::ContradictsModel,
      message("All links of the patch of cell {} are twisted one way, by {} degrees on the average, as on no surface: "
              "the axes of the accelerometers or the numbers of the ports are not as in the cell model {}.",
              id(patch.origin()), Number{toDegrees(twist_rad), 0}, skin.model().name),
      std::move(cells));
}

Finding describeSwap(CellId cell, CellId other) {
  return makeFinding(FindingCode::SwappedReadings,
                     message("The cells {} and {} fit into the skin with each other's readings, and not with their "
                             "own: their cables or IDs are probably swapped. Both are placed through their links.",
                             cell, other),
                     {cell, other});
}

Finding describeTurnedSensor(CellId cell, double angle_rad) {
  return makeFinding(FindingCode::TurnedSensor,
                     message("Cell {} reads as if it were turned by {} degrees against its neighbours: it is mounted "
                             "otherwise, or its axes are not as in the cell model. It is placed through its links.",
                             cell, Number{toDegrees(angle_rad), 0}),
                     {cell});
}

/// Adds what a suspect asks for.
void add(const SkinLinks& skin, const PatchSolver& patch, const AttitudeSuspect& suspect, Explanation& found) {
  const SkinGraph& graph = skin.graph();
  const auto id = [&](std::size_t cell) { return graph.cells()[cell].id; };
  switch (suspect.kind) {
    case AttitudeSuspect::Kind::Patch:
      found.remarks.push_back(describeContradiction(skin, patch, suspect.angle_rad));
      return;
    case AttitudeSuspect::Kind::Link: {
      const GraphLink& link = graph.links()[suspect.link];
      found.findings.push_back(describeUnexpectedAngle(suspect.angle, graph.sourceEnd(link), graph.targetEnd(link),
                                                       suspect.angle_rad, suspect.lowest_rad, suspect.highest_rad));
      found.links[suspect.angle].push_back(suspect.link);
      return;
    }
    case AttitudeSuspect::Kind::Swapped:
      found.findings.push_back(describeSwap(id(suspect.cell), id(suspect.other)));
      found.cells.insert(found.cells.end(), {suspect.cell, suspect.other});
      return;
    case AttitudeSuspect::Kind::Cell:
    case AttitudeSuspect::Kind::Moved:
      break;
  }
  if (hasTooFewPoses(skin, suspect.cell)) {
    found.remarks.push_back(describeSuspiciousSensor(skin, suspect.cell));
    return;
  }
  found.findings.push_back(suspect.kind == AttitudeSuspect::Kind::Moved
                               ? describeMovedCell(skin, suspect.cell, suspect.pose, suspect.angle_rad)
                               : describeTurnedSensor(id(suspect.cell), suspect.angle_rad));
  found.cells.push_back(suspect.cell);
}

class Attitudes {
 public:
  [[nodiscard]] std::optional<Explanation> operator()(const Estimate& estimate) {
    constexpr int kRounds = 3;  // what a first search leaves is rare; each costs a solve
    if (rounds_ == kRounds) return std::nullopt;
    Explanation found;
    if (!searched_) contradicting_.clear();  // patches may be others than at the last look
    for (const PatchSolver& patch : estimate.patches()) {
      const bool is_tree = patch.joint() == nullptr;
      if (patch.cells().size() < 2 || (searched_ && !is_tree)) continue;
      look(estimate.skin(), patch, is_tree, found);
    }
    // Where only swings are taken out, the next look does not search for faults again: this one knew of the swings.
    searched_ = found.links.empty() && found.cells.empty();
    if (found.excludes()) ++rounds_;
    return found.empty() ? std::nullopt : std::optional(std::move(found));
  }

 private:
  void look(const SkinLinks& skin, const PatchSolver& patch, bool is_tree, Explanation& found) {
    const std::vector<SE3> placements = placementsOf(patch);
    std::vector<PatchForce> forces = forcesOn(skin, patch, placements);
    if (seesOneLine(forces)) return;
    OwnAttitudes own =
        findOwnAttitudes(skin, patch.cells(), std::move(forces), placements, is_tree ? nullptr : &patch.joint()->lot());
    bool is_faulty = false;
    if (!searched_) {
      // Only of a tree they are needed once more.
      const std::vector<AttitudeSuspect> suspects =
          findAttitudeSuspects(skin, patch.cells(), is_tree ? own : std::move(own));
      const auto fits_no_surface = [](const AttitudeSuspect& suspect) {
        return suspect.kind == AttitudeSuspect::Kind::Patch;
      };
      if (std::ranges::any_of(suspects, fits_no_surface)) contradicting_.insert(patch.cells().front());
      const std::size_t before = found.findings.size();
      for (const AttitudeSuspect& suspect : suspects) add(skin, patch, suspect, found);
      is_faulty = found.findings.size() > before;
    }
    // What is no part of the skin must not tell how it was turned. The paper's own way takes readings as they are.
    if (!is_tree || is_faulty || contradicting_.contains(patch.cells().front())) return;
    if (skin.options().centring == Centring::Off) return;
    std::ranges::move(swingsOf(skin.table(), patch.cells(), placements, own), std::back_inserter(found.corrections));
  }

  int rounds_ = 0;
  bool searched_ = false;                // no faults are left to be found
  std::set<std::size_t> contradicting_;  // cells of patches that fit no surface
};

}  // namespace

Explainer makeAttitudeExplainer() { return {Estimate::Stage::Patches, Attitudes()}; }

}  // namespace hexoderm
