#pragma once

#include "hexoderm/base/json_reader.h"
#include "hexoderm/base/json_writer.h"
#include "hexoderm/skin/cell_model.h"

namespace hexoderm {

// Cell models inside other JSON documents. A placement is t_u_m and q_u_wxyz; R_u, nine numbers row by row, may be
// given beside the quaternion and goes before it. Only for use in .cpp files: it carries nlohmann's header.

/// Throws FormatError with the key path.
CellModel readCellModel(const JsonReader& json);
void writeCellModel(const CellModel& model, JsonWriter& json);

}  // namespace hexoderm
