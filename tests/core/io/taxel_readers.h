#pragma once

// Readers of taxel files as their users have them, written from the formats alone.

#include "tests/support/testing.h"

#include <sstream>

namespace hexoderm::test {

struct IcubTaxels {
  std::string name;
  std::string sampling;
  std::vector<int> representatives;
  struct Row {
    Eigen::Vector3d position;
    Eigen::Vector3d normal;
    [[nodiscard]] bool isTaxel() const { return !position.isZero(0) || !normal.isZero(0); }
  };
  std::vector<Row> rows;
};

/// nullopt: a part that a reader needs is missing. `drop_last`: as the reader that loses the last line.
inline std::optional<IcubTaxels> readIcubTaxels(const std::string& text, bool drop_last = false) {
  IcubTaxels taxels;
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  if (drop_last && !lines.empty()) lines.pop_back();
  bool calibration = false;
  bool has_representatives = false;
  for (const std::string& line : lines) {
    std::istringstream words(line);
    if (calibration) {
      IcubTaxels::Row row;
      if (words >> row.position.x() >> row.position.y() >> row.position.z() >> row.normal.x() >> row.normal.y() >>
          row.normal.z()) {
        taxels.rows.push_back(row);
      }
      continue;
    }
    std::string key;
    words >> key;
    if (key == "name") words >> taxels.name;
    if (key == "spatial_sampling") words >> taxels.sampling;
    if (key == "[calibration]") calibration = true;
    if (key != "taxel2Repr") continue;
    has_representatives = true;
    std::string open;
    words >> open;
    for (int number = 0; words >> number;) taxels.representatives.push_back(number);
  }
  if (!has_representatives || !calibration || taxels.name.empty() || taxels.sampling != "taxel") return std::nullopt;
  return taxels;
}

struct SkinwareCell {
  std::array<std::int64_t, 10> numbers{};  ///< type, uid, px, py, pz, ox, oy, oz, radius, link
};

/// nullopt: not as many lines of ten integers as the first line says.
inline std::optional<std::vector<SkinwareCell>> readSkinware(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  if (!std::getline(in, line)) return std::nullopt;
  std::vector<SkinwareCell> cells(std::stoul(line));
  for (SkinwareCell& cell : cells) {
    if (!std::getline(in, line)) return std::nullopt;
    std::istringstream words(line);
    for (std::int64_t& number : cell.numbers) {
      if (!(words >> number)) return std::nullopt;
    }
    std::string more;
    if (words >> more) return std::nullopt;
  }
  if (std::getline(in, line)) return std::nullopt;
  return cells;
}

}  // namespace hexoderm::test
