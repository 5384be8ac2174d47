// Any bytes as SkinWire: messages that keep the protocol's rules reach the listener, all else is counted. The first
// byte of an input says how it comes (low 3 bits: which stream; 8: bodies with CRCs in order instead of raw bytes), the
// second in pieces of how many bytes. A body: type, length of 16 bits, so many bytes of protobuf.

#include "hexoderm/base/error.h"
#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/device/sources/recording.h"

#include "hexoderm/device/sources/skin_stream.h"
#include "tests/fuzz/fuzz_checks.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/wire_bytes.h"

#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

namespace {

using namespace hexoderm;
using fuzz::ByteView;
using fuzz::FuzzInput;
using skinwire::Bytes;
using skinwire::Decoded;
using skinwire::DecodeOutcome;
using skinwire::Framing;

enum class Stream { Length, Cobs, Lines, Detected, Recording };
constexpr unsigned kStreams = 5;
constexpr unsigned kHasGoodBodies = 8;

/// Checks the promises that SkinListener makes to its implementations.
class StrictListener final : public SkinListener {
 public:
  void onSkin(const SkinDescription& skin) override {
    fuzz::require(skin.model != nullptr, "a model in every description");
    skin.model->validate();
    known_.clear();
    for (const CellReport& cell : skin.neighbors) known_.insert(cell.id);
    // A cell that was away begins anew.
    for (std::set<CellId>* cells : {&sampled_, &averaged_}) {
      std::erase_if(*cells, [this](CellId cell) { return !known_.contains(cell); });
    }
    described_ = true;
  }
  void onFrame(const SampleFrame& frame) override {
    fuzz::require(described_, "a description before the first frame");
    fuzz::require(std::isfinite(frame.time_s) && frame.time_s >= 0, "finite times of at least 0");
    if (clock_restarts && std::exchange(restarts_, clock_restarts()) != clock_restarts()) allowNewBeginning();
    fuzz::require(frame.time_s >= last_s_, "times that don't go back");
    if (frame.time_s > last_s_) {
      sampled_.clear();
      averaged_.clear();
    }
    last_s_ = frame.time_s;
    for (const CellSample& sample : frame.samples) {
      fuzz::require(sample.acceleration_g.allFinite(), "finite samples");
      requireNew(sample.cell, sampled_);
    }
    for (const CellMean& mean : frame.means) {
      fuzz::require(mean.mean_g.allFinite() && mean.variance_g2.allFinite(), "finite means");
      fuzz::require((mean.variance_g2.array() >= 0).all() && mean.count > 0, "variances and counts in range");
      requireNew(mean.cell, averaged_);
    }
    for (const CellTemperature& temperature : frame.temperatures) {
      fuzz::require(std::isfinite(temperature.temperature_c), "finite temperatures");
      fuzz::require(known_.contains(temperature.cell), "only cells of the description");
    }
  }
  void onJoints(const JointReport& joints) override {
    fuzz::require(described_, "a description before the first joints");
    fuzz::require(std::isfinite(joints.time_s) && joints.time_s >= 0, "finite times of at least 0");
    fuzz::require(!joints.angles.positions.empty(), "joints in every report");
    joints.angles.validate();
  }
  void onStatus(const SourceStatus& /*status*/) override {}
  void onCommandOutcome(const CommandOutcome& /*outcome*/) override {}

  /// How often the source found that the device's clock was set back.
  std::function<std::uint64_t()> clock_restarts;

  /// The device may have started over, or its cells are others.
  void allowNewBeginning() {
    last_s_ = 0;
    sampled_.clear();
    averaged_.clear();
  }

 private:
  void requireNew(CellId cell, std::set<CellId>& cells) const {
    fuzz::require(known_.contains(cell), "only cells of the description");
    fuzz::require(cells.insert(cell).second, "each cell once at a time");
  }

