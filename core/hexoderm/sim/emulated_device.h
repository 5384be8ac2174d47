#pragma once

#include "hexoderm/device/skinwire/messages.h"
#include "hexoderm/device/skinwire/sample_messages.h"
#include "hexoderm/sim/exploration.h"
#include "hexoderm/sim/simulated_body.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

/// How an emulated device sends.
struct EmulatedDeviceOptions {
  double rate_hz = 0;          ///< rate of the samples; 0: the cell model's
  std::uint32_t means_of = 0;  ///< samples that a cell averages by itself; 0: every sample is sent
  std::size_t max_body = skinwire::kMaxBody;
  double message_every_s = 0.01;  ///< ticks that are sent together, where they fit
  double status_every_s = 0.5;
  double working_every_s = 1;  ///< word of a command that takes its time
  ExplorationOptions exploration;

  /// Throws InvalidArgument naming the option.
  void validate() const;
};

/// A skin that is a device: what the cells of a SimulatedBody feel becomes SkinWire messages, and commands are
/// answered. It knows no transport and no clock but its own: the caller lets it tick, at the speed it likes, and sends
/// what it is handed. All times are the device's.
///
/// When power comes, and when asked, the cells explore their neighbours (exploration.h; the interface hangs on the
/// first free port of each patch); meanwhile nothing is sampled. Samples are sent of the cells that were found. A robot
/// says where its joints stand as JointReporting has it.
class EmulatedDevice {
 public:
  using Messages = std::vector<skinwire::Message>;  ///< what the device sends, in order

  /// Throws InvalidArgument as exploreNetwork, firstFreePorts and the options' validate() do, and if the names of the
  /// joints don't fit into a message.
  explicit EmulatedDevice(std::unique_ptr<SimulatedBody> body, EmulatedDeviceOptions options = {});

  /// A host has come: tells it everything. Until then ticks only pass the time.
  void greet(Messages& out);
  /// Forgets a host that has gone, and its requests that are not done yet.
  void forgetHost();
  /// A command that comes again (UDP) is answered again, not done again.
  void take(const skinwire::Command& command, Messages& out);
  /// The next tick of the sensors' clock; appends what is to be sent.
  void tick(Messages& out);
  /// Advances like tick(), but for ticks for which there is no time: their samples are counted as dropped. Means are
  /// then of fewer samples, and dropped where there is none left.
  void skip(std::size_t ticks, Messages& out);
  /// The number of ticks to skip at once if every second one has to be skipped.
  [[nodiscard]] std::size_t ticksPerMessage() const;
  /// A message of samples could not be sent.
  void countDropped(const skinwire::Samples& samples);

  /// Length of a tick, s: 1 / the cell model's rate, whatever part of the ticks is sent.
  [[nodiscard]] double tick_s() const { return 1 / body_->rate_hz(); }
  /// Device time since it started.
  [[nodiscard]] double time_s() const { return static_cast<double>(ticks_) * tick_s(); }
  [[nodiscard]] const SimulatedBody& body() const { return *body_; }  ///< what wears the skin
  /// Its cells are still looking for their neighbours.
  [[nodiscard]] bool isExploring() const { return ticks_ < explored_at_; }
  /// The last one that was begun.
  [[nodiscard]] const Exploration& exploration() const { return exploration_; }
  [[nodiscard]] skinwire::Hello hello() const;    ///< its description of itself
  [[nodiscard]] skinwire::Status status() const;  ///< its report about itself
  /// Samples of each cell per second.
  [[nodiscard]] double rate_hz() const { return 1 / (tick_s() * static_cast<double>(divider_)); }
  /// Red, green, blue; black without a command. Throws InvalidArgument if there is no such cell.
  [[nodiscard]] std::array<std::uint8_t, 3> led(CellId cell) const;

  // Faults and motions while it runs. All throw InvalidArgument for what is not there.
  /// Turns the body until this direction points up, as a command would.
  void turnTo(const Eigen::Vector3d& up_b, Messages& out);
  void turnToNextPose(Messages& out);      ///< turns the body to the next pose of its own choice
  void breakCell(const CellFault& fault);  ///< a cell fails from now on
  /// Mends the cell's sensor at once, and its part in the network from the next exploration on.
  void mendCell(CellId cell);
  /// The mould is another one: the device starts over, with its clock and its numbering, and explores.
  void breakLink(const LinkFault& fault, Messages& out);
  /// Mends all faults of this link; false if there was none. Otherwise like breakLink.
  bool mendLink(const LinkEnd& at, Messages& out);
  /// From the next exploration on.
  void breakPort(const PortFault& fault);
  bool mendPort(const LinkEnd& at);  ///< the port works again; false: it had no fault
  /// It answers no neighbour: from the next exploration on.
  void breakController(CellId cell);
  void exploreAgain(Messages& out);  ///< the cells explore their neighbours again

 private:
  struct Turn {
    std::uint32_t command = 0;
    std::uint64_t say_at = 0;  ///< tick
  };

  void startExploring(Messages& out);
  void finishExploring(Messages& out);
  void restart(std::vector<LinkFault> link_faults, Messages& out);
  void describe(const std::optional<std::uint32_t>& known_topology, Messages& out);
  void answer(const skinwire::Ack& ack, Messages& out);
  void turn(std::uint32_t command, const skinwire::TurnTo& request, Messages& out);
  void dropTurn(std::string why, Messages& out);
  std::string setRate(double rate_hz);
  void tendCommands(Messages& out);
  void requireRoomForJoints() const;
  void tellJoints(Messages& out);
  void takeSamples(SampleFrame frame, Messages& out);
  void average(const SampleFrame& frame, Messages& out);
  /// Returns how many.
  std::size_t sendMeans(Messages& out);
  void flush(Messages& out);
  void send(std::vector<skinwire::Samples> samples, Messages& out);
  [[nodiscard]] bool isFound(CellId cell) const;
  [[nodiscard]] std::uint64_t ticksIn(double seconds) const;

  std::unique_ptr<SimulatedBody> body_;  ///< never null
  EmulatedDeviceOptions options_;
  std::map<CellId, std::vector<SkinFault>> cell_faults_;
  std::size_t divider_ = 1;
  std::uint32_t stream_ = 1;

  std::uint64_t ticks_ = 0;
  std::uint64_t explored_at_ = 0;  ///< tick
  Exploration exploration_;
  NeighborList topology_;
  std::uint32_t topology_id_ = 0;  ///< 0: none yet
  std::vector<bool> found_;        ///< by ID - 1; empty: all of them

  bool has_host_ = false;
  std::uint64_t status_at_ = 0;  ///< tick
  std::map<std::uint32_t, skinwire::Ack> answered_;
  std::optional<Turn> turning_;
  std::vector<Turn> exploring_;

  std::vector<std::array<std::uint8_t, 3>> leds_;
  JointReporting joint_reporting_;
  skinwire::JointsEncoder joints_;
  skinwire::SampleEncoder encoder_;
  std::uint64_t skipped_ = 0;  ///< samples that were not even encoded
  std::uint64_t dropped_ = 0;  ///< those, and those that could not be sent
  std::vector<SampleFrame> batch_;
  struct Sums {
    Eigen::Vector3d sum_g = Eigen::Vector3d::Zero();
    Eigen::Vector3d squares_g2 = Eigen::Vector3d::Zero();
    std::uint32_t count = 0;
  };
  std::vector<Sums> sums_;
  std::uint32_t summed_ticks_ = 0;
  double summed_until_s_ = 0;
};

}  // namespace hexoderm
