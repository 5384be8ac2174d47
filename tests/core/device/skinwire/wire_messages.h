#pragma once

// Messages of a small skin: two cells, joined.

#include "hexoderm/device/skinwire/codec.h"
#include "hexoderm/device/skinwire/crc32c.h"

#include <cstdint>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

namespace hexoderm::skinwire {

/// A body with a right CRC around whatever payload.
inline Bytes bodyOf(std::uint8_t type, Bytes payload, std::uint8_t major = kMajor) {
  payload.insert(payload.begin(), {major, type});
  const std::uint32_t crc = crc32c(payload);
  for (unsigned k = 0; k < 4; ++k) payload.push_back(static_cast<std::uint8_t>(crc >> (8 * k)));
  return payload;
}

/// One piece after the other.
inline Bytes joined(std::initializer_list<Bytes> pieces) {
  Bytes bytes;
  for (const Bytes& piece : pieces) bytes.insert(bytes.end(), piece.begin(), piece.end());
  return bytes;
}

inline Hello helloMessage() { return {kMinor, "two cells", "hex-bma150", true, true, 1000, 7}; }

/// The same with another value of a field.
template <class Value>
Hello helloWith(Value Hello::*field, std::type_identity_t<Value> value) {
  Hello hello = helloMessage();
  hello.*field = std::move(value);
  return hello;
}

inline Topology topologyMessage() {
  return {3,
          0,
          1,
          {{CellId(1), "forearm", {{PortNumber(2), CellId(2), PortNumber(3)}, {PortNumber(1), CellId(0), {}}}},
           {CellId(2), "", {{PortNumber(3), CellId(1), {}}}}}};
}

/// Two ticks of two cells.
inline Samples rawSamples(std::uint64_t sequence, std::uint64_t time_us) {
  return {.sequence = sequence,
          .time_us = time_us,
          .period_us = 1000,
          .cells = {1, 2},
          .raw_lsb = {0, 0, 250, -64, 63, 240, 1, -1, 251, -512, 511, 239}};
}

inline Samples meanSamples() {
  return {.sequence = 44,
          .time_us = 3'000'000,
          .cells = {1, 300},
          .mean_g = {0, 0, 1, 0.5F, 0.5F, -0.75F},
          .variance_g2 = {0.25F, 0.25F, 0.25F, 0, 0, 0.125F},
          .count = {100, 7},
          .temperature_cells = {300},
          .temperature_c = {36.5F}};
}

inline Samples floatSamples() { return {.time_us = 2'000'000, .cells = {1}, .acceleration_g = {0.25F, -0.5F, 0.75F}}; }

/// One of every kind, and of every request.
inline std::vector<Message> everyMessage() {
  return {helloMessage(),
          topologyMessage(),
          rawSamples(40, 1'000'000),
          floatSamples(),
          meanSamples(),
          Status{"exploring", true, 5'000'000'000, 3},
          Command{1, SetRate{500}},
          Command{2, SetLed{7, 255, 0, 16}},
          Command{3, TurnTo{7, {0, -0.6, 0.8}}},
          Command{4, ExploreAgain{}},
          Command{5, Describe{3}},
          Command{6, Describe{}},
          Command{7, std::monostate{}},
          Ack{2, false, "there is no cell 7", false},
          Ack{3, false, "", true},
          Joints{1'000'000, {"elbow", "wrist_yaw"}, {1.25, -0.5}},
          Joints{1'100'000, {}, {1.5, 0.0}}};
}

}  // namespace hexoderm::skinwire
