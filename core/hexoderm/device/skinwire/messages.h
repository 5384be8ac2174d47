#pragma once

#include "hexoderm/device/protocol_violation.h"
#include "hexoderm/skin/neighbor_list.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// SkinWire 1, the protocol of live skins, in plain types. skinwire.proto says what every field means; names and units
/// are the same here. README.md in this folder documents framing and rules.
namespace hexoderm::skinwire {

inline constexpr std::uint8_t kMajor = 1;   ///< a device with another one is refused
inline constexpr std::uint32_t kMinor = 1;  ///< the newest version whose messages and fields are known here

/// Longest body of a frame (and longest line), bytes. A frame that claims to be longer is broken.
inline constexpr std::size_t kMaxBody = 1U << 20U;
/// Longest UDP datagram, bytes: one body, not fragmented on common networks.
inline constexpr std::size_t kMaxDatagram = 1200;
/// Joints of a robot.
inline constexpr std::size_t kMaxJoints = 10'000;
/// Cells of a whole topology.
inline constexpr std::size_t kMaxCells = 1'000'000;
/// Largest time: beyond it a double of microseconds is not exact.
inline constexpr std::uint64_t kMaxTime_us = std::uint64_t{1} << 53U;

/// The device's description of itself.
struct Hello {
  std::uint32_t minor = kMinor;
  std::string device{};
  std::string cell_model{};  ///< name of a built-in model, or a model's JSON text
  bool can_light_cells = false;
  bool can_turn = false;
  double rate_hz = 0;
  std::uint32_t stream = 0;
  friend bool operator==(const Hello&, const Hello&) = default;
};

/// A whole topology, or a part of it.
struct Topology {
  std::uint32_t id = 0;
  std::uint32_t part = 0;
  std::uint32_t parts = 1;  ///< at least 1
  NeighborList cells{};
  friend bool operator==(const Topology&, const Topology&) = default;
};

/// Exactly one of raw_lsb, acceleration_g and mean_g is filled if there are cells, none if there are not.
struct Samples {
  std::optional<std::uint64_t> sequence{};
  std::uint64_t time_us = 0;
  std::uint32_t period_us = 0;
  std::vector<std::uint32_t> cells{};
  std::vector<std::int32_t> raw_lsb{};  ///< ticks x cells x 3
  std::vector<float> acceleration_g{};  ///< ticks x cells x 3
  std::vector<float> mean_g{};          ///< cells x 3
  std::vector<float> variance_g2{};     ///< cells x 3
  std::vector<std::uint32_t> count{};   ///< cells
  std::vector<std::uint32_t> temperature_cells{};
  std::vector<float> temperature_c{};
  friend bool operator==(const Samples&, const Samples&) = default;

  /// 1 for means, 0 without cells. Only for what keeps the rules of `complaint`.
  [[nodiscard]] std::size_t ticks() const;
};

/// The device's report about itself.
struct Status {
  std::string text{};
  bool exploring = false;
  std::uint64_t samples_sent = 0;
  std::uint64_t samples_dropped = 0;
  friend bool operator==(const Status&, const Status&) = default;
};

/// Command: send so many samples a second.
struct SetRate {
  double rate_hz = 0;
  friend bool operator==(const SetRate&, const SetRate&) = default;
};
/// Command: light a cell.
struct SetLed {
  std::uint32_t cell = 0;
  std::uint8_t red = 0, green = 0, blue = 0;
  friend bool operator==(const SetLed&, const SetLed&) = default;
};
/// Command: turn the part, and hold it.
struct TurnTo {
  std::uint32_t cell = 0;
  Eigen::Vector3d up_u = Eigen::Vector3d::UnitZ();  ///< unit, cell frame
  friend bool operator==(const TurnTo&, const TurnTo&) = default;
};
struct ExploreAgain {
  friend bool operator==(const ExploreAgain&, const ExploreAgain&) = default;
};
/// Command: describe yourself.
struct Describe {
  std::optional<std::uint32_t> known_topology{};
  friend bool operator==(const Describe&, const Describe&) = default;
};
/// monostate: a request that this version does not know.
using Request = std::variant<std::monostate, SetRate, SetLed, TurnTo, ExploreAgain, Describe>;

/// What the host asks of the device.
struct Command {
  std::uint32_t number = 0;
  Request request{};
  friend bool operator==(const Command&, const Command&) = default;
};

/// The device's answer to a command.
struct Ack {
  std::uint32_t command = 0;
  bool done = false;
  std::string text{};
  bool working = false;
  friend bool operator==(const Ack&, const Ack&) = default;
};

/// Names as they came; none where they are those of the message before.
struct Joints {
  std::uint64_t time_us = 0;
  std::vector<std::string> names{};
  std::vector<double> position{};  ///< rad or m
  friend bool operator==(const Joints&, const Joints&) = default;
};

/// The alternatives are in the order of the type numbers on the wire, which begin with 1.
using Message = std::variant<Hello, Topology, Samples, Status, Command, Ack, Joints>;

/// The fault of a message beyond its syntax; empty if there is none.
struct ValidationError {
  ProtocolViolationKind kind{};                                ///< WrongLength or WrongValue
  hexoderm::Message reason{};                                  ///< the field and what is expected there
  [[nodiscard]] bool empty() const { return reason.empty(); }  ///< nothing is wrong
};

/// Looks for numbers that are not finite, lengths that don't fit together, times, counts, IDs and texts out of range.
/// Faults that show only against the topology are not looked for.
ValidationError complaint(const Message& message);

}  // namespace hexoderm::skinwire
