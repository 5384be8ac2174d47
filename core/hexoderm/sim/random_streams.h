#pragma once

// Where a simulated skin's random numbers come from.

#include <boost/random/normal_distribution.hpp>

#include <Eigen/Core>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

namespace hexoderm {

/// One stream of random numbers per purpose, so that, say, switching the jitter off leaves the sensors' errors as they
/// were. New purposes go to the end: the numbers of the others stay.
enum class Stream : std::uint32_t {
  Placement,
  Sensors,
  Faults,
  Hand,
  Noise,
  DeadAxis,
  LinkFaults,
  Vibration,
  WholeSkin,
  Lot,
  RobotZero,
  RobotPose,
  RobotSkin,
  Mounting,
  Drift
};

/// The stream's generator for what `keys` number (a recording, a cell ...).
inline std::mt19937_64 randomStream(std::uint64_t seed, Stream stream, std::initializer_list<std::uint32_t> keys) {
  std::vector<std::uint32_t> words = {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                                      static_cast<std::uint32_t>(stream)};
  words.insert(words.end(), keys);
  std::seed_seq sequence(words.begin(), words.end());
  return std::mt19937_64(sequence);
}

inline std::mt19937_64 randomStream(std::uint64_t seed, Stream stream, std::size_t recording = 0) {
  return randomStream(seed, stream, {static_cast<std::uint32_t>(recording)});
}

template <class Distribution>
class NormalNumbers {
 public:
  explicit NormalNumbers(std::mt19937_64 engine) : engine_(engine) {}
  double next() { return normal_(engine_); }
  Eigen::Vector3d nextVector() {
    const double x = next();
    const double y = next();
    return {x, y, next()};
  }

 private:
  std::mt19937_64 engine_;
  Distribution normal_;
};

using NormalSource = NormalNumbers<std::normal_distribution<double>>;
/// By the ziggurat method, several times as fast: for what has to keep up with 10,000 cells. Other numbers.
using FastNormalSource = NormalNumbers<boost::random::normal_distribution<double>>;

}  // namespace hexoderm
