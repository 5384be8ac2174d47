// Prints what a program is given and computes from it, one figure a line: to be compared with what the same program
// prints that was compiled with other flags than the library. Usage: figures SESSION_OF_A_SKIN SESSION_OF_A_ROBOT URDF

#include "hexoderm/io/session_json.h"
#include "hexoderm/mounting/parts/parts.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/hold_out.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "hexoderm/solve/reconstructor.h"

#include <Eigen/Dense>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace hexoderm;

void print(const std::string& name, double figure) { std::printf("%s %.17g\n", name.c_str(), figure); }

template <class Derived>
void print(const std::string& name, const Eigen::MatrixBase<Derived>& figures) {
  for (Eigen::Index row = 0; row < figures.rows(); ++row) {
    for (Eigen::Index column = 0; column < figures.cols(); ++column) print(name, figures(row, column));
  }
}

void print(const std::string& name, const SE3& T) {
  print(name, T.R);
  print(name, T.t);
}

/// Algebra of the program's own on matrices of its own, with the same parts of Eigen as the library uses.
double ownAlgebra(const Eigen::MatrixXd& covariance) {
  const Eigen::Index size = covariance.rows();
  const Eigen::MatrixXd regular = covariance / covariance.norm() + 0.1 * Eigen::MatrixXd::Identity(size, size);
  const Eigen::LLT<Eigen::MatrixXd> factor(regular);
  Eigen::MatrixXd inverse = factor.solve(Eigen::MatrixXd::Identity(size, size));
  Eigen::MatrixXd product(size, size);
  product.noalias() = inverse.transpose() * regular;
  inverse.conservativeResize(size, size + 7);
  inverse.rightCols(7).setOnes();
  std::vector<Eigen::Matrix<double, 6, 6>> aligned(5, Eigen::Matrix<double, 6, 6>::Constant(2));
  for (int k = 0; k < 50; ++k) aligned.push_back(aligned.back() * 1.01);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(inverse, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return product.trace() + aligned.back().sum() + svd.singularValues().sum();
}

void printResult(const SessionSnapshot& snapshot, const SolverOptions& options) {
  const std::shared_ptr<const Reconstruction> result = reconstruct(snapshot, options);
  const PatchReconstruction& patch = result->patches.front();
  print(result->solver + " findings", static_cast<double>(result->findings.size()));
  print("verdict", static_cast<double>(result->assessment.level));
  for (const CellPlacement& cell : patch.cells) {
    const std::string name = result->solver + " cell " + std::to_string(cell.cell.value());
    print(name, cell.T_o_u);
    if (cell.cov_t_r) print(name + " covariance", *cell.cov_t_r);
    if (cell.accel_offset_g) print(name + " offset", *cell.accel_offset_g);
    print(name + " path", static_cast<double>(patch.pathTo(cell.cell).size()));
    for (const SensorPlacement& sensor : cell.sensors) print(name + " " + sensor.name, sensor.T_o_s);
  }
  for (const LinkEstimate& link : patch.links) {
    print("link", link.R_c_n);
    print("link", link.singular_values);
    print("link", link.residual_rad);
  }
  for (const GravityDirection& gravity : patch.gravity) print("gravity", gravity.g_o);
  for (const FlatCell& cell : result->layout.cells) print("flat cell", cell.center);
  for (const FlatLink& link : result->layout.links) print("flat link", link.to - link.from);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(6, 6);
  if (patch.covariance) covariance = patch.covariance->relative(patch.cells.front().cell, patch.cells.back().cell);
  print("relative", covariance);
  const Eigen::MatrixXd large =
      covariance.replicate(30, 30) + Eigen::MatrixXd(covariance.replicate(30, 30).transpose());
  print("own algebra", ownAlgebra(large * large.transpose() + Eigen::MatrixXd::Identity(180, 180)));
  const PoseCoverage coverage = coverageOf(*result, {});
  for (const auto& seen : coverage.seen) print("disc", seen.at.at);
  print("cylinder", *evaluateSurface(patch, SurfaceKind::Cylinder).radius_m);
}

void printRobot(const RobotModel& robot) {
  for (std::size_t link = 0; link < robot.links().size(); ++link) {
    for (const Eigen::Vector3d& point : robot.bodyOf(link).points) print("body", point);
  }
}

void printParts(const SessionSnapshot& snapshot) {
  const std::shared_ptr<const Reconstruction> result = reconstruct(snapshot);
  for (const PatchReconstruction& patch : result->patches) {
    for (const CellPlacement& cell : patch.cells) print("shape", *cell.shape_cov_t_r);
    print("forces", patch.gravity_covariance->forces(0, 1));
  }
  const PartsResult parts = findParts(*result);
  for (const PatchPair& pair : parts.pairs) {
    print("pair", pair.R_a_b);
    print("pair", pair.covariance);
    print("pair", pair.log10_odds);
  }
  for (const PartRelation& relation : parts.relations) {
    print("movement", static_cast<double>(relation.movement));
    if (!relation.hinge) continue;
    print("hinge", relation.hinge->a.u);
    print("hinge", relation.hinge->b.covariance);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: figures SESSION_OF_A_SKIN SESSION_OF_A_ROBOT URDF\n", stderr);
    return 2;
  }
  const std::shared_ptr<const SessionSnapshot> skin = readSessionJson(argv[1]).snapshot();
  print("own algebra", ownAlgebra(Eigen::MatrixXd::Identity(100, 100)));
  for (const Solver solver : {Solver::Tree, Solver::Global}) {
    SolverOptions options;
    options.solver = solver;
    printResult(*skin, options);
  }
  const HoldOutResult held_out = evaluateHoldOut(*skin, skin->poses.back().capture->id, {});
  for (const HoldOutCell& cell : held_out.cells) print("hold-out", cell.error_rad);
  printParts(*readSessionJson(argv[2]).snapshot());
  printRobot(RobotModel::read(argv[3]));
  print("own algebra", ownAlgebra(Eigen::MatrixXd::Identity(150, 150)));
}
