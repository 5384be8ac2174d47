#pragma once

#include "hexoderm/base/se3.h"
#include "hexoderm/base/surface.h"
#include "hexoderm/base/units.h"
#include "hexoderm/sim/simulated_body.h"
#include "hexoderm/sim/skin_faults.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hexoderm {

/// The law by which the simulated mould places neighbours on the surface. It is a law of the simulator, independent of
/// any estimator's gap model.
enum class LinkLaw {
  Bend,     ///< rigid cells; only the gap bends, as an arc of constant length: next centre (2/k) atan(k e) along
  Surface,  ///< neighbouring centres one pitch (2 e) apart along the surface
};
std::string_view linkLawName(LinkLaw law);       ///< "bend", "surface"
LinkLaw linkLawFromName(std::string_view name);  ///< throws InvalidArgument for a name that is none

/// What a skin is like and what is wrong with it.
struct SkinChoice {
  std::string patch = "x17";  ///< x17 | ringN | ringN:closed | sheet:ROWSxCOLS
  std::string surface;        ///< plane | cylinder:r=M | sphere:r=M | cone:r=M,angle=RAD | torus:R=M,r=M
                              ///< empty: x17 on cylinder r=0.0501, rings on the cup that closes them, else a plane
  LinkLaw link_law = LinkLaw::Bend;
  std::uint64_t seed = 1;
  std::vector<CellFault> faults;
  std::vector<LinkFault> link_faults;
  std::vector<WholeSkinFault> whole_skin_faults;
};

/// A skin, its errors and how it is held.
struct SimulatedSkinOptions : SkinChoice {
  /// Where it is given, the surface itself instead of its description.
  std::shared_ptr<const Surface> laid_on{};
  /// What chips of one lot share is drawn from this; absent: from the seed.
  std::optional<std::uint64_t> lot_seed{};
  double position_jitter_m = 0.0002;  ///< 1 sigma, along the surface and normal to it
  double yaw_jitter_rad = 1 * kDegree;
  double tilt_jitter_rad = 0.5 * kDegree;
  bool sensor_errors = true;  ///< offset, scale and cross-axis drawn with the model's sigmas, as one lot
  bool sensor_noise = true;   ///< white noise and quantisation
  bool hand_held = true;      ///< orientation error, tremor and drift from the second pose on
  bool on_robot = false;      ///< a robot with its motors on instead of a hand, see robot()
  double hand_orientation_sigma_rad = 3 * kDegree;
  double tremor_angle_sigma_rad = 0.05 * kDegree;  ///< 4 to 12 Hz
  double tremor_acceleration_g = 0.010;            ///< translational, rms, 4 to 12 Hz
  double drift_rad_per_s = 0.5 * kDegree;
  double reading_rate_hz = 0;        ///< readings a second and cell; 0: the cell model's rate
  double least_vibration_g = 0.008;  ///< on a robot: rms of an axis, drawn per cell and axis from this ...
  double most_vibration_g = 0.035;   ///< ... to this
  std::size_t reglued_before = 2;    ///< recordings before the one that Reglued cells turn in front of
  /// Recordings of a first session, if offsets drift: by the cell model's sigmas from one recording to the next, and
  /// between this session and a second one. Absent: they stay what they are.
  std::optional<std::size_t> drifts_after{};
  double joint_angle_rad = 20 * kDegree;  ///< positive bends the part's front outwards, as around a cylinder

  /// Throws InvalidArgument naming the option.
  void validate() const;
  /// No jitter, no sensor errors, no noise, no hand.
  static SimulatedSkinOptions ideal();
  /// A robot with its motors on, like the leg of an iCub whose recording is public: 20 readings a second, each cell
  /// shaken by 8 to 35 mg rms an axis (noise with a correlation time of 40 ms), and a single joint about the body's x
  /// axis. Directions that the joint does not reach are replaced by the nearest one that it does (SimulatedSkin::up).
  static SimulatedSkinOptions robot();
};

/// The specific force on a moving body at one moment, in the body's axes: an accelerometer fixed at p_b reads up_b +
/// field_b (p_b - hand_b), g.
struct BodyMotion {
  Eigen::Vector3d up_b;     ///< specific force at the hand: gravity's and the tremor's
  Eigen::Matrix3d field_b;  ///< angular and centripetal acceleration per lever arm, g/m
};

/// A skin's body that something else holds and moves, a robot for example.
struct CarriedBody {
  std::function<BodyMotion(double time_s)> motion;  ///< since the hold began
  Eigen::Vector3d hand_b = Eigen::Vector3d::Zero();
};

/// A cell as it really is.
struct TrueCell {
  CellId id;
  SE3 T_b_u;  ///< from the cell frame to the body frame
  Eigen::Vector3d offset_g = Eigen::Vector3d::Zero();
  Eigen::Matrix3d gain = Eigen::Matrix3d::Identity();  ///< reading = gain * specific force + offset, but for faults
  Eigen::Matrix3d R_u_askew = Eigen::Matrix3d::Identity();  ///< turn by which its chip sits askew, in the cell frame
};

/// Gets the frames of a recording one after the other.
using FrameSink = std::function<void(const SampleFrame&)>;

