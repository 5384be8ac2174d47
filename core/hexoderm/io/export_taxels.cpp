#include "hexoderm/io/export_formats.h"

#include "hexoderm/base/text.h"
#include "hexoderm/io/export_selection.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

constexpr std::size_t kTaxelsPerTriangle = 12;
constexpr int kIcubDecimals = 9;
constexpr double kNanometres = 1e9;

/// The rows of the file: those of the cells, filled up to whole triangles, with one to spare.
std::size_t icubRows(const TaxelMap& map) { return (map.taxels.size() / kTaxelsPerTriangle + 1) * kTaxelsPerTriangle; }

std::string icubNumbers(const Eigen::Vector3d& v) {
  const auto numberText = [](double value) {
    const std::string number = formatFixed(value, kIcubDecimals);
    return number.find_first_not_of("-0.") == std::string::npos ? formatFixed(0, kIcubDecimals) : number;  // no "-0"
  };
  return inARow(v, numberText, "\t");
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

std::string skinwareText(const TaxelMap& map) {
  std::string text = std::to_string(map.taxels.size()) + "\n";
  for (const Taxel& taxel : map.taxels) {
    text += inARow(
                skinwareNumbers(taxel, map), [](std::int64_t number) { return std::to_string(number); }, " ") +
            "\n";
  }
  return text;
}

}  // namespace hexoderm
