// SkinLinks::attitudeCovariances(): usual cells several at a time, the others one by one.

#include "hexoderm/graph/shortest_paths.h"
#include "hexoderm/reconstruction/links/edge_batches.h"
#include "hexoderm/reconstruction/links/skin_links.h"

namespace hexoderm {
namespace {

/// Up to kLanes cells with equally many poses, side by side as in LinkBatch.
struct CellBatch {
  int size = 0;
  std::array<std::size_t, kLanes> entries{};
  std::vector<double> g_g;
  std::vector<double> variance_g2;
};

class AttitudeBatcher {
 public:
  AttitudeBatcher(const SkinLinks& skin, std::vector<Eigen::Matrix3d>& covariances, std::vector<bool>& done)
      : table_(skin.table()),
        options_(edgeKernelOptions(skin.model(), skin.options())),
        covariances_(covariances),
        done_(done),
        waiting_(2 * (table_.enabledPoses().size() + 1)) {}

  void add(std::size_t entry, std::size_t cell, bool is_centred) {
    std::size_t poses = 0;
    for (const std::size_t pose : table_.enabledPoses()) poses += table_.at(cell, pose).usable ? 1 : 0;
    constexpr std::size_t kFewestPoses = 2;
    constexpr std::size_t kFewestToCentre = 3;
    if (poses < kFewestPoses) return;
    const bool centred = is_centred && poses >= kFewestToCentre;
    CellBatch& batch = waiting_[2 * poses + (centred ? 1 : 0)];
    batch.g_g.resize(3 * kLanes * poses);
    batch.variance_g2.resize(kLanes * poses);
    batch.entries.at(static_cast<std::size_t>(batch.size)) = entry;
    fill(batch, batch.size, cell);
    if (++batch.size < kLanes) return;
    run(batch, poses, centred);
  }

  void finish() {
    for (std::size_t k = 0; k < waiting_.size(); ++k) {
      CellBatch& batch = waiting_[k];
      if (batch.size == 0) continue;
      // Lanes that are over repeat the first.
      for (std::size_t value = 0; value < batch.g_g.size(); ++value) repeat(batch.g_g, value, batch.size);
      for (std::size_t value = 0; value < batch.variance_g2.size(); ++value)
        repeat(batch.variance_g2, value, batch.size);
      run(batch, k / 2, k % 2 == 1);
    }
  }

 private:
  static void repeat(std::vector<double>& values, std::size_t at, int size) {
    const std::size_t lane = at % kLanes;
    if (lane >= static_cast<std::size_t>(size)) values[at] = values[at - lane];
  }

  void fill(CellBatch& batch, int lane, std::size_t cell) const {
    auto to = static_cast<std::size_t>(lane);
    std::size_t to_variance = to;
    for (const std::size_t pose : table_.enabledPoses()) {
      const GravityTable::Entry& entry = table_.at(cell, pose);
      if (!entry.usable) continue;
      for (int axis = 0; axis < 3; ++axis, to += kLanes) batch.g_g[to] = entry.mean_g[axis];
      batch.variance_g2[to_variance] = entry.variance_g2;
      to_variance += kLanes;
    }
  }

  void run(CellBatch& batch, std::size_t poses, bool centred) {
    AttitudeKernelOutput out{};
    (hasFourLanes() ? estimateAttitudesByFour : estimateAttitudesByOne)(
        options_, {static_cast<int>(poses), batch.g_g.data(), batch.variance_g2.data(), centred}, out);
    for (int lane = 0; lane < batch.size; ++lane) {
      if (out.usual[lane] == 0) continue;
      const std::size_t entry = batch.entries.at(static_cast<std::size_t>(lane));
      const auto at = [&](int k) { return out.covariance[kLanes * k + lane]; };
      covariances_[entry] << at(0), at(1), at(2), at(1), at(3), at(4), at(2), at(4), at(5);
      done_[entry] = true;
    }
    batch.size = 0;
  }

  const GravityTable& table_;
  EdgeKernelOptions options_;
  std::vector<Eigen::Matrix3d>& covariances_;
  std::vector<bool>& done_;
  std::vector<CellBatch> waiting_;  ///< by the number of poses and whether they are centred
};

}  // namespace

std::vector<Eigen::Matrix3d> SkinLinks::attitudeCovariances(std::span<const std::size_t> cells,
                                                            std::span<const std::size_t> links) const {
  std::vector<Eigen::Matrix3d> covariances(cells.size());
  std::vector<bool> done(cells.size(), false);
  AttitudeBatcher batcher(*this, covariances, done);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const bool is_usual = readings_.measured(cells[k]) && links[k] != kNoIndex && !edges_[links[k]].supported;
    if (is_usual) batcher.add(k, cells[k], edges_[links[k]].centred);
  }
  batcher.finish();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (!done[k]) covariances[k] = attitudeCovariance(cells[k], links[k]);
  }
  return covariances;
}

}  // namespace hexoderm
