#include "hexoderm/reconstruction/evaluation/loop_search.h"

#include "hexoderm/util/error.h"

#include "hexoderm/reconstruction/links/gap_share.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

namespace hexoderm {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

struct FreePort {
  LinkEnd end;
  Eigen::Vector3d center;   ///< centre of its cell, patch frame
  Eigen::Vector3d point;    ///< its link point
  Eigen::Vector3d outward;  ///< unit

  [[nodiscard]] bool looksAt(const FreePort& other, double max_angle_rad) const {
    return angleBetween(outward, other.center - center) <= max_angle_rad;
  }
};

class PatchLoops {
 public:
  PatchLoops(const Reconstruction& reconstruction, const PatchReconstruction& patch)
      : model_(*reconstruction.model),
        limit_m_(reconstruction.options.max_opening * model_.link_sigma_m),
        patch_(patch),
        links_at_(patch.cells.size()) {
    for (std::size_t cell = 0; cell < patch.cells.size(); ++cell) index_of_.emplace(patch.cells[cell].cell, cell);
    ends_.resize(patch.links.size(), {kNone, kNone});
    for (std::size_t k = 0; k < patch.links.size(); ++k) {
      const LinkEstimate& link = patch.links[k];
      const auto source = index_of_.find(link.source.cell);
      const auto target = index_of_.find(link.target.cell);
      if (!link.used || source == index_of_.end() || target == index_of_.end()) continue;
      ends_[k] = {source->second, target->second};
      links_at_[source->second].push_back(k);
      links_at_[target->second].push_back(k);
    }
    came_by_.assign(patch.cells.size(), kNone);
  }

  void findOpen(const LoopSearchOptions& options, std::vector<FoundLoop>& loops) {
    const double max_gap = options.max_gap_m.value_or(model_.reach_m());
    std::vector<FreePort> ports = freePorts();
    std::ranges::sort(ports, {}, [](const FreePort& port) { return port.point.x(); });
    for (std::size_t a = 0; a < ports.size(); ++a) {
      for (std::size_t b = a + 1; b < ports.size() && ports[b].point.x() - ports[a].point.x() <= max_gap; ++b) {
        if (ports[a].end.cell == ports[b].end.cell || (ports[a].point - ports[b].point).norm() > max_gap) continue;
        if (!ports[a].looksAt(ports[b], options.max_angle_rad) || !ports[b].looksAt(ports[a], options.max_angle_rad)) {
          continue;
        }
        const bool in_order = ports[a].end < ports[b].end;
        addOpen(ports[in_order ? a : b], ports[in_order ? b : a], loops);
      }
    }
  }

  void findClosed(std::vector<FoundLoop>& loops) {
    for (const std::size_t closing : linksOutsideTree()) {
      const LinkEstimate& link = patch_.links[closing];
      const std::vector<std::size_t> chain = chainBetween(ends_[closing].first, ends_[closing].second, closing);
      if (chain.empty()) continue;
      FoundLoop loop = begin(link.source, link.target, ends_[closing].first, chain);
      loop.closed = true;
      loop.limit_m = limit_m_;
      // The way back to the source goes through the closing link itself.
      std::size_t cell = ends_[closing].first;
      for (const std::size_t k : chain) {
        loop.closure.gap_m += acrossLink(k, cell);
        loop.closure.loop_length_m += lengthOf(k);
        cell = other(k, cell);
      }
      loop.closure.gap_m += acrossLink(closing, cell);
      loop.closure.loop_length_m += lengthOf(closing);
      finish(loop.closure);
      loops.push_back(std::move(loop));
    }
  }

 private:
  [[nodiscard]] std::size_t other(std::size_t link, std::size_t cell) const {
    return ends_[link].first == cell ? ends_[link].second : ends_[link].first;
  }
  [[nodiscard]] double lengthOf(std::size_t link) const {
    return model_.port(patch_.links[link].source.port).vector_m.norm() +
           model_.port(patch_.links[link].target.port).vector_m.norm();
  }

  /// The way from the centre of `from` to the centre of its neighbour, by the estimated orientations.
  [[nodiscard]] Eigen::Vector3d acrossLink(std::size_t link, std::size_t from) const {
    const bool forwards = ends_[link].first == from;
    const LinkEstimate& estimate = patch_.links[link];
    const Eigen::Vector3d p_c = model_.port(estimate.source.port).vector_m;
    const Eigen::Vector3d p_n = model_.port(estimate.target.port).vector_m;
    const Eigen::Matrix3d& R_o_c = patch_.cells[ends_[link].first].T_o_u.R;
    const Eigen::Matrix3d& R_o_n = patch_.cells[ends_[link].second].T_o_u.R;
    Eigen::Vector3d way = R_o_c * p_c - R_o_n * p_n;
    if (patch_.gap_share) {
      const double e = (p_c.norm() + p_n.norm()) / 2;
      way += patch_.gap_share->share * arcOpening_m(R_o_c * p_c.normalized(), R_o_n * p_n.normalized(), e);
    }
    return forwards ? way : Eigen::Vector3d(-way);
  }

