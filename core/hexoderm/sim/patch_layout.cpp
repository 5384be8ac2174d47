#include "hexoderm/sim/patch_layout.h"

#include "hexoderm/base/error.h"
#include "hexoderm/skin/breadth_first.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <boost/functional/hash.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/range/iterator_range.hpp>
#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>
#include <unordered_map>

namespace hexoderm {
namespace {

using Matrix43 = Eigen::Matrix<double, 4, 3>;

/// A step this short changes nothing that matters: jitter is 200 times larger.
constexpr double kSmallStep_m = 1e-6;
/// Rms misfit of a link below which the sheet as laid is exact: planes, cylinders.
constexpr double kExact_m = 1e-10;
/// Steps need not be exact, only downhill: sparse factorisation of 100,000 cells would take much longer.
constexpr double kStepTolerance = 1e-3;
constexpr int kMaxStepIterations = 1000;
/// A step that lowers the cost by less than this part is the last one.
constexpr double kSettled = 1e-4;

/// The world's view of one end of a link.
struct End {
  Eigen::Vector3d port;      ///< extended port vector
  Eigen::Vector3d outward;   ///< its direction
  Eigen::Vector3d sideways;  ///< normal x outward
  Eigen::Vector3d normal;
  Eigen::Matrix<double, 3, 2> axes;  ///< the cell's x and y
  Eigen::Matrix<double, 3, 2> tilt;  ///< change of the normal by a shift along x and y
};

End lookAt(const Port& port, const SE3& cell, const Surface& surface) {
  End end;
  end.port = cell.R * port.vector_m;
  end.outward = end.port.normalized();
  end.normal = cell.R.col(2);
  end.sideways = end.normal.cross(end.outward);
  end.axes = cell.R.leftCols<2>();
  end.tilt = surface.weingarten(cell.t) * end.axes;
  return end;
}

/// Violation of a link's law by two cells on the surface, metres, with derivatives by each cell's shift along its own x
/// and y axis (metres) and its turn about z (times `lever_m`, so metres too). Bend: the vector between the ends of both
/// extended port vectors, eq. (2), and the yaw times the rms half width of the side. Surface: at either end, the
/// bearing of the other cell less the extended pitch along the port.
struct LinkMisfit {
  Eigen::Vector4d value;
  Eigen::Matrix<double, 4, 3> by_source;
  Eigen::Matrix<double, 4, 3> by_target;
};

class SheetRelaxation {
 public:
  SheetRelaxation(const PatchPlan& plan, const Surface& surface, LinkLaw law)
      : plan_(plan),
        surface_(surface),
        law_(law),
        lever_m_(plan.links.empty() ? 1 : reachOf(plan.links.front().source_port)) {}

  [[nodiscard]] LinkMisfit misfit(const PlannedLink& link, const SE3& source, const SE3& target) const {
    return law_ == LinkLaw::Bend ? bendMisfit(link, source, target) : surfaceMisfit(link, source, target);
  }

  /// The cell moved along the surface by step (x, y, yaw times lever).
  [[nodiscard]] SE3 moved(const SE3& T_b_u, const Eigen::Vector3d& step) const {
    SE3 T;
    T.t = surface_.project(T_b_u.t + T_b_u.R.leftCols<2>() * step.head<2>());
    const double yaw = step.z() / lever_m_;
    const Eigen::Vector3d x = std::cos(yaw) * T_b_u.R.col(0) + std::sin(yaw) * T_b_u.R.col(1);
    const Eigen::Vector3d z = surface_.normal(T.t);
    T.R.col(0) = (x - z * z.dot(x)).normalized();
    T.R.col(1) = z.cross(T.R.col(0));
    T.R.col(2) = z;
    return T;
  }

  /// Fits one cell to those of its links whose other ends are laid.
  void fitCell(std::size_t cell, std::span<const PlannedLink> links, std::vector<SE3>& cells) const {
    // A sheet that grows cell by cell amplifies every turn of a cell; a stiff yaw keeps it from folding.
    const Eigen::Vector4d weights = law_ == LinkLaw::Bend ? Eigen::Vector4d(1, 1, 1, 30) : Eigen::Vector4d::Ones();
    for (int iteration = 0; iteration < 10; ++iteration) {
      Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
      Eigen::Vector3d g = Eigen::Vector3d::Zero();
      for (const PlannedLink& link : links) {
        const LinkMisfit m = misfit(link, cells[link.source], cells[link.target]);
        const Matrix43& J = link.source == cell ? m.by_source : m.by_target;
        H += J.transpose() * weights.asDiagonal() * J;
        g += J.transpose() * weights.cwiseProduct(m.value);
      }
      const Eigen::Vector3d step = H.ldlt().solve(-g);
      // A cell that would have to jump has neighbours that contradict each other: relaxation sorts that out for all.
      if (!step.allFinite() || step.norm() > lever_m_) return;
      cells[cell] = moved(cells[cell], step);
      if (step.norm() < 1e-14) return;
    }
  }

