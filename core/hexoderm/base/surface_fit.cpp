#include "hexoderm/base/surface_fit.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/units.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hexoderm {
namespace {

/// Singular values below this part of the largest count as zero: points on a line or in a plane.
constexpr double kFlat = 1e-10;

/// The points moved to their centroid and scaled to a mean square of 1, so that no threshold depends on units.
struct Cloud {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  double scale = 1;
  Eigen::Matrix3Xd points;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< principal directions, largest spread first
  Eigen::Vector3d spread = Eigen::Vector3d::Zero();    ///< singular values, descending
};

Cloud normalise(std::span<const Eigen::Vector3d> points, std::size_t least, const Message& what) {
  if (points.size() < least) {
    throw InvalidArgument(located(what, message("at least {} points are needed, there are {}", least, points.size())));
  }
  Cloud cloud;
  cloud.points.resize(3, static_cast<Eigen::Index>(points.size()));
  Eigen::Index column = 0;
  for (const Eigen::Vector3d& point : points) cloud.points.col(column++) = point;
  if (!cloud.points.allFinite()) throw InvalidArgument(located(what, message("the points must be finite")));
  cloud.centroid = cloud.points.rowwise().mean();
  cloud.points.colwise() -= cloud.centroid;
  cloud.scale = cloud.points.norm() / std::sqrt(static_cast<double>(points.size()));
  if (!(cloud.scale > 0)) throw InvalidArgument(located(what, message("all points are the same")));
  cloud.points /= cloud.scale;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(cloud.points.transpose(), Eigen::ComputeThinU | Eigen::ComputeThinV);
  cloud.axes = svd.matrixV();
  cloud.spread = svd.singularValues();
  // Coordinates far from zero carry rounding errors that no spread below them can beat.
  const double rounding = 1e-15 * cloud.centroid.norm() / cloud.scale;
  if (cloud.spread.y() <= std::max(kFlat, rounding) * cloud.spread.x()) {
    throw InvalidArgument(located(what, message("the points lie on a line")));
  }
  return cloud;
}

void requireSolid(const Cloud& cloud, const Message& what) {
  const double rounding = 1e-15 * cloud.centroid.norm() / cloud.scale;
  if (cloud.spread.z() <= std::max(kFlat, rounding) * cloud.spread.x()) {
    throw InvalidArgument(located(what, message("the points lie in a plane")));
  }
}

/// The x of minimum norm that minimises |A x - b|. All of this file solves by it: every further kind of decomposition
/// and of size would cost seconds of compiling, and these systems are small.
Eigen::VectorXd leastSquares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(A, Eigen::ComputeThinU | Eigen::ComputeThinV).solve(b);
}

/// A direction and its opposite describe the same axis; one of them is returned.
Eigen::Vector3d canonicalSign(const Eigen::Vector3d& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis(largest) < 0 ? Eigen::Vector3d(-axis) : axis;
}

/// Two unit vectors that make a right-handed frame with the unit vector `axis`: columns.
Eigen::Matrix<double, 3, 2> perpendicularBasis(const Eigen::Vector3d& axis) {
  Eigen::Matrix<double, 3, 2> basis;
  basis.col(0) = axis.unitOrthogonal();
  basis.col(1) = axis.cross(basis.col(0));
  return basis;
}

/// From its foot on the axis through `point` to x.
Eigen::Vector3d armTo(const Eigen::Vector3d& x, const Eigen::Vector3d& point, const Eigen::Vector3d& axis) {
  const Eigen::Vector3d from = x - point;
  return from - axis * axis.dot(from);
}

template <class Surface>
double costOf(const Surface& surface, const Eigen::Matrix3Xd& points) {
  double sum = 0;
  for (const auto& x : points.colwise()) {
    const double d = surface.distance(x);
    sum += d * d;
  }
  return sum;
}

