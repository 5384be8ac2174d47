#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/joint_angles.h"
#include "hexoderm/robots/robot_model.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// One line: the joints in one pose, or at one time. Exactly one of the two keys is there.
struct JointAnglesRow {
  std::optional<PoseId> pose;
  std::optional<double> time_s;  ///< seconds since 1970, UTC
  JointAngles angles;
};
/// Joint angles of a robot for the poses of a session (resources/formats/README.md has the file). Rows in the order of
/// the file; poses differ, times ascend.
struct JointAnglesTable {
  std::vector<JointAnglesRow> rows;
  /// The angles in a pose. Of a table by time those of the row nearest to `taken_at_ms` (milliseconds since 1970,
  /// UTC), if it is at most `within_s` away. nullopt if there are none.
  [[nodiscard]] std::optional<JointAngles> of(PoseId pose, std::optional<std::int64_t> taken_at_ms,
                                              double within_s = 1) const;
};

/// How a table of joint angles is read.
struct JointAnglesCsvOptions {
  /// Free joints of the robot that have no column stand at 0; otherwise that is an error, which names them.
  bool missing_are_zero = false;
};

/// Reads a table for a robot. Throws FormatError naming file, line and column, and what was expected: no key column, a
/// unit that is not said, a column that is no joint of the robot, joints without a column, what is no number, a pose
/// twice, times that go back.
JointAnglesTable readJointAnglesCsv(const std::filesystem::path& path, const RobotModel& robot,
                                    JointAnglesCsvOptions options = {});
/// The same of a text; `file` is named in errors.
JointAnglesTable parseJointAnglesCsv(std::string_view text, const std::string& file, const RobotModel& robot,
                                     JointAnglesCsvOptions options = {});

/// The same as a file's text, which reads back exactly: columns in rad and m, those joints that any row names. Throws
/// InvalidArgument for rows of both keys, or that do not name the same joints.
std::string jointAnglesCsv(const JointAnglesTable& table, const RobotModel& robot);

}  // namespace hexoderm
