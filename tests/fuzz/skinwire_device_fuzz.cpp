// Any bytes from a host, read by skinwire.h, the device's side: it stays within its buffer, and what it takes for a
// command is what the library takes it for. The first byte of an input says how it comes (low 2 bits: which framing; 8:
// bodies with CRCs in order instead of raw bytes), the second how large the receiver's buffer is. A body: type, length
// of 16 bits, so many bytes of protobuf.

#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/device/skinwire/skinwire.h"

#include "tests/core/device/skinwire/commands_in_c.h"
#include "tests/fuzz/fuzz_checks.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/wire_bytes.h"

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

Framing framingOf(skinwire_framing framing) { return framing == SKINWIRE_COBS ? Framing::Cobs : Framing::Length; }

/// Bodies with their CRCs, in the framing; in a datagram only the last.
Bytes assemble(skinwire_framing framing, FuzzInput& input) {
  Bytes bytes;
  while (!input.atEnd()) {
    const Bytes body = fuzz::nextBody(input);
    if (framing == SKINWIRE_DATAGRAM) {
      bytes = body;
    } else {
      fuzz::appendFrame(framingOf(framing), body, bytes);
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
  skinwire::FrameDecoder decoder(framingOf(framing));
  decoder.feed(bytes);
  while (std::optional<Decoded> decoded = decoder.next()) all.push_back(std::move(*decoded));
  return all;
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
  fuzz::require(skinwire::isSame(again, command), "the same command again");
}

void requireAgreement(const Event& event, const Decoded& decoded) {
  const auto* command = decoded.outcome == DecodeOutcome::Understood ? std::get_if<Command>(&decoded.message) : nullptr;
  if (event.event == SKINWIRE_COMMAND) {
    fuzz::require(command != nullptr || isTurnToNoUnitVector(event.command), "only what is a command");
    if (command != nullptr) fuzz::require(skinwire::isSame(event.command, *command), "the same command");
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
