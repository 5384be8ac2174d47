#include "hexoderm/device/pose_average.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hexoderm {

GravityAccumulator& PoseAverage::of(CellId cell) {
  const std::size_t number = index_.of(cell);
  if (number == cells_.size()) cells_.emplace_back();
  return cells_[number];
}

void PoseAverage::add(const SampleFrame& frame) {
  for (const CellSample& sample : frame.samples) {
    if (isUsable(sample)) of(sample.cell).add(sample.acceleration_g);
  }
  for (const CellMean& mean : frame.means) {
    if (isUsable(mean)) of(mean.cell).add(mean);
  }
}

PoseCapture PoseAverage::pose(PoseId id, Message label) const {
  std::vector<std::size_t> in_order(cells_.size());
  std::iota(in_order.begin(), in_order.end(), std::size_t{0});
  std::ranges::sort(in_order, {}, [this](std::size_t number) { return index_.id(number); });
  PoseCapture pose{id, std::move(label), {}};
  pose.samples.reserve(in_order.size());
  for (const std::size_t number : in_order) {
    pose.samples.push_back(cells_[number].sample(index_.id(number)));
  }
  return pose;
}

PoseCapture averageFrames(std::span<const SampleFrame> frames, PoseId id, Message label) {
  PoseAverage average;
  for (const SampleFrame& frame : frames) average.add(frame);
  return average.pose(id, std::move(label));
}

}  // namespace hexoderm
