#include "hexoderm/reconstruction/links/tree_placement.h"

namespace hexoderm {
namespace {

/// Errors carried from a cell to its children, all in the patch frame. With e_k the attitude error of cell k and k_j
/// the elastomer's part on link j, the position error of cell n is
///   u_n - e_n x b_n - e_o x (t_n - f_n) + tau_n + link errors,
/// b_n: from n's centre to its incoming link point, f_n: the first port vector of its branch.
struct Carried {
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d u_covariance = Eigen::Matrix3d::Zero();  ///< of u_n, from the cells strictly between origin and n
  Matrix6d prior_covariance = Matrix6d::Zero();            ///< of (tau_n, kappa_n)
  double links = 0;
};

}  // namespace

std::vector<TreePlacement> placeAlongTree(const SkinGraph& graph, const CellModel& model, const ShortestPaths& paths,
                                          const std::vector<EdgeRotation>& edges,
                                          const std::vector<Eigen::Matrix3d>& attitude_covariance) {
  const auto place = [&graph](std::size_t cell) { return graph.cells()[cell].place; };
  std::vector<TreePlacement> placements(paths.order.size());
  std::vector<Carried> carried(paths.order.size());
  const std::size_t origin = place(paths.root);
  const Eigen::Matrix3d origin_covariance = attitude_covariance[origin];

  for (const std::size_t cell : paths.order) {
    if (cell == paths.root) continue;
    const std::size_t n = place(cell);
    const std::size_t c = place(paths.predecessor[n]);
    const GraphLink& link = graph.links()[paths.link[n]];
    const EdgeRotation& edge = edges[paths.link[n]];
    const bool forward = place(link.source) == c;
    const Port& port_c = model.port(forward ? link.source_port : link.target_port);
    const Port& port_n = model.port(forward ? link.target_port : link.source_port);
    // The reverse edge is exactly the transpose, never estimated twice.
    const Eigen::Matrix3d R_c_n = forward ? edge.R_c_n : Eigen::Matrix3d(edge.R_c_n.transpose());

    const SE3& T_o_c = placements[c].T_o_u;
    const SE3 T_o_n = T_o_c * linkTransform(R_c_n, port_c, port_n);
    placements[n].T_o_u = T_o_n;

    const Carried& before = carried[c];
    Carried& now = carried[n];
    const Eigen::Vector3d a = T_o_c.R * port_c.vector_m;
    now.b = T_o_n.R * port_n.vector_m;
    now.first = c == origin ? a : before.first;
    now.links = before.links + 1;
    if (c != origin) {
      const Eigen::Matrix3d lever = skew(a - before.b);
      const Eigen::Matrix3d own = T_o_c.R * attitude_covariance[c] * T_o_c.R.transpose();
      now.u_covariance = before.u_covariance + lever * own * lever.transpose();
    }
    // kappa_n = kappa_c + k;  tau_n = tau_c + kappa_c x (a - b) - k x b.
    Matrix6d F = Matrix6d::Identity();
    F.topRightCorner<3, 3>() = -skew(a - now.b);
    Eigen::Matrix<double, 6, 3> G;
    G << skew(now.b), Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d R_o_source = placements[place(link.source)].T_o_u.R;
    const Eigen::Matrix3d prior = R_o_source * edge.prior_part * R_o_source.transpose();
    now.prior_covariance = F * before.prior_covariance * F.transpose() + G * prior * G.transpose();

    const Eigen::Matrix3d own = T_o_n.R * attitude_covariance[n] * T_o_n.R.transpose();
    const Eigen::Matrix3d lever_n = skew(now.b);                // -e_n x b_n = [b]x e_n
    const Eigen::Matrix3d lever_o = skew(T_o_n.t - now.first);  // -e_o x (t - f) = [t - f]x e_o
    const double link_variance = now.links * model.link_sigma_m * model.link_sigma_m;
    Matrix6d left = now.prior_covariance;
    left.topLeftCorner<3, 3>() += now.u_covariance + lever_n * own * lever_n.transpose() +
                                  lever_o * origin_covariance * lever_o.transpose() +
                                  link_variance * Eigen::Matrix3d::Identity();
    left.topRightCorner<3, 3>() += lever_n * own - lever_o * origin_covariance;
    left.bottomLeftCorner<3, 3>() = left.topRightCorner<3, 3>().transpose().eval();
    left.bottomRightCorner<3, 3>() += own + origin_covariance;

    // The error was a left one in the patch frame; the file's is a right one in the cell frame.
    Matrix6d to_right = Matrix6d::Identity();
    to_right.bottomRightCorner<3, 3>() = T_o_n.R.transpose();
    const Matrix6d covariance = to_right * left * to_right.transpose();
    placements[n].covariance = (covariance + covariance.transpose()) / 2;
  }
  return placements;
}

}  // namespace hexoderm
