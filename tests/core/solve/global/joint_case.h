#pragma once

// Problems for the joint estimate with their truth, in memory: of simulated skins, or of cells that obey the link model
// and readings that obey the sensor model exactly.

#include "hexoderm/base/units.h"
#include "tests/support/independent_chips.h"
#include "tests/support/normal_draw.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/testing.h"

#include "hexoderm/solve/global/global_cost.h"

namespace hexoderm {

inline const GapShare kPivotGap{0, std::nullopt};
inline const GapShare kArcGap{1, std::nullopt};
inline const GapShare kFitGap{0.5, 0.5};

inline const char* nameOf(const GapShare& gap) {
  if (gap.sigma) return "fit";
  return gap.mean == 0 ? "pivot" : "arc";
}

struct GlobalCase {
  explicit GlobalCase(CellModel cell_model) : model(std::make_shared<const CellModel>(std::move(cell_model))) {
    problem.model = model.get();
    problem.link_sigma_m = model->link_sigma_m;
  }
  std::shared_ptr<const CellModel> model;
  GlobalProblem problem;
  GlobalState truth;
};

inline GlobalLink makeLink(const CellModel& model, std::size_t c, std::uint32_t port_c, std::size_t n,
                           std::uint32_t port_n) {
  const Port& source = model.port(PortNumber(port_c));
  const Port& target = model.port(PortNumber(port_n));
  return {c, n, source.vector_m, target.vector_m, nominalAlignment(source, target)};
}

inline Eigen::Vector3d middleOf(const std::vector<SE3>& cells) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const SE3& cell : cells) middle += cell.t / static_cast<double>(cells.size());
  return middle;
}

/// Adds a reading R^T f of every cell in every direction, as good as those of a hand-held skin.
inline void addExactReadings(GlobalCase& example, const std::vector<Eigen::Vector3d>& ups_o) {
  GlobalProblem& problem = example.problem;
  problem.poses = ups_o.size();
  problem.readings.assign(example.truth.cells.size(), {});
  for (std::size_t cell = 0; cell < example.truth.cells.size(); ++cell) {
    const Eigen::Matrix3d R_a_o =
        example.model->accelerometer.T_u_a.R.transpose() * example.truth.cells[cell].R.transpose();
    for (std::size_t pose = 0; pose < ups_o.size(); ++pose) {
      problem.readings[cell].push_back({pose, R_a_o * ups_o[pose].normalized(), 1e-5});
    }
  }
  for (const Eigen::Vector3d& up : ups_o) {
    example.truth.force_o.push_back(up.normalized());
    example.truth.acceleration_o.push_back(Eigen::Vector3d::Zero());
  }
}

/// Placement of the cell n that is turned by R_c_n, by its link: the closure of GlobalProblem, met exactly.
inline SE3 placeByLink(const SE3& T_o_c, const GlobalLink& link, const Eigen::Matrix3d& R_c_n, double share) {
  const Eigen::Vector3d u_c = link.p_c.normalized();
  const Eigen::Vector3d u_n = R_c_n * link.p_n.normalized();
  const double a = angleBetween(u_c, -u_n) / 2;
  const double e = (link.p_c.norm() + link.p_n.norm()) / 2;
  const Eigen::Vector3d m = (u_c - u_n).normalized();
  return T_o_c * SE3{R_c_n, link.p_c + share * 2 / 3 * e * a * a * m - R_c_n * link.p_n};
}

/// X17, its cells in the order of PinJointedSkin's bentX17(), every link bent, twisted and yawed at random.
inline GlobalCase exactX17(CellModel model, double share, double bend_sigma_rad, double twist_sigma_rad,
                           double yaw_sigma_rad, std::uint64_t seed) {
  GlobalCase example(std::move(model));
  test::NormalDraw draw(seed);
  example.truth.cells = {SE3()};
  const std::pair<std::uint32_t, std::uint32_t> arms[] = {{1, 4}, {4, 1}, {2, 3}, {3, 2}};
  for (const auto& [out, in] : arms) {
    std::size_t from = 0;
    for (int k = 0; k < 4; ++k) {
      const std::size_t next = example.truth.cells.size();
      const GlobalLink link = makeLink(*example.model, from, out, next, in);
      const double bend = bend_sigma_rad * draw.normal();
      const double twist = twist_sigma_rad * draw.normal();
      const Eigen::Vector3d angles(twist, bend, yaw_sigma_rad * draw.normal());
      const Eigen::Matrix3d R_c_n = expSO3(linkAxes({PortNumber(), link.p_c}) * angles) * link.R_nom;
      example.truth.cells.push_back(placeByLink(example.truth.cells[from], link, R_c_n, share));
      example.problem.links.push_back(link);
      from = next;
    }
  }
  example.truth.middle_o = middleOf(example.truth.cells);
  example.truth.gap_share = share;
  return example;
}

