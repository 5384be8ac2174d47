#pragma once

// The device's side in C, spoken to with the library's messages.

#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/device/skinwire/skinwire.h"
#include "tests/support/testing.h"

#include <variant>

namespace hexoderm::skinwire {

inline constexpr std::array<std::pair<skinwire_framing, std::optional<Framing>>, 3> kFramings = {
    {{SKINWIRE_COBS, Framing::Cobs}, {SKINWIRE_LENGTH, Framing::Length}, {SKINWIRE_DATAGRAM, std::nullopt}}};

/// Puts a message of the library, whose texts have no 0, into a frame.
inline std::size_t put(skinwire_frame& frame, const Message& message) {
  if (const auto* hello = std::get_if<Hello>(&message)) {
    const skinwire_hello in_c = {hello->device.c_str(), hello->cell_model.c_str(),          hello->can_light_cells,
                                 hello->can_turn,       static_cast<float>(hello->rate_hz), hello->stream};
    return skinwire_put_hello(&frame, &in_c);
  }
  if (const auto* topology = std::get_if<Topology>(&message)) {
    std::vector<std::vector<skinwire_port>> ports;
    std::vector<skinwire_cell> cells;
    for (const CellReport& cell : topology->cells) {
      std::vector<skinwire_port>& of_cell = ports.emplace_back();
      for (const NeighborReport& report : cell.neighbors) {
        of_cell.push_back({report.port.value(), report.cell.value(), report.cell_port ? report.cell_port->value() : 0});
      }
      cells.push_back({cell.id.value(), cell.body_part.c_str(), of_cell.data(), of_cell.size()});
    }
    const skinwire_topology in_c = {topology->id, topology->part, topology->parts, cells.data(), cells.size()};
    return skinwire_put_topology(&frame, &in_c);
  }
  if (const auto* samples = std::get_if<Samples>(&message)) {
    const auto orNull = [](const auto& values) { return values.empty() ? nullptr : values.data(); };
    std::vector<std::int16_t> narrow(samples->raw_lsb.begin(), samples->raw_lsb.end());
    const bool is_narrow = std::equal(narrow.begin(), narrow.end(), samples->raw_lsb.begin(), samples->raw_lsb.end());
    const skinwire_samples in_c = {samples->sequence.has_value(),
                                   samples->sequence.value_or(0),
                                   samples->time_us,
                                   samples->period_us,
                                   samples->cells.data(),
                                   samples->cells.size(),
                                   samples->ticks(),
                                   is_narrow ? orNull(narrow) : nullptr,
                                   is_narrow ? nullptr : orNull(samples->raw_lsb),
                                   orNull(samples->acceleration_g),
                                   orNull(samples->mean_g),
                                   orNull(samples->variance_g2),
                                   orNull(samples->count),
                                   samples->temperature_cells.data(),
                                   samples->temperature_c.data(),
                                   samples->temperature_c.size()};
    return skinwire_put_samples(&frame, &in_c);
  }
  if (const auto* status = std::get_if<Status>(&message)) {
    const skinwire_status in_c = {status->text.c_str(), status->exploring, status->samples_sent,
                                  status->samples_dropped};
    return skinwire_put_status(&frame, &in_c);
  }
  if (const auto* ack = std::get_if<Ack>(&message)) {
    const skinwire_ack in_c = {ack->command, ack->done, ack->working, ack->text.c_str()};
    return skinwire_put_ack(&frame, &in_c);
  }
  const auto& joints = std::get<Joints>(message);
  std::vector<const char*> names;
  for (const std::string& name : joints.names) names.push_back(name.c_str());
  const std::vector<float> position(joints.position.begin(), joints.position.end());
  const skinwire_joints in_c = {joints.time_us, names.empty() ? nullptr : names.data(), position.data(),
                                position.size()};
  return skinwire_put_joints(&frame, &in_c);
}

/// The frame of a message; empty if it was not put. The buffer is as large as a host allows, and as said.
inline Bytes framed(const Message& message, skinwire_framing framing = SKINWIRE_COBS,
                    std::size_t capacity = SKINWIRE_FRAME_SIZE(SKINWIRE_MAX_BODY)) {
  Bytes bytes(capacity);
  skinwire_frame frame = skinwire_frame_in(bytes.data(), bytes.size(), framing);
  bytes.resize(put(frame, message));
  EXPECT_EQ(bytes.empty(), frame.fault != SKINWIRE_FINE);
  return bytes;
}

inline Decoded decodeFrame(ByteView frame, std::optional<Framing> framing) {
  if (!framing) return decodeBody(frame);
  FrameDecoder decoder(framing);
  decoder.feed(frame);
  std::optional<Decoded> decoded = decoder.next();
  EXPECT_TRUE(decoded.has_value());
  EXPECT_EQ(decoder.buffered(), 0U);
  return decoded.value_or(Decoded());
}

}  // namespace hexoderm::skinwire
