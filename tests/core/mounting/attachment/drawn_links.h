#pragma once

// Patches on the links of an arm, which see gravity with errors that are known exactly.

#include "hexoderm/base/units.h"
#include "hexoderm/mounting/attachment/links.h"
#include "tests/core/mounting/parts/gravity_draw.h"
#include "tests/support/testing.h"

namespace hexoderm {

struct LinksTruth {
  struct OnLink {
    std::string link;
    Eigen::Matrix3d R_l_u;
  };
  std::map<CellId, OnLink> cells;
  JointAngles zeros;
  Eigen::Vector3d up_w = Eigen::Vector3d::UnitZ();
};

/// What findLinks() claims, beside the truth, counted over seeds.
struct LinksTally {
  int patches = 0;
  int wrong = 0;                  ///< candidates without the right link
  int none = 0;                   ///< no candidate
  std::vector<double> turn_nees;  ///< of the turns on the right links, each by 3
  std::vector<double> errors_rad;
  std::vector<double> stated_rad;
  std::vector<double> zero_nees;  ///< of the zeros that are shown
  std::vector<double> tilt_nees;  ///< by 2

  void add(const LinksResult& result, const LinksTruth& truth) {
    for (const PatchLinks& patch : result.patches) addPatch(patch, truth.cells.at(patch.origin));
    if (!result.robot) return;
    for (const JointZero& zero : result.robot->zeros) {
      const double error = zero.zero_rad - truth.zeros.positions.at(zero.joint);
      if (zero.shown) zero_nees.push_back(std::pow(error / zero.sigma_rad, 2));
    }
    tilt_nees.push_back(neesOfAxis(result.robot->up_w, result.robot->up_covariance, truth.up_w));
  }

 private:
  void addPatch(const PatchLinks& found, const LinksTruth::OnLink& truth) {
    ++patches;
    const PatchTurn* right = nullptr;
    for (const LinkCandidate& candidate : found.candidates) {
      for (const PatchTurn& turn : candidate.links) right = turn.link == truth.link ? &turn : right;
    }
    if (right == nullptr) {
      ++(found.candidates.empty() ? none : wrong);
      return;
    }
    const Eigen::Vector3d e = logSO3(right->R_l_o.transpose() * truth.R_l_u);
    turn_nees.push_back(e.dot(right->covariance.llt().solve(e)) / 3);
    errors_rad.push_back(e.norm());
    stated_rad.push_back(std::sqrt(right->covariance.trace()));
  }
};

/// Six joints that turn: the first upright, and each at right angles to the one before. On l4 and l6 there is more: a
/// link that is fixed, and one that slides.
inline std::string armUrdf() {
  std::string urdf = "<robot name=\"arm\">\n<link name=\"base\"/>\n";
  const auto add = [&urdf](const std::string& joint, const std::string& type, const std::string& parent,
                           const std::string& child, const std::string& rest) {
    urdf += "<joint name=\"" + joint + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" +
            child + "\"/>" + rest + "</joint>\n<link name=\"" + child + "\"/>\n";
  };
  const auto limits = [](const std::string& lower, const std::string& upper) {
    return "<limit lower=\"" + lower + "\" upper=\"" + upper + R"(" effort="1" velocity="1"/>)";
  };
  add("j1", "continuous", "base", "l1", R"(<origin xyz="0 0 0.3"/><axis xyz="0 0 1"/>)");
  add("j2", "revolute", "l1", "l2",
      R"(<origin xyz="0 0 0.1" rpy="0.3 0 0.4"/><axis xyz="0 1 0"/>)" + limits("-2", "2"));
  add("j3", "revolute", "l2", "l3", R"(<origin xyz="0.1 0 0.2"/><axis xyz="0 0 1"/>)" + limits("-2.5", "2.5"));
  add("j4", "revolute", "l3", "l4", R"(<origin xyz="0 0 0.2" rpy="0 0.2 0"/><axis xyz="1 0 0"/>)" + limits("-2", "2"));
  add("cover", "fixed", "l4", "l4_cover", R"(<origin xyz="0 0.05 0" rpy="0.5 0.6 0.7"/>)");
  add("j5", "revolute", "l4", "l5", R"(<origin xyz="0 0 0.2"/><axis xyz="0 0 1"/>)" + limits("-2.5", "2.5"));
  add("j6", "revolute", "l5", "l6", R"(<origin xyz="0 0 0.1"/><axis xyz="0 1 0"/>)" + limits("-2", "2"));
  add("slide", "prismatic", "l6", "finger", R"(<axis xyz="0 0 1"/>)" + limits("0", "0.1"));
  return urdf + "</robot>\n";
}

