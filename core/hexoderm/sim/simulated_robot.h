#pragma once

#include "hexoderm/base/joint_angles.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/sim/simulated_skin.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace hexoderm {

/// A patch on a link of a simulated robot.
struct PatchMount {
  std::string link;
  /// Where the patch's middle lies in the link's frame: z out of the skin, x where SimulatedSkin says "around the
  /// body". A patch on the link's body lies at the body's nearest point, with z along its normal and x as near to this
  /// x as possible.
  SE3 T_l_m;
  std::string patch = "x17";  ///< as in SimulatedSkinOptions
  /// As in SimulatedSkinOptions; empty: the link's body where the robot describes one, so that the backs of the cells
  /// lie on it; else what suits the patch.
  std::string surface{};
};

/// What holds the base of a simulated robot.
enum class BaseHold {
  Fixed,  ///< bolted down, with gravity along +z but for a tilt
  Hand,   ///< a person, who turns the whole robot anew in every pose, and trembles
};

/// A robot, its patches, and what holds it.
struct SimulatedRobotOptions {
  std::vector<PatchMount> mounts{};
  std::uint64_t seed = 1;
  BaseHold base = BaseHold::Fixed;
  double zero_offset_sigma_rad = 0.5 * kDegree;  ///< of the joints' encoders
  double base_tilt_sigma_rad = 1 * kDegree;      ///< of a fixed base about x and about y
  double range_share = 0.9;                      ///< middle part of each joint's range in which poses are drawn
  /// Errors of the cells and the hand, motors (`on_robot`), and faults, by the robot's numbers of its cells. What
  /// mounts and seed say replaces patch, surface, and seed.
  SimulatedSkinOptions skin{};

  /// Throws InvalidArgument naming the option.
  void validate() const;
  /// Nothing is drawn but the poses: no tilt, no zero offsets, ideal skins on a fixed base.
  static SimulatedRobotOptions ideal();
};

/// A patch as it is on the robot.
struct MountedPatch {
  std::string link;
  /// Links that are fixed to each other are one part: the first of them, seen from the root.
  std::string part;
  std::vector<CellId> cells;  ///< in the skin's order; the middle cell of an x17 is the first
  std::vector<SE3> T_l_u;     ///< true placement of each in the link's frame
};

/// The robot as it stands in one pose.
struct SimulatedRobotPose {
  JointAngles reported;     ///< of all free joints: what encoders say
  JointAngles true_angles;  ///< reported + zero offsets
  Eigen::Vector3d up_w;     ///< unit; in a hand, where the hold begins
  std::vector<SE3> T_w_l;   ///< by the true angles, of every link of the robot
};

/// A robot that exists only here, with skins on its links. Joints stand in angles drawn at random, and while a pose is
/// held the whole robot is one rigid body. Everything follows from options and seed. It is simulation and says so.
///
/// Cells have the IDs 1, 2, ..., mount by mount.
class SimulatedRobot final : public SimulatedBody {
 public:
  /// Throws InvalidArgument for options that make no robot (unknown link, no mounts, a fault of what is not there), and
  /// what SimulatedSkin and RobotModel::bodyOf() throw.
  SimulatedRobot(CellModel model, RobotModel robot, SimulatedRobotOptions options);
  ~SimulatedRobot() override;
  SimulatedRobot(SimulatedRobot&&) noexcept;
  SimulatedRobot& operator=(SimulatedRobot&&) noexcept;

  [[nodiscard]] const CellModel& model() const override;
  [[nodiscard]] const RobotModel& robot() const;                   ///< the robot that wears the skin
  [[nodiscard]] const SimulatedRobotOptions& options() const;      ///< the options it was made with
  [[nodiscard]] const NeighborList& neighbors() const override;    ///< body parts are not told
  [[nodiscard]] const std::vector<MountedPatch>& patches() const;  ///< the patches, each with its place on a link
  /// True angle minus reported one of every free joint, rad; 0 for those that slide.
  [[nodiscard]] const JointAngles& zeroOffsets() const;
  /// The placement of every cell in the frame of the link that it is on.
  [[nodiscard]] GroundTruth groundTruth() const override;
  /// "Simulated robot demo_arm on a fixed base: x17 on upper_arm and x17 on forearm, seed 1".
  [[nodiscard]] Message description() const override;
  [[nodiscard]] double rate_hz() const override;

  /// The next pose: angles in the joints' ranges, and in a hand an orientation of the base. The first pose of a robot
  /// in a hand stands upright.
  SimulatedRobotPose nextPose();
  /// Readings of all cells while the pose that was drawn last is held. Throws InvalidArgument if none was.
  std::vector<SampleFrame> record(std::size_t frame_count = 100);

  // Live. The robot stands in a pose as nextPose() draws them until it is turned; then its joints move, at 60 degrees
  // or 0.1 m a second at most, and in a hand the whole of it is turned meanwhile.

  [[nodiscard]] bool turnsOnRequest() const override { return true; }
  /// In a hand all joints go to angles drawn at random, and the hand does the rest. On a fixed base they go to those,
  /// of many drawn at random, that come nearest to what is asked for; it is refused if none come within 90 degrees.
  void turnTo(CellId cell, const Eigen::Vector3d& up_u) override;
  /// In a hand alone; the joints stay as they are.
  void turnTo(const Eigen::Vector3d& up_w) override;
  /// As nextPose() draws it.
  void turnToNextPose() override;
  [[nodiscard]] bool turning() const override;
  [[nodiscard]] JointAngles jointAngles() const override;
  SampleFrame next() override;
  void skip(std::size_t ticks) override;

  void breakCell(const CellFault& fault) override;
  void mendCell(CellId cell) override;
  [[nodiscard]] std::vector<CellFault> cellFaults() const override;
  [[nodiscard]] std::vector<LinkFault> linkFaults() const override;
  [[nodiscard]] std::unique_ptr<SimulatedBody> withLinkFaults(std::vector<LinkFault> faults) const override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The mounts of the demo: an x17 on the upper arm and one on the forearm of demo_arm.urdf.
std::vector<PatchMount> demoMounts();

}  // namespace hexoderm
