#pragma once

// Parts of a session inside JSON documents: session files and the session store. Only for use in .cpp files: it carries
// nlohmann's header.

#include "hexoderm/session/session.h"
#include "hexoderm/util/json_reader.h"

namespace hexoderm {

/// An array of cells as reported. Reading throws FormatError with the key path.
NeighborList readNeighbors(const JsonReader& json);
nlohmann::ordered_json neighborsJson(const NeighborList& neighbors);

/// `source`, `source_port`, `target`, `target_port` as in calibration files, and `why` where there is a reason.
MutedLink readMutedLink(const JsonReader& json);
nlohmann::ordered_json mutedLinkJson(const MutedLink& link);

/// `[{"joint", "position"}]`, rad or m. Reading throws FormatError for a joint that is given twice.
JointAngles readJointAngles(const JsonReader& json);
nlohmann::ordered_json jointAnglesJson(const JointAngles& angles);

GroundTruth readTruth(const JsonReader& json);
nlohmann::ordered_json truthJson(const GroundTruth& truth);

}  // namespace hexoderm
