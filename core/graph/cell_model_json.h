#pragma once

#include "hexoderm/graph/cell_model.h"
#include "hexoderm/util/json_reader.h"

namespace hexoderm {

// Cell models inside other JSON documents. Only for use in .cpp files: it carries nlohmann's header.

/// Throws FormatError with the key path.
CellModel readCellModel(const JsonReader& json);
nlohmann::ordered_json cellModelJson(const CellModel& model);

}  // namespace hexoderm
