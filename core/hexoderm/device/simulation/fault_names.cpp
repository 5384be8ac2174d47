#include "hexoderm/device/simulation/fault_names.h"

#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"

#include <algorithm>
#include <array>

namespace hexoderm {
namespace {

constexpr std::array<std::pair<std::string_view, SkinFault>, 12> kSkinFaults = {{{"dead", SkinFault::Dead},
                                                                                 {"stuck", SkinFault::Stuck},
                                                                                 {"stuck-axis", SkinFault::StuckAxis},
                                                                                 {"dead-axis", SkinFault::DeadAxis},
                                                                                 {"saturated", SkinFault::Saturated},
                                                                                 {"noisy", SkinFault::Noisy},
                                                                                 {"wrong-gain", SkinFault::WrongGain},
                                                                                 {"no-samples", SkinFault::NoSamples},
                                                                                 {"echo", SkinFault::Echo},
                                                                                 {"swapped", SkinFault::Swapped},
                                                                                 {"yawed", SkinFault::Yawed},
                                                                                 {"reglued", SkinFault::Reglued}}};
constexpr std::array<std::pair<std::string_view, WholeSkinFault>, 7> kWholeSkinFaults = {
    {{"identical", WholeSkinFault::Identical},
     {"axes-swapped", WholeSkinFault::AxesSwapped},
     {"axes-permuted", WholeSkinFault::AxesPermuted},
     {"ports-rotated", WholeSkinFault::PortsRotated},
     {"port-offset", WholeSkinFault::PortOffset},
     {"shuffled", WholeSkinFault::Shuffled},
     {"random", WholeSkinFault::Random}}};
constexpr std::array<std::pair<std::string_view, LinkFaultKind>, 3> kLinkFaults = {
    {{"wrong-port", LinkFaultKind::WrongPort}, {"joint", LinkFaultKind::Joint}, {"cable", LinkFaultKind::Cable}}};

template <class Kinds>
std::string namesOf(const Kinds& kinds) {
  std::string names;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    names += std::string(k == 0 ? "" : k + 1 == kinds.size() ? " or " : ", ") + std::string(kinds[k].first);
  }
  return names;
}

}  // namespace

std::span<const std::pair<std::string_view, SkinFault>> skinFaultNames() { return kSkinFaults; }
std::span<const std::pair<std::string_view, LinkFaultKind>> linkFaultNames() { return kLinkFaults; }
std::span<const std::pair<std::string_view, WholeSkinFault>> wholeSkinFaultNames() { return kWholeSkinFaults; }

std::string faultSyntax() {
  return "KIND:CELL with KIND " + namesOf(kSkinFaults) + ", or KIND:CELL:PORT with KIND " + namesOf(kLinkFaults) +
         ", or KIND alone, of the whole skin: " + namesOf(kWholeSkinFaults);
}

void addFault(const std::string& text, const std::string& what, SimulatedSkinOptions& skin) {
  const std::vector<std::string> parts = split(text, ':');
  const auto number = [&](std::size_t part) { return parseUnsigned(parts[part], what + " " + text); };
  const auto kindIn = [&](const auto& kinds, std::size_t part_count) {
    const auto* const found = std::ranges::find_if(kinds, [&](const auto& kind) { return kind.first == parts[0]; });
    return found != kinds.end() && parts.size() == part_count ? &found->second : nullptr;
  };
  if (const SkinFault* kind = kindIn(kSkinFaults, 2)) {
    skin.faults.push_back({*kind, CellId(number(1))});
  } else if (const WholeSkinFault* of_all = kindIn(kWholeSkinFaults, 1)) {
    skin.whole_skin_faults.push_back(*of_all);
  } else if (const LinkFaultKind* of_link = kindIn(kLinkFaults, 3)) {
    skin.link_faults.push_back({*of_link, {CellId(number(1)), PortNumber(number(2))}});
  } else {
    throw InvalidArgument(what + ": expected " + faultSyntax() + ", found \"" + text + "\"");
  }
}

}  // namespace hexoderm
