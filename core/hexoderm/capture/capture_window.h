#pragma once

// The samples of one pose while they are collected.

#include "hexoderm/device/cell_index.h"
#include "hexoderm/device/gravity_accumulator.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

class CaptureWindow {
 public:
  /// Collects `wanted` samples of each cell from `start_s` on. It waits for the cells in `expected`, or, if that is
  /// empty, for every cell that sends something.
  CaptureWindow(double start_s, std::uint32_t wanted, const std::vector<CellId>& expected, bool keep_frames);

  /// Takes a frame, until the window is complete. The first device-side mean of each cell is left out, because it may
  /// reach back beyond the start.
  void add(const SampleFrame& frame);

  /// Looks for cells that must not be waited for any longer; to be called now and then. Cells not in `heard` are given
  /// up; when more than half of the others are complete, the rest has as long again as those took.
  void giveUpOn(double now_s, const std::vector<CellId>& heard);

  [[nodiscard]] bool isComplete() const { return complete_; }
  [[nodiscard]] double start_s() const { return start_s_; }
  [[nodiscard]] double end_s() const { return end_s_; }  ///< time of the last frame that was taken
  [[nodiscard]] std::uint32_t wanted() const { return wanted_; }
  /// The share of the awaited samples that have arrived, 0 to 1.
  [[nodiscard]] double progress() const;

  /// Samples in order of cell IDs, of cells that have any.
  [[nodiscard]] std::vector<GravitySample> samples() const;
  /// Cells that were waited for, with fewer samples than wanted, or none.
  [[nodiscard]] std::vector<CellId> shortCells() const;
  std::vector<SampleFrame> takeFrames() { return std::move(frames_); }

 private:
  struct Cell {
    GravityAccumulator gravity;
    bool expected = false;
    bool met_mean = false;
    bool given_up = false;
  };
  std::size_t indexOf(CellId cell);
  void countIn(Cell& cell, std::uint32_t before);

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
