#include "hexoderm/device/simulation/fault_names.h"

#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"

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
  for (const auto& [name, kind] : kSkinFaults) {
    if (parts.size() != 2 || parts[0] != name) continue;
    skin.faults.push_back({kind, CellId(number(1))});
    return;
  }
  for (const auto& [name, kind] : kWholeSkinFaults) {
    if (parts.size() != 1 || parts[0] != name) continue;
    skin.whole_skin_faults.push_back(kind);
    return;
  }
  for (const auto& [name, kind] : kLinkFaults) {
    if (parts.size() != 3 || parts[0] != name) continue;
    skin.link_faults.push_back({kind, {CellId(number(1)), PortNumber(number(2))}});
    return;
  }
  throw InvalidArgument(what + ": expected " + faultSyntax() + ", found \"" + text + "\"");
}

}  // namespace hexoderm
