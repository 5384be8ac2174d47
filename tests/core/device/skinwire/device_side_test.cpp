// skinwire.h, the device's side in C, against the library, which is the host's side.

#include "hexoderm/device/skinwire/crc32c.h"
#include "hexoderm/device/skinwire/description.h"
#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/device/skinwire/skinwire.h"
#include "hexoderm/util/error.h"
#include "tests/core/device/skinwire/device_side_in_c.h"
#include "tests/core/device/skinwire/wire_messages.h"

#include <gtest/gtest.h>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>

namespace hexoderm::skinwire {
namespace {

constexpr std::array<std::pair<skinwire_framing, std::optional<Framing>>, 3> kFramings = {
    {{SKINWIRE_COBS, Framing::Cobs}, {SKINWIRE_LENGTH, Framing::Length}, {SKINWIRE_DATAGRAM, std::nullopt}}};

/// Puts a message of the library, whose texts have no 0, into a frame.
std::size_t put(skinwire_frame& frame, const Message& message) {
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
Bytes framed(const Message& message, skinwire_framing framing = SKINWIRE_COBS,
             std::size_t capacity = SKINWIRE_FRAME_SIZE(SKINWIRE_MAX_BODY)) {
  Bytes bytes(capacity);
  skinwire_frame frame = skinwire_frame_in(bytes.data(), bytes.size(), framing);
  bytes.resize(put(frame, message));
  EXPECT_EQ(bytes.empty(), frame.fault != SKINWIRE_FINE);
  return bytes;
}

Decoded decodeFrame(ByteView frame, std::optional<Framing> framing) {
  if (!framing) return decodeBody(frame);
  FrameDecoder decoder(framing);
  decoder.feed(frame);
  std::optional<Decoded> decoded = decoder.next();
  EXPECT_TRUE(decoded.has_value());
  EXPECT_EQ(decoder.buffered(), 0U);
  return decoded.value_or(Decoded());
}

/// Messages of all kinds. Some break a rule that a device could break.
class RandomMessages {
 public:
  explicit RandomMessages(std::uint64_t seed) : random_(seed) {}

  std::uint64_t upTo(std::uint64_t most) { return std::uniform_int_distribution<std::uint64_t>(0, most)(random_); }
  bool chance(unsigned percent) { return upTo(99) < percent; }

  Message device() {
    switch (upTo(5)) {
      case 0:
        return hello();
      case 1:
        return topology();
      case 2:
        return Status{text(1005), chance(50), number(UINT64_MAX), number(UINT64_MAX)};
      case 3:
        return ack();
      case 4:
        return joints();
      default:
        return samples();
    }
  }

  Message command() {
    Command command{static_cast<std::uint32_t>(number(UINT32_MAX)), {}};
    switch (upTo(5)) {
      case 0:
        command.request = SetRate{chance(10) ? 1e6 : std::ldexp(1 + fraction(), static_cast<int>(upTo(59)) - 41)};
        break;
      case 1:
        command.request = SetLed{id(), byte(), byte(), byte()};
        break;
      case 2: {
        Eigen::Vector3d up(fraction() - 0.5, fraction() - 0.5, fraction() - 0.5);
        if (chance(30)) up = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(upTo(2)));
        command.request = TurnTo{id(), up.normalized()};
        break;
      }
      case 3:
        command.request = ExploreAgain{};
        break;
      case 4:
        command.request = chance(50) ? Describe{} : Describe{static_cast<std::uint32_t>(number(UINT32_MAX))};
        break;
      default:
        break;  // one that the device does not know
    }
    return command;
  }

  Bytes garbage(std::size_t most) {
    Bytes bytes(upTo(most));
    for (std::uint8_t& one : bytes) one = chance(20) ? std::uint8_t{0} : byte();
    return bytes;
  }

 private:
  std::uint8_t byte() { return static_cast<std::uint8_t>(upTo(255)); }
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
                 real(),
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

TEST(DeviceSide, CrcHasThePublishedCheckValue) {
  const std::string text = "123456789";
  EXPECT_EQ(skinwire_crc32c(Bytes(text.begin(), text.end()).data(), text.size()), 0xE3069283U);
}

TEST(DeviceSide, MakesTheSameBytesAsTheHost) {
  for (const Message& message : everyMessage()) {
    if (std::holds_alternative<Command>(message)) continue;
    EXPECT_EQ(framed(message, SKINWIRE_DATAGRAM), encodeBody(message)) << "kind " << message.index();
    EXPECT_EQ(framed(message, SKINWIRE_COBS), encodeFrame(Framing::Cobs, message)) << "kind " << message.index();
    EXPECT_EQ(framed(message, SKINWIRE_LENGTH), encodeFrame(Framing::Length, message)) << "kind " << message.index();
  }
}

TEST(DeviceSide, RandomMessagesAreDecodedToTheSameValuesAndWrongOnesNotSent) {
  RandomMessages random(1);
  int sent = 0;
  int refused = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Message message = random.device();
    const auto [framing, decoder] = kFramings.at(random.upTo(2));
    const Bytes frame = framed(message, framing);
    const Complaint why = complaint(message);
    const bool is_too_long = why.empty() && framing == SKINWIRE_DATAGRAM && encodeBody(message).size() > kMaxDatagram;
    ASSERT_EQ(frame.empty(), !why.empty() || is_too_long) << k << ", kind " << message.index() << ": " << why.reason;
    ++(frame.empty() ? refused : sent);
    if (frame.empty()) continue;
    const Decoded decoded = decodeFrame(frame, decoder);
    ASSERT_EQ(decoded.outcome, DecodeOutcome::Understood) << k << ": " << decoded.reason();
    ASSERT_EQ(decoded.message, message) << k << ", kind " << message.index();
    ASSERT_TRUE(decoded.offences.empty()) << k << ": " << decoded.reason();
  }
  EXPECT_GT(sent, 15'000);
  EXPECT_GT(refused, 1000);
}

TEST(DeviceSide, ABufferThatIsTooSmallIsNeverOverrun) {
  RandomMessages random(2);
  for (int k = 0; k < 300; ++k) {
    const Message message = random.device();
    const auto [framing, decoder] = kFramings.at(random.upTo(2));
    const Bytes whole = framed(message, framing);
    if (whole.empty()) continue;
    EXPECT_EQ(framed(message, framing, whole.size()), whole);
    for (std::size_t capacity = 0; capacity < whole.size(); capacity += 1 + random.upTo(whole.size() / 20)) {
      constexpr std::uint8_t kGuard = 0xA5;
      Bytes bytes(capacity + 8, kGuard);
      skinwire_frame frame = skinwire_frame_in(bytes.data(), capacity, framing);
      ASSERT_EQ(put(frame, message), 0U) << capacity << " of " << whole.size();
      ASSERT_EQ(frame.fault, SKINWIRE_NO_ROOM);
      ASSERT_EQ(Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(capacity), bytes.end()), Bytes(8, kGuard));
    }
  }
}

TEST(DeviceSide, BlocksOfCobsEndWhereTheHostEndsThem) {
  for (std::size_t size = 1; size <= 1000; ++size) {
    const Message status = Status{std::string(size, 'x'), false, 0, 0};
    ASSERT_EQ(framed(status), encodeFrame(Framing::Cobs, status)) << size;
  }
}

/// One cell, many ticks, in a body of so many bytes.
Samples samplesOfBody(std::size_t size) {
  Samples samples;
  samples.period_us = 1;
  samples.cells = {1};
  samples.raw_lsb.assign(size / 3 * 3 - 60, 0);
  const std::size_t missing = size - encodeBody(samples).size();
  samples.raw_lsb.resize(samples.raw_lsb.size() + missing / 3 * 3, 0);
  // A value of two bytes in place of one.
  for (std::size_t k = 0; encodeBody(samples).size() < size; ++k) samples.raw_lsb.at(k) = 100;
  EXPECT_EQ(encodeBody(samples).size(), size);
  return samples;
}

TEST(DeviceSide, TheLongestFramesArriveAndLongerOnesAreRefused) {
  for (const auto& [framing, decoder] : kFramings) {
    const std::size_t longest = framing == SKINWIRE_DATAGRAM ? kMaxDatagram : kMaxBody;
    Samples samples = samplesOfBody(longest);
    const Bytes frame = framed(samples, framing, SKINWIRE_FRAME_SIZE(longest));
    ASSERT_FALSE(frame.empty());
    const Decoded decoded = decodeFrame(frame, decoder);
    ASSERT_EQ(decoded.outcome, DecodeOutcome::Understood) << decoded.reason();
    EXPECT_EQ(decoded.message, Message(samples));
    samples.raw_lsb.back() = 100;
    EXPECT_TRUE(framed(samples, framing, 2 * longest).empty());
  }
}

TEST(DeviceSide, BuffersOfTheStatedSizesAreEnoughAtWorst) {
  for (const std::size_t cells : {1, 7, 100}) {
    for (const std::size_t ticks : {1, 5, 50}) {
      Samples raw;
      raw.sequence = kMaxTime_us;
      raw.time_us = kMaxTime_us / 2;
      raw.period_us = UINT32_MAX;
      raw.cells.assign(cells, UINT32_MAX);
      raw.raw_lsb.assign(3 * cells * ticks, INT16_MIN);
      EXPECT_FALSE(framed(raw, SKINWIRE_COBS, SKINWIRE_FRAME_SIZE(SKINWIRE_RAW_BODY(cells, ticks))).empty());
    }
    Samples means;
    means.sequence = means.time_us = kMaxTime_us;
    means.period_us = UINT32_MAX;
    means.cells.assign(cells, UINT32_MAX);
    means.mean_g.assign(3 * cells, 1.7F);
    means.variance_g2.assign(3 * cells, 1.7F);
    means.count.assign(cells, UINT32_MAX);
    EXPECT_FALSE(framed(means, SKINWIRE_LENGTH, SKINWIRE_FRAME_SIZE(SKINWIRE_MEANS_BODY(cells))).empty());
  }
}

TEST(DeviceSide, ReadingsWithoutCellsAreRefusedAndTemperaturesAloneAreSent) {
  const std::int16_t value = 0;
  const std::uint32_t cell = 1;
  Bytes bytes(100);
  skinwire_frame frame = skinwire_frame_in(bytes.data(), bytes.size(), SKINWIRE_COBS);
  skinwire_samples samples{};
  samples.raw_lsb = &value;
  samples.tick_count = 1;
  EXPECT_EQ(skinwire_put_samples(&frame, &samples), 0U);
  EXPECT_EQ(frame.fault, SKINWIRE_WRONG_LENGTH);
  samples.raw_lsb = nullptr;
  samples.cells = &cell;
  samples.cell_count = 1;
  EXPECT_EQ(skinwire_put_samples(&frame, &samples), 0U) << "a cell without readings";
  samples.tick_count = std::numeric_limits<std::size_t>::max();
  samples.raw_lsb = &value;
  EXPECT_EQ(skinwire_put_samples(&frame, &samples), 0U) << "more values than there are numbers";

  Samples warm;
  warm.temperature_cells = {7};
  warm.temperature_c = {21.5F};
  EXPECT_EQ(decodeFrame(framed(warm), Framing::Cobs).message, Message(warm));
  EXPECT_EQ(decodeFrame(framed(Topology{1, 0, 1, {}}), Framing::Cobs).message, Message(Topology{1, 0, 1, {}}));
}

TEST(DeviceSide, ACellWithoutAnIdIsNotSent) { EXPECT_TRUE(framed(Topology{1, 0, 1, {{CellId(0), "", {}}}}).empty()); }

TEST(DeviceSide, ATopologyGoesInPartsThatFitTheBuffer) {
  std::vector<skinwire_port> ports;
  std::vector<skinwire_cell> cells;
  for (std::uint32_t k = 0; k < 200; ++k) ports.push_back({1 + k % 4, 1 + k, k % 5});
  for (std::uint32_t k = 0; k < 50; ++k)
    cells.push_back({1000 * k + 1, k % 7 == 0 ? "forearm" : nullptr, &ports[4 * k], 4});
  for (const auto& [framing, decoder] : kFramings) {
    for (const std::size_t capacity : {100, 256, 1000, 5000}) {
      Bytes bytes(capacity);
      skinwire_frame frame = skinwire_frame_in(bytes.data(), bytes.size(), framing);
      skinwire_topology topology{};
      for (std::size_t at = 0; at < cells.size(); ++topology.parts) {
        at += skinwire_cells_that_fit(&frame, &cells[at], cells.size() - at);
      }
      TopologyAssembler assembler;
      std::optional<NeighborList> whole;
      for (std::size_t at = 0; at < cells.size(); at += topology.cell_count, ++topology.part) {
        topology.cells = &cells[at];
        topology.cell_count = skinwire_cells_that_fit(&frame, topology.cells, cells.size() - at);
        ASSERT_GT(skinwire_put_topology(&frame, &topology), 0U) << frame.fault;
        whole = assembler.add(std::get<Topology>(decodeFrame(ByteView(bytes).first(frame.size), decoder).message));
      }
      ASSERT_TRUE(whole.has_value()) << capacity;
      EXPECT_EQ(whole->size(), cells.size());
      EXPECT_EQ(whole->back().id, CellId(49'001));
      EXPECT_EQ(whole->front().neighbors.size(), 4U);
    }
  }
  Bytes small(40);
  const skinwire_frame frame = skinwire_frame_in(small.data(), small.size(), SKINWIRE_COBS);
  EXPECT_EQ(skinwire_cells_that_fit(&frame, cells.data(), cells.size()), 0U);
}

/// Whether the library takes an Ack with this text.
bool isTextOfAHost(const std::string& text) {
  Bytes body = {kMajor, 6, 0x1A, static_cast<std::uint8_t>(text.size())};
  body.insert(body.end(), text.begin(), text.end());
  const std::uint32_t crc = crc32c(body);
  for (unsigned k = 0; k < 4; ++k) body.push_back(static_cast<std::uint8_t>(crc >> (8 * k)));
  return decodeBody(body).outcome == DecodeOutcome::Understood;
}

TEST(DeviceSide, SendsOnlyTextsThatAHostTakes) {
  EXPECT_FALSE(framed(Ack{1, false, "\xC3\xA4", false}).empty());
  EXPECT_TRUE(framed(Ack{1, false, "\xE4", false}).empty());
  std::mt19937_64 random(3);
  int taken = 0;
  for (int k = 0; k < 100'000; ++k) {
    std::string text;
    const std::uint64_t lead = random();
    // Beginnings of every length, then what may follow.
    text += static_cast<char>(0x80 | (lead & 0x7FU));
    for (std::uint64_t more = lead >> 8U & 3U; more > 0; --more) text += static_cast<char>(0x80 | (random() & 0x3FU));
    if ((lead >> 16U & 3U) == 0) text += 'x';
    const bool is_taken = isTextOfAHost(text);
    taken += is_taken ? 1 : 0;
    ASSERT_EQ(framed(Ack{1, false, text, false}, SKINWIRE_COBS, 64).empty(), !is_taken) << testing::PrintToString(text);
  }
  EXPECT_GT(taken, 1000);
}

TEST(DeviceSide, FloatsAndDoublesAreConvertedAsProcessorsDo) {
  std::mt19937_64 random(4);
  const auto expectSame = [](double from) {
    const float in_c = skinwire_float_of_double(std::bit_cast<std::uint64_t>(from));
    const auto expected = static_cast<float>(from);
    if (std::isnan(from)) {
      EXPECT_TRUE(std::isnan(in_c));
    } else {
      EXPECT_EQ(std::bit_cast<std::uint32_t>(in_c), std::bit_cast<std::uint32_t>(expected)) << from;
    }
    EXPECT_EQ(skinwire_is_finite(in_c), std::isfinite(expected)) << from;
  };
  for (int k = 0; k < 200'000; ++k) {
    const auto single = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isnan(single)) {
      ASSERT_EQ(skinwire_double_of_float(single), std::bit_cast<std::uint64_t>(static_cast<double>(single))) << single;
    }
    expectSame(std::bit_cast<double>(random()));
    // Of the magnitudes that a single has, and beyond by a little; and halfway between two of them.
    const double near =
        std::ldexp(1 + static_cast<double>(random() >> 12U) * 0x1p-52, static_cast<int>(random() % 290) - 155);
    expectSame(near);
    if (std::isfinite(single)) {
      const float next = std::nextafter(single, std::numeric_limits<float>::infinity());
      if (std::isfinite(next)) expectSame((static_cast<double>(single) + static_cast<double>(next)) / 2);
    }
  }
}

// ---- commands

struct Received {
  std::vector<skinwire_event> events;  ///< all but SKINWIRE_NOTHING
  std::vector<skinwire_command> commands;
};

Received receive(ByteView bytes, skinwire_framing framing, std::size_t capacity = SKINWIRE_COMMAND_SIZE) {
  // On the heap, where a sanitizer sees a byte beyond its end.
  Bytes buffer(capacity);
  buffer.shrink_to_fit();
  skinwire_receiver receiver = skinwire_receiver_in(buffer.data(), buffer.size(), framing);
  Received received;
  for (const std::uint8_t byte : bytes) {
    skinwire_command command{};
    const skinwire_event event = skinwire_receive(&receiver, byte, &command);
    if (event != SKINWIRE_NOTHING) received.events.push_back(event);
    if (event == SKINWIRE_COMMAND) received.commands.push_back(command);
  }
  return received;
}

void expectSame(const skinwire_command& in_c, const Command& command) {
  EXPECT_EQ(in_c.number, command.number);
  if (const auto* rate = std::get_if<SetRate>(&command.request)) {
    ASSERT_EQ(in_c.request, SKINWIRE_SET_RATE);
    EXPECT_EQ(in_c.of.set_rate.rate_hz, static_cast<float>(rate->rate_hz));
  } else if (const auto* led = std::get_if<SetLed>(&command.request)) {
    ASSERT_EQ(in_c.request, SKINWIRE_SET_LED);
    EXPECT_EQ(in_c.of.set_led.cell, led->cell);
    EXPECT_EQ(in_c.of.set_led.red, led->red);
    EXPECT_EQ(in_c.of.set_led.green, led->green);
    EXPECT_EQ(in_c.of.set_led.blue, led->blue);
  } else if (const auto* turn = std::get_if<TurnTo>(&command.request)) {
    ASSERT_EQ(in_c.request, SKINWIRE_TURN_TO);
    EXPECT_EQ(in_c.of.turn_to.cell, turn->cell);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(in_c.of.turn_to.up[k], static_cast<float>(turn->up_u[static_cast<Eigen::Index>(k)]));
    }
  } else if (std::holds_alternative<ExploreAgain>(command.request)) {
    EXPECT_EQ(in_c.request, SKINWIRE_EXPLORE_AGAIN);
  } else if (const auto* describe = std::get_if<Describe>(&command.request)) {
    ASSERT_EQ(in_c.request, SKINWIRE_DESCRIBE);
    EXPECT_EQ(in_c.of.describe.has_known_topology, describe->known_topology.has_value());
    EXPECT_EQ(in_c.of.describe.known_topology, describe->known_topology.value_or(0));
  } else {
    EXPECT_EQ(in_c.request, SKINWIRE_UNKNOWN);
  }
}

TEST(DeviceSide, UnderstandsEveryCommandOfAHost) {
  RandomMessages random(5);
  for (int k = 0; k < 5000; ++k) {
    const Message message = random.command();
    for (const auto& [framing, encoder] : kFramings) {
      skinwire_command command{};
      if (!encoder) {
        const Bytes body = encodeBody(message);
        ASSERT_LE(body.size(), std::size_t{SKINWIRE_COMMAND_SIZE});
        ASSERT_EQ(skinwire_read_body(body.data(), body.size(), &command), SKINWIRE_COMMAND);
      } else {
        const Received received = receive(encodeFrame(*encoder, message), framing);
        ASSERT_EQ(received.events, std::vector{SKINWIRE_COMMAND}) << k;
        command = received.commands.front();
      }
      expectSame(command, std::get<Command>(message));
    }
  }
}

Bytes commandOf(Bytes payload, std::uint8_t major = kMajor, std::uint8_t type = 5) {
  payload.insert(payload.begin(), {major, type});
  const std::uint32_t crc = crc32c(payload);
  for (unsigned k = 0; k < 4; ++k) payload.push_back(static_cast<std::uint8_t>(crc >> (8 * k)));
  return payload;
}

skinwire_event eventOf(const Bytes& body, skinwire_command& command) {
  return skinwire_read_body(body.data(), body.size(), &command);
}

TEST(DeviceSide, ReadsWhatALaterVersionMaySend) {
  skinwire_command command{};
  // A request with the number 9; fields with unknown numbers of every kind, also within a request.
  EXPECT_EQ(eventOf(commandOf({0x08, 7, 0x4A, 2, 1, 2}), command), SKINWIRE_COMMAND);
  EXPECT_EQ(command.number, 7U);
  EXPECT_EQ(command.request, SKINWIRE_UNKNOWN);
  EXPECT_EQ(eventOf(commandOf({0x08, 7, 0x78, 0x96, 0x01, 0x79, 1,    2, 3, 4, 5, 6, 7, 8, 0x7D, 1, 2, 3, 4,  //
                               0x1A, 6, 0x08, 5,    0x10, 9,    0x28, 1}),
                    command),
            SKINWIRE_COMMAND);
  EXPECT_EQ(command.request, SKINWIRE_SET_LED);
  EXPECT_EQ(command.of.set_led.cell, 5U);
  EXPECT_EQ(command.of.set_led.red, 9);
  EXPECT_EQ(eventOf(commandOf({0x08, 7}, 2), command), SKINWIRE_SKIPPED) << "major version 2";
  EXPECT_EQ(eventOf(commandOf({0x08, 7}, kMajor, 8), command), SKINWIRE_SKIPPED) << "a message of type 8";
  EXPECT_EQ(eventOf(commandOf({0x08}), command), SKINWIRE_BROKEN) << "a number that is cut off";
  EXPECT_EQ(eventOf(commandOf({0x1A, 2, 0x08}), command), SKINWIRE_BROKEN) << "a request that is cut off";
  EXPECT_EQ(eventOf(commandOf({0x1A, 3, 0x10, 0x80, 0x02}), command), SKINWIRE_BROKEN) << "red of 256";
  EXPECT_EQ(eventOf(commandOf({0x22, 2, 0x08, 1}), command), SKINWIRE_BROKEN) << "a turn to nowhere";
}

TEST(DeviceSide, TakesTheLastOfSeveralRequestsAsProtobufDoes) {
  // Up is (0, 0, 1) in the frame of cell 9.
  Bytes turn = {0x22, 28, 0x08, 9, 0x12, 24};
  turn.resize(turn.size() + 22, 0);
  turn.insert(turn.end(), {0xF0, 0x3F});
  const Bytes light = {0x1A, 2, 0x08, 5};
  const Bytes more_light = {0x1A, 2, 0x10, 100};
  const auto expectAsTheLibrary = [](const std::vector<Bytes>& pieces) {
    Bytes payload = {0x08, 7};
    for (const Bytes& piece : pieces) payload.insert(payload.end(), piece.begin(), piece.end());
    const Bytes body = commandOf(payload);
    const Decoded decoded = decodeBody(body);
    ASSERT_EQ(decoded.outcome, DecodeOutcome::Understood) << decoded.reason();
    skinwire_command command{};
    ASSERT_EQ(eventOf(body, command), SKINWIRE_COMMAND);
    expectSame(command, std::get<Command>(decoded.message));
  };
  expectAsTheLibrary({light, more_light});
  expectAsTheLibrary({turn, light});
  expectAsTheLibrary({turn, light, turn});
  expectAsTheLibrary({light, turn, more_light});
  expectAsTheLibrary({{0x32, 2, 0x08, 3}, light, {0x32, 0}});
}

TEST(DeviceSide, BelievesNoLengthThatReachesBeyondTheBody) {
  // With each number the CRC behind the payload is another one, and now and then looks like the field that is missing.
  for (std::uint8_t number = 1; number < 128; ++number) {
    for (const Bytes& request : {Bytes{0x32, 0, 0x08, 3}, Bytes{0x1A, 0, 0x08, 5}, Bytes{0x2A, 0}, Bytes{0x4A, 0}}) {
      for (const std::size_t too_much : {1, 2, 3, 4, 5, 100}) {
        Bytes payload = {0x08, number};
        payload.insert(payload.end(), request.begin(), request.end());
        payload.at(3) = static_cast<std::uint8_t>(request.size() - 2 + too_much);
        skinwire_command command{};
        ASSERT_EQ(eventOf(commandOf(payload), command), SKINWIRE_BROKEN) << testing::PrintToString(payload);
        payload.at(3) = static_cast<std::uint8_t>(request.size() - 2);
        ASSERT_EQ(eventOf(commandOf(payload), command), SKINWIRE_COMMAND);
      }
    }
  }
}

TEST(DeviceSide, FindsTheNextCommandAfterGarbage) {
  RandomMessages random(6);
  const Bytes good = encodeFrame(Framing::Cobs, Command{77, SetLed{3, 1, 2, 3}});
  for (int k = 0; k < 20'000; ++k) {
    Bytes bytes = random.garbage(300);
    bytes.push_back(0);
    bytes.insert(bytes.end(), good.begin(), good.end());
    const Received received = receive(bytes, SKINWIRE_COBS);
    ASSERT_FALSE(received.events.empty());
    ASSERT_EQ(received.events.back(), SKINWIRE_COMMAND) << k;
    expectSame(received.commands.back(), Command{77, SetLed{3, 1, 2, 3}});
  }
}

TEST(DeviceSide, LeavesOutCommandsThatAreLongerThanItsBuffer) {
  const Message good = Command{77, ExploreAgain{}};
  const Bytes body = commandOf(Bytes(0, 0));
  Bytes long_payload = {0x08, 7, 0x4A, 100};
  long_payload.resize(long_payload.size() + 100, 1);
  const Bytes long_body = commandOf(long_payload);
  Bytes cobs = encodeCobs(long_body);
  cobs.push_back(0);
  const Bytes next = encodeFrame(Framing::Cobs, good);
  cobs.insert(cobs.end(), next.begin(), next.end());
  EXPECT_EQ(receive(cobs, SKINWIRE_COBS).events, (std::vector{SKINWIRE_BROKEN, SKINWIRE_COMMAND}));
  EXPECT_EQ(receive(cobs, SKINWIRE_COBS, 200).events, (std::vector{SKINWIRE_COMMAND, SKINWIRE_COMMAND}));

  Bytes by_length = {static_cast<std::uint8_t>(long_body.size()), 0, 0, 0};
  by_length.insert(by_length.end(), long_body.begin(), long_body.end());
  const Bytes next_by_length = encodeFrame(Framing::Length, good);
  by_length.insert(by_length.end(), next_by_length.begin(), next_by_length.end());
  EXPECT_EQ(receive(by_length, SKINWIRE_LENGTH).events, (std::vector{SKINWIRE_BROKEN, SKINWIRE_COMMAND}));
}

TEST(DeviceSide, SaysThatAStreamWithLengthsIsLost) {
  Bytes bytes = encodeFrame(Framing::Length, Command{77, ExploreAgain{}});
  const Bytes good = bytes;
  bytes.at(6) ^= 1U;
  bytes.insert(bytes.end(), good.begin(), good.end());
  const Received received = receive(bytes, SKINWIRE_LENGTH);
  ASSERT_FALSE(received.events.empty());
  for (const skinwire_event event : received.events) EXPECT_EQ(event, SKINWIRE_LOST);
  EXPECT_EQ(receive(Bytes{5, 0, 0, 0}, SKINWIRE_LENGTH).events, std::vector{SKINWIRE_LOST});
  EXPECT_EQ(receive(Bytes{1, 0, 16, 0}, SKINWIRE_LENGTH).events, std::vector{SKINWIRE_LOST});
}

// ---- means

TEST(DeviceSide, AveragesAsExactlyAsFloatsAllow) {
  std::mt19937_64 random(7);
  constexpr float kLsb_g = 1.0F / 256;
  for (const int count : {1, 2, 3, 100, 65'535, 70'000}) {
    for (const int spread : {1, 10, 65'536}) {
      skinwire_average average{};
      double sum = 0;
      double squares = 0;
      const int counted = std::min<int>(count, SKINWIRE_MAX_AVERAGE);
      std::vector<double> values;
      for (int k = 0; k < count; ++k) {
        const auto value = static_cast<std::int16_t>(
            spread == 65'536 ? (k % 2 == 0 ? INT16_MIN : INT16_MAX)
                             : 256 + static_cast<int>(random() % static_cast<unsigned>(spread)));
        const std::array<std::int16_t, 3> reading = {value, 0, INT16_MIN};
        skinwire_average_add(&average, reading.data());
        if (k < counted) values.push_back(value);
      }
      for (const double value : values) sum += value;
      for (const double value : values) squares += (value - sum / counted) * (value - sum / counted);
      std::array<float, 3> mean_g{};
      std::array<float, 3> variance_g2{};
      std::uint32_t counted_in_c = 0;
      ASSERT_TRUE(skinwire_average_take(&average, kLsb_g, mean_g.data(), variance_g2.data(), &counted_in_c));
      EXPECT_EQ(counted_in_c, static_cast<std::uint32_t>(counted));
      EXPECT_FLOAT_EQ(mean_g[0], static_cast<float>(sum / counted / 256));
      EXPECT_EQ(mean_g[1], 0);
      EXPECT_EQ(mean_g[2], -128);
      EXPECT_FLOAT_EQ(variance_g2[0], count < 2 ? 0 : static_cast<float>(squares / (counted - 1) / 65'536));
      EXPECT_EQ(variance_g2[2], 0);
      EXPECT_FALSE(skinwire_average_take(&average, kLsb_g, mean_g.data(), variance_g2.data(), &counted_in_c));
    }
  }
}

// ---- as a C compiler sees it

TEST(DeviceSide, InCSpeaksAsInCpp) {
  Bytes bytes(1000);
  bytes.resize(skinwire_in_c_every_message(bytes.data(), bytes.size()));
  FrameDecoder decoder(Framing::Cobs);
  decoder.feed(bytes);
  std::vector<std::size_t> kinds;
  while (const std::optional<Decoded> decoded = decoder.next()) {
    ASSERT_EQ(decoded->outcome, DecodeOutcome::Understood) << decoded->reason();
    kinds.push_back(decoded->message.index());
    if (const auto* samples = std::get_if<Samples>(&decoded->message); samples != nullptr && !samples->mean_g.empty()) {
      EXPECT_EQ(samples->mean_g, (std::vector{2 / 256.0F, 2 / 256.0F, 1.0F, 2 / 256.0F, 2 / 256.0F, 1.0F}));
      EXPECT_EQ(samples->count, (std::vector<std::uint32_t>{2, 2}));
    }
  }
  EXPECT_EQ(kinds, (std::vector<std::size_t>{0, 1, 2, 2, 3, 5, 6}));
  const Bytes command = encodeFrame(Framing::Cobs, Command{9, ExploreAgain{}});
  EXPECT_EQ(skinwire_in_c_command(command.data(), command.size()), 9U);
}

}  // namespace
}  // namespace hexoderm::skinwire
