// Any bytes from a host, read by skinwire.h, the device's side: it stays within its buffer, and what it takes for a
// command is what the library takes it for. The first byte of an input says how it comes (low 2 bits: which framing; 8:
// bodies with CRCs in order instead of raw bytes), the second how large the receiver's buffer is. A body: type, length
// of 16 bits, so many bytes of protobuf.

#include "hexoderm/device/skinwire/crc32c.h"
#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/device/skinwire/skinwire.h"

#include "tests/fuzz/fuzz_checks.h"
#include "tests/fuzz/fuzz_input.h"

#include <cmath>
#include <limits>
#include <utility>

namespace {

using namespace hexoderm;
using fuzz::ByteView;
using fuzz::FuzzInput;
using skinwire::Bytes;
using skinwire::Command;
using skinwire::Decoded;
using skinwire::DecodeOutcome;
using skinwire::Framing;

constexpr unsigned kFramings = 3;
constexpr unsigned kHasGoodBodies = 8;
constexpr std::uint8_t kGuard = 0xA5;
constexpr std::size_t kGuards = 16;

void append(ByteView bytes, Bytes& out) { out.insert(out.end(), bytes.begin(), bytes.end()); }

void putNumber(std::uint64_t value, std::size_t size, Bytes& out) {
  for (std::size_t k = 0; k < size; ++k) out.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
}

/// Bodies with their CRCs, in the framing; in a datagram only the last.
Bytes assemble(skinwire_framing framing, FuzzInput& input) {
  Bytes bytes;
  while (!input.atEnd()) {
    Bytes body = {skinwire::kMajor, input.byte()};
    append(input.piece(), body);
    putNumber(skinwire::crc32c(body), 4, body);
    if (framing == SKINWIRE_DATAGRAM) {
      bytes = std::move(body);
    } else if (framing == SKINWIRE_COBS) {
      append(skinwire::encodeCobs(body), bytes);
      bytes.push_back(0);
    } else {
      putNumber(body.size(), 4, bytes);
      append(body, bytes);
    }
  }
  return bytes;
}

struct Event {
  skinwire_event event;
  skinwire_command command;
};

/// One for each frame; after SKINWIRE_LOST no more.
std::vector<Event> eventsOf(ByteView bytes, skinwire_framing framing, std::size_t capacity) {
  std::vector<Event> events;
  if (framing == SKINWIRE_DATAGRAM) {
    Event event{};
    event.event = skinwire_read_body(bytes.data(), bytes.size(), &event.command);
    return {event};
  }
  Bytes buffer(capacity + kGuards, kGuard);
  skinwire_receiver receiver = skinwire_receiver_in(buffer.data(), capacity, framing);
  for (const std::uint8_t byte : bytes) {
    Event event{};
    event.event = skinwire_receive(&receiver, byte, &event.command);
    if (event.event != SKINWIRE_NOTHING) events.push_back(event);
    if (event.event == SKINWIRE_LOST) break;
  }
  for (std::size_t k = 0; k < kGuards; ++k) {
    fuzz::require(buffer.at(capacity + k) == kGuard, "no byte behind the receiver's buffer");
  }
  return events;
}

std::vector<Decoded> decodedByTheLibrary(ByteView bytes, skinwire_framing framing) {
  if (framing == SKINWIRE_DATAGRAM) return {skinwire::decodeBody(bytes)};
  std::vector<Decoded> all;
  skinwire::FrameDecoder decoder(framing == SKINWIRE_COBS ? Framing::Cobs : Framing::Length);
  decoder.feed(bytes);
  while (std::optional<Decoded> decoded = decoder.next()) all.push_back(std::move(*decoded));
  return all;
}

void requireSame(const skinwire_command& in_c, const Command& command) {
  fuzz::require(in_c.number == command.number, "the same number");
  if (const auto* rate = std::get_if<skinwire::SetRate>(&command.request)) {
    fuzz::require(in_c.request == SKINWIRE_SET_RATE && in_c.of.set_rate.rate_hz == static_cast<float>(rate->rate_hz),
                  "the same rate");
  } else if (const auto* led = std::get_if<skinwire::SetLed>(&command.request)) {
    const skinwire_set_led& found = in_c.of.set_led;
    fuzz::require(in_c.request == SKINWIRE_SET_LED && found.cell == led->cell && found.red == led->red &&
                      found.green == led->green && found.blue == led->blue,
                  "the same light");
  } else if (const auto* turn = std::get_if<skinwire::TurnTo>(&command.request)) {
    fuzz::require(in_c.request == SKINWIRE_TURN_TO && in_c.of.turn_to.cell == turn->cell, "the same turn");
    for (std::size_t k = 0; k < 3; ++k) {
      fuzz::require(in_c.of.turn_to.up[k] == static_cast<float>(turn->up_u[static_cast<Eigen::Index>(k)]),
                    "the same direction");
    }
  } else if (std::holds_alternative<skinwire::ExploreAgain>(command.request)) {
    fuzz::require(in_c.request == SKINWIRE_EXPLORE_AGAIN, "the same exploration");
  } else if (const auto* describe = std::get_if<skinwire::Describe>(&command.request)) {
    const skinwire_describe& found = in_c.of.describe;
    fuzz::require(in_c.request == SKINWIRE_DESCRIBE &&
                      found.has_known_topology == describe->known_topology.has_value() &&
                      (!found.has_known_topology || found.known_topology == *describe->known_topology),
                  "the same question");
  } else {
    fuzz::require(in_c.request == SKINWIRE_UNKNOWN, "no request that is known");
  }
}

/// skinwire.h leaves it to the host that `up` has length 1; the library asks for it.
bool isTurnToNoUnitVector(const skinwire_command& command) {
  constexpr double kSurely = 0.9e-3;
  if (command.request != SKINWIRE_TURN_TO) return false;
  double square = 0;
  for (const float value : command.of.turn_to.up) square += static_cast<double>(value) * static_cast<double>(value);
  return std::abs(std::sqrt(square) - 1) > kSurely;
}

/// A single has no rates below this.
bool isTooSlowForAFloat(const Command& command) {
  const auto* rate = std::get_if<skinwire::SetRate>(&command.request);
  return rate != nullptr && !(static_cast<float>(rate->rate_hz) > 0);
}

/// A command that the library understood is understood, written as the library writes it. As it came it may have been
/// longer than the buffer, or of an odd protobuf: a group, or a number in more bytes than it needs.
void requireUnderstoodAgain(const Command& command) {
  const Bytes body = skinwire::encodeBody(command);
  skinwire_command again{};
  fuzz::require(body.size() <= SKINWIRE_COMMAND_SIZE, "commands that fit the buffer");
  fuzz::require(skinwire_read_body(body.data(), body.size(), &again) == SKINWIRE_COMMAND,
                "every command that there is");
  requireSame(again, command);
}

void requireAgreement(const Event& event, const Decoded& decoded) {
  const auto* command = decoded.outcome == DecodeOutcome::Understood ? std::get_if<Command>(&decoded.message) : nullptr;
  if (event.event == SKINWIRE_COMMAND) {
    fuzz::require(command != nullptr || isTurnToNoUnitVector(event.command), "only what is a command");
    if (command != nullptr) requireSame(event.command, *command);
  }
  if (event.event == SKINWIRE_SKIPPED) {
    fuzz::require(command == nullptr && decoded.major != 0, "only what is whole, and no command");
  }
  if (event.event == SKINWIRE_LOST) {
    fuzz::require(decoded.outcome == DecodeOutcome::Broken, "nothing that could be read");
  }
  if (command != nullptr && !isTooSlowForAFloat(*command)) requireUnderstoodAgain(*command);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput input({data, size});
  const unsigned head = input.byte();
  const std::size_t capacity = input.byte();
  const auto framing = static_cast<skinwire_framing>((head & 3U) % kFramings);
  const Bytes assembled = (head & kHasGoodBodies) != 0 ? assemble(framing, input) : Bytes();
  const ByteView bytes = (head & kHasGoodBodies) != 0 ? ByteView(assembled) : input.rest();

  const std::vector<Event> events = eventsOf(bytes, framing, capacity);
  const std::vector<Decoded> decoded = decodedByTheLibrary(bytes, framing);
  // With lengths, the library may wait for a frame that is too short to be one, and it ends at a wrong CRC where the
  // receiver only leaves out what is too long for its buffer.
  const bool is_lost = !events.empty() && events.back().event == SKINWIRE_LOST;
  const bool is_stuck = framing == SKINWIRE_LENGTH && !decoded.empty() && decoded.back().major == 0;
  fuzz::require(events.size() == decoded.size() || (is_lost && events.size() == decoded.size() + 1) ||
                    (is_stuck && events.size() > decoded.size()),
                "as many frames as the library finds");
  for (std::size_t k = 0; k < std::min(events.size(), decoded.size()); ++k) requireAgreement(events[k], decoded[k]);
  return 0;
}
