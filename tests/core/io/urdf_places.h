#pragma once

#include "hexoderm/base/se3.h"

#include <urdf_parser/urdf_parser.h>

#include <gtest/gtest.h>

#include <string>

namespace hexoderm::test {

inline SE3 fromUrdf(const urdf::Pose& pose) {
  const Eigen::Quaterniond q(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
  return {q.toRotationMatrix(), {pose.position.x, pose.position.y, pose.position.z}};
}

/// Where a link is in another, on which it hangs by fixed joints.
inline SE3 placeIn(const urdf::ModelInterface& model, const std::string& link, const std::string& root) {
  SE3 T;
  auto at = model.getLink(link);
  while (at && at->name != root) {
    EXPECT_EQ(at->parent_joint->type, urdf::Joint::FIXED) << at->name;
    T = fromUrdf(at->parent_joint->parent_to_joint_origin_transform) * T;
    at = at->getParent();
  }
  EXPECT_TRUE(at) << link << " does not hang on " << root;
  return T;
}

}  // namespace hexoderm::test
