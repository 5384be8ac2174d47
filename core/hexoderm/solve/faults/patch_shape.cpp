#include "hexoderm/solve/faults/patch_shape.h"

#include "hexoderm/base/units.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

/// The weight of the cell model's scatter of twist, bend and yaw against what a patch's links show, in links. The
/// model's twist and bend include the part's curvature, which the shape explains, so they say little about the rest.
constexpr std::array<double, 3> kWeightOfModel = {1, 1, 4};
/// Prior deviation of a patch's curvature, as the bend of one link.
constexpr double kCurvatureSigma = 30 * kDegree;
constexpr double kHuberThreshold = 1.5;

/// What (S_xx, S_yy, S_xy, antisymmetric part) make of twist and bend of a link with this heading.
using Rows = std::array<Eigen::Vector4d, 2>;
Rows rowsAt(double heading_rad) {
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  return {Eigen::Vector4d(c * s, -c * s, -(c * c - s * s), -1), Eigen::Vector4d(c * c, s * s, 2 * c * s, 0)};
}

/// Expected square of a link's own scatter, given that its angle is `off` the shape, of which `of_shape` is the
/// variance there, for scatter of the given variance. Deviations beyond the Huber threshold count as the threshold,
/// lest a broken link hide itself and others.
double scatterOf(double off, double variance, double scatter, double of_shape) {
  constexpr double kClippedSquare = 0.7785;  // mean of a squared normal deviate, clipped at 1.5
  const double whole = scatter + variance;
  if (!(whole > 0)) return 0;
  const double clipped = std::min(off * off, kHuberThreshold * kHuberThreshold * whole) / kClippedSquare;
  const double share = scatter / whole;
  return share * share * (clipped + of_shape) + share * variance;
}

double huberWeight(double squared_off, double variance) {
  const double limit = kHuberThreshold * kHuberThreshold * variance;
  return squared_off <= limit ? 1 : std::sqrt(limit / squared_off);
}

/// Links go in few directions, so that what depends on them is computed once for all that go the same way.
class ShapeFit {
 public:
  ShapeFit(const CellModel& model, std::span<const SeenLink> links)
      : model_sigma_(model.twist_sigma_rad, model.bend_sigma_rad, model.yaw_sigma_rad), links_(links) {
    constexpr double kSame = 1e-9;
    std::map<std::pair<long long, long long>, std::size_t> known;
    for (const SeenLink& link : links) {
      const Rows rows = rowsAt(link.heading_rad);
      const auto key = std::pair(std::llround(rows[kTwist][0] / kSame), std::llround(rows[kBend][0] / kSame));
      const auto [at, is_new] = known.emplace(key, headings_.size());
      if (is_new) headings_.push_back({rows});
      heading_of_.push_back(at->second);
    }
  }

  PatchShape run(bool with_antisymmetric, const PatchShape* near) {
    constexpr int kRounds = 30;
    constexpr double kSettled_rad = 1e-6;  // far below any scatter
    shape_.sigma = model_sigma_;
    if (near != nullptr) startFrom(*near);
    for (int round = 0; round < kRounds; ++round) {
      const PatchShape before = shape_;
      findParameters(with_antisymmetric, round > 0 || near != nullptr);
      findScatter();
      if ((shape_.parameters - before.parameters).norm() + (shape_.sigma - before.sigma).norm() < kSettled_rad) break;
    }
    return shape_;
  }

 private:
  struct Heading {
    Rows rows;
    std::array<double, 2> expected{};  ///< twist and bend by the shape
    std::array<double, 2> variance{};  ///< of these
    std::array<double, 2> weight{};    ///< of all links that go this way
    std::array<double, 2> pull{};      ///< their angles, weighted
  };

  void startFrom(const PatchShape& near) {
    shape_ = near;
    for (Heading& heading : headings_) {
      for (const std::size_t a : {std::size_t{kTwist}, std::size_t{kBend}}) {
        heading.expected[a] = heading.rows[a].dot(near.parameters);
      }
    }
  }

  void findParameters(bool with_antisymmetric, bool is_robust) {
    for (Heading& heading : headings_) heading.weight = heading.pull = {};
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const SeenLink& link = links_[k];
      Heading& heading = headings_[heading_of_[k]];
      for (const int axis : {kTwist, kBend}) {
        const auto a = static_cast<std::size_t>(axis);
        const double variance = shape_.sigma[axis] * shape_.sigma[axis] + link.variance_rad2[axis];
        const double off = link.angles_rad[axis] - heading.expected[a];
        const double weight = (is_robust ? huberWeight(off * off, variance) : 1) / variance;
        heading.weight[a] += weight;
        heading.pull[a] += weight * link.angles_rad[axis];
      }
    }
    Eigen::Matrix4d normal = Eigen::Matrix4d::Identity() / (kCurvatureSigma * kCurvatureSigma);
    if (!with_antisymmetric) normal(3, 3) = 1e12;
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const Heading& heading : headings_) {
      for (const std::size_t a : {std::size_t{kTwist}, std::size_t{kBend}}) {
        normal += heading.weight[a] * heading.rows[a] * heading.rows[a].transpose();
        right += heading.pull[a] * heading.rows[a];
      }
    }
    const Eigen::LDLT<Eigen::Matrix4d> factor(normal);
    shape_.parameters = factor.solve(right);
    const Eigen::Matrix4d covariance = factor.solve(Eigen::Matrix4d::Identity());
    shape_.antisymmetric_sigma = std::sqrt(covariance(3, 3));
    for (Heading& heading : headings_) {
      for (const std::size_t a : {std::size_t{kTwist}, std::size_t{kBend}}) {
        heading.expected[a] = heading.rows[a].dot(shape_.parameters);
        heading.variance[a] = heading.rows[a].dot(covariance * heading.rows[a]);
      }
    }
  }

  void findScatter() {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const SeenLink& link = links_[k];
      const Heading& heading = headings_[heading_of_[k]];
      for (const int axis : {kTwist, kBend, kYaw}) {
        const auto a = static_cast<std::size_t>(axis);
        sum[axis] +=
            scatterOf(link.angles_rad[axis] - (axis == kYaw ? 0 : heading.expected[a]), link.variance_rad2[axis],
                      shape_.sigma[axis] * shape_.sigma[axis], axis == kYaw ? 0 : heading.variance[a]);
      }
    }
    for (const int axis : {kTwist, kBend, kYaw}) {
      const double weight = kWeightOfModel.at(static_cast<std::size_t>(axis));
      const double variance = (weight * model_sigma_[axis] * model_sigma_[axis] + sum[axis]) /
                              (weight + static_cast<double>(links_.size()));
      shape_.sigma[axis] = axis == kYaw ? std::max(model_sigma_[axis], std::sqrt(variance)) : std::sqrt(variance);
    }
  }

  Eigen::Vector3d model_sigma_;
  std::span<const SeenLink> links_;
  std::vector<Heading> headings_;
  std::vector<std::size_t> heading_of_;  ///< per link
  PatchShape shape_;
};

}  // namespace

Eigen::Vector3d PatchShape::anglesAt(double heading_rad) const {
  const Rows rows = rowsAt(heading_rad);
  return {rows[kTwist].dot(parameters), rows[kBend].dot(parameters), 0};
}

PatchShape fitPatchShape(const CellModel& model, std::span<const SeenLink> links, bool with_antisymmetric,
                         const PatchShape* near) {
  return ShapeFit(model, links).run(with_antisymmetric, near);
}

}  // namespace hexoderm