/// Eight cells, bent by 45 degrees from one to the next, which close to a ring.
inline GlobalCase exactRing(CellModel model, double share) {
  GlobalCase example(std::move(model));
  constexpr std::size_t kCells = 8;
  example.truth.cells = {SE3()};
  for (std::size_t k = 0; k < kCells; ++k) {
    const GlobalLink link = makeLink(*example.model, k, 2, (k + 1) % kCells, 3);
    example.problem.links.push_back(link);
    if (k + 1 == kCells) break;
    const Eigen::Vector3d bend = 45 * kDegree * Eigen::Vector3d::UnitZ().cross(link.p_c.normalized());
    example.truth.cells.push_back(placeByLink(example.truth.cells[k], link, expSO3(bend) * link.R_nom, share));
  }
  example.truth.middle_o = middleOf(example.truth.cells);
  example.truth.gap_share = share;
  return example;
}

/// A simulated skin in `poses` scripted poses. The directions of `truth` are those asked for; a hand misses them.
inline GlobalCase simulatedCase(const SimulatedSkinOptions& options, std::size_t poses, const GapShare& gap,
                                const CellModel& model = builtInCellModel("hex-bma150")) {
  SimulatedSkin skin(model, options);
  GlobalCase example(skin.model());
  GlobalProblem& problem = example.problem;
  const std::vector<TrueCell>& truth = skin.truth();
  problem.origin = truth.size() / 3;
  problem.gap = gap;
  const SE3 T_o_b = truth[problem.origin].T_b_u.inverse();
  for (const TrueCell& cell : truth) example.truth.cells.push_back(T_o_b * cell.T_b_u);
  example.truth.middle_o = middleOf(example.truth.cells);
  example.truth.gap_share = gap.mean;
  for (const CellReport& report : skin.neighbors()) {
    for (const NeighborReport& neighbor : report.neighbors) {
      if (neighbor.cell < report.id) continue;
      problem.links.push_back(makeLink(*example.model, report.id.value() - 1, neighbor.port.value(),
                                       neighbor.cell.value() - 1, neighbor.cell_port->value()));
    }
  }
  const std::vector<Eigen::Vector3d> ups_b = scriptedUpDirections(poses);
  const Session session = simulateSession(skin, poses);
  problem.poses = poses;
  problem.readings.resize(truth.size());
  const Eigen::Matrix3d R_a_u = example.model->accelerometer.T_u_a.R.transpose();
  for (std::size_t pose = 0; pose < poses; ++pose) {
    for (const GravitySample& sample : session.poses()[pose].capture->samples) {
      problem.readings[sample.cell.value() - 1].push_back({pose, R_a_u * sample.mean_g, 1e-5});
    }
    example.truth.force_o.push_back(T_o_b.R * ups_b[pose]);
    example.truth.acceleration_o.push_back(Eigen::Vector3d::Zero());
  }
  return example;
}

/// A state some way off, of the unknowns that are free. Forces turn by about as much as cells.
inline GlobalState perturbed(const GlobalProblem& problem, const GlobalState& state, double turn_rad, double shift_m,
                             std::uint64_t seed) {
  test::NormalDraw draw(seed);
  const BorderLayout layout(problem);
  Eigen::VectorXd cells(static_cast<Eigen::Index>(6 * problem.cellCount()));
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    cells.segment<3>(static_cast<Eigen::Index>(6 * cell)) = shift_m * draw.vector();
    cells.segment<3>(static_cast<Eigen::Index>(6 * cell + 3)) = turn_rad * draw.vector();
  }
  Eigen::VectorXd border(layout.size());
  for (std::size_t pose = 0; pose < problem.poses; ++pose) {
    border.segment<3>(layout.force(pose)) = turn_rad * draw.vector();
    if (problem.accelerations) border.segment<3>(layout.acceleration(pose)) = 3 * draw.vector();
  }
  if (problem.gap.sigma) border[layout.gapShare()] = 0.3 * draw.normal();
  if (problem.estimatesLot()) {
    border.segment<3>(layout.lot()) = 0.03 * draw.vector();
    border[layout.lot() + 3] = 0.1 * draw.normal();
  }
  return moved(problem, state, cells, border);
}

}  // namespace hexoderm
