#include "widgets/style/scene_colors.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

/// Relative luminance as the WCAG defines it.
double luminance(const Rgb& color) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

}  // namespace

double contrast(const Rgb& a, const Rgb& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

Rgb mixed(const Rgb& a, const Rgb& b, double share_of_b) {
  Rgb result{};
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = a[k] + share_of_b * (b[k] - a[k]);
  return result;
}

Rgb onScale(const std::vector<Rgb>& scale, double t) {
  // Written so that a value that is not a number ends at 0.
  const double position = (t > 0 ? std::min(t, 1.0) : 0.0) * static_cast<double>(scale.size() - 1);
  const auto lower = static_cast<std::size_t>(position);
  const std::size_t upper = std::min(lower + 1, scale.size() - 1);
  return mixed(scale[lower], scale[upper], position - static_cast<double>(lower));
}

Rgb onMap(const ColorMap& map, double t) {
  constexpr double kSlack = 1e-9;  // of a value at an end
  if (t < -kSlack) return map.below;
  return t > 1 + kSlack ? map.above : onScale(map.steps, t);
}

Rgb categoryColor(const SceneColors& colors, std::size_t category, std::size_t count) {
  if (count <= colors.classes.size()) return colors.classes[category];
  return onScale(colors.scale.steps, (static_cast<double>(category) + 0.5) / static_cast<double>(count));
}

const Rgb& markOn(const Rgb& face, const SceneColors& colors) {
  // The light mark is calmer and gains where a face turns into the shade; the dark one is for bright faces.
  constexpr double kEnoughContrast = 3.0;  // the WCAG's requirement for large text
  return contrast(colors.light_mark, face) >= kEnoughContrast ? colors.light_mark : colors.dark_mark;
}

}  // namespace hexoderm
