#pragma once

// A simulated robot of two bodies with a hinge between them and patches of skin on both, in a hand or on a table, and
// its session. The patches are those of SimulatedSkin, with their sensors' errors.

#include "hexoderm/base/units.h"
#include "hexoderm/session/session.h"
#include "hexoderm/sim/hand_motion.h"
#include "tests/support/normal_draw.h"
#include "tests/support/random_vector.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/testing.h"

namespace hexoderm {

struct JointedSkinsOptions {
  /// The bodies of the patches, 0 or 1.
  std::vector<std::size_t> body_of_patch = {0, 0, 1, 1};
  std::string patch = "x17";
  std::uint64_t seed = 1;
  bool hand_held = true;
  double joint_range_rad = 130 * kDegree;  ///< of the joint's angle: an elbow's
  int sensor_frames = 100;
};

class JointedSkins {
 public:
  explicit JointedSkins(const JointedSkinsOptions& options) : options_(options), draw_(options.seed * 7919 + 17) {
    for (std::size_t k = 0; k < options.body_of_patch.size(); ++k) {
      const SimulatedSkinOptions skin = test::skinOptions(options.patch, "", options.seed * 1000 + k);
      const SE3 T_body_b{anyRotation(), anyPlace(0.1)};
      patches_.push_back({options.body_of_patch[k], T_body_b, SimulatedSkin(model_, skin)});
    }
    axis_0_ = draw_.direction();
    T_0_1_ = {anyRotation(), anyPlace(0.1)};
  }

  [[nodiscard]] Session session(std::size_t poses) {
    NeighborList neighbors;
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      for (CellReport report : patches_[k].skin.neighbors()) {
        report.id = idOf(k, report.id);
        for (NeighborReport& neighbor : report.neighbors) neighbor.cell = idOf(k, neighbor.cell);
        neighbors.push_back(report);
      }
    }
    Session session(model_, neighbors);
    const Eigen::Matrix3d turned = anyRotation();
    drawAngles(poses);
    for (const Eigen::Vector3d& up : scriptedUpDirections(poses)) {
      const PoseId id = session.nextPoseId();
      session.addPose({std::make_shared<const PoseCapture>(averageFrames(framesOfPose(turned * up), id, {}))});
    }
    return session;
  }

