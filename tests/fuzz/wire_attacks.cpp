// Streams of a device that lies, breaks off, babbles, changes its skin all the time, sets its clock or claims giant
// counts: thousands of each kind, the same in every run, given to the fuzz target "skinwire", which requires what
// README.md beside this file says. The memory that all of them take together is limited.

#include "hexoderm/device/skinwire/framing.h"

#include "tests/core/device/skinwire/random_messages.h"
#include "tests/fuzz/fuzz_checks.h"
#include "tests/fuzz/wire_bytes.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace hexoderm;
using fuzz::append;
using fuzz::putNumber;
using skinwire::Bytes;
using skinwire::Framing;

// As the first byte of an input for skinwire_fuzz.cpp says them.
enum Head : std::uint8_t { kLength = 0, kCobs = 1, kLines = 2, kDetected = 3, kGoodBodies = 8 };

#if defined(__SANITIZE_ADDRESS__)
constexpr long kMaxMemory_KiB = 4L << 20U;  // what is freed is kept for a while, to be watched
#else
constexpr long kMaxMemory_KiB = 1L << 20U;
#endif

class Attacker : public skinwire::RandomMessages {
 public:
  using RandomMessages::RandomMessages;

  template <class Values>
  auto oneOf(const Values& values) {
    return *(std::begin(values) + static_cast<std::ptrdiff_t>(upTo(std::size(values) - 1)));
  }

