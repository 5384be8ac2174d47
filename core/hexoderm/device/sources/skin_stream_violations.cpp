// What SkinStream says about a device that does something wrong. Nothing here changes what is delivered.

#include "hexoderm/base/text.h"
#include "hexoderm/device/sources/skin_stream.h"
#include "hexoderm/device/topology_check.h"

#include <algorithm>
#include <string>
#include <utility>

namespace hexoderm {
namespace {

constexpr const char* kTime = "samples.time_us";

const char* readingsField(const skinwire::Samples& samples) {
  if (!samples.raw_lsb.empty()) return "samples.raw_lsb";
  return samples.mean_g.empty() ? "samples.acceleration_g" : "samples.mean_g";
}

}  // namespace

template <class MakeReason>
void SkinStream::note(ProtocolViolationKind kind, std::uint64_t count, const MakeReason& reason) {
  counters_changed_ = true;
  if (log_.addAgain(kind, count)) return;
  log_.add({kind, printable(reason()), "", count});
}

void SkinStream::note(const std::optional<ProtocolViolation>& offence) {
  if (!offence) return;
  counters_changed_ = true;
  ProtocolViolation safe = *offence;
  safe.reason = printable(safe.reason);
  log_.add(safe);
}

void SkinStream::noteOnce(const std::optional<ProtocolViolation>& offence) {
  if (offence && !log_.has(offence->kind)) note(offence);
}

void SkinStream::noteWrongBaud(unsigned baud) {
  if (std::exchange(is_baud_noted_, true)) return;
  counters_changed_ = true;
  const Message doubt = message("is the baud rate right? now {}", baud);
  if (log_.explain(ProtocolViolationKind::BrokenFrame, doubt)) return;
  note(ProtocolViolation{ProtocolViolationKind::BrokenFrame, message("bytes came, but no frame ({})", doubt)});
}

void SkinStream::noteAllOf(const skinwire::Decoded& decoded) {
  const bool is_rest_of_a_frame = std::exchange(is_first_piece_forgiven_, false) &&
                                  decoded.outcome == skinwire::DecodeOutcome::Broken && decoded.major == 0;
  if (is_rest_of_a_frame) return;
  was_heard_ = true;
  // A later minor version has fields and messages that this one does not know.
  const bool is_newer = has_hello_ && hello_.minor > skinwire::kMinor;
  for (const ProtocolViolation& offence : decoded.offences) {
    const bool is_unknown =
        offence.kind == ProtocolViolationKind::UnknownField || offence.kind == ProtocolViolationKind::UnknownMessage;
    if (!(is_newer && is_unknown)) note(offence);
  }
}

void SkinStream::noteNewModel(const CellModel& before) {
  if (cellModelToJson(before) == cellModelToJson(*model_)) return;
  note(ProtocolViolationKind::CellModelChanged, 1, [&] {
    return located("hello.cell_model",
                   before.name == model_->name
                       ? message("the device sends other values of cell model {} than before", excerptOf(before.name))
                       : message("the device changed its cell model from {} to {}", excerptOf(before.name),
                                 excerptOf(model_->name)));
  });
}

void SkinStream::noteUnknownCells(const skinwire::Samples& samples) {
  const std::size_t first = static_cast<std::size_t>(
      std::ranges::find_if(samples.cells, [this](std::uint32_t cell) { return !index_of_.contains(cell); }) -
      samples.cells.begin());
  if (first == samples.cells.size()) return;
  note(ProtocolViolationKind::UnknownCell, looked_up_unknown_ * std::max<std::size_t>(samples.ticks(), 1), [&] {
    return located(
        "samples.cells[" + std::to_string(first) + "]",
        message("the topology has no cell {}; expected one of its {} cells", samples.cells[first], neighbors_.size()));
  });
}

void SkinStream::noteLate(const skinwire::Samples& samples) {
  // Overtaken on the way: the numbers say so.
  if (samples.sequence && next_sequence_ && *samples.sequence < *next_sequence_) return;
  if (samples.time_us == 0) {
    return note(ProtocolViolationKind::NoTime, 1, [] {
      return located(kTime, message("is missing, or 0 again; expected the device's clock in microseconds"));
    });
  }
  note(ProtocolViolationKind::TimeBackwards, 1, [&] {
    return located(
        kTime,
        samples.time_us < last_us_
            ? message("went back from {} to {}; expected microseconds that never go back", last_us_, samples.time_us)
            : message("is {} again, at which a cell of the message already was; expected microseconds "
                      "(milliseconds stand still between samples)",
                      samples.time_us));
  });
}

void SkinStream::noteSequence(const skinwire::Samples& samples) {
  if (!samples.sequence || !next_sequence_ || *samples.sequence >= *next_sequence_) return;
  // What the network delivers late has an earlier time, too.
  if (samples.time_us <= last_us_) return;
  note(ProtocolViolationKind::Sequence, 1, [&] {
    return located(
        "samples.sequence",
        message("expected {}, found {}; it counts the samples sent before (one cell at one tick), not messages",
                *next_sequence_, *samples.sequence));
  });
}

void SkinStream::judgeFrame(const skinwire::Samples& samples, std::uint64_t time_us) {
  note(reading_check_.add(frame_, model_->accelerometer, readingsField(samples)));
  // Cells may come in any order. What is lost on the way is known only where samples are numbered.
  const bool is_whole = samples.sequence && status_.lost_samples == 0;
  for (const CellSample& sample : frame_.samples) {
    note(clock_check_.addSample(sample.cell, time_us, hello_.rate_hz, model_->accelerometer.rate_hz, is_whole));
  }
}

void SkinStream::judgeClock(Clock::time_point now) {
  constexpr auto kPatience = std::chrono::seconds(2);
  if (isDescribed()) {
    undescribed_since_.reset();
    if (last_us_ > 0) note(clock_check_.compare(last_us_, now, pace_));
    return;
  }
  if (!was_heard_ || is_exploring_) return undescribed_since_.reset();
  if (!undescribed_since_) undescribed_since_ = now;
  if (now - *undescribed_since_ >= kPatience) noteMissingDescription();
}

void SkinStream::noteMissingDescription() {
  if (isDescribed() || !was_heard_ || !model_complaint_.empty()) return;
  constexpr std::uint64_t kAskedInVain = 2;
  noteOnce(ProtocolViolation{
      ProtocolViolationKind::NotDescribed,
      !has_hello_ && times_asked_ >= kAskedInVain && !was_rejected_
          ? message("no hello came that can be used, and the device did not answer Describe {} times: is "
                    "its RX connected?",
                    times_asked_)
      : has_hello_ ? message("no whole topology came; expected topology after hello, and all its parts")
                   : message("no hello came that can be used; expected hello before everything else")});
}

void SkinStream::judgeTopology() {
  if (is_topology_judged_ || !isDescribed()) return;
  is_topology_judged_ = true;
  for (const ProtocolViolation& offence : offencesOf(*model_, neighbors_)) note(offence);
  counters_changed_ = false;
}

}  // namespace hexoderm
