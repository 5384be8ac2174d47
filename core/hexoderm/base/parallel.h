#pragma once

#include <cstddef>
#include <functional>

namespace hexoderm {

/// How many threads of this process compute at once at most, where they share the work of one call. At least 1; at
/// first as many as the computer has cores that the process may use.
[[nodiscard]] std::size_t cores();
/// Says how many; 0 counts as 1. What computes already goes on as it began.
void setCores(std::size_t count);

/// How many of them nobody uses at this moment, beside the thread that asks.
[[nodiscard]] std::size_t freeCores();

/// Keeps cores from inParallel() as long as it lives: for threads that compute on their own beside.
class CoresInUse {
 public:
  explicit CoresInUse(std::size_t count);  ///< any number, also of more than there are
  ~CoresInUse();
  CoresInUse(const CoresInUse&) = delete;
  CoresInUse& operator=(const CoresInUse&) = delete;

 private:
  std::ptrdiff_t count_;
};

/// Calls work(k) for every k below `count`, several at once where cores are free, and returns when all have ended. By
/// which thread and in which order is chance: no number may depend on it, so that sums over several k are made
/// afterwards, in their order. Exceptions: that of the lowest k, after all have ended. It can be called within itself.
void inParallel(std::size_t count, const std::function<void(std::size_t)>& work);

/// Calls work(begin, end) for consecutive ranges of `grain` indices below `count`, the last one shorter, as
/// inParallel() does. Where they begin and end depends on the two numbers alone.
void inRanges(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work);

}  // namespace hexoderm
