#include "hexoderm/solve/faults/requested_exclusions.h"

#include "hexoderm/base/error.h"

#include <optional>

namespace hexoderm {
namespace {

Message setAsideText(const MutedLink& muted, bool is_reported) {
  const Message link = linkText(muted.source, muted.target);
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
    findings.push_back(makeFinding(FindingCode::LinkSetAside, setAsideText(muted, link.has_value()),
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

}  // namespace hexoderm
