#include "hexoderm/solve/tree/tree_placement.h"

#include "tests/support/neighbor_lists.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

/// The definition: every error of its own carried to a cell by its own 6 x 3 matrix, and their sum of squares.
///   left error of n: rotation e_n - e_o + sum_j k_j, position u_n - e_n x b_n - e_o x (t_n - f_n) + tau_n.
TEST(TreePlacement, CovarianceIsThatOfAllErrorsCarriedToTheCell) {
  const CellModel model = builtInCellModel("hex-bma150");
  // A chain with a branch: 1 - 2 - 3 - 4 and 3 - 5, with the origin in 2.
  NeighborList list = test::listOfCells(5);
  for (const std::uint32_t id : {1U, 2U, 3U}) test::joinCells(list, id, 1, id + 1, 4);
  test::joinCells(list, 3, 2, 5, 3);
  const SkinGraph graph(model, list);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto drawCovariance = [&](double scale) {
    const Eigen::Matrix3d root = Eigen::Matrix3d::NullaryExpr([&] { return scale * normal(random); });
    return Eigen::Matrix3d(root * root.transpose());
  };
  std::vector<EdgeRotation> edges(graph.links().size());
  std::vector<double> weights(edges.size(), 1);
  for (EdgeRotation& edge : edges) {
    edge.R_c_n = expSO3(Eigen::Vector3d::NullaryExpr([&] { return normal(random); }));
    edge.prior_part = drawCovariance(0.02);
  }
  std::vector<Eigen::Matrix3d> attitude;
  for (std::size_t cell = 0; cell < 5; ++cell) attitude.push_back(drawCovariance(0.05));
  const ShortestPaths paths = findShortestPaths(graph, weights, 1);
  const std::vector<TreePlacement> placed = placeAlongTree(graph, model, paths, edges, attitude, {0.5, 0.7});

  EXPECT_TRUE(placed[1].covariance.isZero());
  for (const std::size_t cell : {0U, 2U, 3U, 4U}) {
    std::vector<std::size_t> path = {cell};
    while (path.back() != 1) path.push_back(paths.predecessor[path.back()]);
    std::ranges::reverse(path);
    const SE3& T_o_n = placed[cell].T_o_u;
    Matrix6d left = Matrix6d::Zero();
    const auto add = [&](const Eigen::Matrix<double, 6, 3>& J, const Eigen::Matrix3d& R, const Eigen::Matrix3d& own) {
      left += J * R * own * R.transpose() * J.transpose();
    };
    const auto portsOf =
        [&](std::size_t k) {  // of the link path[k - 1] - path[k]: its ends' vectors in the patch frame
          const GraphLink& link = graph.links()[paths.link[path[k]]];
          const bool forward = link.target == path[k];
          const Eigen::Vector3d at_c = model.port(forward ? link.source_port : link.target_port).vector_m;
          const Eigen::Vector3d at_n = model.port(forward ? link.target_port : link.source_port).vector_m;
          return std::pair<Eigen::Vector3d, Eigen::Vector3d>(placed[path[k - 1]].T_o_u.R * at_c,
                                                             placed[path[k]].T_o_u.R * at_n);
        };
    Eigen::Matrix<double, 6, 3> J;
    // The origin's attitude, and the cell's own.
    J << skew(T_o_n.t - portsOf(1).first), -Eigen::Matrix3d::Identity();
    add(J, Eigen::Matrix3d::Identity(), attitude[1]);
    J << skew(portsOf(path.size() - 1).second), Eigen::Matrix3d::Identity();
    add(J, T_o_n.R, attitude[cell]);
    for (std::size_t k = 1; k < path.size(); ++k) {
      // The attitude of a cell between: its two ports lie otherwise.
      if (k + 1 < path.size()) {
        J << skew(portsOf(k + 1).first - portsOf(k).second), Eigen::Matrix3d::Zero();
        add(J, placed[path[k]].T_o_u.R, attitude[path[k]]);
      }
      // A bend of the link turns all that comes after it about the link's point.
      const Eigen::Vector3d point = placed[path[k]].T_o_u.t + portsOf(k).second;
      J << -skew(T_o_n.t - point), Eigen::Matrix3d::Identity();
      const GraphLink& link = graph.links()[paths.link[path[k]]];
      add(J, placed[link.source].T_o_u.R, edges[paths.link[path[k]]].prior_part);
    }
    left.topLeftCorner<3, 3>() +=
        static_cast<double>(path.size() - 1) * model.link_sigma_m * model.link_sigma_m * Eigen::Matrix3d::Identity();
    // All links open by the same share of their arcs, of which 0.5 +- 0.7 is known.
    Eigen::Vector3d arcs_m = Eigen::Vector3d::Zero();
    for (std::size_t k = 1; k < path.size(); ++k) {
      const auto [at_c, at_n] = portsOf(k);
      arcs_m += arcOpening_m(at_c.normalized(), at_n.normalized(), (at_c.norm() + at_n.norm()) / 2);
    }
    ASSERT_GT(arcs_m.norm(), 1e-6);
    left.topLeftCorner<3, 3>() += (0.5 * 0.5 + 0.7 * 0.7) * arcs_m * arcs_m.transpose();
    Matrix6d to_right = Matrix6d::Identity();
    to_right.bottomRightCorner<3, 3>() = T_o_n.R.transpose();
    const Matrix6d expected = to_right * left * to_right.transpose();
    EXPECT_LT((placed[cell].covariance - expected).norm(), 1e-12 * expected.norm()) << "cell " << cell;
  }
}

}  // namespace
}  // namespace hexoderm
