#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hexoderm {

/// A field of a table: empty, a text, a whole number or a number.
using CsvField = std::variant<std::monostate, std::string, std::uint64_t, double>;

/// A table: a header line whose names carry the units, then one row each of as many fields.
struct CsvTable {
  std::string file;  ///< "cells.csv"
  std::vector<std::string> header;
  std::vector<std::vector<CsvField>> rows;
};

/// cells.csv, sensors.csv, links.csv, poses.csv and residuals.csv (links x poses), in metres, degrees and g; and
/// covariances.csv, each cell's upper triangle (order and frames as in CellPlacement), in metres and radians. A field
/// is empty where its figure is not known. Rows with a place name the patch and the cell whose frame it is in.
std::vector<CsvTable> csvTables(const Reconstruction& reconstruction);

/// What the table with this name holds: lengths at all, and what is in a patch's frame.
struct CsvContents {
  bool lengths = true;
  bool in_frame = true;
};
CsvContents csvContents(std::string_view file);

/// RFC 4180 quoting, UTF-8, lines ended by a line feed, every number exact. InvalidArgument: a number is not finite.
std::string csvText(const CsvTable& table);

}  // namespace hexoderm
