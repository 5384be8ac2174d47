#include "hexoderm/solve/checks/loop_search.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/result/result_graph.h"
#include "hexoderm/solve/tree/gap_share.h"

#include <boost/graph/incremental_components.hpp>
#include <boost/property_map/vector_property_map.hpp>

#include <algorithm>

namespace hexoderm {
namespace {

struct FreePort {
  LinkEnd end;
  Eigen::Vector3d center;   ///< centre of its cell, patch frame
  Eigen::Vector3d point;    ///< its link point
  Eigen::Vector3d outward;  ///< unit

  [[nodiscard]] bool looksAt(const FreePort& other) const {
    constexpr double kWithin = 45 * kDegree;
    return angleBetween(outward, other.center - center) <= kWithin;
  }
};

class LoopSearch {
 public:
  explicit LoopSearch(const Reconstruction& reconstruction)
      : model_(*reconstruction.model),
        limit_m_(reconstruction.options.max_opening * model_.link_sigma_m),
        graph_(reconstruction.graph()),
        chains_(graph_) {
    boost::initialize_incremental_components(graph_.graph(), joined_);
  }

  void findOpen(const PatchReconstruction& patch, std::vector<FoundLoop>& loops) {
    const double max_gap = model_.reach_m();
    std::vector<FreePort> ports = freePorts(patch);
    std::ranges::sort(ports, {}, [](const FreePort& port) { return port.point.x(); });
    for (std::size_t a = 0; a < ports.size(); ++a) {
      for (std::size_t b = a + 1; b < ports.size() && ports[b].point.x() - ports[a].point.x() <= max_gap; ++b) {
        if (ports[a].end.cell == ports[b].end.cell || (ports[a].point - ports[b].point).norm() > max_gap) continue;
        if (!ports[a].looksAt(ports[b]) || !ports[b].looksAt(ports[a])) continue;
        const bool in_order = ports[a].end < ports[b].end;
        addOpen(patch.id, ports[in_order ? a : b], ports[in_order ? b : a], loops);
      }
    }
  }

  void findClosed(const PatchReconstruction& patch, std::vector<FoundLoop>& loops) {
    for (const ResultEdge& closing : edgesOutsideTree(patch)) {
      const std::vector<ResultEdge> chain = chainBetween(closing.tail(), closing.head(), closing.link);
      if (chain.empty()) continue;
      FoundLoop loop = begin(patch.id, closing.tail(), closing.head(), chain);
      loop.closed = true;
      loop.limit_m = limit_m_;
      for (const ResultEdge& edge : chain) loop.closure.gap_m += across(edge);
      // The way back to the source goes through the closing link itself.
      loop.closure.gap_m += across({closing.link, false, true});
      loop.closure.loop_length_m += lengthAcross(model_, *closing.link);
      finish(loop.closure);
      loops.push_back(std::move(loop));
    }
  }

 private:
  std::vector<ResultEdge> chainBetween(LinkEnd first, LinkEnd second, const LinkEstimate* but = nullptr) {
    return chains_.between(*graph_.find(first.cell), *graph_.find(second.cell), but);
  }

  [[nodiscard]] const ResultCell& at(CellId cell) const { return graph_.graph()[*graph_.find(cell)]; }

  [[nodiscard]] bool joins(const PatchReconstruction& patch, const LinkEstimate& link) const {
    return link.used && patch.findCell(link.source.cell) != nullptr && patch.findCell(link.target.cell) != nullptr;
  }

  /// The way from the centre of a cell to the centre of its neighbour, by the estimated orientations.
  [[nodiscard]] Eigen::Vector3d across(const ResultEdge& edge) const {
    const LinkEstimate& link = *edge.link;
    const Eigen::Vector3d p_c = model_.port(link.source.port).vector_m;
    const Eigen::Vector3d p_n = model_.port(link.target.port).vector_m;
    const ResultCell& source = at(link.source.cell);
    const Eigen::Matrix3d& R_o_c = source.placement->T_o_u.R;
    const Eigen::Matrix3d& R_o_n = at(link.target.cell).placement->T_o_u.R;
    Eigen::Vector3d way = R_o_c * p_c - R_o_n * p_n;
    if (source.patch->gap_share) {
      const double e = (p_c.norm() + p_n.norm()) / 2;
      way += source.patch->gap_share->share * arcOpening_m(R_o_c * p_c.normalized(), R_o_n * p_n.normalized(), e);
    }
    return edge.forwards ? way : Eigen::Vector3d(-way);
  }