  bool described_ = false;
  double last_s_ = 0;
  std::uint64_t restarts_ = 0;
  std::set<CellId> known_;
  std::set<CellId> sampled_;
  std::set<CellId> averaged_;
};

/// A message that was understood keeps the rules, and is the same again as body and as line.
void requireSound(const skinwire::Message& message) {
  fuzz::require(skinwire::complaint(message).empty(), "no complaint about what was understood");
  Bytes body;
  std::string line;
  try {
    body = skinwire::encodeBody(message);
    line = skinwire::encodeLine(message);
  } catch (const InvalidArgument&) {
    return;  // longer than allowed in the other coding
  }
  const Decoded from_body = skinwire::decodeBody(body);
  fuzz::require(from_body.outcome == DecodeOutcome::Understood && from_body.message == message, "the same body again");
  if (line.size() > skinwire::kMaxBody) return;
  const Decoded from_line = skinwire::decodeLine(line);
  fuzz::require(from_line.outcome == DecodeOutcome::Understood && from_line.message == message, "the same line again");
}

class Host {
 public:
  Host() : stream_(listener_) {
    listener_.clock_restarts = [this] { return stream_.clockRestarts(); };
  }
  void take(const Decoded& decoded) {
    if (decoded.outcome == DecodeOutcome::Understood) {
      requireSound(decoded.message);
      if (!std::holds_alternative<skinwire::Samples>(decoded.message)) listener_.allowNewBeginning();
    } else {
      fuzz::require(!decoded.reason().empty(), "a reason");
      fuzz::require(decoded.reason().english().size() < 2000, "a reason of bounded length");
    }
    now_ += std::chrono::milliseconds(100);
    stream_.take(decoded, now_);
    stream_.reportCounters(now_);
  }

 private:
  StrictListener listener_;
  SkinStream stream_;
  SkinStream::Clock::time_point now_{};
};

std::vector<Decoded> decodeInPieces(std::optional<Framing> framing, ByteView bytes, std::size_t piece) {
  skinwire::FrameDecoder decoder(framing);
  std::vector<Decoded> all;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    decoder.feed(bytes.subspan(at, std::min(piece, bytes.size() - at)));
    while (std::optional<Decoded> decoded = decoder.next()) {
      all.push_back(std::move(*decoded));
      fuzz::require(all.size() <= bytes.size(), "no more frames than bytes");
    }
    fuzz::require(decoder.buffered() <= at + piece, "no more bytes waiting than came");
  }
  return all;
}

/// A stream says the same, however its bytes come in pieces.
std::vector<Decoded> decodeStream(std::optional<Framing> framing, ByteView bytes, std::size_t piece) {
  std::vector<Decoded> in_pieces = decodeInPieces(framing, bytes, piece);
  const std::vector<Decoded> at_once = decodeInPieces(framing, bytes, std::max<std::size_t>(bytes.size(), 1));
  fuzz::require(in_pieces.size() == at_once.size(), "as many frames in pieces as at once");
  for (std::size_t k = 0; k < at_once.size(); ++k) {
    fuzz::require(in_pieces[k].outcome == at_once[k].outcome && in_pieces[k].message == at_once[k].message,
                  "the same frames in pieces as at once");
  }
  return in_pieces;
}

/// Bodies with their CRCs, in the stream's framing.
Bytes assemble(Stream stream, FuzzInput& input) {
  Bytes bytes;
  std::uint64_t arrived_us = 0;
  while (!input.atEnd()) {
    const Bytes body = fuzz::nextBody(input);
    if (stream == Stream::Recording) fuzz::putNumber(arrived_us += 1000, 8, bytes);
    fuzz::appendFrame(stream == Stream::Cobs ? Framing::Cobs : Framing::Length, body, bytes);
  }
  return bytes;
}

std::vector<Decoded> readRecording(ByteView records) {
  static const fuzz::ScratchFile file("fuzz.skinrec");
  std::vector<Decoded> all;
  Bytes bytes = {'S', 'K', 'I', 'N', 'R', 'E', 'C', '1'};
  fuzz::append(records, bytes);
  file.write(fuzz::asText(bytes));
  RecordingReader reader(file.path());
  std::chrono::microseconds last{};
  while (const std::optional<RecordedBody> record = reader.next()) {
    fuzz::require(record->arrived >= last, "arrivals that don't go back");
    last = record->arrived;
    all.push_back(skinwire::decodeBody(record->body));
  }
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput input({data, size});
  const unsigned head = input.byte();
  const std::size_t piece = input.byte() + std::size_t{1};
  const auto stream = static_cast<Stream>((head & 7U) % kStreams);
  const bool has_bodies = (head & kHasGoodBodies) != 0 && stream != Stream::Lines;
  Bytes assembled;
  if (has_bodies) assembled = assemble(stream, input);
  const ByteView bytes = has_bodies ? ByteView(assembled) : input.rest();

  static constexpr std::array<std::optional<Framing>, 4> kFramings = {Framing::Length, Framing::Cobs, Framing::Lines,
                                                                      std::nullopt};
  const std::vector<Decoded> messages =
      stream == Stream::Recording ? readRecording(bytes)
                                  : decodeStream(kFramings.at(static_cast<std::size_t>(stream)), bytes, piece);
  Host host;
  for (const Decoded& message : messages) host.take(message);
  return 0;
}
