#pragma once

#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_cut.h"
#include "widgets/scene/scene_sight.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

/// Where an ID stands.
struct PlacedLabel {
  std::size_t cell = 0;  ///< index in the layout
  int font_px = 0;       ///< at 72 dpi, one of LabelChoice::kFonts
  Eigen::Vector2d at_px = Eigen::Vector2d::Zero();
  double depth_m = 0;  ///< before the eye
};

/// Decides which cells have their IDs written on them: those whose faces look at the viewer, are large enough for the
/// letters, and lie within the picture. Where two would cover each other, or where there are more than kMax, round
/// numbers come first, as on a ruler. The choice depends on the sight alone and not on what was chosen before, and as
/// the skin turns an ID comes and goes but once. No Qt, no OpenGL.
///
/// A choice takes one pass over all cells, and none at all where even the nearest of them is too small.
class LabelChoice {
 public:
  static constexpr std::array kFonts = {8, 10, 12, 14, 16, 18, 20, 22, 24, 26};
  static constexpr std::size_t kMax = 400;
  static constexpr double kMinFacing = 0.4;      ///< cosine between a face's normal and the line of sight
  static constexpr double kDigitAdvance = 0.57;  ///< share of the letters' size

  /// Null: there are no cells.
  void setContent(const std::shared_ptr<const SceneContent>& content) {
    content_ = content;
    candidates_.clear();
    chosen_.clear();
    if (!content) return;
    side_m_ = content->reconstruction->model->side_m;
    box_.setEmpty();
    for (const SceneCell& cell : content->layout.cells) box_.extend(cell.T_s_u.t);
  }

  /// Cells that a cut removes have none.
  const std::vector<PlacedLabel>& choose(const SceneSight& sight, const std::optional<SceneCut>& cut) {
    chosen_.clear();
    if (!content_ || content_->layout.cells.empty()) return chosen_;
    std::vector<Eigen::AlignedBox2d> taken;
    const auto roomFor = [&](const PlacedLabel& label) {
      const double height = sight.text_scale * label.font_px;
      const int digits = digitsOf(content_->layout.cells[label.cell].id.value());
      const Eigen::Vector2d half(0.5 * kDigitAdvance * digits * height, 0.4 * height);
      return Eigen::AlignedBox2d(label.at_px - half, label.at_px + half);
    };
    if (!anyCanBeRead(sight)) return chosen_;
    findCandidates(sight, cut);
    for (const Candidate& candidate : candidates_) {
      if (chosen_.size() >= kMax) break;
      const Eigen::AlignedBox2d room = roomFor(candidate.label);
      if (std::ranges::any_of(taken, [&](const Eigen::AlignedBox2d& other) { return overlaps(other, room); })) continue;
      taken.push_back(room);
      chosen_.push_back(candidate.label);
    }
    return chosen_;
  }

  [[nodiscard]] const SceneContent* content() const { return content_.get(); }

 private:
  static constexpr double kLetterShare = 0.52;  // size of the letters, share of the cell's side
  static constexpr double kWidthShare = 1.5;    // width that an ID may take, share of the side
  static constexpr double kTightest = 0.65;     // share of its room that a label of the smallest size is given at least
  /// How early a number comes: round ones first.
  static std::uint32_t roundness(std::uint32_t id) {
    constexpr std::array<std::uint32_t, 7> kSteps = {1000, 500, 100, 50, 10, 5, 2};
    for (std::uint32_t k = 0; k < kSteps.size(); ++k) {
      if (id % kSteps.at(k) == 0) return k;
    }
    return kSteps.size();
  }

  static int digitsOf(std::uint32_t id) {
    int digits = 1;
    for (; id >= 10; id /= 10) ++digits;
    return digits;
  }

  static bool overlaps(const Eigen::AlignedBox2d& a, const Eigen::AlignedBox2d& b) {
    return (a.min().array() < b.max().array()).all() && (b.min().array() < a.max().array()).all();
  }

  struct Candidate {
    std::uint32_t roundness = 0;  ///< the smaller come first
    PlacedLabel label;
  };
  [[nodiscard]] PlacedLabel placed(std::size_t cell, double wanted_px, const SceneSight& sight, double facing) const {
    PlacedLabel label;
    label.cell = cell;
    // Even sizes only, so that zooming does not make new letters at every step.
    label.font_px =
        std::clamp(2 * static_cast<int>(std::min(wanted_px, 1.0 * kFonts.back()) / 2), kFonts.front(), kFonts.back());
    const Eigen::Vector3d& center = content_->layout.cells[cell].T_s_u.t;
    label.at_px = sight.at(center);
    // The text stands upright to the viewer: it comes along the line of sight until its own tilted face can't cut it,
    // and stays behind everything that really is in front.
    const double steepest = std::max(facing, 0.3);
    const double tilt = std::sqrt(std::max(0.0, 1 - steepest * steepest)) / steepest;
    label.depth_m = sight.depthOf(center) - side_m_ * (0.05 + 0.4 * tilt);
    return label;
  }

  [[nodiscard]] bool anyCanBeRead(const SceneSight& sight) const {
    if (box_.isEmpty()) return false;
    // The corner that comes closest. A camera within the box is as close as can be.
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 8; ++k) {
      const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(k);
      least = std::min(least, sight.depthOf(box_.corner(corner)));
    }
    if (!sight.parallel && least <= 0) return true;
    return kLetterShare * side_m_ * sight.scaleAt(least) >= kTightest * kFonts.front() * sight.text_scale;
  }

  void findCandidates(const SceneSight& sight, const std::optional<SceneCut>& cut) {
    candidates_.clear();
    const std::vector<SceneCell>& cells = content_->layout.cells;
    const double smallest = kTightest * kFonts.front();
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const Eigen::Vector3d& center = cells[k].T_s_u.t;
      const double pixels = side_m_ * sight.scaleAt(sight.depthOf(center)) / sight.text_scale;
      if (!(kLetterShare * pixels >= smallest)) continue;
      const double facing = cells[k].T_s_u.R.col(2).dot(sight.towards(center));
      if (facing <= kMinFacing || (cut && cut->removes(center))) continue;
      const std::uint32_t id = cells[k].id.value();
      const double wanted = std::min(kLetterShare, kWidthShare / (LabelChoice::kDigitAdvance * digitsOf(id))) * pixels;
      if (wanted < smallest) continue;
      const PlacedLabel label = placed(k, wanted, sight, facing);
      const double reach = label.font_px * sight.text_scale;
      if (label.at_px.x() < -reach || label.at_px.x() > sight.window[0] + reach || label.at_px.y() < -reach ||
          label.at_px.y() > sight.window[1] + reach) {
        continue;
      }
      candidates_.push_back({roundness(id), label});
    }
    std::ranges::stable_sort(candidates_, {}, &Candidate::roundness);
  }

  std::shared_ptr<const SceneContent> content_;
  double side_m_ = 0;
  Eigen::AlignedBox3d box_;  ///< of the faces' centres
  std::vector<Candidate> candidates_;
  std::vector<PlacedLabel> chosen_;
};

}  // namespace hexoderm
