#pragma once

// What every source of SkinWire messages does with them.

#include "hexoderm/device/plausibility.h"
#include "hexoderm/device/protocol_violation_log.h"
#include "hexoderm/device/skin_source.h"
#include "hexoderm/device/skinwire/codec.h"
#include "hexoderm/device/skinwire/description.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

namespace hexoderm {

/// Lets a few changes through at once, and one every so often after that.
class ChangeBudget {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr int kAtOnce = 4;
  static constexpr std::chrono::seconds kEvery{3};

  /// Whether a change may pass now; if so, it counts.
  bool spend(Clock::time_point now) {
    free_at_ = std::max(free_at_, now - (kAtOnce - 1) * kEvery);
    if (free_at_ > now) return false;
    free_at_ += kEvery;
    return true;
  }

 private:
  Clock::time_point free_at_ = Clock::time_point::min();
};

/// What is known of the device from one connection alone.
struct ConnectionState {
  Message device_text_;
  bool has_hello_ = false;
  std::vector<std::string> joint_names_;    ///< of the device's last message that had them
  std::shared_ptr<const CellModel> model_;  ///< null: none, or one that makes no sense
  Message model_complaint_;
  skinwire::TopologyAssembler assembler_;
  bool has_topology_ = false;
  NeighborList neighbors_;
  std::optional<SkinDescription> held_;  ///< newer, not passed on yet
  bool is_model_held_ = false;           ///< it has another model, so that samples can't be read by the one known
  bool is_exploring_ = false;
  bool was_heard_ = false;     ///< a message came on this connection
  bool was_rejected_ = false;  ///< one that was rejected came on it, which may have been an answer
  std::uint64_t times_asked_ = 0;
  std::optional<std::chrono::steady_clock::time_point> undescribed_since_;
};

/// The host's end of SkinWire above the framing: puts the description together, checks samples against it, numbers and
/// times, calls the listener, counts and reports, and names what the device does wrong. It knows no socket, no file and
/// no clock.
///
/// A loose plug changes the topology many times a second, and everything behind the listener works, and some of it
/// writes to disk, for each. So only a few changes are passed on at once, and then the newest one every few seconds
/// (ChangeBudget). Meanwhile samples are those of the skin that the listener knows.
class SkinStream : private ConnectionState {
 public:
  using Clock = std::chrono::steady_clock;
  enum class Effect {
    Nothing,       ///< broken or late
    Alive,         ///< something that makes sense came
    Incompatible,  ///< another major version
  };

  explicit SkinStream(SkinListener& listener) : listener_(listener) {}

  /// Forgets the device, but not what the listener was told of it: a new connection, whose device starts with Hello.
  void restart();
  Effect take(skinwire::Decoded decoded, Clock::time_point now);
  /// Passes a change of the skin on that was held back, once it is time.
  void tend(Clock::time_point now);

  /// Hello and a whole topology are there, and the cell model makes sense.
  [[nodiscard]] bool isDescribed() const { return has_topology_ && model_ != nullptr; }
  [[nodiscard]] const skinwire::Hello& hello() const { return hello_; }
  /// ID of the last whole topology.
  [[nodiscard]] std::optional<std::uint32_t> topologyId() const {
    return has_topology_ ? std::optional(topology_id_) : std::nullopt;
  }
  /// The message that is still missing before isDescribed(); for status lines.
  [[nodiscard]] Message whatIsMissing() const;
  /// The device's last report, and what is to be said of its changes; for status lines.
  [[nodiscard]] Message deviceText() const;
  /// Why the last message that was rejected was.
  [[nodiscard]] const Message& lastRejection() const { return last_rejection_; }
  [[nodiscard]] std::uint64_t rejectedMessages() const { return status_.rejected_messages; }
  [[nodiscard]] std::uint64_t clockRestarts() const { return status_.clock_restarts; }
  /// The device's name, for status lines.
  [[nodiscard]] Message deviceName() const;

  /// Called for every Ack.
  std::function<void(const skinwire::Ack&)> on_ack;

