#pragma once

#include "hexoderm/geometry/lanes.h"
#include "hexoderm/reconstruction/links/gravity_table.h"
#include "hexoderm/reconstruction/links/skin_readings.h"

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace hexoderm {

/// Up to kLanes links, whose cells measured in equally many poses together, with their readings side by side as kernels
/// want them: value k of the link in lane l is at [kLanes * k + l]. Lanes that are over repeat the first.
struct LinkBatch {
  int poses = 0;
  int size = 0;
  std::array<std::size_t, kLanes> links{};
  std::vector<double> c_g;          ///< poses x 3, source cell, in its frame
  std::vector<double> n_g;          ///< poses x 3, target cell
  std::vector<double> variance_g2;  ///< poses: sum of both means' variances, per axis

  /// The link of a lane, also of those that are over.
  [[nodiscard]] std::size_t linkIn(int lane) const {
    return links.at(static_cast<std::size_t>(lane < size ? lane : 0));
  }
};

/// Hands out the links whose both cells measure, in two poses together at least, in batches; returns the others, in
/// their order.
std::vector<std::size_t> forBatches(const SkinGraph& graph, const GravityTable& table, const SkinReadings& readings,
                                    std::span<const std::size_t> links,
                                    const std::function<void(const LinkBatch&)>& use);

}  // namespace hexoderm