  /// Fits all cells to all links: damped Gauss-Newton, each step by conjugate gradients, whose shortest solution keeps
  /// the patch from wandering on a sphere. On a surface of changing curvature (torus, cone) the patch may slide to a
  /// place that fits better.
  void relax(std::vector<SE3>& cells) const {
    using Sparse = Eigen::SparseMatrix<double>;
    const auto unknowns = static_cast<Eigen::Index>(3 * cells.size());
    double current = cost(cells);
    if (current < kExact_m * kExact_m * static_cast<double>(plan_.links.size())) return;
    double damping = 1e-9;
    for (int iteration = 0; iteration < 50; ++iteration) {
      std::vector<Eigen::Triplet<double>> entries;
      entries.reserve(36 * plan_.links.size() + 3 * cells.size());
      Eigen::VectorXd g = Eigen::VectorXd::Zero(unknowns);
      const auto add = [&](std::size_t a, std::size_t b, const Eigen::Matrix3d& block) {
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) {
            entries.emplace_back(static_cast<int>(3 * a) + i, static_cast<int>(3 * b) + j, block(i, j));
          }
        }
      };
      for (const PlannedLink& link : plan_.links) {
        const LinkMisfit m = misfit(link, cells[link.source], cells[link.target]);
        add(link.source, link.source, m.by_source.transpose() * m.by_source);
        add(link.target, link.target, m.by_target.transpose() * m.by_target);
        const Eigen::Matrix3d cross = m.by_source.transpose() * m.by_target;
        add(link.source, link.target, cross);
        add(link.target, link.source, cross.transpose());
        g.segment<3>(static_cast<Eigen::Index>(3 * link.source)) += m.by_source.transpose() * m.value;
        g.segment<3>(static_cast<Eigen::Index>(3 * link.target)) += m.by_target.transpose() * m.value;
      }
      for (int k = 0; k < unknowns; ++k) entries.emplace_back(k, k, damping);
      Sparse H(unknowns, unknowns);
      H.setFromTriplets(entries.begin(), entries.end());

      Eigen::ConjugateGradient<Sparse, Eigen::Lower | Eigen::Upper> solver;
      solver.setTolerance(kStepTolerance);
      solver.setMaxIterations(kMaxStepIterations);
      solver.compute(H);
      const Eigen::VectorXd step = solver.solve(-g);
      if (!step.allFinite()) return;
      if (step.cwiseAbs().maxCoeff() < kSmallStep_m) return;

      std::vector<SE3> candidate(cells.size());
      for (std::size_t k = 0; k < cells.size(); ++k) {
        candidate[k] = moved(cells[k], step.segment<3>(static_cast<Eigen::Index>(3 * k)));
      }
      const double next = cost(candidate);
      if (next < current) {
        const bool settled = current - next < kSettled * current;
        cells = std::move(candidate);
        current = next;
        damping = std::max(damping / 10, 1e-9);
        if (settled) return;
      } else {
        damping = std::max(damping * 100, 1e-4);
        if (damping > 1e3) return;
      }
    }
  }

