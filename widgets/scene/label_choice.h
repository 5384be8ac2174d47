#pragma once

#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_cut.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

class vtkCamera;

namespace hexoderm {

/// From where labels are read, in the scene's frame. Pixels count from the window's lower left corner.
struct LabelSight {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();  ///< with `up` and `back` (towards the viewer) a right-handed frame
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  Eigen::Vector3d back = Eigen::Vector3d::UnitZ();
  bool parallel = false;
  double pixels_per_m = 1;  ///< in parallel projection; in perspective one metre before the eye
  Eigen::Vector2d middle_px = Eigen::Vector2d::Zero();  ///< the pixel straight ahead
  std::array<int, 2> window{};
  double text_scale = 1;  ///< pixels of a letter per pixel at 72 dpi

  static LabelSight of(vtkCamera* camera, const std::array<int, 2>& window, int dpi);
  /// Pixels per metre at this distance before the eye; 0 behind it.
  [[nodiscard]] double scaleAt(double depth_m) const {
    return parallel ? pixels_per_m : depth_m > 0 ? pixels_per_m / depth_m : 0;
  }
  [[nodiscard]] double depthOf(const Eigen::Vector3d& p) const { return (eye - p).dot(back); }
  friend bool operator==(const LabelSight&, const LabelSight&) = default;
};

/// Where an ID stands.
struct PlacedLabel {
  std::size_t cell = 0;  ///< index in the layout
  int font_px = 0;       ///< at 72 dpi, one of LabelChoice::kFonts
  Eigen::Vector2d at_px = Eigen::Vector2d::Zero();
  double depth_m = 0;  ///< before the eye
};

/// Decides which cells have their IDs written on them: those whose faces look at the viewer, are large enough for the
/// letters, and lie within the picture. Where two would cover each other, or where there are more than kMost, round
/// numbers come first, as on a ruler. The choice depends on the sight alone and not on what was chosen before, and as
/// the skin turns an ID comes and goes but once. No Qt, no OpenGL.
///
/// A choice takes one pass over all cells, and none at all where even the nearest of them is too small.
class LabelChoice {
 public:
  static constexpr std::array kFonts = {8, 10, 12, 14, 16, 18, 20, 22, 24, 26};
  static constexpr std::size_t kMost = 400;
  static constexpr double kLeastFacing = 0.4;    ///< cosine between a face's normal and the line of sight
  static constexpr double kDigitAdvance = 0.57;  ///< share of the letters' size

  /// Null: there are no cells.
  void setContent(const std::shared_ptr<const SceneContent>& content);
  /// Cells that a cut removes have none.
  const std::vector<PlacedLabel>& choose(const LabelSight& sight, const std::optional<SceneCut>& cut);
  [[nodiscard]] const SceneContent* content() const { return content_.get(); }

 private:
  struct Candidate {
    std::uint32_t roundness = 0;  ///< the smaller come first
    PlacedLabel label;
  };
  [[nodiscard]] PlacedLabel placed(std::size_t cell, double wanted_px, const LabelSight& sight, double facing) const;
  [[nodiscard]] bool anyCanBeRead(const LabelSight& sight) const;
  void findCandidates(const LabelSight& sight, const std::optional<SceneCut>& cut);

  std::shared_ptr<const SceneContent> content_;
  double side_m_ = 0;
  Eigen::AlignedBox3d box_;  ///< of the faces' centres
  std::vector<Candidate> candidates_;
  std::vector<PlacedLabel> chosen_;
};

}  // namespace hexoderm
