#include "hexoderm/skin/skin_graph.h"

#include "hexoderm/skin/skin_graph_boost.h"

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <utility>

namespace hexoderm {
namespace {

/// A cell's claim about one of its ports.
struct Claim {
  LinkEnd from;
  CellId to;
  std::optional<PortNumber> to_port;
  std::size_t from_cell = 0;  ///< indices of the graph's cells
  std::size_t to_cell = 0;
  bool disputed = false;                   ///< another claim about the port says otherwise; none of them counts
  std::optional<std::size_t> joined_with;  ///< the claim of the other side that it made a link with
};

Message endText(LinkEnd end) { return message("cell {} port {}", end.cell, end.port); }

/// Sorts the reports into links and findings.
class ReportSorter {
 public:
  ReportSorter(const CellModel& model, std::vector<Finding>& findings) : model_(model), findings_(findings) {}

  std::vector<GraphCell> sortCells(const NeighborList& neighbors) {
    std::vector<std::pair<CellId, std::size_t>> entries;
    entries.reserve(neighbors.size());
    for (std::size_t k = 0; k < neighbors.size(); ++k) entries.emplace_back(neighbors[k].id, k);
    if (!std::ranges::is_sorted(entries)) std::ranges::sort(entries);
    std::vector<bool> is_repeated(neighbors.size(), false);
    for (std::size_t k = 1; k < entries.size(); ++k) {
      is_repeated[entries[k].second] = entries[k].first == entries[k - 1].first;
    }
    reports_.reserve(neighbors.size());
    for (std::size_t k = 0; k < neighbors.size(); ++k) {
      const CellReport& report = neighbors[k];
      if (report.id.value() == 0) {
        add(FindingCode::ReservedCellId,
            message("A cell carries the ID 0, which means \"no neighbour\"; it is left out."), {report.id});
      } else if (isInterface(report.id)) {
        continue;  // part of the network, not of the skin
      } else if (is_repeated[k]) {
        add(FindingCode::DuplicateCell,
            message("Cell {} is listed more than once; only the first entry counts.", report.id), {report.id});
      } else {
        reports_.push_back(&report);
      }
    }
    std::vector<GraphCell> cells;
    cells.reserve(reports_.size());
    for (const auto& [id, k] : entries) {
      if (id.value() == 0 || isInterface(id) || is_repeated[k]) continue;
      cells.push_back({id, neighbors[k].body_part, PatchId(), 0});
    }
    return cells;
  }

  /// The links that both sides agree on, and muted ones for those that are known but bad, in the order of their ends.
  /// `graph` has its cells.
  std::vector<GraphLink> sortLinks(const SkinGraph& graph) {
    collectClaims(graph);
    for (const auto& [first, last] : claims_of_) {
      for (std::size_t k = first; k < last; ++k) {
        if (!claims_[k].disputed) settle(k);
      }
    }
    const auto ends = [](const GraphLink& link) {
      return std::tuple(link.source, link.source_port, link.target, link.target_port);
    };
    if (!std::ranges::is_sorted(links_, {}, ends)) std::ranges::sort(links_, {}, ends);
    muteDoubleLinks(graph);
    return std::move(links_);
  }

 private:
  [[nodiscard]] bool isInterface(CellId id) const { return id >= model_.interface_id; }

  void add(FindingCode code, Message words, std::vector<CellId> cells, std::vector<PortNumber> ports = {}) {
    findings_.push_back(makeFinding(code, std::move(words), std::move(cells), std::move(ports)));
  }

  /// A report's claims stand together, in the order of their ports.
  void collectClaims(const SkinGraph& graph) {
    claims_of_.assign(graph.cells().size(), {0, 0});
    std::size_t count = 0;
    for (const CellReport* report : reports_) count += report->neighbors.size();
    claims_.reserve(count);
    links_.reserve(count / 2);
    for (const CellReport* report : reports_) {
      const std::size_t first = claims_.size();
      const std::size_t cell = graph.indexOf(report->id).value();
      for (const NeighborReport& neighbor : report->neighbors) {
        if (neighbor.cell.value() == 0) continue;
        Claim claim{{report->id, neighbor.port}, neighbor.cell, neighbor.cell_port, cell, 0, false, std::nullopt};
        if (!accept(graph, claim)) continue;
        if (Claim* known = find(first, claims_.size(), claim.from.port)) {
          compare(*known, claim);
        } else {
          claims_.push_back(claim);
        }
      }
      std::ranges::sort(claims_.begin() + static_cast<std::ptrdiff_t>(first), claims_.end(), {}, &Claim::from);
      claims_of_[cell] = {first, claims_.size()};
    }
  }