  [[nodiscard]] static CellId idOf(std::size_t patch, CellId cell) {
    return CellId(static_cast<std::uint32_t>(1000 * patch) + cell.value());
  }
  [[nodiscard]] std::size_t bodyOf(CellId cell) const { return patches_[cell.value() / 1000].body; }
  /// From the frame of a cell to that of its body.
  [[nodiscard]] SE3 T_body_u(CellId cell) const {
    const PatchOnBody& patch = patches_[cell.value() / 1000];
    return patch.T_body_b * test::truePlacement(patch.skin, CellId(cell.value() % 1000));
  }
  /// The middle of a patch's cells in the frame of its body.
  [[nodiscard]] Eigen::Vector3d middleOf(std::size_t patch) const {
    const std::vector<TrueCell>& cells = patches_[patch].skin.truth();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const TrueCell& cell : cells) sum += cell.T_b_u.t / static_cast<double>(cells.size());
    return patches_[patch].T_body_b * sum;
  }
  /// The hinge's axis in the frame of a body.
  [[nodiscard]] Eigen::Vector3d axisIn(std::size_t body) const {
    return body == 0 ? axis_0_ : Eigen::Vector3d(T_0_1_.R.transpose() * axis_0_);
  }
  /// The specific force at a point of body 0 (in its frame) in a pose, mean over the samples, g: up and about 1 long.
  [[nodiscard]] Eigen::Vector3d forceAt(std::size_t pose, const Eigen::Vector3d& x_0) const {
    const Mean& mean = means_[pose];
    return mean.up_0 + mean.field_0 * (x_0 - mean.hand_0);
  }

 private:
  struct PatchOnBody {
    std::size_t body = 0;
    SE3 T_body_b;
    SimulatedSkin skin;
  };

  struct Mean {
    Eigen::Vector3d up_0 = Eigen::Vector3d::Zero();
    Eigen::Matrix3d field_0 = Eigen::Matrix3d::Zero();
    Eigen::Vector3d hand_0 = Eigen::Vector3d::Zero();
  };

  Eigen::Vector3d anyPlace(double sigma_m) {
    return sigma_m * test::randomVector([&] { return draw_.normal(); });
  }
  Eigen::Matrix3d anyRotation() {
    const double w = draw_.normal();
    const double x = draw_.normal();
    const double y = draw_.normal();
    return Eigen::Quaterniond(w, x, y, draw_.normal()).normalized().toRotationMatrix();
  }

  /// The joint is moved from pose to pose, as the instructions have it: one angle from each part of its range, in any
  /// order.
  void drawAngles(std::size_t poses) {
    std::uniform_real_distribution<double> within(0, 1);
    for (std::size_t k = 0; k < poses; ++k) {
      const double share = (static_cast<double>(k) + within(draw_.generator())) / static_cast<double>(poses);
      angles_.push_back(options_.joint_range_rad * (share - 0.5));
    }
    for (std::size_t k = poses; k > 1; --k) {
      std::swap(angles_[k - 1], angles_[std::uniform_int_distribution<std::size_t>(0, k - 1)(draw_.generator())]);
    }
  }

  /// Of a pose in which `up` (unit, frame of body 0) is to be up.
  std::vector<SampleFrame> framesOfPose(const Eigen::Vector3d& up) {
    const SimulatedSkinOptions& hand = patches_.front().skin.options();
    const HandMotion motion = options_.hand_held ? HandMotion(up, hand, draw_.generator()) : HandMotion(up);
    const Eigen::Vector3d hand_0 = anyPlace(0.05);
    const SE3 T_0_1 = SE3{expSO3(angles_[means_.size()] * axis_0_), Eigen::Vector3d::Zero()} * T_0_1_;
    std::vector<SampleFrame> frames(static_cast<std::size_t>(options_.sensor_frames));
    const Accelerometer& accelerometer = model_.accelerometer;
    const double white_g = accelerometer.noise_g_per_sqrt_hz * std::sqrt(accelerometer.rate_hz / 2);
    Mean& mean = means_.emplace_back();
    mean.hand_0 = hand_0;
    for (std::size_t tick = 0; tick < frames.size(); ++tick) {
      frames[tick].time_s = static_cast<double>(tick) / accelerometer.rate_hz;
      const BodyMotion body = motion.at(frames[tick].time_s);
      mean.up_0 += body.up_b / static_cast<double>(frames.size());
      mean.field_0 += body.field_b / static_cast<double>(frames.size());
      for (std::size_t k = 0; k < patches_.size(); ++k) {
        const PatchOnBody& patch = patches_[k];
        const SE3 T_0_b = patch.body == 0 ? patch.T_body_b : T_0_1 * patch.T_body_b;
        for (const TrueCell& cell : patch.skin.truth()) {
          const SE3 T_b_chip{cell.T_b_u.R * cell.R_u_askew, cell.T_b_u.t};
          const SE3 T_0_a = T_0_b * T_b_chip * accelerometer.T_u_a;
          const Eigen::Vector3d force_0 = body.up_b + body.field_b * (T_0_a.t - hand_0);
          Eigen::Vector3d reading = cell.gain * (T_0_a.R.transpose() * force_0) + cell.offset_g;
          for (int axis = 0; axis < 3; ++axis) {
            const double noisy = reading[axis] + white_g * draw_.normal();
            reading[axis] = accelerometer.lsb_g * std::round(noisy / accelerometer.lsb_g);
          }
          frames[tick].samples.push_back({idOf(k, cell.id), reading});
        }
      }
    }
    return frames;
  }

  JointedSkinsOptions options_;
  test::NormalDraw draw_;
  CellModel model_ = builtInCellModel("hex-bma150");
  std::vector<PatchOnBody> patches_;
  Eigen::Vector3d axis_0_;
  SE3 T_0_1_;
  std::vector<double> angles_;
  std::vector<Mean> means_;
};

}  // namespace hexoderm
