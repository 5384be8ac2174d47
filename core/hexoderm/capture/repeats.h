#pragma once

// Readings that a gateway sends several times over.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace hexoderm {

/// Tells from how long readings stay the same whether each is sent several times over. A gateway that passes 20
/// readings a second on at 100 Hz sends four or five equal ones in a row and hardly ever fewer; a sensor whose noise is
/// below its step repeats itself by chance, and then one equal reading is the most frequent run.
class Repeats {
 public:
  /// `length` equal readings of one cell have come, then another one.
  void note(std::uint32_t length) {
    ++runs_[std::min<std::size_t>(length, kLongest)];
    if (++count_ < kForgetAfter) return;
    before_ = std::exchange(runs_, {});
    count_before_ = std::exchange(count_, 0);
  }

  /// Looks again at the runs; true if it was not known yet that readings come several times over. To be called now and
  /// then.
  bool update() {
    const std::uint32_t all = count_ + count_before_;
    if (all < kFewestRuns) return false;
    std::uint32_t shorter = 0, short_run = 1;
    for (std::size_t length = 1; length <= kLongest; ++length) {
      shorter += runs_[length] + before_[length];
      short_run = static_cast<std::uint32_t>(length);
      if (kShortShare * shorter >= all) break;
    }
    // Twice as many may be two readings that happen to be equal.
    const std::uint32_t was = std::exchange(times_, 2 * short_run - 1);
    return was == 1 && times_ > 1;
  }

  /// Whether readings come several times over.
  [[nodiscard]] bool any() const { return times_ > 1; }
  /// Whether the n-th of equal readings in a row, n >= 1, says something new.
  [[nodiscard]] bool isNew(std::uint32_t n) const { return (n - 1) % times_ == 0; }

 private:
  static constexpr std::size_t kLongest = 127;
  static constexpr std::uint32_t kFewestRuns = 8;
  static constexpr std::uint32_t kForgetAfter = 1000;
  static constexpr std::uint32_t kShortShare = 10;  // one run in ten may be shorter

  std::array<std::uint32_t, kLongest + 1> runs_{}, before_{};
  std::uint32_t count_ = 0, count_before_ = 0;
  std::uint32_t times_ = 1;
};

}  // namespace hexoderm
