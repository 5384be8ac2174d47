#include "hexoderm/solve/result/reconstruction.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/units.h"

#include <algorithm>

namespace hexoderm {
namespace {

constexpr EnumNames<VerdictLevel> kVerdicts = {{"good", "usable", "coarse", "not_enough", "not_trusted", "failed"}};
constexpr EnumNames<Limit> kLimits = {
    {"nothing", "no_skin", "no_pose", "directions", "readings", "mould", "patches", "findings"}};
constexpr EnumNames<Remedy> kRemedies = {{"nothing", "check_skin", "take_pose", "retake_poses"}};

constexpr EnumNames<EdgeQuality> kQualities = {{"un", "partially", "fully", "over"}};

}  // namespace

std::string_view verdictName(VerdictLevel level) { return kVerdicts.of(level); }
std::optional<VerdictLevel> verdictFromName(std::string_view name) { return kVerdicts.find(name); }
std::string_view limitName(Limit limit) { return kLimits.of(limit); }
std::optional<Limit> limitFromName(std::string_view name) { return kLimits.find(name); }
std::string_view remedyName(Remedy remedy) { return kRemedies.of(remedy); }
std::optional<Remedy> remedyFromName(std::string_view name) { return kRemedies.find(name); }

std::optional<double> LinkEstimate::knownResidual() const {
  // A file may state the rms alone.
  const bool is_measured =
      residual_rad > 0 ||
      std::ranges::any_of(pose_residual_rad, [](const std::optional<double>& angle) { return angle.has_value(); });
  return is_measured ? std::optional(residual_rad) : std::nullopt;
}

std::optional<double> LinkEstimate::knownSigma() const {
  return sigma_rad > 0 ? std::optional(sigma_rad) : std::nullopt;
}

bool LinkEstimate::hasMetrics() const { return used || knownResidual() || knownSigma(); }

std::string_view qualityName(EdgeQuality quality) { return kQualities.of(quality); }
std::optional<EdgeQuality> qualityFromName(std::string_view name) { return kQualities.find(name); }

const CellPlacement* PatchReconstruction::findCell(CellId cell_id) const {
  const auto found = std::ranges::lower_bound(cells, cell_id, {}, &CellPlacement::cell);
  return found != cells.end() && found->cell == cell_id ? &*found : nullptr;
}

std::vector<CellId> PatchReconstruction::pathTo(CellId cell_id) const {
  std::vector<CellId> path{cell_id};
  while (path.back() != origin) {
    const CellPlacement* cell = findCell(path.back());
    const bool goes_on = cell != nullptr && cell->predecessor && path.size() < cells.size();
    if (!goes_on) return {};
    path.push_back(*cell->predecessor);
  }
  std::ranges::reverse(path);
  return path;
}

std::size_t Reconstruction::cellCount() const {
  std::size_t count = 0;
  for (const PatchReconstruction& patch : patches) count += patch.cells.size();
  return count;
}

std::size_t Reconstruction::linkCount() const {
  std::size_t count = 0;
  for (const PatchReconstruction& patch : patches) count += patch.links.size();
  return count;
}

Reconstruction::Located Reconstruction::find(CellId id) const {
  for (const PatchReconstruction& patch : patches) {
    if (const CellPlacement* cell = patch.findCell(id)) return {&patch, cell};
  }
  return {};
}

const LinkEstimate* Reconstruction::findLink(LinkEnd a, LinkEnd b) const {
  if (b < a) std::swap(a, b);
  for (const PatchReconstruction& patch : patches) {
    for (const LinkEstimate& link : patch.links) {
      if (link.source == a && link.target == b) return &link;
    }
  }
  return nullptr;
}

const PatchReconstruction* largestPatch(const Reconstruction& reconstruction) {
  const auto largest = std::ranges::max_element(reconstruction.patches, {},
                                                [](const PatchReconstruction& patch) { return patch.cells.size(); });
  return largest == reconstruction.patches.end() || largest->cells.empty() ? nullptr : &*largest;
}

Message sizeText(const Reconstruction& reconstruction) {
  const std::size_t cells = reconstruction.cellCount();
  const std::size_t links = reconstruction.linkCount();
  const std::size_t patches = reconstruction.patches.size();
  return inRow({cells == 1 ? message("1 cell") : message("{} cells", cells),
                links == 1 ? message("1 link") : message("{} links", links),
                patches == 1 ? message("1 patch") : message("{} patches", patches)},
               ", ");
}

double rotationSigma(const Eigen::Matrix3d& covariance) { return std::min(kPi, largestDeviation(covariance)); }

Uncertainty95 uncertaintyBy(const Matrix6d& cov_t_r) {
  return {kSigmasFor95Percent * largestDeviation(cov_t_r.topLeftCorner<3, 3>()),
          std::min(kPi, kSigmasFor95Percent * largestDeviation(cov_t_r.bottomRightCorner<3, 3>()))};
}

std::optional<Uncertainty95> uncertaintyOf(const CellPlacement& cell) {
  return cell.cov_t_r ? std::optional(uncertaintyBy(*cell.cov_t_r)) : std::nullopt;
}

std::optional<Uncertainty95> shapeUncertaintyOf(const CellPlacement& cell) {
  return cell.shape_cov_t_r ? std::optional(uncertaintyBy(*cell.shape_cov_t_r)) : std::nullopt;
}

}  // namespace hexoderm
