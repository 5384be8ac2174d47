#pragma once

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"

#include <cstdint>
#include <random>

namespace hexoderm::test {

/// Normal numbers and what is made of them, in an order that no compiler chooses.
class NormalDraw {
 public:
  explicit NormalDraw(std::uint64_t seed) : random_(seed) {}
  std::mt19937_64& generator() { return random_; }
  double normal() { return normal_(random_); }
  Eigen::Vector3d vector() {
    const double x = normal();
    const double y = normal();
    return {x, y, normal()};
  }
  Eigen::Vector3d direction() { return vector().normalized(); }
  Eigen::Matrix3d rotation() { return expSO3(kPi * vector()); }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

}  // namespace hexoderm::test
