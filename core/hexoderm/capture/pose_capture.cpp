#include "hexoderm/capture/pose_average.h"

#include "hexoderm/capture/cell_index.h"
#include "hexoderm/capture/gravity_accumulator.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace hexoderm {

struct PoseAverage::State {
  CellIndex index{std::numeric_limits<std::size_t>::max()};
  std::vector<GravityAccumulator> cells;  ///< by the index's numbers

  GravityAccumulator& of(CellId cell) {
    const std::size_t number = index.of(cell);
    if (number == cells.size()) cells.emplace_back();
    return cells[number];
  }
};

PoseAverage::PoseAverage() : state_(std::make_unique<State>()) {}
PoseAverage::~PoseAverage() = default;
PoseAverage::PoseAverage(PoseAverage&&) noexcept = default;
PoseAverage& PoseAverage::operator=(PoseAverage&&) noexcept = default;

void PoseAverage::add(const SampleFrame& frame) {
  for (const CellSample& sample : frame.samples) {
    if (isUsable(sample)) state_->of(sample.cell).add(sample.acceleration_g);
  }
  for (const CellMean& mean : frame.means) {
    if (isUsable(mean)) state_->of(mean.cell).add(mean);
  }
}

PoseCapture PoseAverage::pose(PoseId id, Message label) const {
  std::vector<std::size_t> in_order(state_->cells.size());
  std::iota(in_order.begin(), in_order.end(), std::size_t{0});
  std::ranges::sort(in_order, {}, [this](std::size_t number) { return state_->index.id(number); });
  PoseCapture pose{id, std::move(label), {}};
  pose.samples.reserve(in_order.size());
  for (const std::size_t number : in_order) {
    pose.samples.push_back(state_->cells[number].sample(state_->index.id(number)));
  }
  return pose;
}

PoseCapture averageFrames(std::span<const SampleFrame> frames, PoseId id, Message label) {
  PoseAverage average;
  for (const SampleFrame& frame : frames) average.add(frame);
  return average.pose(id, std::move(label));
}

}  // namespace hexoderm
