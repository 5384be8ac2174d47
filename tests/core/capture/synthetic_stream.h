#pragma once

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "hexoderm/device/sample_frame.h"
#include "tests/support/random_vector.h"
#include "tests/support/testing.h"

namespace hexoderm::test {

struct StreamOptions {
  std::size_t cells = 1;
  double rate_hz = 1000;
  double jitter = 0;       ///< jitter of the time between frames, relative, uniform
  double noise_g = 0.011;  ///< per axis
  double lsb_g = 0.004;
  double offset_g = 0;  ///< per axis, uniform up to this, drawn per cell
  double gain = 1;
  double tremor_g = 0;  ///< rms per axis, of three waves of 4 to 12 Hz, common to all cells
  unsigned seed = 1;
};

/// A part that is held and moved, written for tests and independent of the simulated skin: cells at random orientations
/// on one rigid part. Up is a path on the sphere; moves follow s^3 (10 - 15 s + 6 s^2).
class SyntheticStream {
 public:
  explicit SyntheticStream(const StreamOptions& options) : options_(options), random_(options.seed) {
    for (std::size_t k = 0; k < options.cells; ++k) {
      const Eigen::Vector3d turn = randomVector();
      cells_.push_back(
          {expSO3(turn), options.offset_g * Eigen::Vector3d::NullaryExpr([this] { return uniform(-1, 1); })});
    }
    for (auto& axis : waves_) {
      for (auto& [rate_rad_s, phase] : axis) {
        rate_rad_s = 2 * kPi * uniform(4, 12);
        phase = uniform(0, 2 * kPi);
      }
    }
  }

  Eigen::Vector3d randomVector() {
    return test::randomVector([this] { return normal_(random_); });
  }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  /// A direction perpendicular to the present one.
  Eigen::Vector3d someAxis() { return up_.cross(randomVector()).normalized(); }

  /// Returns [begin, end) in device time.
  std::pair<double, double> hold(double duration_s) { return turn(0, duration_s); }
  std::pair<double, double> move(double angle_rad, double duration_s) {
    const Eigen::Vector3d axis = someAxis(), from = up_;
    return run(duration_s, [&](double t) {
      const double s = t / duration_s;
      return Eigen::Vector3d(expSO3(axis * angle_rad * s * s * s * (10 - 15 * s + 6 * s * s)) * from);
    });
  }
  std::pair<double, double> turnAbout(const Eigen::Vector3d& axis, double angle_rad, double duration_s) {
    const Eigen::Vector3d from = up_;
    return run(duration_s, [&](double t) { return Eigen::Vector3d(expSO3(axis * angle_rad * t / duration_s) * from); });
  }
  std::pair<double, double> turn(double rate_rad_s, double duration_s) {
    return turnAbout(someAxis(), rate_rad_s * duration_s, duration_s);
  }

  std::vector<SampleFrame> frames;
  [[nodiscard]] const Eigen::Vector3d& up() const { return up_; }

 private:
  struct Cell {
    Eigen::Matrix3d R_u_b;
    Eigen::Vector3d offset_g;
  };

  template <class Path>
  std::pair<double, double> run(double duration_s, const Path& path) {
    const double begin_s = now_s_;
    while (now_s_ < begin_s + duration_s) {
      up_ = path(now_s_ - begin_s).normalized();
      Eigen::Vector3d force = up_;
      for (int axis = 0; axis < 3; ++axis) {
        for (const auto& [rate_rad_s, phase] : waves_[static_cast<std::size_t>(axis)]) {
          force(axis) += options_.tremor_g * std::sqrt(2.0 / 3) * std::sin(rate_rad_s * now_s_ + phase);
        }
      }
      SampleFrame frame{now_s_};
      for (std::size_t k = 0; k < cells_.size(); ++k) {
        Eigen::Vector3d reading = options_.gain * (cells_[k].R_u_b * force) + cells_[k].offset_g;
        reading += options_.noise_g * randomVector();
        if (options_.lsb_g > 0) reading = options_.lsb_g * (reading / options_.lsb_g).array().round();
        frame.samples.push_back({CellId(static_cast<std::uint32_t>(k + 1)), reading});
      }
      frames.push_back(std::move(frame));
      now_s_ += (1 + options_.jitter * uniform(-1, 1)) / options_.rate_hz;
    }
    up_ = path(duration_s).normalized();
    return {begin_s, now_s_};
  }

  StreamOptions options_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::vector<Cell> cells_;
  std::array<std::array<std::pair<double, double>, 3>, 3> waves_;
  Eigen::Vector3d up_ = Eigen::Vector3d::UnitZ();
  double now_s_ = 10;
};

/// A stream that begins with a hold.
inline SyntheticStream held(double duration_s, const StreamOptions& options = {}) {
  SyntheticStream stream(options);
  stream.hold(duration_s);
  return stream;
}

}  // namespace hexoderm::test
