#include "hexoderm/capture/capture_window.h"

#include <algorithm>
#include <utility>

namespace hexoderm {

CaptureWindow::CaptureWindow(double start_s, std::uint32_t wanted, const std::vector<CellId>& expected,
                             bool keep_frames)
    : start_s_(start_s), end_s_(start_s), wanted_(wanted), keep_frames_(keep_frames), expect_all_(expected.empty()) {
  for (const CellId cell : expected) {
    const std::size_t k = indexOf(cell);
    if (k == CellIndex::kNone || cells_[k].expected) continue;
    cells_[k].expected = true;
    ++expected_;
  }
}

std::size_t CaptureWindow::indexOf(CellId cell) {
  const std::size_t k = index_.of(cell);
  if (k != CellIndex::kNone && k >= cells_.size()) {
    cells_.emplace_back().expected = expect_all_;
    if (expect_all_) ++expected_;
  }
  return k;
}

void CaptureWindow::add(const SampleFrame& frame) {
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

void CaptureWindow::countIn(Cell& cell, std::uint32_t before) {
  if (!cell.expected || cell.given_up) return;
  const std::uint32_t now = std::min(cell.gravity.count(), wanted_);
  collected_ += now - before;
  if (now >= wanted_) ++expected_full_;
}

void CaptureWindow::giveUpOn(double now_s, const std::vector<CellId>& heard) {
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

double CaptureWindow::progress() const {
  if (complete_) return 1;
  if (expected_ == 0) return 0;
  return static_cast<double>(collected_) / (static_cast<double>(expected_) * wanted_);
}

std::vector<GravitySample> CaptureWindow::samples() const {
  std::vector<GravitySample> samples;
  samples.reserve(cells_.size());
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    if (cells_[k].gravity.count() > 0) samples.push_back(cells_[k].gravity.sample(index_.id(k)));
  }
  std::ranges::sort(samples, {}, &GravitySample::cell);
  return samples;
}

std::vector<CellId> CaptureWindow::shortCells() const {
  std::vector<CellId> cells;
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    if (cells_[k].expected && cells_[k].gravity.count() < wanted_) cells.push_back(index_.id(k));
  }
  std::ranges::sort(cells);
  return cells;
}

}  // namespace hexoderm
