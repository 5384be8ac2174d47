#include "hexoderm/sim/fault_names.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"
#include "hexoderm/sim/simulated_skin.h"

namespace hexoderm {
namespace {

template <class Kind>
std::string anyOf(const EnumNames<Kind>& kinds) {
  const std::span<const std::string_view> names(kinds.names);
  return inARow(names.first(names.size() - 1)) + " or " + std::string(names.back());
}

}  // namespace

std::string faultSyntax() {
  return "KIND:CELL with KIND " + anyOf(kSkinFaultNames) + ", or KIND:CELL:PORT with KIND " + anyOf(kLinkFaultNames) +
         ", or KIND alone, of the whole skin: " + anyOf(kWholeSkinFaultNames);
}

void addFault(const std::string& text, const std::string& what, SkinChoice& skin) {
  const std::vector<std::string> parts = split(text, ':');
  const auto number = [&](std::size_t part) { return parseUnsigned(parts[part], what + " " + text); };
  const auto of_cell = kSkinFaultNames.find(parts[0]);
  const auto of_link = kLinkFaultNames.find(parts[0]);
  const auto of_all = kWholeSkinFaultNames.find(parts[0]);
  if (of_cell && parts.size() == 2) {
    skin.faults.push_back({*of_cell, CellId(number(1))});
  } else if (of_all && parts.size() == 1) {
    skin.whole_skin_faults.push_back(*of_all);
  } else if (of_link && parts.size() == 3) {
    skin.link_faults.push_back({*of_link, {CellId(number(1)), PortNumber(number(2))}});
  } else {
    throw InvalidArgument(what + ": expected " + faultSyntax() + ", found \"" + text + "\"");
  }
}

}  // namespace hexoderm
