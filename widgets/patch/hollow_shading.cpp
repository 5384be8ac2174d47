#include "widgets/patch/hollow_shading.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace hexoderm {
namespace {

constexpr float kDarkest = 0.45F;  // share of its light that a hollow loses at most
// Pixels to the neighbours on both sides: a hollow is seen across, and so in one direction at least.
constexpr std::array<std::array<int, 2>, 8> kPairs = {
    {{3, 0}, {0, 3}, {2, 2}, {2, -2}, {8, 0}, {0, 8}, {6, 6}, {6, -6}}};
constexpr int kReach = 8;

}  // namespace

DepthPicture depthPicture(const std::vector<float>& depths, const QSize& size, const HollowSight& sight) {
  constexpr float kNothing = std::numeric_limits<float>::infinity();
  DepthPicture picture{size.width(), size.height(), std::vector<float>(depths.size(), kNothing)};
  const auto near = static_cast<float>(sight.near_m);
  const auto far = static_cast<float>(sight.far_m);
  for (int y = 0; y < picture.height; ++y) {
    const float* in = depths.data() + static_cast<std::ptrdiff_t>(picture.height - 1 - y) * picture.width;
    float* out = picture.depth_m.data() + static_cast<std::ptrdiff_t>(y) * picture.width;
    for (int x = 0; x < picture.width; ++x) {
      const float depth = sight.parallel ? near + in[x] * (far - near) : near * far / (far - in[x] * (far - near));
      out[x] = in[x] < 1 ? depth : kNothing;
    }
  }
  for (const QRect& rect : sight.elsewhere) {
    const QRect inside = rect & QRect(QPoint(0, 0), size);
    for (int y = inside.top(); y <= inside.bottom(); ++y) {
      std::fill_n(picture.depth_m.begin() + static_cast<std::ptrdiff_t>(y) * picture.width + inside.left(),
                  inside.width(), kNothing);
    }
  }
  return picture;
}

QImage shadeHollows(const QImage& picture, const DepthPicture& depth, double full_m) {
  const int width = depth.width;
  const int height = depth.height;
  if (picture.size() != QSize(width, height) || width <= 2 * kReach || height <= 2 * kReach || !(full_m > 0)) {
    return picture;
  }
  const auto full = static_cast<float>(full_m);
  QImage shaded = picture.copy();
  shaded.setDevicePixelRatio(picture.devicePixelRatio());
  std::vector<float> hollow(static_cast<std::size_t>(width));
  for (int y = kReach; y + kReach < height; ++y) {
    const float* line = depth.depth_m.data() + static_cast<std::ptrdiff_t>(y) * width;
    std::ranges::fill(hollow, 0.0F);
    for (const auto& [dx, dy] : kPairs) {
      const std::ptrdiff_t step = static_cast<std::ptrdiff_t>(dy) * width + dx;
      for (int x = kReach; x < width - kReach; ++x) {
        // How much nearer the two are; what is far nearer covers this pixel rather than standing beside it.
        const float before = std::clamp(line[x] - line[x - step], -full, full);
        const float after = std::clamp(line[x] - line[x + step], -full, full);
        hollow[static_cast<std::size_t>(x)] += std::max(0.0F, before + after);
      }
    }
    auto* out = reinterpret_cast<QRgb*>(shaded.scanLine(y));
    const float most = 0.5F * static_cast<float>(kPairs.size()) * full;
    for (int x = kReach; x < width - kReach; ++x) {
      const float share = std::min(1.0F, hollow[static_cast<std::size_t>(x)] / most);
      if (!(share > 0.01F) || line[x] > 1e30F) continue;
      const auto light = static_cast<std::uint32_t>(256.0F * (1 - kDarkest * share));
      const QRgb color = out[x];
      out[x] = 0xff000000U | (((color & 0x00ff00ffU) * light >> 8U) & 0x00ff00ffU) |
               (((color & 0x0000ff00U) * light >> 8U) & 0x0000ff00U);
    }
  }
  return shaded;
}

}  // namespace hexoderm
