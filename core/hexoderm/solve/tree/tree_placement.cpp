#include "hexoderm/solve/tree/tree_placement.h"

namespace hexoderm {
namespace {

/// Errors carried from a cell to its children, all in the patch frame. With e_k the attitude error of cell k and k_j
/// the elastomer's part on link j, the position error of cell n is
///   u_n - e_n x b_n - e_o x (t_n - f_n) + tau_n + link errors,
/// b_n: from n's centre to its incoming link point, f_n: the first port vector of its branch.
struct Carried {
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d own = Eigen::Matrix3d::Zero();           ///< covariance of e_n
  Eigen::Matrix3d u_covariance = Eigen::Matrix3d::Zero();  ///< of u_n, from the cells strictly between origin and n
  Eigen::Matrix3d tau = Eigen::Matrix3d::Zero();           ///< covariance of tau_n,
  Eigen::Matrix3d tau_kappa = Eigen::Matrix3d::Zero();     ///< of tau_n with kappa_n,
  Eigen::Matrix3d kappa = Eigen::Matrix3d::Zero();         ///< and of kappa_n
  double links = 0;
  Eigen::Vector3d arcs_m = Eigen::Vector3d::Zero();  ///< how far t_n moves if the mould bends in arcs
};

/// [w]x M.
Eigen::Matrix3d crossed(const Eigen::Vector3d& w, const Eigen::Matrix3d& M) {
  Eigen::Matrix3d product;
  for (int k = 0; k < 3; ++k) product.col(k) = w.cross(M.col(k));
  return product;
}

/// [w]x M [w]x^T, for a symmetric M.
Eigen::Matrix3d crossedTwice(const Eigen::Vector3d& w, const Eigen::Matrix3d& M) {
  return crossed(w, crossed(w, M).transpose());
}

Eigen::Matrix3d rotated(const Eigen::Matrix3d& R, const Eigen::Matrix3d& covariance) {
  return R * covariance * R.transpose();
}

}  // namespace

std::vector<TreePlacement> placeAlongTree(const SkinGraph& graph, const CellModel& model, const ShortestPaths& paths,
                                          const std::vector<EdgeRotation>& edges,
                                          const std::vector<Eigen::Matrix3d>& attitude_covariance,
                                          const GapShare& gap) {
  const auto place = [&graph](std::size_t cell) { return graph.cells()[cell].place; };
  std::vector<TreePlacement> placements(paths.order.size());
  std::vector<Carried> carried(paths.order.size());
  const std::size_t origin = place(paths.root);
  const Eigen::Matrix3d origin_covariance = attitude_covariance[origin];
  const double mean_square_share = gap.mean * gap.mean + gap.sigma.value_or(0) * gap.sigma.value_or(0);

  for (const std::size_t cell : paths.order) {
    if (cell == paths.root) continue;
    const std::size_t n = place(cell);
    const std::size_t c = place(paths.predecessor[n]);
    const GraphLink& link = graph.links()[paths.link[n]];
    const EdgeRotation& edge = edges[paths.link[n]];
    const bool forward = link.target == cell;
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
    now.own = rotated(T_o_n.R, attitude_covariance[n]);
    if (c != origin) now.u_covariance = before.u_covariance + crossedTwice(a - before.b, before.own);

    // kappa_n = kappa_c + k;  tau_n = tau_c + kappa_c x (a - b) - k x b.
    const Eigen::Vector3d x = now.b - a;
    const Eigen::Matrix3d prior = rotated(forward ? T_o_c.R : T_o_n.R, edge.prior_part);
    const Eigen::Matrix3d mixed = crossed(x, before.tau_kappa.transpose());
    now.kappa = before.kappa + prior;
    now.tau_kappa = before.tau_kappa + crossed(x, before.kappa) + crossed(now.b, prior);
    now.tau = before.tau + mixed + mixed.transpose() + crossedTwice(x, before.kappa) + crossedTwice(now.b, prior);

    const Eigen::Vector3d lever_o = T_o_n.t - now.first;  // -e_o x (t - f) = [t - f]x e_o, and so with -e_n x b_n
    Eigen::Matrix3d position =
        now.tau + now.u_covariance + crossedTwice(now.b, now.own) + crossedTwice(lever_o, origin_covariance);
    position.diagonal().array() += now.links * model.link_sigma_m * model.link_sigma_m;
    if (mean_square_share > 0) {
      const double e_m = (port_c.vector_m.norm() + port_n.vector_m.norm()) / 2;
      now.arcs_m = before.arcs_m + arcOpening_m(a.normalized(), now.b.normalized(), e_m);
      position += mean_square_share * now.arcs_m * now.arcs_m.transpose();
    }
    const Eigen::Matrix3d mixed_left = now.tau_kappa + crossed(now.b, now.own) - crossed(lever_o, origin_covariance);
    const Eigen::Matrix3d rotation = now.kappa + now.own + origin_covariance;

    // The error was a left one in the patch frame; the file's is a right one in the cell frame.
    Matrix6d& covariance = placements[n].covariance;
    const Eigen::Matrix3d rotation_right = rotated(T_o_n.R.transpose(), rotation);
    covariance.topLeftCorner<3, 3>() = (position + position.transpose()) / 2;
    covariance.topRightCorner<3, 3>() = mixed_left * T_o_n.R;
    covariance.bottomLeftCorner<3, 3>() = covariance.topRightCorner<3, 3>().transpose();
    covariance.bottomRightCorner<3, 3>() = (rotation_right + rotation_right.transpose()) / 2;
  }
  return placements;
}

}  // namespace hexoderm
