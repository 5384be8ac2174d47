// Two cells side by side, measured in two poses: built in memory, solved, and checked, as another program would do it.

#include "hexoderm/solve/reconstructor.h"

#include <cmath>
#include <cstdio>
#include <memory>

int main() {
  using namespace hexoderm;

  const CellModel model = loadCellModel(CELL_MODELS "/hex-bma150.json");
  const NeighborList neighbors = {
      {CellId(1), "", {{PortNumber(2), CellId(2), PortNumber(3)}}},
      {CellId(2), "", {{PortNumber(3), CellId(1), PortNumber(2)}}},
  };
  Session session(model, neighbors);

  // Cell 2 is bent against cell 1 by this rotation, so it sees every vector turned back by it.
  const Eigen::Matrix3d R_1_2 = expSO3({0.05, 0.25, 0.0});
  const Eigen::Vector3d ups[] = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()};
  for (const Eigen::Vector3d& up : ups) {
    auto capture = std::make_shared<PoseCapture>();
    capture->id = session.nextPoseId();
    capture->samples = {{CellId(1), up, Eigen::Matrix3d::Zero(), 100},
                        {CellId(2), R_1_2.transpose() * up, Eigen::Matrix3d::Zero(), 100}};
    session.addPose({capture, false});
  }

  // The paper's way gives exact readings back exactly; the default knows how far it may be off.
  SolverOptions paper;
  paper.solver = Solver::Tree;
  paper.centring = Centring::Off;
  paper.support_axes = SupportAxes::Off;
  for (const SolverOptions& options : {paper, SolverOptions()}) {
    const std::shared_ptr<const Reconstruction> result = reconstruct(*session.snapshot(), options);
    const auto* cell_1 = result->find(CellId(1)).cell;
    const auto* cell_2 = result->find(CellId(2)).cell;
    if (cell_1 == nullptr || cell_2 == nullptr) {
      std::puts("A cell was not placed");
      return 1;
    }

    const SE3 T_1_2 = cell_1->T_o_u.inverse() * cell_2->T_o_u;
    const SE3 expected = linkTransform(R_1_2, model.port(PortNumber(2)), model.port(PortNumber(3)));
    const double angle_rad = rotationAngle(expected.R.transpose() * T_1_2.R);
    const double distance_m = (expected.t - T_1_2.t).norm();
    double limit_rad = 1e-9;
    double limit_m = 1e-9;
    if (const auto& covariance = result->patches.front().covariance) {
      const Matrix6d cov_t_r = covariance->relative(CellId(1), CellId(2));
      limit_rad = 3 * std::sqrt(cov_t_r.bottomRightCorner<3, 3>().trace());
      limit_m = 3 * std::sqrt(cov_t_r.topLeftCorner<3, 3>().trace());
    }
    std::printf("%s by the %s solver: off by %.1e rad, %.1e m; at most %.1e rad, %.1e m\n",
                sizeText(*result).english().c_str(), result->solver.c_str(), angle_rad, distance_m, limit_rad, limit_m);
    if (!(angle_rad <= limit_rad && distance_m <= limit_m && limit_rad < 0.5 && limit_m < 0.005)) return 1;
  }
  return 0;
}