  [[nodiscard]] std::vector<FreePort> freePorts(const PatchReconstruction& patch) const {
    std::vector<LinkEnd> joined;
    for (const LinkEstimate& link : patch.links) {
      if (!joins(patch, link)) continue;
      joined.push_back(link.source);
      joined.push_back(link.target);
    }
    std::ranges::sort(joined);
    std::vector<FreePort> ports;
    for (const CellPlacement& cell : patch.cells) {
      for (const Port& port : model_.ports) {
        const LinkEnd end{cell.cell, port.number};
        if (std::ranges::binary_search(joined, end)) continue;
        ports.push_back({end, cell.T_o_u.t, cell.T_o_u * port.vector_m, cell.T_o_u.R * port.vector_m.normalized()});
      }
    }
    return ports;
  }

  void addOpen(PatchId patch, const FreePort& first, const FreePort& second, std::vector<FoundLoop>& loops) {
    const std::vector<ResultEdge> chain = chainBetween(first.end, second.end);
    if (chain.size() < 2) return;  // two joined cells may have more ports that face each other
    FoundLoop loop = begin(patch, first.end, second.end, chain);
    loop.closure.gap_m = first.point - second.point;
    loop.closure.loop_length_m +=
        model_.port(first.end.port).vector_m.norm() + model_.port(second.end.port).vector_m.norm();
    finish(loop.closure);
    loops.push_back(std::move(loop));
  }

  [[nodiscard]] FoundLoop begin(PatchId patch, LinkEnd first, LinkEnd second,
                                const std::vector<ResultEdge>& chain) const {
    FoundLoop loop;
    loop.patch = patch;
    loop.closure.first = first;
    loop.closure.second = second;
    loop.cells.push_back(first.cell);
    for (const ResultEdge& edge : chain) {
      loop.cells.push_back(edge.head().cell);
      loop.closure.loop_length_m += lengthAcross(model_, *edge.link);
    }
    return loop;
  }

  static void finish(LoopEvaluation& closure) {
    closure.length_m = closure.gap_m.norm();
    closure.percent = closure.loop_length_m > 0 ? 100 * closure.length_m / closure.loop_length_m : 0;
  }

  /// Used links that some spanning tree leaves over: the solver's, where every cell hangs on it, else one made here.
  [[nodiscard]] std::vector<ResultEdge> edgesOutsideTree(const PatchReconstruction& patch) {
    std::vector<ResultEdge> used;
    for (const LinkEstimate& link : patch.links) {
      if (joins(patch, link)) used.push_back({&link, true, true});
    }
    std::stable_partition(used.begin(), used.end(), [](const ResultEdge& edge) { return edge.link->in_tree; });
    std::vector<ResultEdge> outside;
    for (const ResultEdge& edge : used) {
      const std::size_t a = *graph_.find(edge.link->source.cell);
      const std::size_t b = *graph_.find(edge.link->target.cell);
      if (boost::same_component(a, b, joined_)) {
        outside.push_back(edge);
      } else {
        joined_.union_set(a, b);
      }
    }
    return outside;
  }

  const CellModel& model_;
  double limit_m_;
  const ResultGraph& graph_;
  ChainSearch chains_;
  using PerCell = boost::vector_property_map<std::size_t>;
  boost::disjoint_sets<PerCell, PerCell> joined_{PerCell(), PerCell()};  ///< cells, by the links of spanning trees
};

}  // namespace

std::vector<FoundLoop> findLoops(const Reconstruction& reconstruction) {
  std::vector<FoundLoop> loops;
  if (reconstruction.patches.empty()) return loops;
  LoopSearch search(reconstruction);
  for (const PatchReconstruction& patch : reconstruction.patches) {
    search.findOpen(patch, loops);
    search.findClosed(patch, loops);
  }
  std::ranges::stable_sort(loops, [](const FoundLoop& a, const FoundLoop& b) {
    return a.closed != b.closed ? b.closed : a.closure.length_m > b.closure.length_m;
  });
  return loops;
}

}  // namespace hexoderm
