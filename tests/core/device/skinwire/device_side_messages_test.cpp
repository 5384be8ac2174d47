// What a device may say with skinwire.h: readings, the skin in parts, texts.

#include "hexoderm/device/skinwire/description.h"
#include "tests/core/device/skinwire/device_side_fixture.h"
#include "tests/core/device/skinwire/wire_messages.h"

namespace hexoderm::skinwire {
namespace {

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
  // Volatile, or g++ follows the constant into a loop that is never reached, and warns.
  const volatile std::size_t too_many = std::numeric_limits<std::size_t>::max();
  samples.tick_count = too_many;
  samples.raw_lsb = &value;
  EXPECT_EQ(skinwire_put_samples(&frame, &samples), 0U) << "more values than there are numbers";

  const Samples warm{.temperature_cells = {7}, .temperature_c = {21.5F}};
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
  const Bytes payload = joined({{0x1A, static_cast<std::uint8_t>(text.size())}, Bytes(text.begin(), text.end())});
  return decodeBody(bodyOf(6, payload)).outcome == DecodeOutcome::Understood;
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

}  // namespace
}  // namespace hexoderm::skinwire
