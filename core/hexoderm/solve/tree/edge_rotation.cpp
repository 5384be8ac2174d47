#include "hexoderm/solve/tree/edge_rotation.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/procrustes.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/tree/edge_batches.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

constexpr double kSupportScale = 0.1;                       // the paper's 10 %
constexpr double kUniformSigma = kPi / 1.7320508075688772;  // sigma of an unknown angle
constexpr double kShortestCentred_g = 0.05;                 // a shorter difference has no direction worth comparing
// Keeps the normal equations invertible without support axes.
constexpr double kUnsupportedInformation = 1e-9;
constexpr double kMinVariance_g2 = 1e-18;  // readings without noise weigh alike

/// The gap's axes in the source frame, those of linkAxes(). Seen from the target the link comes in, hence the
/// nominal alignment: its columns in the target frame are R_nom^T times these.
Eigen::Matrix3d gapAxes(const Port& source) {
  Eigen::Matrix3d axes;
  axes.col(0) = source.vector_m.normalized();
  axes.col(1) = Eigen::Vector3d::UnitZ().cross(axes.col(0)).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

Eigen::Matrix3Xd unitColumns(const Eigen::Matrix3Xd& v) { return v.colwise().normalized(); }
Eigen::Matrix3Xd lessMean(const Eigen::Matrix3Xd& v) { return v.colwise() - v.rowwise().mean().eval(); }

/// sum |v|^2 I - v v^T: the information that the vectors v carry about a rotation.
template <typename Vectors>
Eigen::Matrix3d rotationInformation(const Eigen::MatrixBase<Vectors>& v) {
  Eigen::Matrix3d information = v.squaredNorm() * Eigen::Matrix3d::Identity();
  information -= v.lazyProduct(v.transpose());
  return information;
}

/// Scatter of sum_p v_p x e_p for one cell's sensor errors e_p (offset, scale, cross-axis). `x`: its readings in its
/// own frame, `basis`: its axes b_i in the frame of v.
Eigen::Matrix3d sensorScatter(const Accelerometer& a, const Eigen::Matrix3Xd& v, const Eigen::Matrix3Xd& x,
                              const Eigen::Matrix3d& basis) {
  const Eigen::Matrix3d S = skew(v.rowwise().sum());
  Eigen::Matrix3d scatter = std::pow(a.largestOffsetSigma_g(), 2) * S * S.transpose();
  const Eigen::Matrix3d T = v.lazyProduct(x.transpose());  // column j: sum_p v_p x_pj
  // Over all i and j the moments T_j x b_i add up to the information of T; those with i = j are scale errors.
  const double cross_axis = a.cross_axis_sigma * a.cross_axis_sigma;
  scatter += cross_axis * rotationInformation(T);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d moment = T.col(i).cross(basis.col(i));
    scatter += (a.scale_sigma * a.scale_sigma - cross_axis) * moment * moment.transpose();
  }
  return scatter;
}

Eigen::Matrix3d noiseScatter(const Eigen::Matrix3Xd& v, const std::vector<double>& variance_g2) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (Eigen::Index p = 0; p < v.cols(); ++p) {
    scatter += variance_g2[static_cast<std::size_t>(p)] * rotationInformation(v.col(p));
  }
  return scatter;
}

/// One way of solving an edge: with or without centring.
class EdgeSolver {
 public:
  EdgeSolver(const CellModel& model, const Port& source, const Port& target, const EdgeReadings& readings)
      : model_(model), source_(source), target_(target), readings_(readings) {}

  /// `plain`: the solution that is neither centred nor supported, which classes need in any case.
  [[nodiscard]] EdgeRotation solve(bool centred, bool supported, const ProcrustesSolution& plain) const {
    const Eigen::Matrix3Xd N = centred ? lessMean(readings_.n_g) : unitColumns(readings_.n_g);
    const Eigen::Matrix3Xd C = centred ? lessMean(readings_.c_g) : unitColumns(readings_.c_g);
    EdgeRotation edge;
    edge.centred = centred;
    edge.supported = supported;
    const Eigen::Matrix3d axes = gapAxes(source_);
    if (supported) {
      const Eigen::Index count = N.cols();
      Eigen::Matrix3Xd N_supported(3, count + 3);
      Eigen::Matrix3Xd C_supported(3, count + 3);
      N_supported << N, kSupportScale * nominalAlignment(source_, target_).transpose() * axes;
      C_supported << C, kSupportScale * axes;
      edge.R_c_n = solveProcrustes(N_supported, C_supported).R_c_n;
    } else {
      edge.R_c_n = centred ? solveProcrustes(N, C).R_c_n : plain.R_c_n;
    }
    predict(edge, C, axes);
    return edge;
  }

