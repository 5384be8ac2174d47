#pragma once

#include "hexoderm/device/skinwire/codec.h"
#include "hexoderm/device/skinwire/skinwire.h"

#include <variant>

namespace hexoderm::skinwire {

/// Whether skinwire.h understood a command as the library means it.
inline bool isSame(const skinwire_command& in_c, const Command& command) {
  if (in_c.number != command.number) return false;
  if (const auto* rate = std::get_if<SetRate>(&command.request)) {
    return in_c.request == SKINWIRE_SET_RATE && in_c.of.set_rate.rate_hz == static_cast<float>(rate->rate_hz);
  }
  if (const auto* led = std::get_if<SetLed>(&command.request)) {
    const skinwire_set_led& found = in_c.of.set_led;
    return in_c.request == SKINWIRE_SET_LED && found.cell == led->cell && found.red == led->red &&
           found.green == led->green && found.blue == led->blue;
  }
  if (const auto* turn = std::get_if<TurnTo>(&command.request)) {
    return in_c.request == SKINWIRE_TURN_TO && in_c.of.turn_to.cell == turn->cell &&
           Eigen::Map<const Eigen::Vector3f>(in_c.of.turn_to.up) == turn->up_u.cast<float>();
  }
  if (std::holds_alternative<ExploreAgain>(command.request)) return in_c.request == SKINWIRE_EXPLORE_AGAIN;
  if (const auto* describe = std::get_if<Describe>(&command.request)) {
    const skinwire_describe& found = in_c.of.describe;
    return in_c.request == SKINWIRE_DESCRIBE && found.has_known_topology == describe->known_topology.has_value() &&
           (!found.has_known_topology || found.known_topology == *describe->known_topology);
  }
  return in_c.request == SKINWIRE_UNKNOWN;
}

}  // namespace hexoderm::skinwire