  /// A further claim about a port that there is one about.
  void compare(Claim& first, const Claim& claim) {
    if (first.to == claim.to && (first.to_port == claim.to_port || !claim.to_port)) {
      add(FindingCode::DuplicateLink,
          message("The neighbour at {} is reported more than once; it counts once.", endText(claim.from)),
          {claim.from.cell, claim.to}, {claim.from.port});
      return;
    }
    add(FindingCode::ContradictoryLink,
        message("Cell {} reports two different neighbours at port {}: cells {} and {}. Neither link is used.",
                claim.from.cell, claim.from.port, first.to, claim.to),
        {claim.from.cell, first.to, claim.to}, {claim.from.port});
    first.disputed = true;
  }

  /// Null if there is none; the first and the one after the last claim to look at are given.
  Claim* find(std::size_t first, std::size_t last, PortNumber port) {
    for (std::size_t k = first; k < last; ++k) {
      if (claims_[k].from.port == port) return &claims_[k];
    }
    return nullptr;
  }

  /// Fills in the cell that is claimed; false, with a finding, for a claim that can't be used.
  bool accept(const SkinGraph& graph, Claim& claim) {
    if (model_.findPort(claim.from.port) == nullptr) {
      add(FindingCode::UnknownPort,
          message("Cell {} reports a neighbour at port {}, but cell model {} has no such port. The link is not used.",
                  claim.from.cell, claim.from.port, model_.name),
          {claim.from.cell}, {claim.from.port});
      return false;
    }
    if (isInterface(claim.to)) {
      add(FindingCode::InterfaceLink,
          message("A computer interface (ID {}) is connected at {}.", claim.to, endText(claim.from)), {claim.from.cell},
          {claim.from.port});
      return false;
    }
    if (claim.to == claim.from.cell) {
      add(FindingCode::SelfLink,
          message("Cell {} reports itself as its neighbour at port {}. The link is not used.", claim.from.cell,
                  claim.from.port),
          {claim.from.cell}, {claim.from.port});
      return false;
    }
    const std::optional<std::size_t> to_cell = graph.indexOf(claim.to);
    if (!to_cell) {
      add(FindingCode::UnknownCell,
          message("Cell {} reports cell {} at port {}, but no such cell was found. The link is not used.",
                  claim.from.cell, claim.to, claim.from.port),
          {claim.from.cell, claim.to}, {claim.from.port});
      return false;
    }
    if (claim.to_port && model_.findPort(*claim.to_port) == nullptr) {
      add(FindingCode::UnknownPort,
          message("Cell {} reports port {} of cell {}, but cell model {} has no such port. The link is not used.",
                  claim.from.cell, *claim.to_port, claim.to, model_.name),
          {claim.to}, {*claim.to_port});
      return false;
    }
    claim.to_cell = *to_cell;
    return true;
  }

  /// Claims of a cell that may be the other side of a claim made by `from`: how many, and the first.
  struct Answers {
    std::size_t count = 0;
    std::size_t first = 0;
  };
  [[nodiscard]] Answers answers(std::size_t cell, LinkEnd from) const {
    Answers found;
    const auto [first, last] = claims_of_[cell];
    for (std::size_t k = first; k < last; ++k) {
      const Claim& claim = claims_[k];
      if (claim.disputed || claim.to != from.cell || claim.to_port.value_or(from.port) != from.port) continue;
      if (found.count++ == 0) found.first = k;
    }
    return found;
  }