  void addResiduals(EdgeRotation& edge) const {
    const Eigen::Matrix3Xd N = edge.centred ? lessMean(readings_.n_g) : readings_.n_g;
    const Eigen::Matrix3Xd C = edge.centred ? lessMean(readings_.c_g) : readings_.c_g;
    double sum = 0;
    double expected = 0;
    double weights = 0;
    edge.pose_residual_rad.reserve(static_cast<std::size_t>(N.cols()));
    const Accelerometer& a = model_.accelerometer;
    for (Eigen::Index p = 0; p < N.cols(); ++p) {
      double angle = 0;
      const double length = std::min(N.col(p).norm(), C.col(p).norm());
      if (length >= kShortestCentred_g) {
        angle = angleBetween(C.col(p), edge.R_c_n * N.col(p));
        const double offset = edge.centred ? 0 : a.largestOffsetSigma_g();
        const double shared_g2 = edge.centred ? 0 : a.sharedOffsetBetween_g2(edge.R_c_n).trace() / 3;
        // Two cells, two directions across the vector; gains act on the whole reading, not on what centring leaves.
        const double per_axis =
            readings_.variance_g2[static_cast<std::size_t>(p)] + shared_g2 +
            2 * (offset * offset + a.scale_sigma * a.scale_sigma + a.cross_axis_sigma * a.cross_axis_sigma);
        // A short window says less than a long one.
        const double weight = 1 / std::max(per_axis, kMinVariance_g2);
        sum += weight * angle * angle;
        expected += weight * 2 * per_axis / (length * length);
        weights += weight;
      }
      edge.pose_residual_rad.push_back(angle);
    }
    if (weights == 0) return;
    edge.residual_rad = std::sqrt(sum / weights);
    edge.expected_residual_rad = std::sqrt(expected / weights);
  }

 private:
  /// Scatter of sum_p v_p x e of the offset e that the lot leaves between the two cells.
  [[nodiscard]] Eigen::Matrix3d sharedScatter(const Eigen::Matrix3Xd& v, const Eigen::Matrix3d& R_c_n) const {
    const Accelerometer& a = model_.accelerometer;
    const Eigen::Matrix3d S = skew(v.rowwise().sum());
    return S * a.sharedOffsetBetween_g2(R_c_n) * S.transpose();
  }

  /// First-order covariance of d in R_true = exp(d) R: with A the information of the vectors used,
  /// d = A^-1 sum_p v_p x e_p, e_p the error of c_p less that of R n_p.
  void predict(EdgeRotation& edge, const Eigen::Matrix3Xd& C, const Eigen::Matrix3d& axes) const {
    const double support = edge.supported ? 2 * kSupportScale * kSupportScale : kUnsupportedInformation;
    const Eigen::Matrix3d inverse = (rotationInformation(C) + support * Eigen::Matrix3d::Identity()).inverse();
    const Eigen::Matrix3d scatter = noiseScatter(C, readings_.variance_g2) +
                                    sensorScatter(model_.accelerometer, C, readings_.c_g, Eigen::Matrix3d::Identity()) +
                                    sensorScatter(model_.accelerometer, C, readings_.n_g, edge.R_c_n) +
                                    sharedScatter(C, edge.R_c_n);
    // Support axes pull towards the nominal alignment, which is wrong by what the elastomer really bends.
    Eigen::Vector3d prior(model_.twist_sigma_rad, model_.bend_sigma_rad, model_.yaw_sigma_rad);
    if (!edge.supported) prior.setConstant(kUniformSigma);
    const Eigen::Matrix3d W = axes * prior.cwiseAbs2().asDiagonal() * axes.transpose();
    edge.prior_part = support * support * inverse * W * inverse;
    edge.covariance = inverse * scatter * inverse + edge.prior_part;
    edge.covariance = (edge.covariance + edge.covariance.transpose()).eval() / 2;
  }

  const CellModel& model_;
  const Port& source_;
  const Port& target_;
  const EdgeReadings& readings_;
};

}  // namespace