  [[nodiscard]] std::vector<FreePort> freePorts() const {
    std::vector<LinkEnd> joined;
    for (std::size_t k = 0; k < patch_.links.size(); ++k) {
      if (ends_[k].first == kNone) continue;
      joined.push_back(patch_.links[k].source);
      joined.push_back(patch_.links[k].target);
    }
    std::ranges::sort(joined);
    std::vector<FreePort> ports;
    for (const CellPlacement& cell : patch_.cells) {
      for (const Port& port : model_.ports) {
        const LinkEnd end{cell.cell, port.number};
        if (std::ranges::binary_search(joined, end)) continue;
        ports.push_back({end, cell.T_o_u.t, cell.T_o_u * port.vector_m, cell.T_o_u.R * port.vector_m.normalized()});
      }
    }
    return ports;
  }

  void addOpen(const FreePort& first, const FreePort& second, std::vector<FoundLoop>& loops) {
    const std::size_t from = index_of_.at(first.end.cell);
    const std::vector<std::size_t> chain = chainBetween(from, index_of_.at(second.end.cell), kNone);
    if (chain.empty()) return;
    FoundLoop loop = begin(first.end, second.end, from, chain);
    loop.closure.gap_m = first.point - second.point;
    for (const std::size_t k : chain) loop.closure.loop_length_m += lengthOf(k);
    loop.closure.loop_length_m +=
        model_.port(first.end.port).vector_m.norm() + model_.port(second.end.port).vector_m.norm();
    finish(loop.closure);
    loops.push_back(std::move(loop));
  }

  [[nodiscard]] FoundLoop begin(LinkEnd first, LinkEnd second, std::size_t from,
                                const std::vector<std::size_t>& chain) const {
    FoundLoop loop;
    loop.patch = patch_.id;
    loop.closure.first = first;
    loop.closure.second = second;
    std::size_t cell = from;
    loop.cells.push_back(patch_.cells[cell].cell);
    for (const std::size_t k : chain) {
      cell = other(k, cell);
      loop.cells.push_back(patch_.cells[cell].cell);
    }
    return loop;
  }

  static void finish(LoopEvaluation& closure) {
    closure.length_m = closure.gap_m.norm();
    closure.percent = closure.loop_length_m > 0 ? 100 * closure.length_m / closure.loop_length_m : 0;
  }

  /// Used links that some spanning tree leaves over: the solver's, where every cell hangs on it, else one made here.
  [[nodiscard]] std::vector<std::size_t> linksOutsideTree() const {
    std::vector<std::size_t> used;
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      if (ends_[k].first != kNone) used.push_back(k);
    }
    std::stable_partition(used.begin(), used.end(), [&](std::size_t k) { return patch_.links[k].in_tree; });
    std::vector<std::size_t> parent(patch_.cells.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto rootOf = [&](std::size_t cell) {
      while (parent[cell] != cell) cell = parent[cell] = parent[parent[cell]];
      return cell;
    };
    std::vector<std::size_t> outside;
    for (const std::size_t k : used) {
      const std::size_t a = rootOf(ends_[k].first);
      const std::size_t b = rootOf(ends_[k].second);
      if (a == b) {
        outside.push_back(k);
      } else {
        parent[a] = b;
      }
    }
    return outside;
  }

  /// The links of a shortest chain, `without` left out; empty if there is none.
  [[nodiscard]] std::vector<std::size_t> chainBetween(std::size_t from, std::size_t to, std::size_t without) {
    // Searched backwards, so that the links come out in order.
    std::vector<std::size_t> open{to};
    std::vector<std::size_t> chain;
    came_by_[to] = kNone;
    std::unordered_set<std::size_t> seen{to};
    for (std::size_t next = 0; next < open.size() && !seen.contains(from); ++next) {
      for (const std::size_t k : links_at_[open[next]]) {
        const std::size_t cell = other(k, open[next]);
        if (k == without || !seen.insert(cell).second) continue;
        came_by_[cell] = k;
        open.push_back(cell);
      }
    }
    if (!seen.contains(from)) return chain;
    for (std::size_t cell = from; cell != to; cell = other(came_by_[cell], cell)) chain.push_back(came_by_[cell]);
    return chain;
  }

  const CellModel& model_;
  double limit_m_;
  const PatchReconstruction& patch_;
  std::unordered_map<CellId, std::size_t> index_of_;
  std::vector<std::pair<std::size_t, std::size_t>> ends_;  ///< per link, as indices of cells; kNone: not used
  std::vector<std::vector<std::size_t>> links_at_;
  std::vector<std::size_t> came_by_;  ///< results of the last search, valid for the cells it saw
};

}  // namespace

void LoopSearchOptions::validate() const {
  if (max_gap_m && !(*max_gap_m >= 0 && std::isfinite(*max_gap_m))) {
    throw InvalidArgument(message("loop search: the largest gap must be metres of 0 or more"));
  }
  if (!(max_angle_rad >= 0 && std::isfinite(max_angle_rad))) {
    throw InvalidArgument(message("loop search: the largest angle must be radians of 0 or more"));
  }
}

std::vector<FoundLoop> findLoops(const Reconstruction& reconstruction, const LoopSearchOptions& options) {
  options.validate();
  std::vector<FoundLoop> loops;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    PatchLoops search(reconstruction, patch);
    search.findOpen(options, loops);
    search.findClosed(loops);
  }
  std::ranges::stable_sort(loops, [](const FoundLoop& a, const FoundLoop& b) {
    return a.closed != b.closed ? b.closed : a.closure.length_m > b.closure.length_m;
  });
  return loops;
}

}  // namespace hexoderm