  void settle(std::size_t index) {
    const Claim& claim = claims_[index];
    if (!claim.to_port) {
      const Answers back = answers(claim.to_cell, claim.from);
      if (back.count == 1) {
        // The other side may fit several of our ports as well; then the link is ambiguous.
        if (answers(claim.from_cell, claims_[back.first].from).count == 1) {
          join(index, back.first);
        } else {
          ambiguous(claim);
        }
      } else if (back.count == 0) {
        add(FindingCode::OneSidedLink,
            message("Cell {} reports cell {} at port {}, but cell {} does not report it back. The link is not used.",
                    claim.from.cell, claim.to, claim.from.port, claim.to),
            {claim.from.cell, claim.to}, {claim.from.port});
      } else {
        ambiguous(claim);
      }
      return;
    }
    const LinkEnd to{claim.to, *claim.to_port};
    const auto [first, last] = claims_of_[claim.to_cell];
    const Claim* back = find(first, last, to.port);
    if (back == nullptr || back->disputed) {
      addLink(claim, to.port, back == nullptr ? FindingCode::OneSidedLink : FindingCode::ContradictoryLink);
      if (back == nullptr) {
        add(FindingCode::OneSidedLink,
            message("Only cell {} reports the {}; cell {} does not report it back. The link is not used.",
                    claim.from.cell, linkText(claim.from, to), to.cell),
            {claim.from.cell, to.cell}, {claim.from.port, to.port});
      }
      return;
    }
    if (back->to == claim.from.cell && back->to_port.value_or(claim.from.port) == claim.from.port) {
      join(index, static_cast<std::size_t>(back - claims_.data()));
      return;
    }
    addLink(claim, to.port, FindingCode::ContradictoryLink);
    add(FindingCode::ContradictoryLink,
        message("Cell {} reports {} at its port {}, but that port reports {}. Neither link is used.", claim.from.cell,
                endText(to), claim.from.port,
                back->to_port ? endText({back->to, *back->to_port}) : message("cell {}", back->to)),
        {claim.from.cell, to.cell, back->to}, {claim.from.port, to.port});
  }

  void ambiguous(const Claim& claim) {
    add(FindingCode::ContradictoryLink,
        message("Cells {} and {} report each other at more than one port without naming the other side's; it can't be "
                "told which ports belong together. No link between them is used.",
                claim.from.cell, claim.to),
        {claim.from.cell, claim.to}, {claim.from.port});
  }

  /// A claim and what answers it. Both sides come here; the link is made once.
  void join(std::size_t index, std::size_t back) {
    if (claims_[back].joined_with == index) return;
    claims_[index].joined_with = back;
    addLink(claims_[index], claims_[back].from.port, std::nullopt);
    if (GraphLink& link = links_.back(); model_.isForbidden(link.source_port, link.target_port)) {
      link.muted_by = FindingCode::ForbiddenPortPair;
      const auto& [a, b] = std::minmax(claims_[index].from, claims_[back].from);
      add(FindingCode::ForbiddenPortPair,
          message("The {} joins ports that cell model {} forbids to join. It is not used.", linkText(a, b),
                  model_.name),
          {a.cell, b.cell}, {a.port, b.port});
    }
  }

  /// Cells are in the order of their IDs.
  void addLink(const Claim& claim, PortNumber to_port, std::optional<FindingCode> muted_by) {
    if (claim.from_cell < claim.to_cell) {
      links_.push_back({claim.from_cell, claim.to_cell, claim.from.port, to_port, muted_by});
    } else {
      links_.push_back({claim.to_cell, claim.from_cell, to_port, claim.from.port, muted_by});
    }
  }

  /// Two rigid hexagons share one side at most.
  void muteDoubleLinks(const SkinGraph& graph) {
    std::vector<std::size_t> used;  // of one source, those to the same target together
    for (std::size_t first = 0; first < links_.size();) {
      used.clear();
      std::size_t last = first;
      for (; last < links_.size() && links_[last].source == links_[first].source; ++last) {
        if (!links_[last].muted()) used.push_back(last);
      }
      std::ranges::sort(used, {}, [&](std::size_t k) { return std::pair(links_[k].target, k); });
      for (auto from = used.begin(); from != used.end();) {
        const auto to =
            std::find_if(from, used.end(), [&](std::size_t k) { return links_[k].target != links_[*from].target; });
        if (to - from > 1) muteTogether(graph, {from, to});
        from = to;
      }
      first = last;
    }
  }

