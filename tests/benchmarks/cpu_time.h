#pragma once

// What benchmarks measure by: the CPU time of all threads, the least of several runs, since other programs only ever
// make it longer; and 100,000 singular value decompositions as a unit that holds on any computer.

#include <time.h>
#include <Eigen/SVD>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

namespace hexoderm {

/// Of all threads, or by another clock.
inline double cpuTime_ms(clockid_t clock = CLOCK_PROCESS_CPUTIME_ID) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Of at least three runs, one if it takes more than ten seconds, and of as many as go into half a second, up to 40.
/// `prepare` is not timed; `now_ms` is the clock.
template <class Run, class Prepare, class Clock>
double least_ms(Run run, Prepare prepare, Clock now_ms) {
  constexpr double kLongEnough_ms = 500;
  constexpr double kTooLong_ms = 10'000;
  double least = std::numeric_limits<double>::infinity();
  double sum = 0;
  for (int k = 0; k < 40 && (k < 3 || sum < kLongEnough_ms) && sum < kTooLong_ms; ++k) {
    prepare();
    const double before = now_ms();
    run();
    const double took = now_ms() - before;
    least = std::min(least, took);
    sum += took;
  }
  return least;
}
template <class Run, class Prepare>
double least_ms(Run run, Prepare prepare) {
  return least_ms(run, prepare, [] { return cpuTime_ms(); });
}
template <class Run>
double least_ms(Run run) {
  return least_ms(run, [] {});
}

/// 100,000 of Eigen's JacobiSVD<Matrix3d>, with both factors.
inline double yardstick_ms() {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Matrix3d> matrices(1000);
  for (Eigen::Matrix3d& matrix : matrices) matrix = matrix.unaryExpr([&](double) { return normal(random); });
  double sum = 0;
  const double ms = least_ms([&] {
    for (int k = 0; k < 100; ++k) {
      for (const Eigen::Matrix3d& matrix : matrices) {
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
        sum += svd.singularValues()(0);
      }
    }
  });
  if (!(sum > 0)) std::abort();  // so that nothing is left out as unused
  return ms;
}

}  // namespace hexoderm
