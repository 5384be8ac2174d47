#pragma once

#include "hexoderm/base/finding.h"
#include "hexoderm/skin/cell_model.h"
#include "hexoderm/skin/cell_table.h"
#include "hexoderm/skin/neighbor_list.h"

#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

/// A vertex: one cell. Vertices are ordered by ID.
struct GraphCell {
  CellId id;
  std::string body_part;
  PatchId patch;
  std::size_t place = 0;  ///< among the cells of its patch, SkinGraph::patches()[patch]
};

/// A link joins port to port; it stands for the two directed edges source -> target and back. The source is the end
/// with the smaller (ID, port). A muted link is known but kept out of patches and of the solution.
struct GraphLink {
  std::size_t source = 0;  ///< index of the cell in SkinGraph::cells()
  std::size_t target = 0;
  PortNumber source_port;
  PortNumber target_port;
  std::optional<FindingCode> muted_by;

  [[nodiscard]] bool muted() const { return muted_by.has_value(); }  ///< the link is set aside, and not used
  /// The index of the cell at the other end.
  [[nodiscard]] std::size_t other(std::size_t cell) const { return cell == source ? target : source; }
};

/// The skin as a graph (lines 2 to 6 of the paper's Algorithm 1): cells, links, patches, and a finding for every report
/// that could not be used. Interface edges and edges between different known body parts are left out of the patches;
/// every kind of bad link is muted and named, and the rest still makes a graph.
class SkinGraph {
 public:
  /// Never throws for a bad topology; its faults are findings.
  SkinGraph(const CellModel& model, const NeighborList& neighbors);

  [[nodiscard]] const std::vector<GraphCell>& cells() const { return cells_; }  ///< all cells, by their index
  /// All links that can be used or are muted.
  [[nodiscard]] const std::vector<GraphLink>& links() const { return links_; }
  /// What is wrong with the neighbours that cells report.
  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  /// Nothing for a cell that is not in the graph.
  [[nodiscard]] std::optional<std::size_t> indexOf(CellId id) const { return table_.find(id); }
  /// Index of the link between two ports, in either order.
  [[nodiscard]] std::optional<std::size_t> indexOf(LinkEnd a, LinkEnd b) const;
  /// Indices of the links at a cell, muted ones included.
  [[nodiscard]] std::span<const std::size_t> linksAt(std::size_t cell) const {
    return std::span(links_at_).subspan(first_link_at_[cell], first_link_at_[cell + 1] - first_link_at_[cell]);
  }
  /// The cell and port that the link leaves.
  [[nodiscard]] LinkEnd sourceEnd(const GraphLink& link) const { return {cells_[link.source].id, link.source_port}; }
  /// The cell and port that the link leads to.
  [[nodiscard]] LinkEnd targetEnd(const GraphLink& link) const { return {cells_[link.target].id, link.target_port}; }

  /// Connected components over the links that are not muted, numbered in the order of their smallest cell ID; the cells
  /// of patch k, in ascending order, are patches()[k].
  [[nodiscard]] const std::vector<std::vector<std::size_t>>& patches() const { return patches_; }

  /// Takes links out of the solution and finds the patches again.
  void mute(std::span<const std::size_t> links, FindingCode why);

 private:
  void indexLinks();
  void findPatches();

  std::vector<GraphCell> cells_;
  std::vector<GraphLink> links_;
  std::vector<Finding> findings_;
  std::vector<std::size_t> links_at_;       ///< of all cells, one after the other
  std::vector<std::size_t> first_link_at_;  ///< per cell, and the end
  std::vector<std::vector<std::size_t>> patches_;
  CellTable table_;
};

/// "link 5 port 2 - 9 port 3", the one way a link is named in texts.
Message linkText(LinkEnd source, LinkEnd target);

}  // namespace hexoderm
