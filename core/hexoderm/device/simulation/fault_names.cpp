#include "hexoderm/device/simulation/fault_names.h"

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

}  // namespace

std::span<const std::pair<std::string_view, SkinFault>> skinFaultNames() { return kSkinFaults; }
std::span<const std::pair<std::string_view, LinkFaultKind>> linkFaultNames() { return kLinkFaults; }
std::span<const std::pair<std::string_view, WholeSkinFault>> wholeSkinFaultNames() { return kWholeSkinFaults; }

}  // namespace hexoderm
