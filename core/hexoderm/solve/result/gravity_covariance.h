#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>

namespace hexoderm {

/// How far off a patch's directions of gravity may be, and how the errors of its poses hang together: the sensors'
/// offsets are the same in all poses, and so is the attitude of the origin, in whose frame all of them are stated.
/// Poses are indices of PatchReconstruction::gravity. Comes with the solver's factor, so it exists for a fresh joint
/// reconstruction only, not for one read from a file.
class GravityCovariance {
 public:
  GravityCovariance() = default;
  virtual ~GravityCovariance() = default;
  GravityCovariance(const GravityCovariance&) = delete;
  GravityCovariance& operator=(const GravityCovariance&) = delete;

  /// Cross-covariance of the specific forces at the patch's middle (about 1 g, along GravityDirection::g_o) in two
  /// poses, patch frame, g^2; rows a, columns b.
  [[nodiscard]] virtual Eigen::Matrix3d forces(std::size_t a, std::size_t b) const = 0;
  /// Covariance of GravityDirection::Force::swing_o, (g/m)^2; absent where swings are not estimated.
  [[nodiscard]] virtual std::optional<Eigen::Matrix3d> swing(std::size_t pose) const = 0;
  /// As if nothing but the sensors' own noise had disturbed the readings: forces() grants each of them a hand's tremor,
  /// which is not there on a robot that holds still. Null where that is not known. The first call costs about as much
  /// as a step of the solver with its covariance.
  [[nodiscard]] virtual std::shared_ptr<const GravityCovariance> withoutTremor() const { return nullptr; }
};

}  // namespace hexoderm
