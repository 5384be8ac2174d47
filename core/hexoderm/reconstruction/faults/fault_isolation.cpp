#include "hexoderm/reconstruction/faults/fault_isolation.h"

#include "hexoderm/reconstruction/faults/suspects.h"
#include "hexoderm/util/error.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace hexoderm {
namespace {

Finding describeInconsistentPose(PoseId pose) {
  return makeFinding(
      FindingCode::InconsistentPose,
      "In pose " + toString(pose) +
          " most neighbouring cells contradict each other, and without it they don't: the part probably moved "
          "while it was sampled. The pose is not used; take it again.",
      {}, {}, {pose});
}

void muteLinks(SkinLinks& skin, const std::vector<SuspectSearch::BadLink>& bad_links, std::vector<Finding>& findings) {
  std::map<FindingCode, std::vector<std::size_t>> links_by_code;
  for (const SuspectSearch::BadLink& bad : bad_links) {
    links_by_code[bad.findings.front().code].push_back(bad.link);
    findings.insert(findings.end(), bad.findings.begin(), bad.findings.end());
  }
  for (const auto& [code, links] : links_by_code) skin.mute(links, code);
}

}  // namespace

void setLinksAside(SkinLinks& skin, std::vector<Finding>& findings) {
  std::vector<std::size_t> links;
  for (const MutedLink& muted : skin.snapshot().muted_links) {
    const std::optional<std::size_t> link = skin.graph().indexOf(muted.source, muted.target);
    std::string text = "The " + linkInWords(muted.source, muted.target) + " was set aside by hand";
    if (!muted.why.empty()) text += " (" + muted.why + ")";
    text += link ? "; it is not used." : ", but the skin reports no such link.";
    findings.push_back(makeFinding(FindingCode::LinkSetAside, std::move(text), {muted.source.cell, muted.target.cell},
                                   {muted.source.port, muted.target.port}));
    if (link) links.push_back(*link);
  }
  if (!links.empty()) skin.mute(links, FindingCode::LinkSetAside);
}

void leaveOutCells(SkinLinks& skin, std::vector<Finding>& findings) {
  for (const CellId id : skin.options().left_out) {
    const std::optional<std::size_t> cell = skin.graph().indexOf(id);
    if (!cell) throw InvalidArgument("there is no cell " + toString(id) + " to be left out");
    skin.dropCell(*cell);
    findings.push_back(makeFinding(FindingCode::LeftOut,
                                   "Cell " + toString(id) + " was left out; it is placed through its links.", {id}));
  }
}

Completion isolateSuspects(SkinLinks& skin, const std::stop_token& stop, std::vector<Finding>& findings) {
  while (!stop.stop_requested()) {
    const SuspectSearch search(skin.model(), skin.graph(), skin.table(), skin.readings(), skin.edges(), skin.options());
    if (const auto pose = search.worstPose()) {
      findings.push_back(describeInconsistentPose(skin.poseId(*pose)));
      skin.dropPose(*pose);
    } else if (const auto cell = search.worstCell()) {
      findings.push_back(describeBadSensor(skin.graph(), skin.table(), skin.snapshot(), *cell, false));
      skin.dropCell(*cell);
    } else {
      muteLinks(skin, search.badLinks(), findings);
      return Completion::Finished;
    }
    skin.estimateEdges();
  }
  return Completion::Stopped;
}

}  // namespace hexoderm
