#pragma once

// What SimulatedSkinOptions::faults and link_faults do to a skin.

#include "hexoderm/base/enum_names.h"
#include "hexoderm/device/sample_frame.h"
#include "hexoderm/sim/patch_plan.h"
#include "hexoderm/sim/simulated_skin.h"

#include <bitset>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace hexoderm {

/// The defects of one cell's sensor.
struct CellHealth {
  std::bitset<enumeratorCount<SkinFault>()> faults;  ///< by SkinFault
  int stuck_axis = -1;
  int dead_axis = -1;
  /// From the cell as it lies now to the cell as it is said to lie; of a reglued one, see reglued_before.
  std::optional<Eigen::Matrix3d> turn;
  std::optional<Eigen::Vector3d> first_reading_g;  ///< set for a stuck cell

  [[nodiscard]] bool has(SkinFault fault) const { return faults[static_cast<std::size_t>(fault)]; }
  /// See WrongDelivery.
  [[nodiscard]] bool sendsAnothers() const { return has(SkinFault::Echo) || has(SkinFault::Swapped); }
  /// Applies the defects to a reading before its noise is added.
  [[nodiscard]] Eigen::Vector3d sensed(const Eigen::Vector3d& reading_g) const;
  [[nodiscard]] double noiseFactor() const;
  /// Applies the defects to a reading with noise, quantised.
  Eigen::Vector3d sent(Eigen::Vector3d reading_g);
};

/// `random` draws the axis, where a fault is of one axis.
void addFault(CellHealth& cell, SkinFault kind, std::mt19937_64& random);
/// Throws InvalidArgument for a fault of a cell that is not there.
std::vector<CellHealth> breakCells(const SimulatedSkinOptions& options, std::size_t cell_count);

/// Cells that send what others should, and skins of which all sensors are wrong alike: SkinFault::Echo and Swapped, and
/// the WholeSkinFaults of readings.
class WrongDelivery {
 public:
  WrongDelivery(const SimulatedSkinOptions& options, const NeighborList& neighbors);
  /// `frame`: a tick of the given recording, with the cells' readings as they should be delivered.
  void apply(const std::vector<CellHealth>& cells, std::size_t recording, SampleFrame& frame) const;

 private:
  void exchange(const std::vector<CellHealth>& cells, std::vector<CellSample>& samples) const;

  std::vector<WholeSkinFault> whole_;
  std::vector<std::optional<CellId>> first_neighbor_;  ///< per cell
  std::uint64_t seed_;
};

/// The faults of a patch's links.
class LinkFaults {
 public:
  /// Throws InvalidArgument with the reason for a link that is not there, that is broken twice alike, or that can't be
  /// broken in this way.
  LinkFaults(const PatchPlan& plan, const CellModel& model, const SimulatedSkinOptions& options);

  /// The patch's links with the ports that the cells report. They are as large as a skin, and asked for once.
  [[nodiscard]] std::vector<PlannedLink> takeReportedLinks() { return std::move(reported_); }

  /// Takes the cells behind every cable to where the cable lets them lie.
  void pullCables(std::vector<TrueCell>& cells) const;

  /// The motion of every cell (body frame) that bends all joints; empty without joints.
  [[nodiscard]] std::vector<SE3> bendingOf(const std::vector<TrueCell>& cells) const;

 private:
  /// A link whose far side moves as one piece.
  struct Cut {
    PlannedLink link;                   ///< from the near side to the far one
    std::vector<std::size_t> far_side;  ///< cells
  };

  void renumberPorts(const CellModel& model, bool around);
  void reportWrongPort(const LinkEnd& at, std::size_t link, const CellModel& model, std::uint64_t seed);
  static Cut cutAt(const PatchPlan& plan, const std::vector<PlannedLink>& links, std::size_t link);
  static std::vector<SE3> composed(const std::vector<Cut>& cuts, const std::vector<SE3>& motions, std::size_t cells);

  std::vector<PlannedLink> reported_;
  std::vector<Cut> joints_;
  std::vector<Cut> cables_;
  double joint_angle_rad_;
  std::uint64_t seed_;
};

}  // namespace hexoderm
