#pragma once

// Parts of a session inside JSON documents: session files and the session store. Only for use in .cpp files: it carries
// nlohmann's header.

#include "hexoderm/session/session.h"
#include "hexoderm/util/json_reader.h"
#include "hexoderm/util/json_scanner.h"
#include "hexoderm/util/json_writer.h"

#include <functional>
#include <string>
#include <vector>

namespace hexoderm {

/// An array of cells as reported. Reading throws FormatError with the key path.
NeighborList readNeighbors(const JsonReader& json);
NeighborList scanNeighbors(JsonScanner& json);
void writeNeighbors(const NeighborList& neighbors, JsonWriter& json);

/// `source`, `source_port`, `target`, `target_port` as in calibration files, and `why` where there is a reason.
MutedLink readMutedLink(const JsonReader& json);
nlohmann::ordered_json mutedLinkJson(const MutedLink& link);

/// `[{"joint", "position"}]`, rad or m. Reading throws FormatError for a joint that is given twice.
JointAngles readJointAngles(const JsonReader& json);
nlohmann::ordered_json jointAnglesJson(const JointAngles& angles);

/// `urdf`, `sha256` and `packages`; an object without `urdf` is no robot.
std::optional<RobotDescription> readRobot(const JsonReader& json);
nlohmann::ordered_json robotJson(const std::optional<RobotDescription>& robot);

/// `R`, `t_m` and, where it is known, `cov_t_r` of a placement; origin and link stand around them.
void readPlace(const JsonReader& json, PatchOnLink& place);
void writePlace(const PatchOnLink& place, nlohmann::ordered_json& json);

/// What was decided about a patch. Reading throws FormatError for what PatchPlacement::validate() refuses.
PatchPlacement readPlacement(const JsonReader& json);
nlohmann::ordered_json placementJson(const PatchPlacement& placement);
/// An array of them, each patch once.
std::vector<PatchPlacement> readPlacements(const JsonReader& json);
nlohmann::ordered_json placementsJson(const std::vector<PatchPlacement>& placements);

/// A pose but for its samples, which `take_samples` returns; `id_key`: of its number.
SessionPose readPose(const JsonReader& json, const std::string& id_key,
                     const std::function<std::vector<GravitySample>()>& take_samples);

GroundTruth readTruth(const JsonReader& json);
GroundTruth scanTruth(JsonScanner& json);
void writeTruth(const GroundTruth& truth, JsonWriter& json);

}  // namespace hexoderm
