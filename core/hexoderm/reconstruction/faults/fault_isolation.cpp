#include "hexoderm/reconstruction/faults/fault_isolation.h"

#include "hexoderm/reconstruction/faults/suspects.h"
#include "hexoderm/util/error.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace hexoderm {
namespace {

Finding describeInconsistentPose(PoseId pose) {
  return makeFinding(FindingCode::InconsistentPose,
                     message("In pose {} most neighbouring cells contradict each other, and without it they don't: the "
                             "part probably moved while it was sampled. The pose is not used; take it again.",
                             pose),
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

Message setAsideInWords(const MutedLink& muted, bool is_reported) {
  const Message link = linkInWords(muted.source, muted.target);
  if (muted.why.empty()) {
    return is_reported ? message("The {} was set aside by hand; it is not used.", link)
                       : message("The {} was set aside by hand, but the skin reports no such link.", link);
  }
  return is_reported
             ? message("The {} was set aside by hand ({}); it is not used.", link, muted.why)
             : message("The {} was set aside by hand ({}), but the skin reports no such link.", link, muted.why);
}

}  // namespace

void setLinksAside(SkinLinks& skin, std::vector<Finding>& findings) {
  std::vector<std::size_t> links;
  for (const MutedLink& muted : skin.snapshot().muted_links) {
    const std::optional<std::size_t> link = skin.graph().indexOf(muted.source, muted.target);
    findings.push_back(makeFinding(FindingCode::LinkSetAside, setAsideInWords(muted, link.has_value()),
                                   {muted.source.cell, muted.target.cell}, {muted.source.port, muted.target.port}));
    if (link) links.push_back(*link);
  }
  if (!links.empty()) skin.mute(links, FindingCode::LinkSetAside);
}

void leaveOutCells(SkinLinks& skin, std::vector<Finding>& findings) {
  for (const CellId id : skin.options().left_out) {
    const std::optional<std::size_t> cell = skin.graph().indexOf(id);
    if (!cell) throw InvalidArgument(message("there is no cell {} to be left out", id));
    skin.dropCell(*cell);
    findings.push_back(
        makeFinding(FindingCode::LeftOut, message("Cell {} was left out; it is placed through its links.", id), {id}));
  }
}

Completion isolateSuspects(SkinLinks& skin, const std::stop_token& stop, std::vector<Finding>& findings) {
  std::vector<std::size_t> suspicious;
  const auto searchAll = [&skin] {
    return std::make_unique<SuspectSearch>(skin.model(), skin.graph(), skin.table(), skin.readings(), skin.edges(),
                                           skin.options());
  };
  std::unique_ptr<SuspectSearch> search = searchAll();
  while (!stop.stop_requested()) {
    if (const auto pose = search->worstPose()) {
      findings.push_back(describeInconsistentPose(skin.poseId(*pose)));
      skin.dropPose(*pose);
      skin.estimateEdges();
      search = searchAll();
    } else if (const auto cell = search->worstCell(suspicious)) {
      if (hasTooFewPoses(skin.table(), *cell) && !search->isClearlyWrong(*cell)) {
        findings.push_back(describeSuspiciousSensor(skin.graph(), skin.table(), *cell));
        suspicious.push_back(*cell);
        continue;
      }
      findings.push_back(describeBadSensor(skin.graph(), skin.table(), skin.snapshot(), *cell, false));
      skin.dropCell(*cell);
      search->update(skin.estimateEdgesAround(*cell));
    } else {
      muteLinks(skin, search->badLinks(suspicious), findings);
      return Completion::Finished;
    }
  }
  return Completion::Stopped;
}

}  // namespace hexoderm