  void muteTogether(const SkinGraph& graph, std::span<const std::size_t> doubled) {
    for (const std::size_t k : doubled) links_[k].muted_by = FindingCode::DuplicateLink;
    const GraphLink& link = links_[doubled.front()];
    const CellId source = graph.cells()[link.source].id;
    const CellId target = graph.cells()[link.target].id;
    add(FindingCode::DuplicateLink,
        message("Cells {} and {} are joined {} times, which two hexagons can't be. None of these links is used.",
                source, target, doubled.size()),
        {source, target}, {link.source_port, link.target_port});
  }

  const CellModel& model_;
  std::vector<Finding>& findings_;
  std::vector<const CellReport*> reports_;
  std::vector<Claim> claims_;
  std::vector<std::pair<std::size_t, std::size_t>> claims_of_;  ///< per cell, the first and the one after the last
  std::vector<GraphLink> links_;
};

}  // namespace

SkinGraph::SkinGraph(const CellModel& model, const NeighborList& neighbors) {
  ReportSorter sorter(model, findings_);
  cells_ = sorter.sortCells(neighbors);
  std::vector<CellId> ids;
  ids.reserve(cells_.size());
  for (const GraphCell& cell : cells_) ids.push_back(cell.id);
  table_ = CellTable(ids);
  links_ = sorter.sortLinks(*this);
  for (GraphLink& link : links_) {
    const std::string& part_a = cells_[link.source].body_part;
    const std::string& part_b = cells_[link.target].body_part;
    if (!link.muted() && part_a != part_b && !part_a.empty() && !part_b.empty()) {
      link.muted_by = FindingCode::BodyPartBoundary;
      const LinkEnd a = sourceEnd(link);
      const LinkEnd b = targetEnd(link);
      findings_.push_back(
          makeFinding(FindingCode::BodyPartBoundary,
                      message("The {} joins {} and {}; the patch ends there.", linkText(a, b), part_a, part_b),
                      {a.cell, b.cell}, {a.port, b.port}));
    }
  }
  indexLinks();
  findPatches();
}

void SkinGraph::indexLinks() {
  first_link_at_.assign(cells_.size() + 1, 0);
  for (const GraphLink& link : links_) {
    ++first_link_at_[link.source + 1];
    ++first_link_at_[link.target + 1];
  }
  std::partial_sum(first_link_at_.begin(), first_link_at_.end(), first_link_at_.begin());
  links_at_.resize(2 * links_.size());
  std::vector<std::size_t> next(first_link_at_.begin(), first_link_at_.end() - 1);
  for (std::size_t k = 0; k < links_.size(); ++k) {
    links_at_[next[links_[k].source]++] = k;
    links_at_[next[links_[k].target]++] = k;
  }
}

std::optional<std::size_t> SkinGraph::indexOf(LinkEnd a, LinkEnd b) const {
  const LinkEnd& smaller = std::min(a, b);
  const LinkEnd& larger = std::max(a, b);
  const auto cell = indexOf(smaller.cell);
  if (!cell) return std::nullopt;
  for (const std::size_t link : linksAt(*cell)) {
    if (sourceEnd(links_[link]) == smaller && targetEnd(links_[link]) == larger) return link;
  }
  return std::nullopt;
}

void SkinGraph::mute(std::span<const std::size_t> links, FindingCode why) {
  for (const std::size_t link : links) links_.at(link).muted_by = why;
  findPatches();
}

void SkinGraph::findPatches() {
  // Components are numbered in the order of their first vertices, and so of their smallest IDs.
  std::vector<std::uint32_t> patch_of(cells_.size());
  patches_.assign(boost::connected_components(*this, patch_of.data()), {});
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    std::vector<std::size_t>& patch = patches_[patch_of[k]];
    cells_[k].patch = PatchId(patch_of[k]);
    cells_[k].place = patch.size();
    patch.push_back(k);
  }
}

Message linkText(LinkEnd source, LinkEnd target) {
  return message("link {} port {} - {} port {}", source.cell, source.port, target.cell, target.port);
}

}  // namespace hexoderm