EdgeQuality classifyEdge(const Eigen::Vector3d& singular_values, double threshold) {
  if (singular_values.x() < threshold) return EdgeQuality::Undefined;
  if (singular_values.y() < threshold) return EdgeQuality::Partially;
  if (singular_values.z() < threshold) return EdgeQuality::Fully;
  return EdgeQuality::Over;
}

double paperWeight(EdgeQuality quality) {
  return quality == EdgeQuality::Undefined ? 3 : quality == EdgeQuality::Partially ? 2 : 1;
}

EdgeKernelOptions edgeKernelOptions(const CellModel& model, const SolverOptions& options) {
  const Accelerometer& a = model.accelerometer;
  EdgeKernelOptions kernel;
  kernel.offset_variance_g2 = std::pow(a.largestOffsetSigma_g(), 2);
  kernel.shared_offset_variance_g2 = a.offset_shared_sigma_g * a.offset_shared_sigma_g;
  kernel.scale_variance = a.scale_sigma * a.scale_sigma;
  kernel.cross_axis_variance = a.cross_axis_sigma * a.cross_axis_sigma;
  kernel.support = kUnsupportedInformation;
  kernel.prior_variance = kUniformSigma * kUniformSigma;
  kernel.shortest_g = kShortestCentred_g;
  kernel.least_variance_g2 = kMinVariance_g2;
  kernel.centre = options.centring != Centring::Off;
  kernel.always_centre = options.centring == Centring::On;
  return kernel;
}

bool needsSupport(const EdgeRotation& unsupported, SupportAxes axes, const CellModel& model) {
  if (axes != SupportAxes::Auto) return axes == SupportAxes::On;
  const bool leaves_open =
      unsupported.quality == EdgeQuality::Undefined || unsupported.quality == EdgeQuality::Partially;
  return leaves_open && largestDeviation(unsupported.covariance) >
                            std::max({model.twist_sigma_rad, model.bend_sigma_rad, model.yaw_sigma_rad});
}

EdgeRotation estimateEdgeRotation(const CellModel& model, const Port& source, const Port& target,
                                  const EdgeReadings& readings, const SolverOptions& options) {
  const Eigen::Index poses = readings.n_g.cols();
  const ProcrustesSolution plain = solveProcrustes(unitColumns(readings.n_g), unitColumns(readings.c_g));
  const EdgeQuality quality = classifyEdge(plain.singular_values, options.class_threshold);
  const EdgeSolver solver(model, source, target, readings);
  // Two vectors less their mean are one difference and its opposite: a single direction.
  constexpr Eigen::Index kFewestToCentre = 3;
  const bool may_centre = options.centring != Centring::Off && poses >= kFewestToCentre;
  const auto solve = [&](bool supported) {
    EdgeRotation edge = solver.solve(may_centre && options.centring == Centring::On, supported, plain);
    if (!may_centre || options.centring == Centring::On) return edge;
    EdgeRotation centred = solver.solve(true, supported, plain);
    return centred.covariance.trace() < edge.covariance.trace() ? centred : edge;
  };
  EdgeRotation edge = solve(false);
  edge.quality = quality;
  if (needsSupport(edge, options.support_axes, model)) edge = solve(true);
  edge.singular_values = plain.singular_values;
  edge.quality = quality;
  edge.deviation_rad = largestDeviation(edge.covariance);
  edge.angles = linkAngles(edge.R_c_n, source, target);
  solver.addResiduals(edge);
  return edge;
}

Eigen::Matrix3d cellAttitudeCovariance(const Accelerometer& accelerometer, const Eigen::Matrix3Xd& g_g,
                                       const std::vector<double>& variance_g2, bool centred, bool supported) {
  if (g_g.cols() == 0) return Eigen::Matrix3d::Zero();
  const Eigen::Matrix3Xd v = centred ? lessMean(g_g) : unitColumns(g_g);
  const double support = supported ? 2 * kSupportScale * kSupportScale : kUnsupportedInformation;
  const Eigen::Matrix3d inverse = (rotationInformation(v) + support * Eigen::Matrix3d::Identity()).inverse();
  const Eigen::Matrix3d scatter =
      noiseScatter(v, variance_g2) + sensorScatter(accelerometer, v, g_g, Eigen::Matrix3d::Identity());
  return inverse * scatter * inverse;
}

}  // namespace hexoderm
