// What SkinStream says about a device that does something wrong. Nothing here changes what is delivered.

#include "hexoderm/base/text.h"
#include "hexoderm/device/sources/skin_stream.h"
#include "hexoderm/skin/skin_graph.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace hexoderm {
namespace {

constexpr const char* kTime = "samples.time_us";

const char* readingsField(const skinwire::Samples& samples) {
  if (!samples.raw_lsb.empty()) return "samples.raw_lsb";
  return samples.mean_g.empty() ? "samples.acceleration_g" : "samples.mean_g";
}

constexpr std::array<std::pair<FindingCode, ProtocolViolationKind>, 9> kViolationsOfTopologies = {
    {{FindingCode::ReservedCellId, ProtocolViolationKind::CellIdZero},
     {FindingCode::DuplicateCell, ProtocolViolationKind::DuplicateCell},
     {FindingCode::UnknownPort, ProtocolViolationKind::UnknownPort},
     {FindingCode::UnknownCell, ProtocolViolationKind::UnknownNeighbour},
     {FindingCode::OneSidedLink, ProtocolViolationKind::OneSidedLink},
     {FindingCode::SelfLink, ProtocolViolationKind::ContradictoryLink},
     {FindingCode::ContradictoryLink, ProtocolViolationKind::ContradictoryLink},
     {FindingCode::DuplicateLink, ProtocolViolationKind::ContradictoryLink},
     {FindingCode::ForbiddenPortPair, ProtocolViolationKind::ContradictoryLink}}};

/// What a device's maker can't know from the finding alone.
Message expectedOf(ProtocolViolationKind kind, const CellModel& model) {
  switch (kind) {
    case ProtocolViolationKind::CellIdZero:
      return message("IDs of cells begin with 1");
    case ProtocolViolationKind::UnknownPort: {
      std::vector<PortNumber> ports;
      for (const Port& port : model.ports) ports.push_back(port.number);
      return message("the model's ports are {}", ports);
    }
    case ProtocolViolationKind::OneSidedLink:
      return message("both cells of a link have to list it");
    default:
      return {};
  }
}

/// What is wrong with a topology as a device sent it, one offence a cell or link; none for one that SkinGraph takes as
/// it is. Links to interfaces and between body parts are as they should be.
std::vector<ProtocolViolation> offencesOf(const CellModel& model, const NeighborList& neighbors) {
  std::vector<ProtocolViolation> offences;
  const SkinGraph graph(model, neighbors);
  for (const Finding& finding : graph.findings()) {
    const auto* const offence =
        std::ranges::find(kViolationsOfTopologies, finding.code, &decltype(kViolationsOfTopologies)::value_type::first);
    if (offence == kViolationsOfTopologies.end()) continue;
    const ProtocolViolationKind kind = offence->second;
    const Message expected = expectedOf(kind, model);
    Message reason = located("topology", finding.message);
    if (!expected.empty()) reason = message("{} Expected: {}", std::move(reason), expected);
    offences.push_back({kind, std::move(reason)});
  }
  if (graph.cells().empty()) {
    offences.push_back(
        {ProtocolViolationKind::NoCells, located("topology.cells", message("expected at least one cell"))});
  }
  return offences;
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
