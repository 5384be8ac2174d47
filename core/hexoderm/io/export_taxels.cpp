#include "hexoderm/io/export_taxels.h"

#include "hexoderm/io/export_support.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hexoderm {
namespace {

constexpr std::size_t kTaxelsPerTriangle = 12;
constexpr int kIcubDecimals = 9;
constexpr double kNanometres = 1e9;

/// The rows of the file: those of the cells, filled up to whole triangles, with one to spare.
std::size_t icubRows(const TaxelMap& map) { return (map.taxels.size() / kTaxelsPerTriangle + 1) * kTaxelsPerTriangle; }

std::string icubNumbers(const Eigen::Vector3d& v) {
  std::string text;
  for (const double value : v) {
    std::string number = formatFixed(value, kIcubDecimals);
    if (number.find_first_not_of("-0.") == std::string::npos) number = formatFixed(0, kIcubDecimals);  // no "-0"
    text += (text.empty() ? "" : "\t") + number;
  }
  return text;
}

std::int64_t nanometres(double value) { return std::llround(value * kNanometres); }

std::vector<std::int64_t> skinwareNumbers(const Taxel& taxel, const TaxelMap& map) {
  std::vector<std::int64_t> numbers = {0, taxel.cell.value()};
  for (const Eigen::Vector3d& v : {taxel.position, taxel.normal}) {
    for (const double value : v) numbers.push_back(nanometres(value));
  }
  numbers.push_back(nanometres(map.radius_m));
  numbers.push_back(static_cast<std::int64_t>(taxel.link));
  return numbers;
}

}  // namespace

TaxelMap taxelMap(const CellModel& model, const std::vector<ExportMount>& mounted, const ExportOptions& options) {
  TaxelMap map;
  map.radius_m = std::sqrt(0.75) * model.side_m;
  for (const ExportMount& mount : mounted) {
    auto link = std::ranges::find(map.links, mount.link);
    if (link == map.links.end()) link = map.links.insert(link, mount.link);
    const auto index = static_cast<std::size_t>(link - map.links.begin());
    for (const CellPlacement& cell : mount.patch->cells) {
      const SE3 T_l_u = rigid(mount.T_l_o) * rigid(cell.T_o_u);
      map.taxels.push_back({cell.cell, T_l_u.t, T_l_u.R.col(2), index});
    }
  }
  if (map.links.empty()) map.links.push_back(options.parent_link);
  std::ranges::sort(map.taxels, {}, &Taxel::cell);
  return map;
}

std::string icubText(const TaxelMap& map) {
  const std::size_t rows = icubRows(map);
  std::string text = "name    " + map.links.front() + "\nspatial_sampling     taxel\ntaxel2Repr ( ";
  for (std::size_t row = 0; row < rows; ++row)
    text += row < map.taxels.size() ? " " + std::to_string(row) + " " : " -1 ";
  text += " )\n[calibration]\n";
  const Taxel none;
  for (std::size_t row = 0; row < rows; ++row) {
    const Taxel& taxel = row < map.taxels.size() ? map.taxels[row] : none;
    text += icubNumbers(taxel.position) + "\t" + icubNumbers(taxel.normal) + "\n";
  }
  return text + "\n";
}

void verifyIcub(std::string_view bytes, const TaxelMap& map, const std::string& file) {
  const std::vector<std::string> lines = split(bytes, '\n');
  constexpr std::size_t kHeaderLines = 4;
  const std::size_t rows = icubRows(map);
  // The text behind the last line break is empty, and so is the line before it.
  requireMeant(lines.size() == kHeaderLines + rows + 2 && lines[lines.size() - 2].empty(), file,
               "expected " + std::to_string(rows) + " rows and an empty line");
  std::istringstream representatives(lines[2]);
  std::string word;
  representatives >> word >> word;
  for (std::size_t row = 0; row < rows; ++row) {
    representatives >> word;
    requireMeant(word == (row < map.taxels.size() ? std::to_string(row) : "-1"), file,
                 "row " + std::to_string(row) + " has another representative");
  }
  const double tolerance = 0.6 * std::pow(10.0, -kIcubDecimals);
  for (std::size_t row = 0; row < rows; ++row) {
    const std::vector<std::string> numbers = split(lines[kHeaderLines + row], '\t');
    requireMeant(numbers.size() == 6, file, "row " + std::to_string(row) + " has no six numbers");
    const Taxel meant = row < map.taxels.size() ? map.taxels[row] : Taxel{};
    for (std::size_t k = 0; k < 6; ++k) {
      const double expected = (k < 3 ? meant.position : meant.normal)[static_cast<Eigen::Index>(k % 3)];
      requireMeant(std::abs(parseNumber(numbers[k], "row") - expected) <= tolerance, file,
                   "row " + std::to_string(row) + " is elsewhere");
    }
  }
}

std::string skinwareText(const TaxelMap& map) {
  std::string text = std::to_string(map.taxels.size()) + "\n";
  for (const Taxel& taxel : map.taxels) {
    std::string line;
    for (const std::int64_t number : skinwareNumbers(taxel, map)) {
      line += (line.empty() ? "" : " ") + std::to_string(number);
    }
    text += line + "\n";
  }
  return text;
}

void verifySkinware(std::string_view bytes, const TaxelMap& map, const std::string& file) {
  std::istringstream in{std::string(bytes)};
  std::size_t count = 0;
  requireMeant(static_cast<bool>(in >> count) && count == map.taxels.size(), file,
               "expected " + std::to_string(map.taxels.size()) + " cells");
  for (const Taxel& taxel : map.taxels) {
    for (const std::int64_t meant : skinwareNumbers(taxel, map)) {
      std::int64_t number = 0;
      requireMeant(static_cast<bool>(in >> number) && number == meant, file,
                   "cell " + toString(taxel.cell) + " has another number");
    }
  }
  std::string more;
  requireMeant(!(in >> more), file, "expected no further number");
}

}  // namespace hexoderm
