#include "hexoderm/graph/skin_graph.h"

#include "hexoderm/graph/boost_graph.h"

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace hexoderm {
namespace {

/// A cell's claim about one of its ports.
struct Claim {
  LinkEnd from;
  CellId to;
  std::optional<PortNumber> to_port;
};

Message endInWords(LinkEnd end) { return message("cell {} port {}", end.cell, end.port); }

/// Sorts the reports into links and findings.
class ReportSorter {
 public:
  ReportSorter(const CellModel& model, std::vector<Finding>& findings) : model_(model), findings_(findings) {}

  std::vector<GraphCell> sortCells(const NeighborList& neighbors) {
    std::vector<GraphCell> cells;
    for (const CellReport& report : neighbors) {
      if (report.id.value() == 0) {
        add(FindingCode::ReservedCellId,
            message("A cell carries the ID 0, which means \"no neighbour\"; it is left out."), {report.id});
      } else if (report.id >= model_.interface_id) {
        continue;  // an interface: part of the network, not of the skin
      } else if (!known_.insert(report.id).second) {
        add(FindingCode::DuplicateCell,
            message("Cell {} is listed more than once; only the first entry counts.", report.id), {report.id});
      } else {
        cells.push_back({report.id, report.body_part, PatchId(), 0});
        reports_.push_back(&report);
      }
    }
    std::ranges::sort(cells, {}, &GraphCell::id);
    return cells;
  }

  /// The links that both sides agree on, and muted ones for those that are known but bad.
  struct EndedLink {
    LinkEnd a;
    LinkEnd b;
    std::optional<FindingCode> muted_by;
  };
  std::vector<EndedLink> sortLinks() {
    collectClaims();
    for (const auto& [from, claim] : claims_) settle(claim);
    muteDoubleLinks();
    std::vector<EndedLink> links;
    for (const auto& [ends, muted_by] : links_) links.push_back({ends.first, ends.second, muted_by});
    return links;
  }

 private:
  void add(FindingCode code, Message words, std::vector<CellId> cells, std::vector<PortNumber> ports = {}) {
    findings_.push_back(makeFinding(code, std::move(words), std::move(cells), std::move(ports)));
  }

  void collectClaims() {
    std::set<LinkEnd> disputed;
    for (const CellReport* report : reports_) {
      for (const NeighborReport& neighbor : report->neighbors) {
        if (neighbor.cell.value() == 0) continue;
        const Claim claim{{report->id, neighbor.port}, neighbor.cell, neighbor.cell_port};
        if (!acceptable(claim)) continue;
        const auto [known, is_new] = claims_.try_emplace(claim.from, claim);
        if (is_new) continue;
        const Claim& first = known->second;
        if (first.to == claim.to && (first.to_port == claim.to_port || !claim.to_port)) {
          add(FindingCode::DuplicateLink,
              message("The neighbour at {} is reported more than once; it counts once.", endInWords(claim.from)),
              {claim.from.cell, claim.to}, {claim.from.port});
        } else {
          add(FindingCode::ContradictoryLink,
              message("Cell {} reports two different neighbours at port {}: cells {} and {}. Neither link is used.",
                      claim.from.cell, claim.from.port, first.to, claim.to),
              {claim.from.cell, first.to, claim.to}, {claim.from.port});
          disputed.insert(claim.from);
        }
      }
    }
    for (const LinkEnd& end : disputed) claims_.erase(end);
    disputed_ = std::move(disputed);
  }

  bool acceptable(const Claim& claim) {
    if (model_.findPort(claim.from.port) == nullptr) {
      add(FindingCode::UnknownPort,
          message("Cell {} reports a neighbour at port {}, but cell model {} has no such port. The link is not used.",
                  claim.from.cell, claim.from.port, model_.name),
          {claim.from.cell}, {claim.from.port});
      return false;
    }
    if (claim.to >= model_.interface_id) {
      add(FindingCode::InterfaceLink,
          message("A computer interface (ID {}) is connected at {}.", claim.to, endInWords(claim.from)),
          {claim.from.cell}, {claim.from.port});
      return false;
    }
    if (claim.to == claim.from.cell) {
      add(FindingCode::SelfLink,
          message("Cell {} reports itself as its neighbour at port {}. The link is not used.", claim.from.cell,
                  claim.from.port),
          {claim.from.cell}, {claim.from.port});
      return false;
    }
    if (!known_.contains(claim.to)) {
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
    return true;
  }

  /// Claims of `cell` that may be the other side of a claim made by `from`.
  [[nodiscard]] std::vector<LinkEnd> answers(CellId cell, LinkEnd from) const {
    std::vector<LinkEnd> ends;
    for (auto it = claims_.lower_bound({cell, PortNumber(0)}); it != claims_.end() && it->first.cell == cell; ++it) {
      const Claim& claim = it->second;
      if (claim.to == from.cell && claim.to_port.value_or(from.port) == from.port) ends.push_back(it->first);
    }
    return ends;
  }

  void settle(const Claim& claim) {
    if (!claim.to_port) {
      const std::vector<LinkEnd> ends = answers(claim.to, claim.from);
      if (ends.size() == 1) {
        // The other side may fit several of our ports as well; then the link is ambiguous.
        if (answers(claim.from.cell, ends.front()).size() == 1) {
          keep(claim.from, ends.front());
        } else {
          ambiguous(claim);
        }
      } else if (ends.empty()) {
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
    const auto answer = claims_.find(to);
    if (answer == claims_.end()) {
      mute(claim.from, to, disputed_.contains(to) ? FindingCode::ContradictoryLink : FindingCode::OneSidedLink);
      if (!disputed_.contains(to)) {
        add(FindingCode::OneSidedLink,
            message("Only cell {} reports the {}; cell {} does not report it back. The link is not used.",
                    claim.from.cell, linkInWords(claim.from, to), to.cell),
            {claim.from.cell, to.cell}, {claim.from.port, to.port});
      }
      return;
    }
    const Claim& back = answer->second;
    if (back.to == claim.from.cell && back.to_port.value_or(claim.from.port) == claim.from.port) {
      keep(claim.from, to);
      return;
    }
    mute(claim.from, to, FindingCode::ContradictoryLink);
    add(FindingCode::ContradictoryLink,
        message("Cell {} reports {} at its port {}, but that port reports {}. Neither link is used.", claim.from.cell,
                endInWords(to), claim.from.port,
                back.to_port ? endInWords({back.to, *back.to_port}) : message("cell {}", back.to)),
        {claim.from.cell, to.cell, back.to}, {claim.from.port, to.port});
  }

  void ambiguous(const Claim& claim) {
    add(FindingCode::ContradictoryLink,
        message("Cells {} and {} report each other at more than one port without naming the other side's; it can't be "
                "told which ports belong together. No link between them is used.",
                claim.from.cell, claim.to),
        {claim.from.cell, claim.to}, {claim.from.port});
  }

  static std::pair<LinkEnd, LinkEnd> ordered(LinkEnd a, LinkEnd b) { return a < b ? std::pair(a, b) : std::pair(b, a); }

  void keep(LinkEnd a, LinkEnd b) {
    const auto [entry, is_new] = links_.try_emplace(ordered(a, b), std::nullopt);
    if (is_new && model_.isForbidden(a.port, b.port)) {
      entry->second = FindingCode::ForbiddenPortPair;
      add(FindingCode::ForbiddenPortPair,
          message("The {} joins ports that cell model {} forbids to join. It is not used.",
                  linkInWords(entry->first.first, entry->first.second), model_.name),
          {entry->first.first.cell, entry->first.second.cell}, {entry->first.first.port, entry->first.second.port});
    }
  }

  void mute(LinkEnd a, LinkEnd b, FindingCode why) { links_.insert_or_assign(ordered(a, b), why); }

  /// Two rigid hexagons share one side at most.
  void muteDoubleLinks() {
    std::map<std::pair<CellId, CellId>, std::vector<std::pair<LinkEnd, LinkEnd>>> between;
    for (const auto& [ends, muted_by] : links_) {
      if (!muted_by) between[{ends.first.cell, ends.second.cell}].push_back(ends);
    }
    for (const auto& [cells, doubled] : between) {
      if (doubled.size() < 2) continue;
      for (const auto& ends : doubled) links_[ends] = FindingCode::DuplicateLink;
      add(FindingCode::DuplicateLink,
          message("Cells {} and {} are joined {} times, which two hexagons can't be. None of these links is used.",
                  cells.first, cells.second, doubled.size()),
          {cells.first, cells.second}, {doubled.front().first.port, doubled.front().second.port});
    }
  }

  const CellModel& model_;
  std::vector<Finding>& findings_;
  std::set<CellId> known_;
  std::vector<const CellReport*> reports_;
  std::map<LinkEnd, Claim> claims_;
  std::set<LinkEnd> disputed_;
  std::map<std::pair<LinkEnd, LinkEnd>, std::optional<FindingCode>> links_;
};

}  // namespace

SkinGraph::SkinGraph(const CellModel& model, const NeighborList& neighbors) {
  ReportSorter sorter(model, findings_);
  cells_ = sorter.sortCells(neighbors);
  index_of_.reserve(cells_.size());
  for (std::size_t k = 0; k < cells_.size(); ++k) index_of_.emplace(cells_[k].id, k);

  for (const auto& [a, b, muted_by] : sorter.sortLinks()) {
    GraphLink link{index_of_.at(a.cell), index_of_.at(b.cell), a.port, b.port, muted_by};
    const std::string& part_a = cells_[link.source].body_part;
    const std::string& part_b = cells_[link.target].body_part;
    if (!link.muted() && part_a != part_b && !part_a.empty() && !part_b.empty()) {
      link.muted_by = FindingCode::BodyPartBoundary;
      findings_.push_back(
          makeFinding(FindingCode::BodyPartBoundary,
                      message("The {} joins {} and {}; the patch ends there.", linkInWords(a, b), part_a, part_b),
                      {a.cell, b.cell}, {a.port, b.port}));
    }
    links_.push_back(link);
  }
  links_at_.resize(cells_.size());
  for (std::size_t k = 0; k < links_.size(); ++k) {
    links_at_[links_[k].source].push_back(k);
    links_at_[links_[k].target].push_back(k);
  }
  findPatches();
}

std::optional<std::size_t> SkinGraph::indexOf(CellId id) const {
  const auto found = index_of_.find(id);
  return found == index_of_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::size_t> SkinGraph::indexOf(LinkEnd a, LinkEnd b) const {
  const LinkEnd& smaller = std::min(a, b);
  const LinkEnd& larger = std::max(a, b);
  const auto cell = indexOf(smaller.cell);
  if (!cell) return std::nullopt;
  for (const std::size_t link : links_at_[*cell]) {
    if (sourceEnd(links_[link]) == smaller && targetEnd(links_[link]) == larger) return link;
  }
  return std::nullopt;
}

void SkinGraph::mute(std::span<const std::size_t> links, FindingCode why) {
  for (const std::size_t link : links) links_.at(link).muted_by = why;
  findPatches();
}

void SkinGraph::findPatches() {
  // Every link is there in both directions, so strong and plain components are the same; BGL's plain ones take an
  // undirected or symmetric graph. Components are numbered by their first vertex, that is by their smallest ID.
  const BoostGraph graph = makeBoostGraph(cells_, links_);
  std::vector<std::size_t> component(cells_.size());
  const std::size_t count = boost::connected_components(graph, component.data());
  patches_.assign(count, {});
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    cells_[k].patch = PatchId(static_cast<std::uint32_t>(component[k]));
    cells_[k].place = patches_[component[k]].size();
    patches_[component[k]].push_back(k);
  }
}

Message linkInWords(LinkEnd source, LinkEnd target) {
  return message("link {} port {} - {} port {}", source.cell, source.port, target.cell, target.port);
}

}  // namespace hexoderm
