#pragma once

#include "hexoderm/device/skinwire/codec.h"

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>

namespace hexoderm::skinwire {

/// Messages of all kinds. Some break a rule that a device could break.
class RandomMessages {
 public:
  explicit RandomMessages(std::uint64_t seed) : random_(seed) {}

  std::uint64_t upTo(std::uint64_t most) { return std::uniform_int_distribution<std::uint64_t>(0, most)(random_); }
  bool chance(unsigned percent) { return upTo(99) < percent; }
  std::uint8_t byte() { return static_cast<std::uint8_t>(upTo(255)); }

  Message device() {
    const std::uint64_t kind = upTo(5);
    if (kind == 0) return hello();
    if (kind == 1) return topology();
    if (kind == 2) return Status{text(1005), chance(50), number(UINT64_MAX), number(UINT64_MAX)};
    if (kind == 3) return ack();
    return kind == 4 ? joints() : samples();
  }

  Message command() {
    Command command{static_cast<std::uint32_t>(number(UINT32_MAX)), {}};
    const std::uint64_t kind = upTo(5);  // 5: one that the device does not know
    if (kind == 0) {
      command.request = SetRate{chance(10) ? 1e6 : std::ldexp(1 + fraction(), static_cast<int>(upTo(59)) - 41)};
    }
    if (kind == 1) command.request = SetLed{id(), byte(), byte(), byte()};
    if (kind == 2) {
      Eigen::Vector3d up(fraction() - 0.5, fraction() - 0.5, fraction() - 0.5);
      if (chance(30)) up = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(upTo(2)));
      command.request = TurnTo{id(), up.normalized()};
    }
    if (kind == 3) command.request = ExploreAgain{};
    if (kind == 4) command.request = chance(50) ? Describe{} : Describe{static_cast<std::uint32_t>(number(UINT32_MAX))};
    return command;
  }

  Bytes garbage(std::size_t most) {
    Bytes bytes(upTo(most));
    for (std::uint8_t& one : bytes) one = chance(20) ? std::uint8_t{0} : byte();
    return bytes;
  }

 private:
  double fraction() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  /// Of any length in bits.
  std::uint64_t number(std::uint64_t most) { return chance(5) ? most : upTo(most) >> upTo(63); }
  std::uint32_t id() { return static_cast<std::uint32_t>(1 + number(UINT32_MAX - 1)); }
  float real() {
    if (chance(1))
      return chance(50) ? std::numeric_limits<float>::quiet_NaN() : -std::numeric_limits<float>::infinity();
    return std::ldexp(static_cast<float>(fraction()) - 0.5F, static_cast<int>(upTo(40)) - 20);
  }
  std::uint64_t time_us() { return chance(2) ? kMaxTime_us + upTo(1) : upTo(kMaxTime_us) >> upTo(53); }
  std::string text(std::size_t most) {
    std::string text;
    const std::size_t size = chance(70) ? upTo(20) : upTo(most);
    while (text.size() < size) text += chance(90) ? std::string(1, static_cast<char>(1 + upTo(126))) : "\xC3\xA4";
    return text;
  }

  Message hello() {
    return Hello{kMinor,
                 text(1005),
                 chance(95) ? text(400) + "x" : "",
                 chance(50),
                 chance(50),
                 static_cast<double>(real()),
                 static_cast<std::uint32_t>(number(UINT32_MAX))};
  }
  Message ack() { return Ack{static_cast<std::uint32_t>(number(UINT32_MAX)), chance(50), text(1005), chance(30)}; }
  Message topology() {
    Topology topology{static_cast<std::uint32_t>(number(UINT32_MAX)), 0, 1, {}};
    if (chance(30)) topology.parts = static_cast<std::uint32_t>(1 + number(kMaxCells));
    topology.part = static_cast<std::uint32_t>(upTo(topology.parts - (chance(90) ? 1 : 0)));
    for (std::uint64_t cells = upTo(12); cells > 0; --cells) {
      CellReport cell{CellId(id()), chance(20) ? text(1005) : "", {}};
      for (std::uint64_t ports = upTo(6); ports > 0; --ports) {
        NeighborReport neighbor{PortNumber(id()), CellId(chance(50) ? id() : 0), std::nullopt};
        if (chance(50)) neighbor.cell_port = PortNumber(id());
        cell.neighbors.push_back(neighbor);
      }
      topology.cells.push_back(std::move(cell));
    }
    return topology;
  }
  Message joints() {
    Joints joints{time_us(), {}, {}};
    joints.position.resize(upTo(10));
    for (double& position : joints.position) position = static_cast<double>(chance(2) ? 2e6F : real());
    if (chance(50)) {
      for (std::size_t k = 0; k < joints.position.size(); ++k) joints.names.push_back(text(50) + std::to_string(k));
    }
    return joints;
  }
  Message samples() {
    Samples samples;
    if (chance(70)) samples.sequence = time_us();
    samples.time_us = time_us();
    samples.period_us = static_cast<std::uint32_t>(chance(90) ? 1 + number(UINT32_MAX - 1) : 0);
    const std::size_t cells = chance(90) ? 1 + upTo(20) : 0;
    for (std::size_t k = 0; k < cells; ++k) samples.cells.push_back(id());
    const std::size_t kind = upTo(3);
    const std::size_t values = 3 * cells * (kind == 3 ? 1 : 1 + upTo(5));
    if (kind == 0) {
      for (std::size_t k = 0; k < values; ++k) samples.raw_lsb.push_back(static_cast<std::int16_t>(upTo(UINT16_MAX)));
    } else if (kind == 1) {
      for (std::size_t k = 0; k < values; ++k) samples.raw_lsb.push_back(static_cast<std::int32_t>(upTo(UINT32_MAX)));
    } else if (kind == 2) {
      for (std::size_t k = 0; k < values; ++k) samples.acceleration_g.push_back(real());
    } else {
      for (std::size_t k = 0; k < values; ++k) {
        samples.mean_g.push_back(real());
        samples.variance_g2.push_back(chance(99) ? std::abs(real()) : real());
      }
      for (std::size_t k = 0; k < cells; ++k) {
        samples.count.push_back(static_cast<std::uint32_t>(chance(99) ? id() : 0));
      }
    }
    for (std::uint64_t temperatures = chance(30) ? upTo(5) : 0; temperatures > 0; --temperatures) {
      samples.temperature_cells.push_back(id());
      samples.temperature_c.push_back(real());
    }
    return samples;
  }

  std::mt19937_64 random_;
};

}  // namespace hexoderm::skinwire