  std::uint64_t time_us() {
    static constexpr std::array<std::uint64_t, 8> kOdd = {
        0, 1, 499'999, 500'000, 1'000'000, 3'600'000'000, skinwire::kMaxTime_us - 1, skinwire::kMaxTime_us};
    if (chance(10)) time_us_ = oneOf(kOdd);
    if (chance(10)) time_us_ = upTo(skinwire::kMaxTime_us);
    if (chance(10)) time_us_ -= std::min<std::uint64_t>(time_us_, upTo(2'000'000));
    time_us_ = std::min(time_us_ + upTo(200'000), skinwire::kMaxTime_us);
    return time_us_;
  }

  skinwire::Hello hello() {
    static constexpr std::array<const char*, 3> kModels = {"hex-bma150", "hex-bma150", "{\"name\": 1}"};
    return {skinwire::kMinor,
            chance(50) ? "a" : "b\x1b[2J",
            oneOf(kModels),
            chance(50),
            chance(50),
            1000,
            static_cast<std::uint32_t>(upTo(2))};
  }
  skinwire::Topology topology() {
    skinwire::Topology topology{static_cast<std::uint32_t>(upTo(3)), 0, 1, {}};
    for (std::uint32_t id = 1; id <= 1 + upTo(5); ++id) {
      CellReport cell{CellId(chance(5) ? UINT32_MAX : id), "", {}};
      if (chance(50)) cell.neighbors.push_back({PortNumber(static_cast<std::uint32_t>(upTo(9))), CellId(id + 1), {}});
      topology.cells.push_back(std::move(cell));
    }
    if (chance(20)) topology.parts = 1 + static_cast<std::uint32_t>(upTo(2));
    return topology;
  }
  skinwire::Samples samples() {
    skinwire::Samples samples;
    if (chance(70)) samples.sequence = chance(80) ? sequence_ += upTo(20) : upTo(skinwire::kMaxTime_us);
    samples.time_us = time_us();
    samples.period_us = static_cast<std::uint32_t>(chance(90) ? 1000 : upTo(UINT32_MAX));
    for (std::uint32_t id = 1; id <= 1 + upTo(3); ++id) samples.cells.push_back(id);
    const std::size_t ticks = 1 + upTo(2);
    // What would be too late can't be encoded.
    samples.time_us = std::min(samples.time_us, skinwire::kMaxTime_us - (ticks - 1) * std::uint64_t{samples.period_us});
    for (std::size_t k = 0; k < 3 * ticks * samples.cells.size(); ++k) {
      samples.raw_lsb.push_back(static_cast<std::int32_t>(upTo(1000)) - 500);
    }
    return samples;
  }
  skinwire::Message anything() {
    switch (upTo(5)) {
      case 0:
        return hello();
      case 1:
        return topology();
      case 2:
        return skinwire::Status{"odd", chance(50), upTo(UINT64_MAX), upTo(UINT64_MAX)};
      default:
        return samples();
    }
  }

 private:
  std::uint64_t time_us_ = 0;
  std::uint64_t sequence_ = 0;
};

void append(std::string_view text, Bytes& out) { out.insert(out.end(), text.begin(), text.end()); }

Bytes described(Framing framing) {
  Bytes bytes =
      skinwire::encodeFrame(framing, skinwire::Hello{skinwire::kMinor, "skin", "hex-bma150", false, false, 0, 0});
  append(skinwire::encodeFrame(
             framing, skinwire::Topology{1, 0, 1, {{CellId(1), "", {}}, {CellId(2), "", {}}, {CellId(3), "", {}}}}),
         bytes);
  return bytes;
}

struct Stream {
  Head head;
  Framing framing;
};
constexpr std::array<Stream, 4> kStreams = {
    {{kLength, Framing::Length}, {kCobs, Framing::Cobs}, {kLines, Framing::Lines}, {kDetected, Framing::Length}}};

/// The length in front of a body is another one.
void lieAboutItsLength(Bytes& frame, Attacker& attacker) {
  static constexpr std::array<std::uint32_t, 9> kLies = {0, 1, 5, 6, 7, 1U << 20U, 1U << 24U, UINT32_MAX, 0x7B7B7B7B};
  const std::uint32_t lie =
      attacker.chance(50) ? attacker.oneOf(kLies) : static_cast<std::uint32_t>(frame.size() + attacker.upTo(4)) - 6;
  for (std::size_t b = 0; b < 4; ++b) frame.at(b) = static_cast<std::uint8_t>(lie >> (8 * b));
}
/// The frame breaks off, and a whole one follows; or bytes of something else are in it, or before it.
void breakUp(Bytes& frame, Attacker& attacker) {
  if (attacker.chance(30)) frame.resize(attacker.upTo(frame.size()));
  if (attacker.chance(20) && !frame.empty()) frame.at(attacker.upTo(frame.size() - 1)) ^= attacker.byte();
  if (attacker.chance(30)) {
    const Bytes garbage = attacker.garbage(attacker.chance(50) ? 8 : 300);
    const std::size_t at = attacker.chance(50) ? 0 : attacker.upTo(frame.size());
    frame.insert(frame.begin() + static_cast<std::ptrdiff_t>(at), garbage.begin(), garbage.end());
  }
}

/// A stream that is described, and frames after that, which may be spoiled.
struct Attack {
  std::string_view name;
  int frames = 20;
  bool has_samples_alone = false;
  void (*spoil)(Bytes& frame, Attacker& attacker) = nullptr;
};
constexpr std::array<Attack, 4> kAttacks = {{{"changing skins", 60},
                                             {"time jumps", 100, true},
                                             {"length lies", 20, false, lieAboutItsLength},
                                             {"broken frames", 20, false, breakUp}}};

Bytes madeOf(const Attack& attack, Attacker& attacker) {
  // Only frames that have their lengths in front can lie about them.
  const bool has_lengths = attack.spoil == lieAboutItsLength;
  const Stream stream = has_lengths ? kStreams[attacker.chance(50) ? 0 : 3] : attacker.oneOf(kStreams);
  Bytes input = {stream.head, attacker.byte()};
  append(described(stream.framing), input);
  for (int k = 0; k < attack.frames; ++k) {
    Bytes frame = skinwire::encodeFrame(
        stream.framing, attack.has_samples_alone ? skinwire::Message(attacker.samples()) : attacker.anything());
    if (attack.spoil != nullptr && attacker.chance(40)) attack.spoil(frame, attacker);
    append(frame, input);
  }
  return input;
}

/// Bodies whose CRC is right and whose protobuf says that there is more, or is cut off.
Bytes giantCounts(Attacker& attacker) {
  Bytes input = {static_cast<std::uint8_t>((attacker.chance(50) ? kLength : kCobs) | kGoodBodies), attacker.byte()};
  for (int k = 0; k < 20; ++k) {
    const skinwire::Message message = attacker.anything();
    const Bytes whole = skinwire::encodeBody(message);
    Bytes body(whole.begin() + 2, whole.end() - 4);
    if (attacker.chance(50) && !body.empty()) {
      // The longest number there is, in the place of any byte: a length, a count, a cell.
      const Bytes giant = {0xFF, 0xFF, 0xFF, 0xFF, static_cast<std::uint8_t>(attacker.upTo(15))};
      const auto at = body.begin() + static_cast<std::ptrdiff_t>(attacker.upTo(body.size() - 1));
      body.insert(body.erase(at), giant.begin(), giant.end());
    } else if (attacker.chance(30)) {
      body.resize(attacker.upTo(body.size()));
    }
    input.push_back(whole.at(1));
    putNumber(body.size(), 2, input);
    append(body, input);
  }
  return input;
}

/// As much as a message may have, of what costs most.
std::vector<Bytes> largest() {
  std::vector<Bytes> inputs;
  const auto add = [&](const Stream& stream, const std::function<void(Bytes&)>& fill) {
    Bytes input = {stream.head, 255};
    append(described(stream.framing), input);
    fill(input);
    inputs.push_back(std::move(input));
  };
  const Stream lines = kStreams[2];
  for (const std::string_view nested : {"[", "{\"hello\":", "{\"samples\":{\"cells\":[", "\"", "1", "-", "\\u"}) {
    add(lines, [&](Bytes& input) {
      for (std::size_t size = 0; size + nested.size() < skinwire::kMaxBody; size += nested.size())
        append(nested, input);
      append("\n", input);
    });
  }
  add(lines, [](Bytes& input) {
    append(R"({"samples":{"time_us":1e999,"cells":[-1,1e99,4294967296],"raw_lsb":[1e308]}})"
           "\n",
           input);
  });
  // Cells without a word: two bytes each, in ten parts, more than there may be.
  add(kStreams[0], [](Bytes& input) {
    for (std::uint8_t part = 0; part < 10; ++part) {
      Bytes body = {skinwire::kMajor, 2, 0x08, 9, 0x10, part, 0x18, 10};
      for (int k = 0; k < 200'000; ++k) append(Bytes{0x22, 0}, body);
      putNumber(skinwire::crc32c(body), 4, body);
      putNumber(body.size(), 4, input);
      append(body, input);
    }
  });
  return inputs;
}

}  // namespace

int main() {
  constexpr std::uint64_t kEach = 1000;
  const auto attackBy = [](std::string_view name, const std::function<Bytes(Attacker&)>& make) {
    for (std::uint64_t seed = 1; seed <= kEach; ++seed) {
      Attacker attacker(seed);
      const Bytes input = make(attacker);
      LLVMFuzzerTestOneInput(input.data(), input.size());
    }
    std::cout << kEach << " of " << name << std::endl;  // the kind behind the last one named is the one that crashes
  };
  for (const Attack& attack : kAttacks) {
    attackBy(attack.name, [&](Attacker& attacker) { return madeOf(attack, attacker); });
  }
  attackBy("giant counts", giantCounts);
  const std::vector<Bytes> large = largest();
  for (const Bytes& input : large) LLVMFuzzerTestOneInput(input.data(), input.size());
  std::cout << large.size() << " of the largest" << std::endl;

  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  std::cout << "at most " << usage.ru_maxrss / 1024 << " MiB of memory, the limit is " << kMaxMemory_KiB / 1024
            << " MiB\n";
  return usage.ru_maxrss <= kMaxMemory_KiB ? EXIT_SUCCESS : EXIT_FAILURE;
}
