#include "hexoderm/solve/faults/turn_map.h"

#include "hexoderm/base/median.h"
#include "hexoderm/base/units.h"
#include "hexoderm/skin/breadth_first.h"
#include "hexoderm/skin/skin_graph_boost.h"

#include <Eigen/LU>
#include <cmath>

namespace hexoderm {

TurnMap fitTurnMap(std::span<const DirectedTurn> turns) {
  constexpr double kFarOff = 75 * kDegree;
  constexpr int kRounds = 3;
  struct Flat {
    Eigen::Vector3d turn;  ///< in the sheet laid flat
    Eigen::Vector2d along;
  };
  TurnMap map;
  std::vector<Flat> used;
  for (const DirectedTurn& turn : turns) {
    if (turn.turn_rad.norm() > kFarOff) continue;
    const Eigen::Vector2d along(std::cos(turn.heading_rad), std::sin(turn.heading_rad));
    const Eigen::Vector2d across(-along.y(), along.x());
    Flat flat{Eigen::Vector3d::Zero(), along};
    flat.turn << turn.turn_rad.x() * along + turn.turn_rad.y() * across, turn.turn_rad.z();
    used.push_back(flat);
  }
  if (turns.empty()) return map;
  map.far_off = 1 - static_cast<double>(used.size()) / static_cast<double>(turns.size());
  if (used.size() < 3) return map;
  Eigen::Matrix<double, 3, 2> B = Eigen::Matrix<double, 3, 2>::Zero();
  Eigen::Matrix2d directions = Eigen::Matrix2d::Zero();
  bool is_line = false;
  for (int round = 0;; ++round) {
    Eigen::Matrix<double, 3, 2> moments = Eigen::Matrix<double, 3, 2>::Zero();
    directions.setZero();
    for (const Flat& link : used) {
      moments += link.turn * link.along.transpose();
      directions += link.along * link.along.transpose();
    }
    const double trace = directions.trace();
    is_line = directions.determinant() < 0.01 * trace * trace;
    // Of links that all go one way nothing is known across it.
    B = moments * (directions + 1e-6 * trace * Eigen::Matrix2d::Identity()).inverse();
    if (round == kRounds) break;
    std::vector<double> off;
    for (const Flat& link : used) off.push_back((link.turn - B * link.along).norm());
    const double limit = 4 * median(off) + 2 * kDegree;
    std::erase_if(used, [&](const Flat& link) { return (link.turn - B * link.along).norm() > limit; });
  }
  constexpr double kUsualScatter = 2 * kDegree;
  constexpr double kWeightOfUsual = 6;
  double squared = kWeightOfUsual * kUsualScatter * kUsualScatter;
  for (const Flat& link : used) squared += (link.turn - B * link.along).squaredNorm();
  const auto count = static_cast<double>(used.size());
  const double variance = squared / (3 * count);
  // S = J^T B.
  const double antisymmetric = is_line ? 0 : (B(1, 1) + B(0, 0)) / 2;
  const Eigen::Vector2d yaw = B.row(2).transpose();
  const double unlike = yaw.dot(directions * yaw) + antisymmetric * antisymmetric * count;
  map.bend_rad =
      (B(1, 0) * directions(0, 0) - B(0, 1) * directions(1, 1) + (B(1, 1) - B(0, 0)) * directions(0, 1)) / count;
  map.bend_sigma_rad = std::sqrt(variance / count);
  map.unlike_rad = std::sqrt(unlike / count);
  map.deviate = std::sqrt(unlike / variance);
  return map;
}

double headingOf(const Port& port) { return std::atan2(port.vector_m.y(), port.vector_m.x()); }

std::vector<double> flatHeadings(const SkinLinks& skin, std::size_t patch,
                                 const std::function<double(const Port&)>& of) {
  const SkinGraph& graph = skin.graph();
  const PatchGraph view{&graph, patch};
  std::vector<double> heading(view.cells().size(), 0);
  const auto placeOf = [&](std::size_t cell) { return graph.cells()[cell].place; };
  BreadthFirst(view).searchFrom(view.cells().front(), [&](const SkinEdge& edge) {
    const GraphLink& link = graph.links()[edge.link];
    const double yaw = of(skin.sourcePort(link)) + kPi - of(skin.targetPort(link));
    heading[placeOf(target(edge, view))] = heading[placeOf(edge.from)] + (link.source == edge.from ? yaw : -yaw);
    return true;
  });
  return heading;
}

}  // namespace hexoderm