/// The covariance of a GravitySeen, as the solver's factor would give it.
class DrawnCovariance final : public GravityCovariance {
 public:
  explicit DrawnCovariance(GravitySeen seen) : seen_(std::move(seen)) {}
  [[nodiscard]] Eigen::Matrix3d forces(std::size_t a, std::size_t b) const override {
    const Eigen::Matrix2d C =
        seen_.covariance.block<2, 2>(static_cast<Eigen::Index>(2 * a), static_cast<Eigen::Index>(2 * b));
    return acrossBasis(seen_.up[a]) * C * acrossBasis(seen_.up[b]).transpose();
  }
  [[nodiscard]] std::optional<Eigen::Matrix3d> swing(std::size_t /*pose*/) const override { return std::nullopt; }

 private:
  GravitySeen seen_;
};

/// A patch of one cell that saw this.
inline PatchReconstruction patchThatSaw(const GravitySeen& seen, std::uint32_t number) {
  PatchReconstruction patch;
  patch.id = PatchId(number);
  patch.origin = CellId(100 + number);
  for (std::size_t k = 0; k < seen.size(); ++k) patch.gravity.push_back({seen.poses[k], seen.up[k], 0.01, {}});
  CellPlacement cell;
  cell.cell = patch.origin;
  patch.cells.push_back(std::move(cell));
  patch.gravity_covariance = std::make_shared<DrawnCovariance>(seen);
  return patch;
}

struct DrawnArmOptions {
  std::vector<std::string> links = {"l3", "l6"};  ///< of the patches
  std::size_t poses = 6;
  std::uint64_t seed = 1;
  double error_scale = 1;  ///< of the errors that are drawn; what is stated stays
  double zero_sigma_rad = 0.5 * kDegree;
  double tilt_sigma_rad = 1 * kDegree;
  double range_rad = 1.5;  ///< joints are drawn within +- this
};

/// What the patches see is drawn without a lever.
inline LinksOptions withoutLever() {
  LinksOptions options;
  options.test_lever_m = 0;
  return options;
}

struct DrawnArm {
  RobotModel robot;
  std::vector<std::string> links;        ///< of the patches
  std::map<PoseId, JointAngles> angles;  ///< as reported
  JointAngles zeros;
  Eigen::Vector3d up_w = Eigen::Vector3d::UnitZ();
  std::vector<Eigen::Matrix3d> R_l_o;  ///< of the patches
  std::vector<GravitySeen> seen;       ///< by the patches
  Reconstruction reconstruction;

  explicit DrawnArm(const DrawnArmOptions& options)
      : robot(RobotModel::parse(armUrdf(), "arm.urdf")), links(options.links) {
    GravityDraw draw(options.seed);
    for (const std::string& joint : robot.freeJointNames()) {
      zeros.positions[joint] = joint == "slide" ? 0 : options.zero_sigma_rad * draw.normal();
    }
    up_w = expSO3({options.tilt_sigma_rad * draw.normal(), options.tilt_sigma_rad * draw.normal(), 0}) * up_w;
    std::vector<std::vector<SE3>> T_w_l;
    for (std::uint32_t pose = 1; pose <= options.poses; ++pose) {
      JointAngles true_angles;
      for (const std::string& joint : robot.freeJointNames()) {
        const double angle = joint == "slide" ? 0.05 : options.range_rad * std::tanh(draw.normal());
        angles[PoseId(pose)].positions[joint] = angle;
        true_angles.positions[joint] = angle + zeros.positions.at(joint);
      }
      T_w_l.push_back(robot.forward(true_angles));
    }
    for (std::size_t k = 0; k < options.links.size(); ++k) {
      R_l_o.push_back(draw.rotation());
      std::vector<Eigen::Vector3d> up;
      for (const std::vector<SE3>& of_pose : T_w_l) {
        const SE3& T_w_link = of_pose[robot.linkNamed(options.links[k])];
        up.emplace_back((T_w_link.R * R_l_o.back()).transpose() * up_w);
      }
      seen.push_back(draw.see(up, {}, options.error_scale));
      reconstruction.patches.push_back(patchThatSaw(seen.back(), static_cast<std::uint32_t>(k)));
    }
  }

  [[nodiscard]] LinksResult find(const LinksOptions& options = withoutLever()) const {
    return findLinks(reconstruction, robot, angles, options);
  }
  [[nodiscard]] LinksTruth truth() const {
    LinksTruth result{{}, zeros, up_w};
    for (std::size_t k = 0; k < links.size(); ++k) {
      result.cells[reconstruction.patches[k].origin] = {links[k], R_l_o[k]};
    }
    return result;
  }
};

}  // namespace hexoderm
