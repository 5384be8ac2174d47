#include "hexoderm/device/sources/skin_stream.h"

#include "hexoderm/base/error.h"
#include "hexoderm/device/skinwire/sample_messages.h"

#include <algorithm>
#include <utility>

namespace hexoderm {
namespace {

using skinwire::Decoded;
using skinwire::DecodeOutcome;

constexpr std::uint32_t kUnknown = UINT32_MAX;
constexpr std::chrono::milliseconds kTellEvery(500);
// Late messages in a row that span so much of the device's time are no stragglers: its clock was set back.
constexpr std::uint64_t kClockReset_us = 500'000;

bool sameModel(const SkinDescription& a, const SkinDescription& b) {
  return a.model == b.model || cellModelToJson(*a.model) == cellModelToJson(*b.model);
}

bool sameDescription(const SkinDescription& a, const SkinDescription& b) {
  return a.device == b.device && a.can_light_cells == b.can_light_cells && a.can_turn == b.can_turn &&
         a.neighbors == b.neighbors && sameModel(a, b);
}

MessageArgument printableArgument(MessageArgument argument) {
  if (auto* text = std::get_if<std::string>(&argument.value)) *text = hexoderm::printable(std::move(*text));
  if (auto* items = std::get_if<MessageArgument::List>(&argument.value)) {
    for (MessageArgument& item : *items) item = printableArgument(std::move(item));
  }
  if (const auto* words = std::get_if<Message>(&argument.value)) {
    MessageArgument::List parts = words->arguments();
    for (MessageArgument& part : parts) part = printableArgument(std::move(part));
    argument.value = Message(words->englishTemplate(), std::move(parts));
  }
  return argument;
}

}  // namespace

std::string printable(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
  return text;
}

Message printable(const Message& message) {
  return std::get<Message>(printableArgument(MessageArgument(message)).value);
}

void SkinStream::restart() {
  static_cast<ConnectionState&>(*this) = {};
  startCounting();
}

void SkinStream::startCounting() {
  next_sequence_.reset();
  last_us_ = 0;
  last_joints_us_ = 0;
  late_from_us_.reset();
  for (auto& last_us : cell_last_us_) std::ranges::fill(last_us, 0);
  reading_check_ = {};
  clock_check_ = {};
}

void SkinStream::forgetLookUp() {
  looked_up_cells_.clear();
  looked_up_indices_.clear();
  looked_up_unknown_ = 0;
}

SkinStream::Effect SkinStream::take(Decoded decoded, Clock::time_point now) {
  tend(now);
  noteAllOf(decoded);
  switch (decoded.outcome) {
    case DecodeOutcome::Broken:
      reject(decoded.reason());
      return Effect::Nothing;
    case DecodeOutcome::OtherMajor:
      last_rejection_ = printable(decoded.reason());
      return Effect::Incompatible;
    case DecodeOutcome::UnknownType:
      return Effect::Alive;
    case DecodeOutcome::Understood:
      break;
  }
  if (const auto* samples = std::get_if<skinwire::Samples>(&decoded.message)) return takeSamples(*samples);
  if (const auto* hello = std::get_if<skinwire::Hello>(&decoded.message)) return takeHello(*hello, now);
  if (auto* topology = std::get_if<skinwire::Topology>(&decoded.message))
    return takeTopology(std::move(*topology), now);
  if (const auto* status = std::get_if<skinwire::Status>(&decoded.message)) {
    takeStatus(*status);
  } else if (const auto* ack = std::get_if<skinwire::Ack>(&decoded.message)) {
    if (on_ack) on_ack(*ack);
  } else if (auto* joints = std::get_if<skinwire::Joints>(&decoded.message)) {
    return takeJoints(std::move(*joints));
  }
  return Effect::Alive;
}

void SkinStream::takeStatus(const skinwire::Status& status) {
  device_text_ = Message::verbatim(printable(status.text));
  is_exploring_ = status.exploring;
  if (device_text_.empty() && status.exploring) device_text_ = message("exploring its cells");
  if (status_.dropped_by_device != status.samples_dropped) counters_changed_ = true;
  status_.dropped_by_device = status.samples_dropped;
  listener_.onDeviceStatus({printable(status.text), status.exploring, status.samples_sent, status.samples_dropped});
}

SkinStream::Effect SkinStream::takeJoints(skinwire::Joints joints) {
  if (!joints.names.empty()) joint_names_ = std::move(joints.names);
  if (joint_names_.size() != joints.position.size()) {
    countRejected(
        located("joints.position", message("expected a number for each of {} joints that were named, found {}",
                                           joint_names_.size(), joints.position.size())),
        ProtocolViolationKind::WrongLength);
    return Effect::Nothing;
  }
  if (joints.time_us < last_joints_us_) {
    ++status_.late_frames;
    counters_changed_ = true;
    return Effect::Nothing;
  }
  last_joints_us_ = joints.time_us;
  if (!announced_) return Effect::Alive;
  JointReport report{1e-6 * static_cast<double>(joints.time_us), {}};
  for (std::size_t k = 0; k < joint_names_.size(); ++k) report.angles.positions[joint_names_[k]] = joints.position[k];
  listener_.onJoints(report);
  return Effect::Alive;
}

void SkinStream::countRejected(const Message& why, ProtocolViolationKind kind) {
  note(ProtocolViolation{kind, why});
  reject(why);
}

void SkinStream::reject(const Message& why) {
  last_rejection_ = printable(why);
  was_rejected_ = true;
  ++status_.rejected_messages;
  counters_changed_ = true;
}

SkinStream::Effect SkinStream::takeHello(const skinwire::Hello& hello, Clock::time_point now) {
  if (has_hello_ && hello.stream != hello_.stream) startCounting();
  // UDP devices repeat it every second; a model is parsed only if it is another one.
  const bool same_model = model_ && hello.cell_model == hello_.cell_model;
  // Samples of before say nothing about another rate.
  if (has_hello_ && hello.rate_hz != hello_.rate_hz) clock_check_ = {};
  has_hello_ = true;
  hello_ = hello;
  if (!same_model) {
    model_ = nullptr;
    model_complaint_ = {};
    try {
      model_ = std::make_shared<const CellModel>(skinwire::cellModelOf(hello));
      if (announced_) noteNewModel(*announced_->model);
    } catch (const Error& error) {
      model_complaint_ = printable(error.message());
      countRejected(located("hello.cell_model", model_complaint_), ProtocolViolationKind::CellModel);
    }
    is_topology_judged_ = false;
  }
  announce(now);
  return Effect::Alive;
}

SkinStream::Effect SkinStream::takeTopology(skinwire::Topology part, Clock::time_point now) {
  const std::uint32_t id = part.id;
  std::optional<NeighborList> whole = assembler_.add(std::move(part));
  if (!whole) return Effect::Alive;
  has_topology_ = true;
  topology_id_ = id;
  if (*whole != neighbors_) is_topology_judged_ = false;
  neighbors_ = std::move(*whole);
  announce(now);
  return Effect::Alive;
}

void SkinStream::announce(Clock::time_point now) {
  if (!isDescribed()) return;
  SkinDescription skin{Message::verbatim(printable(hello_.device)), model_, neighbors_, hello_.can_light_cells,
                       hello_.can_turn};
  const std::optional<SkinDescription>& newest = held_ ? held_ : announced_;
  if (newest && sameDescription(*newest, skin)) return;
  if (newest) {
    ++status_.skin_changes;
    counters_changed_ = true;
  }
  held_ = std::move(skin);
  tend(now);
}

void SkinStream::tend(Clock::time_point now) {
  if (!held_) return;
  if (announced_ && sameDescription(*announced_, *held_)) {
    held_.reset();  // it is again as it was
    is_model_held_ = false;
    return;
  }
  if (announced_ && !changes_.spend(now)) {
    is_model_held_ = !sameModel(*announced_, *held_);
    return;
  }
  const bool same_cells = announced_ && announced_->neighbors == held_->neighbors;
  announced_ = std::exchange(held_, std::nullopt);
  is_model_held_ = false;
  if (!same_cells) indexCells();
  listener_.onSkin(*announced_);
}

void SkinStream::indexCells() {
  const auto before = std::exchange(index_of_, {});
  for (const CellReport& cell : announced_->neighbors) {
    index_of_.try_emplace(cell.id.value(), static_cast<std::uint32_t>(index_of_.size()));
  }
  // What came of a cell that stays must not come again.
  for (auto& last_us : cell_last_us_) {
    std::vector<std::uint64_t> of_before(index_of_.size(), 0);
    of_before.swap(last_us);
    for (const auto& [cell, index] : index_of_) {
      if (const auto known = before.find(cell); known != before.end()) last_us[index] = of_before[known->second];
    }
  }
  forgetLookUp();
}

Message SkinStream::deviceText() const {
  if (!held_) return device_text_;
  const Message changes = message("its links or cells keep changing, {} times by now; they are taken over every {}",
                                  status_.skin_changes, Seconds{ChangeBudget::kEvery.count(), 0});
  return inRow({changes, device_text_}, "; ");
}

Message SkinStream::whatIsMissing() const {
  if (!model_complaint_.empty()) return message("its cell model can't be used: {}", model_complaint_);
  if (!has_hello_) return message("it has not said what it is");
  if (!has_topology_) return message("its topology has not come");
  return {};
}

Message SkinStream::deviceName() const {
  return hello_.device.empty() ? message("the device") : Message::verbatim(printable(hello_.device));
}

bool SkinStream::lookUpCells(const std::vector<std::uint32_t>& cells) {
  if (cells == looked_up_cells_) return true;
  forgetLookUp();
  std::vector<bool> seen(index_of_.size(), false);
  for (const std::uint32_t cell : cells) {
    const auto found = index_of_.find(cell);
    if (found == index_of_.end()) {
      looked_up_indices_.push_back(kUnknown);
      ++looked_up_unknown_;
      continue;
    }
    if (seen[found->second]) {
      forgetLookUp();
      return false;
    }
    seen[found->second] = true;
    looked_up_indices_.push_back(found->second);
  }
  looked_up_cells_ = cells;
  return true;
}

bool SkinStream::wasClockSetBack(const skinwire::Samples& samples) {
  if (samples.time_us >= last_us_) return false;  // twice the same
  if (!late_from_us_ || samples.time_us < late_to_us_) late_from_us_ = samples.time_us;
  late_to_us_ = samples.time_us;
  return late_to_us_ - *late_from_us_ >= kClockReset_us;
}

bool SkinStream::isLate(const skinwire::Samples& samples) const {
  if (samples.time_us < last_us_) return true;
  return std::ranges::any_of(looked_up_indices_, [&](std::uint32_t index) {
    return index != kUnknown && cell_last_us_[kindOf(samples)][index] > samples.time_us;
  });
}

SkinStream::Effect SkinStream::takeSamples(const skinwire::Samples& samples) {
  const std::size_t ticks = samples.ticks();
  const std::size_t count = ticks * samples.cells.size();
  if (!isDescribed() || is_model_held_) {
    status_.undescribed_samples += count;
    counters_changed_ = counters_changed_ || count > 0;
    return Effect::Alive;
  }
  if (!samples.raw_lsb.empty() && !(model_->accelerometer.lsb_g > 0)) {
    countRejected(message("samples in LSB need a cell model whose accelerometer.lsb_g is above 0"),
                  ProtocolViolationKind::NoScale);
    return Effect::Nothing;
  }
  if (!lookUpCells(samples.cells)) {
    countRejected(located("samples.cells", message("a cell is twice in one message")),
                  ProtocolViolationKind::RepeatedCell);
    return Effect::Nothing;
  }
  bool late = isLate(samples);
  if (late) noteLate(samples);
  if (late && wasClockSetBack(samples)) {
    startCounting();
    ++status_.clock_restarts;
    late = false;
  }
  if (!late) noteSequence(samples);
  if (samples.sequence) countLosses(*samples.sequence, count, samples.time_us, late);
  counters_changed_ = true;
  if (late) {
    status_.late_frames += std::max<std::size_t>(ticks, 1);
    return Effect::Nothing;
  }
  deliver(samples);
  return Effect::Alive;
}

void SkinStream::countLosses(std::uint64_t first, std::uint64_t count, std::uint64_t time_us, bool late) {
  if (!next_sequence_ || first >= *next_sequence_) {
    // Messages sent before the first one of a connection are not lost: nobody listened.
    if (next_sequence_) status_.lost_samples += first - *next_sequence_;
    next_sequence_ = first + count;
  } else if (!late && time_us > last_us_) {
    next_sequence_ = first + count;  // the numbers started anew
  } else if (!late) {
    // Overtaken by a message of the same time: it had been counted as lost.
    status_.lost_samples -= std::min(status_.lost_samples, count);
  }
}

void SkinStream::deliver(const skinwire::Samples& samples) {
  const std::size_t ticks = samples.ticks();
  const auto isUnknown = [this](const auto& item) { return !index_of_.contains(item.cell.value()); };
  for (std::size_t tick = 0; tick < std::max<std::size_t>(ticks, 1); ++tick) {
    skinwire::decodeTick(samples, tick, model_->accelerometer.lsb_g, frame_);
    if (looked_up_unknown_ > 0) {
      std::erase_if(frame_.samples, isUnknown);
      std::erase_if(frame_.means, isUnknown);
    }
    std::erase_if(frame_.temperatures, isUnknown);
    if (frame_.samples.empty() && frame_.means.empty() && frame_.temperatures.empty()) continue;
    ++status_.frames;
    judgeFrame(samples, samples.time_us + tick * std::uint64_t{samples.period_us});
    listener_.onFrame(frame_);
  }
  if (looked_up_unknown_ > 0) noteUnknownCells(samples);
  status_.unknown_samples += looked_up_unknown_ * ticks;
  late_from_us_.reset();
  last_us_ = samples.time_us + (ticks > 1 ? (ticks - 1) * std::uint64_t{samples.period_us} : 0);
  for (const std::uint32_t index : looked_up_indices_) {
    if (index != kUnknown) cell_last_us_[kindOf(samples)][index] = last_us_ + 1;
  }
}

void SkinStream::report(SourceState state, Message message, Clock::time_point now) {
  if (state == status_.state && message == status_.message) return;
  status_.state = state;
  status_.message = std::move(message);
  if (state == SourceState::Ended) noteMissingDescription();
  tell(now);
}

void SkinStream::reportCounters(Clock::time_point now) {
  judgeClock(now);
  if (log_.hasNews() || (counters_changed_ && now - told_at_ >= kTellEvery)) tell(now);
}

void SkinStream::tell(Clock::time_point now) {
  told_at_ = now;
  counters_changed_ = false;
  judgeTopology();
  log_.takeNews();
  status_.offences = log_.offences();
  listener_.onStatus(status_);
}

}  // namespace hexoderm