/// A skin that exists only here: cells laid on a real surface, with the errors of real sensors and of a person's hands.
/// Everything it produces follows from its options and seed. It is simulation and says so.
///
/// The body frame b is the surface's own: a cylinder's or cone's axis is z; the patch's middle is at +x for closed
/// surfaces and the plane is z = 0 with the cells' fronts to +z. The bisector of the lines of x17 and of sheets, and
/// the line of a ring, run around the body (+y at the middle; +x on the plane). Cells have the IDs 1, 2, ...: x17's
/// middle first, then arm by arm from the middle outwards; sheets row by row. ringN is an open chain of N cells whose
/// ends face each other; ringN:closed lies alike, and its ends are joined. Flat cells need N >= 5 to fit on a cup.
///
/// Without jitter, eq. (2) holds exactly on a plane. With LinkLaw::Bend it also holds for rings, for sheets on
/// cylinders and for trees on spheres; X17's oblique links on a cylinder miss by the geodesic's torsion (0.23 mm at r
/// = 50.1 mm). With LinkLaw::Surface link points lie about (2/3) e a^2 apart (a: half the bend), as cells keep the
/// pitch instead.
class SimulatedSkin final : public SimulatedBody {
 public:
  /// Throws InvalidArgument if options or model make no skin (unknown patch, too small a surface, no opposite
  /// ports, a fault of what is not there).
  SimulatedSkin(CellModel model, SimulatedSkinOptions options);
  ~SimulatedSkin() override;
  SimulatedSkin(SimulatedSkin&&) noexcept;
  SimulatedSkin& operator=(SimulatedSkin&&) noexcept;

  /// The given model, but with interface_id raised if the skin has more cells than IDs below it.
  [[nodiscard]] const CellModel& model() const override;
  /// The given options, with the default surface's description filled in.
  [[nodiscard]] const SimulatedSkinOptions& options() const;
  [[nodiscard]] const NeighborList& neighbors() const override;
  [[nodiscard]] const std::vector<TrueCell>& truth() const;  ///< all cells as they really are
  /// The part of the truth that is about places.
  [[nodiscard]] GroundTruth groundTruth() const override;
  /// "Simulated x17 on cylinder:r=0.0501, link law bend, seed 1".
  [[nodiscard]] Message description() const override;
  /// The two free ports whose distance is the loop gap of an open ring (ringN); nullopt for other patches.
  [[nodiscard]] std::optional<std::pair<LinkEnd, LinkEnd>> loop() const;
  [[nodiscard]] double rate_hz() const override;
  /// The directions of a scripted calibration (scriptedUpDirections), or those that a robot goes to one after the
  /// other: up to 60 degrees to either side.
  [[nodiscard]] std::vector<Eigen::Vector3d> upDirections(std::size_t pose_count) const;

  /// Holds the part so that `up_b` (unit, body frame) points up, and records `frame_count` frames at the model's rate.
  /// A real hand misses by a few degrees and trembles; the first recording of a skin stands on a table and does not.
  /// Each call draws new hand motion from the seed and the number of calls made so far. Readings are in the cell frame.
  /// Throws InvalidArgument if `up_b` is zero or not finite.
  std::vector<SampleFrame> record(const Eigen::Vector3d& up_b, std::size_t frame_count = 100);

  /// The same for a large skin: each frame is given to `take` and then forgotten.
  void record(const Eigen::Vector3d& up_b, std::size_t frame_count, const FrameSink& take);

  /// The same of a body that something else holds and moves, without a hand or joint of the skin's own.
  std::vector<SampleFrame> record(const CarriedBody& body, std::size_t frame_count = 100);

  // Live. The part lies on a table with +z up, as cells with no motion of their own see it, until it is turned. A robot
  // turns it by itself to and fro, at 20 degrees a second at most, and holds it for 3 to 8 s in between.

  /// Not on a robot.
  [[nodiscard]] bool turnsOnRequest() const override;
  /// Begins to turn the part from where it is, and to hold it there as record() does.
  void turnTo(const Eigen::Vector3d& up_b) override;
  void turnTo(CellId cell, const Eigen::Vector3d& up_u) override;
  /// As upDirections() has them.
  void turnToNextPose() override;
  /// From the next tick on something else holds and moves the body, as in record(); nothing turns it by itself.
  void carry(const CarriedBody& body);
  [[nodiscard]] bool turning() const override;
  SampleFrame next() override;
  void skip(std::size_t ticks) override;

  void breakCell(const CellFault& fault) override;
  void mendCell(CellId cell) override;
  [[nodiscard]] std::vector<CellFault> cellFaults() const override;
  [[nodiscard]] std::vector<LinkFault> linkFaults() const override;
  [[nodiscard]] std::unique_ptr<SimulatedBody> withLinkFaults(std::vector<LinkFault> faults) const override;
  /// How far a Yawed or Reglued cell is turned, from the cell as it lies to the cell as it is said to lie; the identity
  /// for others. Throws InvalidArgument if there is no such cell.
  [[nodiscard]] Eigen::Matrix3d turnOf(CellId cell) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Directions (unit, body frame) of a scripted calibration with P poses for a part whose front is +x or +z: standing
/// first, then on its side, then the poses that add most (3: orthogonal; 4 and more: as the six faces of a cube, and
/// after that spread over the sphere).
std::vector<Eigen::Vector3d> scriptedUpDirections(std::size_t pose_count);

}  // namespace hexoderm