/// Levenberg-Marquardt (Marquardt's diagonal scaling) for small problems. `Surface` has kParameters, distance(x),
/// linearise(points, H, g) for H = J^T J and g = J^T r, and moved(step). Every accepted step lowers the cost, so the
/// result is never worse than the start and always finite.
template <class Surface>
double minimise(Surface& surface, const Eigen::Matrix3Xd& points) {
  using Hessian = Eigen::Matrix<double, Surface::kParameters, Surface::kParameters>;
  using Vector = Eigen::Matrix<double, Surface::kParameters, 1>;
  double cost = costOf(surface, points);
  double damping = 1e-4;
  for (int iteration = 0; iteration < 200; ++iteration) {
    Hessian H;
    Vector g;
    surface.linearise(points, H, g);
    bool improved = false;
    double relative_gain = 0;
    while (!improved && damping < 1e12) {
      Hessian damped = H;
      damped.diagonal() += damping * (H.diagonal().array() + 1e-12).matrix();
      const Vector step = leastSquares(damped, -g);
      const Surface candidate = surface.moved(step);
      const double candidate_cost = costOf(candidate, points);
      if (std::isfinite(candidate_cost) && candidate_cost < cost) {
        relative_gain = (cost - candidate_cost) / cost;
        surface = candidate;
        cost = candidate_cost;
        damping = std::max(damping / 10, 1e-15);
        improved = true;
      } else {
        damping *= 10;
      }
    }
    if (!improved || relative_gain < 1e-14) break;
  }
  return cost;
}

struct SphereEstimate {
  static constexpr int kParameters = 4;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 1;

  [[nodiscard]] double distance(const Eigen::Vector3d& x) const { return (x - center).norm() - radius; }
  void linearise(const Eigen::Matrix3Xd& points, Eigen::Matrix4d& H, Eigen::Vector4d& g) const {
    H.setZero();
    g.setZero();
    for (const auto& x : points.colwise()) {
      const Eigen::Vector3d arm = x - center;
      const double length = arm.norm();
      if (length < 1e-300) continue;
      Eigen::Vector4d row;
      row << -arm / length, -1;
      H += row * row.transpose();
      g += row * (length - radius);
    }
  }
  [[nodiscard]] SphereEstimate moved(const Eigen::Vector4d& step) const {
    return {center + step.head<3>(), radius + step(3)};
  }
};

/// A cone of six parameters, or one of five whose angle stays 0: a cylinder.
template <int kCount>
struct RoundEstimate {
  static constexpr int kParameters = kCount;
  static constexpr double kSteepest = kPi / 2 - 1e-3;  ///< beyond that it would be a plane
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on the axis, nearest to the centroid
  double radius = 1;                                ///< at the point
  double angle = 0;                                 ///< between axis and surface; positive: wider along the axis

  [[nodiscard]] double distance(const Eigen::Vector3d& x) const {
    return (armTo(x, point, axis).norm() - radius) * std::cos(angle) - axis.dot(x - point) * std::sin(angle);
  }
  using Hessian = Eigen::Matrix<double, kCount, kCount>;
  using Vector = Eigen::Matrix<double, kCount, 1>;
  /// Parameters: turn of the axis towards the two perpendicular directions, shift along them, radius, angle.
  void linearise(const Eigen::Matrix3Xd& points, Hessian& H, Vector& g) const {
    H.setZero();
    g.setZero();
    const Eigen::Matrix<double, 3, 2> basis = perpendicularBasis(axis);
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    for (const auto& x : points.colwise()) {
      const Eigen::Vector3d arm = armTo(x, point, axis);
      const double length = arm.norm();
      if (length < 1e-300) continue;
      const double along = axis.dot(x - point);
      const Eigen::Vector2d outward = basis.transpose() * arm / length;
      Eigen::Matrix<double, 6, 1> all;
      all << -(along * cosine + length * sine) * outward, -cosine * outward, -cosine,
          -(length - radius) * sine - along * cosine;
      const Vector row = all.head<kCount>();
      H += row * row.transpose();
      g += row * distance(x);
    }
  }
  [[nodiscard]] RoundEstimate moved(const Vector& step) const {
    const Eigen::Matrix<double, 3, 2> basis = perpendicularBasis(axis);
    RoundEstimate next;
    next.axis = (axis + basis * step.template head<2>()).normalized();
    next.point = point + basis * step.template segment<2>(2);
    if constexpr (kCount == 6) next.angle = std::clamp(angle + step(5), -kSteepest, kSteepest);
    const double back = next.axis.dot(next.point);
    next.point -= back * next.axis;
    next.radius = radius + step(4) - back * std::tan(next.angle);
    return next;
  }
};
using CylinderEstimate = RoundEstimate<5>;
using ConeEstimate = RoundEstimate<6>;

