#pragma once

#include "hexoderm/device/cell_index.h"
#include "hexoderm/device/gravity_accumulator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// The samples of one pose while they are collected.
class CaptureWindow {
 public:
  /// Collects `wanted` samples of each cell from `start_s` on. It waits for the cells in `expected`, or, if that is
  /// empty, for every cell that sends something.
  CaptureWindow(double start_s, std::uint32_t wanted, const std::vector<CellId>& expected, bool keep_frames)
      : start_s_(start_s), end_s_(start_s), wanted_(wanted), keep_frames_(keep_frames), expect_all_(expected.empty()) {
    for (const CellId cell : expected) {
      const std::size_t k = indexOf(cell);
      if (k == CellIndex::kNone || cells_[k].expected) continue;
      cells_[k].expected = true;
      ++expected_;
    }
  }

  /// Takes a frame, until the window is complete. The first device-side mean of each cell is left out, because it may
  /// reach back beyond the start.
  void add(const SampleFrame& frame) {
    if (complete_) return;
    end_s_ = frame.time_s;
    for (const CellSample& sample : frame.samples) {
      const std::size_t k = indexOf(sample.cell);
      if (k == CellIndex::kNone || cells_[k].gravity.count() >= wanted_ || !isUsable(sample)) continue;
      const std::uint32_t before = cells_[k].gravity.count();
      cells_[k].gravity.add(sample.acceleration_g);
      countIn(cells_[k], before);
    }
    for (const CellMean& mean : frame.means) {
      const std::size_t k = indexOf(mean.cell);
      if (k == CellIndex::kNone || cells_[k].gravity.count() >= wanted_ || !isUsable(mean)) continue;
      if (!std::exchange(cells_[k].met_mean, true)) continue;
      const std::uint32_t before = cells_[k].gravity.count();
      cells_[k].gravity.add(mean);
      countIn(cells_[k], before);
    }
    if (keep_frames_) frames_.push_back(frame);
    complete_ = expected_ > 0 && expected_full_ == expected_;
  }

  /// Looks for cells that must not be waited for any longer; to be called now and then. Cells not in `heard` are given
  /// up; when more than half of the others are complete, the rest has as long again as those took.
  void giveUpOn(double now_s, const std::vector<CellId>& heard) {
    if (complete_) return;
    std::vector<bool> is_heard(cells_.size(), false);
    for (const CellId cell : heard) {
      const std::size_t k = index_.find(cell);
      if (k < is_heard.size()) is_heard[k] = true;
    }
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      Cell& cell = cells_[k];
      if (!cell.expected || cell.given_up || is_heard[k] || cell.gravity.count() >= wanted_) continue;
      cell.given_up = true;
      --expected_;
      collected_ -= cell.gravity.count();
    }
    if (!deadline_s_ && 2 * expected_full_ > expected_) deadline_s_ = now_s + (now_s - start_s_);
    const bool has_some = std::ranges::any_of(cells_, [](const Cell& cell) { return cell.gravity.count() > 0; });
    complete_ = has_some && (expected_full_ == expected_ || (deadline_s_ && now_s >= *deadline_s_));
  }

  [[nodiscard]] bool isComplete() const { return complete_; }
  [[nodiscard]] double start_s() const { return start_s_; }
  [[nodiscard]] double end_s() const { return end_s_; }  ///< time of the last frame that was taken
  [[nodiscard]] std::uint32_t wanted() const { return wanted_; }
  /// The share of the awaited samples that have arrived, 0 to 1.
  [[nodiscard]] double progress() const {
    if (complete_) return 1;
    if (expected_ == 0) return 0;
    return static_cast<double>(collected_) / (static_cast<double>(expected_) * wanted_);
  }

  /// Samples in order of cell IDs, of cells that have any.
  [[nodiscard]] std::vector<GravitySample> samples() const {
    std::vector<GravitySample> samples;
    samples.reserve(cells_.size());
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      if (cells_[k].gravity.count() > 0) samples.push_back(cells_[k].gravity.sample(index_.id(k)));
    }
    std::ranges::sort(samples, {}, &GravitySample::cell);
    return samples;
  }
  /// Cells that were waited for, with fewer samples than wanted, or none.
  [[nodiscard]] std::vector<CellId> shortCells() const {
    std::vector<CellId> cells;
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      if (cells_[k].expected && cells_[k].gravity.count() < wanted_) cells.push_back(index_.id(k));
    }
    std::ranges::sort(cells);
    return cells;
  }
  std::vector<SampleFrame> takeFrames() { return std::move(frames_); }

 private:
  struct Cell {
    GravityAccumulator gravity;
    bool expected = false;
    bool met_mean = false;
    bool given_up = false;
  };
  std::size_t indexOf(CellId cell) {
    const std::size_t k = index_.of(cell);
    if (k != CellIndex::kNone && k >= cells_.size()) {
      cells_.emplace_back().expected = expect_all_;
      if (expect_all_) ++expected_;
    }
    return k;
  }
  void countIn(Cell& cell, std::uint32_t before) {
    if (!cell.expected || cell.given_up) return;
    const std::uint32_t now = std::min(cell.gravity.count(), wanted_);
    collected_ += now - before;
    if (now >= wanted_) ++expected_full_;
  }

  double start_s_;
  double end_s_;
  std::uint32_t wanted_;
  bool keep_frames_;
  bool expect_all_;
  CellIndex index_;
  std::vector<Cell> cells_;
  std::size_t expected_ = 0;       ///< number of cells that are waited for
  std::size_t expected_full_ = 0;  ///< number of those that have all their samples
  std::uint64_t collected_ = 0;    ///< samples of expected cells
  std::optional<double> deadline_s_;
  bool complete_ = false;
  std::vector<SampleFrame> frames_;
};

}  // namespace hexoderm
