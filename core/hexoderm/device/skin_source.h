#pragma once

#include "hexoderm/base/joint_angles.h"
#include "hexoderm/base/message.h"
#include "hexoderm/device/ground_truth.h"
#include "hexoderm/device/protocol_violation.h"
#include "hexoderm/device/sample_frame.h"
#include "hexoderm/skin/cell_model.h"
#include "hexoderm/skin/neighbor_list.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace hexoderm {

/// A device's description of itself, given before it streams.
struct SkinDescription {
  Message device;                              ///< for people, for example "emulated x17"
  std::shared_ptr<const CellModel> model;      ///< never null
  NeighborList neighbors;                      ///< the explored neighbours; may contradict itself
  bool can_light_cells = false;                ///< answers SetLed
  bool can_turn = false;                       ///< answers TurnTo: a robot that moves itself
  std::shared_ptr<const GroundTruth> truth{};  ///< known only for some simulated skins; else null
};

/// State of a source. From Connecting on, every state can follow every other while the source runs.
enum class SourceState {
  Stopped,
  Connecting,  ///< also while it waits before the next try; the text counts the seconds down
  Waiting,     ///< connected; the device has not described itself yet
  Streaming,
  Silent,        ///< connected, but nothing came for a while
  Ended,         ///< the stream is over (end of a recording or of standard input); no more will come
  Incompatible,  ///< the device speaks another major version; no use to try again
};

/// A source that has not heard anything that makes sense for so long is Silent, unless it is told another time.
inline constexpr std::chrono::milliseconds kSilentAfter{800};

/// Counters are since start().
struct SourceStatus {
  SourceState state = SourceState::Stopped;
  Message message;                    ///< one line for people: what, where, and what happens next
  std::uint64_t frames = 0;           ///< sample frames delivered
  std::uint64_t lost_samples = 0;     ///< the device's numbering says they were sent; they never came, or too late
  std::uint64_t late_frames = 0;      ///< older than what was delivered, or twice: not delivered
  std::uint64_t unknown_samples = 0;  ///< samples of cells that the topology does not have; not delivered
  std::uint64_t undescribed_samples =
      0;                                ///< came before a description, or while a changed one was not used yet; neither
  std::uint64_t rejected_messages = 0;  ///< broken on the way (length, CRC, syntax) or without sense: not delivered
  std::uint64_t reconnects = 0;
  std::uint64_t dropped_by_device = 0;  ///< samples that it could not send, as it said last; since it started itself
  std::uint64_t skin_changes = 0;       ///< how often it described itself differently; not each is passed on
  std::uint64_t clock_restarts = 0;     ///< its clock was set back without notice
  std::vector<ProtocolViolation>
      offences{};  ///< what the device does wrong, the first of each kind; told as soon as it comes
};

/// A device's report about itself while it streams.
struct DeviceStatus {
  std::string text;  ///< for people; empty: nothing remarkable
  bool exploring = false;
  std::uint64_t samples_sent = 0;     ///< since the device started
  std::uint64_t samples_dropped = 0;  ///< likewise; could not be sent
};

/// Where the joints of the robot stand that wears the skin.
struct JointReport {
  double time_s = 0;  ///< device time, by the clock of the samples
  JointAngles angles;
};

/// Rate of samples that the device should send, Hz.
struct SetRate {
  double rate_hz = 0;
};
/// Light of one cell; black turns it off.
struct SetLed {
  CellId cell;
  std::uint8_t red = 0, green = 0, blue = 0;
};
/// Turn the part until up points along `up_u` (unit, in the frame of `cell`), and hold it there.
struct TurnTo {
  CellId cell;
  Eigen::Vector3d up_u;
};
/// Explore the neighbours again; a new topology follows.
struct ExploreAgain {};
using SkinCommand = std::variant<SetRate, SetLed, TurnTo, ExploreAgain>;  ///< what a host can ask of a device

/// Answer to a command.
struct CommandOutcome {
  std::uint32_t command = 0;  ///< the number that send() returned
  bool done = false;
  Message message;  ///< why not, or empty
};

/// Receives what a source delivers, on the source's own thread. Must not throw: std::terminate; a source on a wire
/// may merely end. Must not block for long and must not call start() or stop() of the source.
class SkinListener {
 public:
  virtual ~SkinListener() = default;
  /// Called before the first frame, and again whenever topology or model changed. A device on a wire that changes many
  /// times a second is passed on every few seconds (SourceStatus::skin_changes counts all of its changes).
  virtual void onSkin(const SkinDescription& skin) = 0;
  /// Delivers only finite values, and only of cells that onSkin named. Times don't go back, unless the device's clock
  /// started over, which the state before it tells (Connecting) or which happens without notice if a device restarts on
  /// its own. Frames of the same time have no cell in common.
  virtual void onFrame(const SampleFrame& frame) = 0;
  /// On every change of state or text, and about twice a second while counters change.
  virtual void onStatus(const SourceStatus& status) = 0;
  /// The device's answer to a command, or that none came.
  virtual void onCommandOutcome(const CommandOutcome& outcome) = 0;
  /// Whenever the device says so, in its place among the frames. Not every device does.
  virtual void onDeviceStatus(const DeviceStatus& /*status*/) {}
  /// Whenever the device says so, in its place among the frames, after onSkin. Times don't go back, as those of frames.
  /// Not every device does.
  virtual void onJoints(const JointReport& /*joints*/) {}
};

/// A skin that delivers by itself: a device on a wire, a recording, a simulated skin. It runs on a thread of its own.
/// Errors on the way are reported in the status; no exception leaves the thread.
class SkinSource {
 public:
  virtual ~SkinSource() = default;
  /// Begins to deliver to `listener`, which must live until stop() returns. Throws DeviceError or InvalidArgument if
  /// the source can't exist at all, StorageError or FormatError for a file that can't be read or is no recording. Call
  /// once.
  virtual void start(SkinListener& listener) = 0;
  /// Ends delivery; nothing is called after it returns. Idempotent.
  virtual void stop() noexcept = 0;
  /// Queues a command and returns its number; the outcome arrives by onCommandOutcome. From any thread.
  virtual std::uint32_t send(const SkinCommand& command) = 0;
  /// The address it was opened with, for example "tcp://localhost:7700".
  [[nodiscard]] virtual std::string address() const = 0;
};

}  // namespace hexoderm
