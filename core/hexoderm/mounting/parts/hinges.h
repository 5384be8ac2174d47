#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/message.h"

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

namespace hexoderm {

/// Whether two parts are joined by one revolute joint, as far as gravity says.
enum class HingeKnowledge {
  Found,         ///< one axis explains all poses, and where it is is known
  NoAxis,        ///< no axis does: there is more between the parts than one revolute joint
  NotDetermined  ///< the poses leave open whether there is one, or where
};
std::string_view hingeKnowledgeName(HingeKnowledge knowledge);  ///< "found", "no_axis", "not_determined"

/// The axis as one of the two parts sees it.
struct HingeAxis {
  Eigen::Vector3d u = Eigen::Vector3d::UnitZ();          ///< unit, in the part's frame
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of u, rad^2; of rank 2, across u. About 1 rad: open
  double sigma_rad = 0;                                  ///< of u's direction, the worst way
};

/// How far the joint was turned in a pose.
struct HingeAngle {
  PoseId pose;
  /// Of part b against part a about u, relative to the reference pose, rad in (-pi, pi]; absent where gravity lay along
  /// the axis, which shows no turn about it.
  std::optional<double> angle_rad;
  double sigma_rad = 0;  ///< 0 in the reference pose and where there is no angle
};

/// A revolute joint between two parts a and b: u_a . g_a,p = u_b . g_b,p in every pose p, whatever its angle (the angle
/// between a joint's axis and gravity is the same from both sides). That are P equations for the four unknowns of two
/// unit vectors, so five poses are the least that can contradict it.
///
/// Where the joint is, nothing says: gravity is the same everywhere. P. Mittendorfer and G. Cheng, "Open-loop
/// self-calibration of articulated robots with artificial skins", ICRA 2012; T. Seel, J. Raisch and T. Schauer,
/// "IMU-based joint angle measurement for gait analysis", Sensors 14, 2014 (joint axes from what both sides measure).
struct Hinge {
  HingeKnowledge knowledge = HingeKnowledge::NotDetermined;
  HingeAxis a;
  HingeAxis b;
  Eigen::Matrix3d R_a_b = Eigen::Matrix3d::Identity();  ///< b into a in the reference pose; maps u_b onto u_a
  std::optional<PoseId> reference;                      ///< absent with fewer than five poses
  std::vector<HingeAngle> angles;                       ///< per pose that both parts have
  double chi_squared = 0;
  int freedom = 0;
  double probability = 1;   ///< of a misfit at least as large by chance
  Message why;              ///< one sentence on what is known and what isn't
  Message what_would_tell;  ///< empty where nothing is left open
};

}  // namespace hexoderm
