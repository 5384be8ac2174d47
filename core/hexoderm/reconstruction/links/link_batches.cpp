#include "hexoderm/reconstruction/links/link_batches.h"

namespace hexoderm {
namespace {

class LinkBatcher {
 public:
  LinkBatcher(const SkinGraph& graph, const GravityTable& table, const SkinReadings& readings,
              const std::function<void(const LinkBatch&)>& use)
      : graph_(graph), table_(table), readings_(readings), use_(use), waiting_(table.enabledPoses().size() + 1) {}

  /// False for a link that is none for a batch.
  bool add(std::size_t index) {
    constexpr int kFewestPoses = 2;
    const GraphLink& link = graph_.links()[index];
    if (!readings_.measured(link)) return false;
    int poses = 0;
    for (const std::size_t pose : table_.enabledPoses()) poses += readings_.inBoth(link, pose) ? 1 : 0;
    if (poses < kFewestPoses) return false;
    LinkBatch& batch = waiting_[static_cast<std::size_t>(poses)];
    if (batch.poses == 0) makeRoom(batch, poses);
    batch.links.at(static_cast<std::size_t>(batch.size)) = index;
    fill(batch, batch.size, link);
    if (++batch.size == kLanes) handOut(batch);
    return true;
  }

  void finish() {
    for (LinkBatch& batch : waiting_) {
      if (batch.size == 0) continue;
      for (int lane = batch.size; lane < kLanes; ++lane) fill(batch, lane, graph_.links()[batch.links.front()]);
      handOut(batch);
    }
  }

 private:
  static void makeRoom(LinkBatch& batch, int poses) {
    const std::size_t count = static_cast<std::size_t>(kLanes) * static_cast<std::size_t>(poses);
    batch.poses = poses;
    batch.c_g.resize(3 * count);
    batch.n_g.resize(3 * count);
    batch.variance_g2.resize(count);
  }

  void fill(LinkBatch& batch, int lane, const GraphLink& link) const {
    auto to = static_cast<std::size_t>(lane);
    std::size_t to_variance = to;
    for (const std::size_t pose : table_.enabledPoses()) {
      if (!readings_.inBoth(link, pose)) continue;
      const Eigen::Vector3d& c = readings_.gravityOf(link.source, pose);
      const Eigen::Vector3d& n = readings_.gravityOf(link.target, pose);
      for (int axis = 0; axis < 3; ++axis, to += kLanes) {
        batch.c_g[to] = c[axis];
        batch.n_g[to] = n[axis];
      }
      batch.variance_g2[to_variance] =
          table_.at(link.source, pose).variance_g2 + table_.at(link.target, pose).variance_g2;
      to_variance += kLanes;
    }
  }

  void handOut(LinkBatch& batch) {
    use_(batch);
    batch.size = 0;
  }

  const SkinGraph& graph_;
  const GravityTable& table_;
  const SkinReadings& readings_;
  const std::function<void(const LinkBatch&)>& use_;
  std::vector<LinkBatch> waiting_;  ///< by their number of poses
};

}  // namespace

std::vector<std::size_t> forBatches(const SkinGraph& graph, const GravityTable& table, const SkinReadings& readings,
                                    std::span<const std::size_t> links,
                                    const std::function<void(const LinkBatch&)>& use) {
  LinkBatcher batcher(graph, table, readings, use);
  std::vector<std::size_t> others;
  for (const std::size_t link : links) {
    if (!batcher.add(link)) others.push_back(link);
  }
  batcher.finish();
  return others;
}

}  // namespace hexoderm