 private:
  [[nodiscard]] LinkMisfit bendMisfit(const PlannedLink& link, const SE3& source, const SE3& target) const {
    // A hexagon's side is as long as its centre-to-corner distance; the rms distance from the side's middle is
    // side / sqrt(12), with side = 2 / sqrt(3) times centre to side: a third of it.
    const double half_width = lever_m_ / 3;
    const End s = lookAt(link.source_port, source, surface_);
    const End t = lookAt(link.target_port, target, surface_);
    LinkMisfit misfit;
    misfit.value.head<3>() = source.t + s.port - target.t - t.port;
    misfit.value(3) =
        half_width / 2 * (t.outward.dot(s.normal.cross(s.outward)) - s.outward.dot(t.normal.cross(t.outward)));
    const auto derivative = [&](const End& own, const End& other, double sign) {
      Matrix43 J;
      J.topLeftCorner<3, 2>() = own.axes - own.normal * (own.port.transpose() * own.tilt);
      J.topRightCorner<3, 1>() = own.normal.cross(own.port) / lever_m_;
      for (int k = 0; k < 2; ++k) {
        const Eigen::Vector3d tilt = own.tilt.col(k);
        J(3, k) = half_width / 2 *
                  (other.outward.dot(tilt.cross(own.outward)) + tilt.dot(own.outward) * own.normal.dot(other.sideways));
      }
      J(3, 2) = -half_width / 2 * (other.outward.dot(own.outward) + own.sideways.dot(other.sideways)) / lever_m_;
      return Matrix43(sign * J);
    };
    misfit.by_source = derivative(s, t, 1);
    misfit.by_target = derivative(t, s, -1);
    return misfit;
  }
  [[nodiscard]] LinkMisfit surfaceMisfit(const PlannedLink& link, const SE3& source, const SE3& target) const {
    const End s = lookAt(link.source_port, source, surface_);
    const End t = lookAt(link.target_port, target, surface_);
    const double pitch = reachOf(link.source_port) + reachOf(link.target_port);
    const Eigen::Vector3d to_target = surface_.bearing(source.t, target.t);
    const Eigen::Vector3d to_source = surface_.bearing(target.t, source.t);
    LinkMisfit misfit;
    misfit.value.head<2>() = s.axes.transpose() * (to_target - pitch * s.outward);
    misfit.value.tail<2>() = t.axes.transpose() * (to_source - pitch * t.outward);

    // Parallel transport along the geodesic turns shifts of one end into the other's axes; between neighbours the
    // surface is taken as flat otherwise, which is second order in the pitch.
    const auto alongAndAcross = [](const End& end, const Eigen::Vector3d& bearing) {
      Eigen::Matrix2d frame;  // columns: along the geodesic away from this end, and to its left
      const Eigen::Vector3d along = bearing.normalized();
      frame.col(0) = end.axes.transpose() * along;
      frame.col(1) = end.axes.transpose() * end.normal.cross(along);
      return frame;
    };
    const Eigen::Matrix2d at_source = alongAndAcross(s, to_target);
    const Eigen::Matrix2d at_target = alongAndAcross(t, to_source);
    const Eigen::Matrix2d target_to_source = -at_source * at_target.transpose();
    const auto turned = [&](const Eigen::Vector2d& bearing) {  // a turn of the cell turns what it sees the other way
      return Eigen::Vector2d(Eigen::Vector2d(bearing.y(), -bearing.x()) / lever_m_);
    };
    misfit.by_source.setZero();
    misfit.by_target.setZero();
    misfit.by_source.topLeftCorner<2, 2>() = -Eigen::Matrix2d::Identity();
    misfit.by_source.topRightCorner<2, 1>() = turned(s.axes.transpose() * to_target);
    misfit.by_source.bottomLeftCorner<2, 2>() = target_to_source.transpose();
    misfit.by_target.topLeftCorner<2, 2>() = target_to_source;
    misfit.by_target.bottomLeftCorner<2, 2>() = -Eigen::Matrix2d::Identity();
    misfit.by_target.bottomRightCorner<2, 1>() = turned(t.axes.transpose() * to_source);
    return misfit;
  }
  [[nodiscard]] double cost(const std::vector<SE3>& cells) const {
    double sum = 0;
    for (const PlannedLink& link : plan_.links) {
      sum += misfit(link, cells[link.source], cells[link.target]).value.squaredNorm();
    }
    return sum;
  }

  const PatchPlan& plan_;
  const Surface& surface_;
  LinkLaw law_;
  double lever_m_;
};

/// The cells of a plan. An edge holds the number of its link; those of a cell come in the plan's order.
using PlanGraph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, std::size_t>;

PlanGraph graphOf(const PatchPlan& plan) {
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < plan.links.size(); ++k) {
    ends.emplace_back(plan.links[k].source, plan.links[k].target);
    ends.emplace_back(plan.links[k].target, plan.links[k].source);
    numbers.insert(numbers.end(), 2, k);
  }
  return {boost::edges_are_unsorted_multi_pass, ends.begin(), ends.end(), numbers.begin(), plan.cell_count};
}

/// Distance along the geodesic from one centre to the next.
double linkLength(const PlannedLink& link, LinkLaw law, const Surface& surface, const Eigen::Vector3d& from,
                  const Eigen::Vector3d& direction) {
  const double a = reachOf(link.source_port);
  const double b = reachOf(link.target_port);
  double length = a + b;
  if (law == LinkLaw::Surface) return length;
  const auto curvatureAt = [&](const GeodesicPoint& point) {
    return point.direction.dot(surface.weingarten(point.position) * point.direction);
  };
  // If the curvature changes on the way (cone, torus), the mean of both ends counts.
  for (int k = 0; k < 4; ++k) {
    const GeodesicPoint end = surface.walk(from, direction, length);
    const double curvature = (curvatureAt({from, direction}) + curvatureAt(end)) / 2;
    if (std::abs(curvature) * length < 1e-7) return a + b;
    length = (std::atan(curvature * a) + std::atan(curvature * b)) / curvature;
  }
  return length;
}

void requireRoom(const Surface& surface, const Eigen::Vector3d& position, double reach_m) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(surface.weingarten(position), Eigen::EigenvaluesOnly);
  const double sharpest = solver.eigenvalues().cwiseAbs().maxCoeff();
  if (!position.allFinite() || !(sharpest * reach_m < 1)) {
    throw InvalidArgument(message(
        "the surface is too small for these cells: where one is laid it is curved more sharply than the cell is wide"));
  }
}

