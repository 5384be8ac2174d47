#pragma once

#include "hexoderm/base/joint_angles.h"
#include "hexoderm/base/message.h"
#include "hexoderm/device/ground_truth.h"
#include "hexoderm/device/sample_frame.h"
#include "hexoderm/device/skin_source.h"
#include "hexoderm/sim/skin_faults.h"
#include "hexoderm/skin/cell_model.h"
#include "hexoderm/skin/neighbor_list.h"

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

/// Something with skin on it that exists only here, live: what its cells feel at every tick of a clock, and how it is
/// turned. A source or an emulated device makes of it what people and programs get, whether it is a part in a hand
/// (SimulatedSkin) or a robot (SimulatedRobot).
class SimulatedBody {
 public:
  virtual ~SimulatedBody() = default;

  [[nodiscard]] virtual const CellModel& model() const = 0;  ///< the kind of its cells
  /// Cells have the IDs 1, 2, ... in this order.
  [[nodiscard]] virtual const NeighborList& neighbors() const = 0;
  [[nodiscard]] virtual GroundTruth groundTruth() const = 0;  ///< where its cells really are
  [[nodiscard]] virtual Message description() const = 0;      ///< what it is, in words
  /// Readings a second and cell: the clock's ticks.
  [[nodiscard]] virtual double rate_hz() const = 0;

  /// It turns when it is asked to; else it turns by itself.
  [[nodiscard]] virtual bool turnsOnRequest() const = 0;
  /// Begins to turn until `up_u` (frame of the cell) points up. Throws InvalidArgument if there is no such cell, `up_u`
  /// is zero or not finite, or the body can't turn there.
  virtual void turnTo(CellId cell, const Eigen::Vector3d& up_u) = 0;
  /// The same for a direction of the body, of a robot that of its base.
  virtual void turnTo(const Eigen::Vector3d& up_b) = 0;
  /// Begins to turn to the pose that comes next where nobody asks for another.
  virtual void turnToNextPose() = 0;
  /// The last turn has not arrived yet.
  [[nodiscard]] virtual bool turning() const = 0;
  /// Where the joints stand as the next tick begins, as their encoders report it; empty without such joints.
  [[nodiscard]] virtual JointAngles jointAngles() const { return {}; }

  /// The next tick of the clock, 1 / rate after the one before.
  virtual SampleFrame next() = 0;
  /// As many ticks that nobody reads. No noise is drawn for them.
  virtual void skip(std::size_t ticks) = 0;

  /// Breaks a cell's sensor from the next tick on, or mends all that is broken about it. Throw InvalidArgument if there
  /// is no such cell.
  virtual void breakCell(const CellFault& fault) = 0;
  virtual void mendCell(CellId cell) = 0;  ///< the cell works as before its faults
  /// What was broken from the beginning.
  [[nodiscard]] virtual std::vector<CellFault> cellFaults() const = 0;
  [[nodiscard]] virtual std::vector<LinkFault> linkFaults() const = 0;  ///< the faults of links that it has now
  /// The same body as at its beginning, with these links broken and all sensors whole. Throws InvalidArgument for links
  /// that are not there or can't be broken so.
  [[nodiscard]] virtual std::unique_ptr<SimulatedBody> withLinkFaults(std::vector<LinkFault> faults) const = 0;

  /// Throws InvalidArgument if there is no such cell.
  void requireCell(CellId cell) const;

 protected:
  /// Of length 1. Throws InvalidArgument for what is no direction.
  static Eigen::Vector3d unitUp(const Eigen::Vector3d& up);
};

/// When a simulated body says where its joints stand: ten times a second, and at once when they have come to rest.
class JointReporting {
 public:
  /// To be asked before each tick. nullopt: there is nothing to say now.
  std::optional<JointReport> before(const SimulatedBody& body, double time_s);

 private:
  std::optional<double> due_s_;
  bool was_turning_ = false;
};

}  // namespace hexoderm