/// The algebraic estimate with its axis along `axis`, a start that is biased for short arcs. Of the cone
/// |flat|^2 = 2 c.flat + k + 2 r t z + t^2 z^2, where r is the radius at z = 0 and t the tangent of the angle; its two
/// terms in z are fitted as if they were independent. Of the cylinder without them: Kasa's circle.
template <int kCount>
RoundEstimate<kCount> roundAlong(const Eigen::Vector3d& axis, const Eigen::Matrix3Xd& points) {
  constexpr int kTerms = kCount == 6 ? 5 : 3;
  using Vector = Eigen::Matrix<double, kTerms, 1>;
  const Eigen::Matrix<double, 3, 2> basis = perpendicularBasis(axis);
  Eigen::Matrix<double, kTerms, kTerms> H = Eigen::Matrix<double, kTerms, kTerms>::Zero();
  Vector g = Vector::Zero();
  for (const auto& x : points.colwise()) {
    const Eigen::Vector2d flat = basis.transpose() * x;
    const double z = axis.dot(x);
    const Vector row = Eigen::Matrix<double, 5, 1>(2 * flat.x(), 2 * flat.y(), 1, 2 * z, z * z).template head<kTerms>();
    H += row * row.transpose();
    g += row * flat.squaredNorm();
  }
  // Minimum norm: seen along an axis that lies in a flat patch the circle is not determined.
  const Vector solution = leastSquares(H, g);
  RoundEstimate<kCount> estimate;
  estimate.axis = axis;
  estimate.point = basis * solution.template head<2>();
  estimate.radius = std::sqrt(std::max(solution(2) + solution.template head<2>().squaredNorm(), 1e-12));
  if constexpr (kCount == 6) estimate.angle = std::atan(solution(3) / estimate.radius);
  return estimate;
}

/// Directions spread over the half sphere (golden-angle spiral).
std::vector<Eigen::Vector3d> spreadDirections(int count) {
  std::vector<Eigen::Vector3d> directions;
  const double golden_angle = kPi * (3 - std::sqrt(5.0));
  for (int k = 0; k < count; ++k) {
    const double z = (k + 0.5) / count;
    const double s = std::sqrt(1 - z * z);
    directions.emplace_back(s * std::cos(k * golden_angle), s * std::sin(k * golden_angle), z);
  }
  return directions;
}

/// The starting axes are those of the principal frame, so that they, and with them the result, turn with the points.
std::vector<Eigen::Vector3d> startingAxes(const Cloud& cloud) {
  constexpr int kDirections = 60;
  std::vector<Eigen::Vector3d> axes;
  for (int k = 0; k < 3; ++k) axes.emplace_back(cloud.axes.col(k));
  for (const Eigen::Vector3d& direction : spreadDirections(kDirections)) axes.emplace_back(cloud.axes * direction);
  return axes;
}

/// The best of the local minima next to the most promising starts.
template <class Surface>
Surface bestFrom(const std::vector<Surface>& starts, const Cloud& cloud) {
  constexpr std::size_t kTries = 12;
  std::vector<std::pair<double, std::size_t>> ranking;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const double cost = costOf(starts[k], cloud.points);
    ranking.emplace_back(std::isfinite(cost) ? cost : std::numeric_limits<double>::max(), k);
  }
  std::ranges::sort(ranking);
  ranking.resize(kTries);
  Surface best;
  double best_cost = std::numeric_limits<double>::infinity();
  for (const auto& [start_cost, k] : ranking) {
    Surface surface = starts[k];
    const double cost = minimise(surface, cloud.points);
    if (cost < best_cost) {
      best_cost = cost;
      best = surface;
    }
  }
  return best;
}