  /// Tells the listener if state or text changed.
  void report(SourceState state, Message message, Clock::time_point now);
  /// Tells the listener if counters changed and it was not told for half a second.
  void reportCounters(Clock::time_point now);
  void countReconnect() { ++status_.reconnects; }
  void countRejected(const Message& why, ProtocolViolationKind kind = ProtocolViolationKind::BrokenFrame);
  /// Something that stays as it is while it is looked at: counted once.
  void noteOnce(const std::optional<ProtocolViolation>& offence);
  /// A serial port delivers nothing but broken bytes at this rate. Said of the broken frames.
  void noteWrongBaud(unsigned baud);
  /// A Describe was sent to a device that ought to hear it.
  void countAsked() { ++times_asked_; }
  /// The connection begins in the middle of a frame: that is no offence.
  void forgiveFirstPiece() { is_first_piece_forgiven_ = true; }
  /// Live unless told otherwise.
  void setPace(ClockCheck::Pace pace) { pace_ = pace; }
  [[nodiscard]] SourceState state() const { return status_.state; }

 private:
  void reject(const Message& why);
  Effect takeHello(const skinwire::Hello& hello, Clock::time_point now);
  Effect takeTopology(skinwire::Topology part, Clock::time_point now);
  Effect takeSamples(const skinwire::Samples& samples);
  void takeStatus(const skinwire::Status& status);
  Effect takeJoints(skinwire::Joints joints);
  void startCounting();
  void announce(Clock::time_point now);
  void indexCells();
  void forgetLookUp();
  bool lookUpCells(const std::vector<std::uint32_t>& cells);
  static std::size_t kindOf(const skinwire::Samples& samples) { return samples.mean_g.empty() ? 0 : 1; }
  bool isLate(const skinwire::Samples& samples) const;
  bool wasClockSetBack(const skinwire::Samples& samples);
  void countLosses(std::uint64_t first, std::uint64_t count, std::uint64_t time_us, bool late);
  void deliver(const skinwire::Samples& samples);
  /// Counts an offence; the reason is made for the first one of its kind only.
  template <class MakeReason>
  void note(ProtocolViolationKind kind, std::uint64_t count, const MakeReason& reason);
  void note(const std::optional<ProtocolViolation>& offence);
  void noteAllOf(const skinwire::Decoded& decoded);
  void noteNewModel(const CellModel& before);
  void noteUnknownCells(const skinwire::Samples& samples);
  void noteLate(const skinwire::Samples& samples);
  void noteSequence(const skinwire::Samples& samples);
  void noteMissingDescription();
  void judgeTopology();
  void judgeFrame(const skinwire::Samples& samples, std::uint64_t time_us);
  void judgeClock(Clock::time_point now);
  void tell(Clock::time_point now);

  SkinListener& listener_;
  SourceStatus status_;
  Clock::time_point told_at_{};
  bool counters_changed_ = false;
  Message last_rejection_;

  std::uint64_t last_joints_us_ = 0;
  skinwire::Hello hello_;
  std::uint32_t topology_id_ = 0;
  std::optional<SkinDescription> announced_;  ///< what the listener knows; samples are checked against it
  ChangeBudget changes_;
  std::unordered_map<std::uint32_t, std::uint32_t> index_of_;

  std::optional<std::uint64_t> next_sequence_;
  std::uint64_t last_us_ = 0;
  std::optional<std::uint64_t> late_from_us_;  ///< the first of the late messages in a row whose time goes up
  std::uint64_t late_to_us_ = 0;
  /// By index, of samples and of means; plus 1, so that 0 is "never".
  std::array<std::vector<std::uint64_t>, 2> cell_last_us_;

  // Messages mostly name the same cells again: looked up once.
  std::vector<std::uint32_t> looked_up_cells_;
  std::vector<std::uint32_t> looked_up_indices_;  ///< kUnknown for cells that are not in the topology
  std::size_t looked_up_unknown_ = 0;
  SampleFrame frame_;

  ProtocolViolationLog log_;
  ReadingCheck reading_check_;
  ClockCheck clock_check_;
  ClockCheck::Pace pace_ = ClockCheck::Pace::Live;
  bool is_topology_judged_ = true;
  bool is_first_piece_forgiven_ = false;
  bool is_baud_noted_ = false;
};

/// Control characters become spaces: what a device says appears on terminals.
std::string printable(std::string text);
/// The same for all texts of a message.
Message printable(const Message& message);

}  // namespace hexoderm
