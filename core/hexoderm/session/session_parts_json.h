#pragma once

// Parts of a session inside JSON documents: session files and the session store. Only for use in .cpp files: it carries
// nlohmann's header.

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/json_fields.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/base/message_json.h"
#include "hexoderm/session/session.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace hexoderm {

/// The upper triangle of a covariance. Variances are at least 0, and numbers at most `most`.
struct AsCovariance {
  double most;
  explicit AsCovariance(double magnitude = kNoLimit) : most(magnitude) {}
  template <class Matrix>
  void take(const JsonReader& in, Matrix& matrix) const {
    constexpr int kSize = Matrix::RowsAtCompileTime;
    matrix = fromUpperTriangle<kSize>(in.numbers<std::size_t{kSize * (kSize + 1) / 2}>(most));
    if ((matrix.diagonal().array() < 0).any()) {
      in.fail(kSize == 3 ? message("variances (xx, yy, zz) of at least 0")
                         : message("an upper triangle with variances of at least 0 on its diagonal"));
    }
    if (!isCovariance(matrix)) in.fail(message("a covariance (positive semidefinite)"));
  }
  template <class Matrix>
  void put(JsonWriter& out, const Matrix& matrix) const {
    out.value(upperTriangle(matrix));
  }
};

/// `R`, `t_m` and, where it is known, `cov_t_r` of a placement, behind the fields that stand `before`.
template <class Json, class Place, class... Before>
void placeFields(Json& json, Place& place, Before... before) {
  json.object(before..., requiredField("R", place.T_l_o.R, kRotation),
              requiredField("t_m", place.T_l_o.t, vectorWithin(kMaxLength_m)),
              optionalField("cov_t_r", place.cov_t_r, AsCovariance()));
}

/// An array of cells as reported. Reading throws FormatError with the key path.
NeighborList readNeighbors(const JsonReader& json);
void writeNeighbors(const NeighborList& neighbors, JsonWriter& json);

/// `source`, `source_port`, `target`, `target_port` as in calibration files, and `why` where there is a reason.
MutedLink readMutedLink(const JsonReader& json);
void writeMutedLink(const MutedLink& link, JsonWriter& json);

/// Positions of joints as `[{"joint", "position"}]`, rad or m. Reading throws FormatError for a joint that is given
/// twice.
struct AsJointAngles {
  using Positions = decltype(JointAngles::positions);
  void take(const JsonReader& in, Positions& positions) const;
  void put(JsonWriter& out, const Positions& positions) const;
};

/// "convex" and "concave", as in files; "" for SkinSide::Unknown. Nothing for a name that is none.
std::string_view skinSideName(SkinSide side);
std::optional<SkinSide> skinSideFromName(std::string_view name);
/// The member `surface` of an object; without it nothing is known.
SkinSide readSkinSide(const JsonReader& json);
void writeSkinSide(SkinSide side, JsonWriter& json);

/// `urdf`, `sha256` and `packages`; an object without `urdf` is no robot.
std::optional<RobotDescription> readRobot(const JsonReader& json);
void writeRobot(const std::optional<RobotDescription>& robot, JsonWriter& json);

/// What was decided about a patch. Reading throws FormatError for what PatchPlacement::validate() refuses.
PatchPlacement readPlacement(const JsonReader& json);
void writePlacement(const PatchPlacement& placement, JsonWriter& json);
/// An array of them, each patch once.
std::vector<PatchPlacement> readPlacements(const JsonReader& json);
/// Throws FormatError for the `origin_cell` of an item that is among those before.
void requireOriginOnce(const JsonReader& item, CellId origin, std::set<CellId>& origins);
/// `robot` and `placements`, each where there is one, as members of an object.
void writeRobotMembers(const std::optional<RobotDescription>& robot, const std::vector<PatchPlacement>& placements,
                       JsonWriter& json);

/// A pose and its capture, in front of the fields that stand `behind`; `id_key`: of its number.
template <class Json, class Capture, class Pose, class... Behind>
void poseFields(Json& json, const std::string& id_key, Capture& capture, Pose& pose, Behind... behind) {
  // One below the largest number, so that there is always an ID for the next pose.
  json.object(requiredField(id_key, capture.id, wholeFrom(0, UINT32_MAX - 1)), optionalMessage("label", capture.label),
              optionalField("taken_at_ms", capture.taken_at_ms), optionalField("disabled", pose.disabled),
              optionalField("why_disabled", pose.why_disabled),
              optionalField("joint_angles", pose.joint_angles.positions, AsJointAngles()), behind...);
}
/// A pose but for its samples, which `take_samples` returns.
SessionPose readPose(const JsonReader& json, const std::string& id_key,
                     const std::function<std::vector<GravitySample>()>& take_samples);

GroundTruth readTruth(const JsonReader& json);
void writeTruth(const GroundTruth& truth, JsonWriter& json);

}  // namespace hexoderm