/// Frame of the cell behind a link: entered through the target's port, which points back along the way.
SE3 cellAtEnd(const GeodesicPoint& end, const Eigen::Vector3d& normal, const Port& entered_by) {
  const Eigen::Vector3d back = -end.direction;
  const Eigen::Vector2d port = entered_by.vector_m.head<2>().normalized();
  const Eigen::Vector3d left = normal.cross(back);
  SE3 T;
  T.R.col(0) = port.x() * back - port.y() * left;
  T.R.col(1) = port.y() * back + port.x() * left;
  T.R.col(2) = normal;
  T.t = end.position;
  return T;
}

/// Two cells nearer than half a link lie on top of each other: the patch goes round the body and meets itself.
void requireNoOverlap(const std::vector<SE3>& cells, double closest_m) {
  using Box = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  std::unordered_multimap<Box, std::size_t, boost::hash<Box>> boxes;
  boxes.reserve(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Eigen::Vector3d box = (cells[k].t / closest_m).array().round();
    const auto at = [&](int axis, int by) { return static_cast<std::int64_t>(box[axis]) + by; };
    for (int near = 0; near < 27; ++near) {
      const Box beside(at(0, near / 9 - 1), at(1, near / 3 % 3 - 1), at(2, near % 3 - 1));
      const auto [first, last] = boxes.equal_range(beside);
      for (auto other = first; other != last; ++other) {
        if ((cells[k].t - cells[other->second].t).norm() >= closest_m) continue;
        throw InvalidArgument(
            message("the surface is too small for this patch: cells {} and {} would lie on top of each other",
                    other->second + 1, k + 1));
      }
    }
    boxes.emplace(Box(at(0, 0), at(1, 0), at(2, 0)), k);
  }
}

/// A closed ring's last link may be about as far apart as its others: 1 / 10 of the reach is half a gap in hex-bma150.
void requireClosed(const PatchPlan& plan, const std::vector<SE3>& cells) {
  const auto gapOf = [&](const PlannedLink& link) {
    return (cells[link.source] * link.source_port.vector_m - cells[link.target] * link.target_port.vector_m).norm();
  };
  const double gap = gapOf(*plan.closure);
  if (std::abs(gap - gapOf(plan.links.front())) > 0.1 * reachOf(plan.closure->source_port)) {
    throw InvalidArgument(
        message("the surface does not close this ring: its two ends would be {} mm apart; leave the surface out for a "
                "cylinder that closes it",
                Number{gap * 1000, 1}));
  }
}

}  // namespace

std::vector<SE3> layPatch(const PatchPlan& plan, const Surface& surface, LinkLaw law) {
  const PlanGraph graph = graphOf(plan);
  const auto leadingAway = [&](const PlanGraph::edge_descriptor& edge) {
    const PlannedLink& link = plan.links[graph[edge]];
    return link.source == source(edge, graph) ? link : reversed(link);
  };
  double reach = 0;
  for (const PlannedLink& link : plan.links) {
    reach = std::max({reach, reachOf(link.source_port), reachOf(link.target_port)});
  }
  std::vector<SE3> cells(plan.cell_count);
  std::vector<bool> laid(plan.cell_count, false);
  const SE3 middle = surface.middle();
  const Eigen::Vector3d turn(0, 0, plan.start_yaw_rad);
  cells[plan.start] = {middle.R * expSO3(turn), middle.t};
  laid[plan.start] = true;
  requireRoom(surface, middle.t, reach);

  const SheetRelaxation relaxation(plan, surface, law);
  std::vector<PlannedLink> known;
  BreadthFirst(graph).searchFrom(plan.start, [&](const PlanGraph::edge_descriptor& edge) {
    const PlannedLink link = leadingAway(edge);
    const SE3& from = cells[link.source];
    const Eigen::Vector3d direction = from.R.leftCols<2>() * link.source_port.vector_m.head<2>().normalized();
    const GeodesicPoint end = surface.walk(from.t, direction, linkLength(link, law, surface, from.t, direction));
    requireRoom(surface, end.position, reach);
    cells[link.target] = cellAtEnd(end, surface.normal(end.position), link.target_port);
    laid[link.target] = true;
    if (plan.has_loops) {
      known.clear();
      for (const auto& other : boost::make_iterator_range(out_edges(link.target, graph))) {
        if (laid[target(other, graph)]) known.push_back(leadingAway(other));
      }
      relaxation.fitCell(link.target, known, cells);
    }
    return true;
  });
  if (plan.has_loops) relaxation.relax(cells);
  if (cells.size() > 1) requireNoOverlap(cells, reach);  // a single cell has no links and thus no reach
  if (plan.closure) requireClosed(plan, cells);
  return cells;
}

}  // namespace hexoderm