template <class Surface>
std::vector<double> distances(const Surface& surface, const Cloud& cloud) {
  std::vector<double> result;
  result.reserve(static_cast<std::size_t>(cloud.points.cols()));
  for (const auto& x : cloud.points.colwise()) result.push_back(surface.distance(x) * cloud.scale);
  return result;
}

}  // namespace

SurfaceFit fitPlane(std::span<const Eigen::Vector3d> points_m) {
  const Cloud cloud = normalise(points_m, 3, message("plane fit"));
  SurfaceFit fit;
  fit.point = cloud.centroid;
  fit.axis = canonicalSign(cloud.axes.col(2));
  for (const auto& x : cloud.points.colwise()) fit.distance_m.push_back(fit.axis.dot(x) * cloud.scale);
  return fit;
}

SurfaceFit fitSphere(std::span<const Eigen::Vector3d> points_m) {
  const Cloud cloud = normalise(points_m, 4, message("sphere fit"));
  requireSolid(cloud, message("sphere fit"));
  // Algebraic start: |x|^2 = 2 c.x + (r^2 - |c|^2).
  Eigen::MatrixX4d A(cloud.points.cols(), 4);
  A.leftCols<3>() = 2 * cloud.points.transpose();
  A.col(3).setOnes();
  const Eigen::VectorXd b = cloud.points.colwise().squaredNorm().transpose();
  const Eigen::Vector4d solution = leastSquares(A, b);
  SphereEstimate sphere;
  sphere.center = solution.head<3>();
  sphere.radius = std::sqrt(std::max(solution(3) + sphere.center.squaredNorm(), 1e-12));
  minimise(sphere, cloud.points);
  SurfaceFit fit;
  fit.point = cloud.centroid + cloud.scale * sphere.center;
  fit.radius_m = cloud.scale * sphere.radius;
  fit.distance_m = distances(sphere, cloud);
  return fit;
}

SurfaceFit fitCylinder(std::span<const Eigen::Vector3d> points_m) {
  const Cloud cloud = normalise(points_m, 5, message("cylinder fit"));
  requireSolid(cloud, message("cylinder fit"));
  std::vector<CylinderEstimate> starts;
  for (const Eigen::Vector3d& axis : startingAxes(cloud)) starts.push_back(roundAlong<5>(axis, cloud.points));
  const CylinderEstimate best = bestFrom(starts, cloud);
  SurfaceFit fit;
  fit.axis = canonicalSign(best.axis);
  fit.point = cloud.centroid + cloud.scale * (best.point - best.axis * best.axis.dot(best.point));
  fit.radius_m = cloud.scale * best.radius;
  fit.distance_m = distances(best, cloud);
  return fit;
}

SurfaceFit fitCone(std::span<const Eigen::Vector3d> points_m) {
  const Cloud cloud = normalise(points_m, 6, message("cone fit"));
  requireSolid(cloud, message("cone fit"));
  std::vector<ConeEstimate> starts;
  for (const Eigen::Vector3d& axis : startingAxes(cloud)) {
    starts.push_back(roundAlong<6>(axis, cloud.points));
    const CylinderEstimate cylinder = roundAlong<5>(axis, cloud.points);
    starts.push_back({axis, cylinder.point, cylinder.radius, 0});
  }
  const ConeEstimate best = bestFrom(starts, cloud);
  SurfaceFit fit;
  const double towards_wide = best.angle < 0 ? -1 : 1;
  fit.axis = towards_wide * best.axis;
  fit.half_angle_rad = std::abs(best.angle);
  fit.point = cloud.centroid + cloud.scale * best.point;
  fit.radius_m = cloud.scale * best.radius;
  fit.distance_m = distances(best, cloud);
  return fit;
}

double rms(std::span<const double> values) {
  if (values.empty()) return 0;
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace hexoderm
