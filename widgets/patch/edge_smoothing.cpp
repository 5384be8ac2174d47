#include "widgets/patch/edge_smoothing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace hexoderm {
namespace {

// The usual settings; brightness is from 0 to 255.
constexpr std::uint8_t kLeastContrast = 12;  // least contrast of an edge in the dark ...
constexpr int kContrastDivisor = 8;          // ... and what is none beside a neighbour as bright as that
constexpr int kReach_px = 16;                // how far the ends of an edge are looked for
constexpr float kSpeckPart = 0.75F;          // how much of a single pixel is taken away

std::vector<std::uint8_t> brightness(const QImage& picture) {
  const int width = picture.width();
  std::vector<std::uint8_t> bright(static_cast<std::size_t>(width) * picture.height());
  for (int y = 0; y < picture.height(); ++y) {
    const auto* in = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
    std::uint8_t* out = bright.data() + static_cast<std::size_t>(y) * width;
    for (int x = 0; x < width; ++x) {
      const QRgb color = in[x];
      out[x] = static_cast<std::uint8_t>(
          (77 * ((color >> 16) & 255) + 150 * ((color >> 8) & 255) + 29 * (color & 255)) >> 8);
    }
  }
  return bright;
}

/// The brightness about one pixel. Names as on a map: north is up, `ne` in the upper right corner.
struct Surroundings {
  int m, n, s, w, e, nw, ne, sw, se;

  Surroundings(const std::uint8_t* at, std::ptrdiff_t line)
      : m(at[0]),
        n(at[-line]),
        s(at[line]),
        w(at[-1]),
        e(at[1]),
        nw(at[-line - 1]),
        ne(at[-line + 1]),
        sw(at[line - 1]),
        se(at[line + 1]) {}
  [[nodiscard]] bool runsEastWest() const {
    const int across_lines = std::abs(nw + sw - 2 * w) + 2 * std::abs(n + s - 2 * m) + std::abs(ne + se - 2 * e);
    const int along_lines = std::abs(nw + ne - 2 * n) + 2 * std::abs(w + e - 2 * m) + std::abs(sw + se - 2 * s);
    return across_lines >= along_lines;
  }
  /// Difference from the surroundings, 0 to 1 of `contrast`: 1 for a single pixel.
  [[nodiscard]] float speck(int contrast) const {
    const float mean = static_cast<float>(2 * (n + s + w + e) + nw + ne + sw + se) / 12;
    return std::min(std::abs(mean - static_cast<float>(m)) / static_cast<float>(contrast), 1.0F);
  }
};

/// A pixel's colour goes towards the neighbour at `neighbour`, an offset in pixels of the picture.
struct Mixture {
  std::ptrdiff_t neighbour = 0;
  float part = 0;
};

struct EdgeEnd {
  int distance_px = kReach_px;
  int change = 0;  ///< change of brightness beyond it; 0 if the end is out of reach
};

/// Goes along the edge between a pixel and its neighbour until both together become brighter or darker. `room_px` is
/// left of the picture in that direction.
EdgeEnd findEnd(const std::uint8_t* at, std::ptrdiff_t neighbour, std::ptrdiff_t step, int room_px, int threshold) {
  const int here = at[0] + at[neighbour];
  for (int distance_px = 1; distance_px <= std::min(room_px, kReach_px); ++distance_px) {
    const std::uint8_t* there = at + distance_px * step;
    const int change = there[0] + there[neighbour] - here;
    if (std::abs(change) >= threshold) return {distance_px, change};
  }
  return {};
}

/// The pixel `at` (x, y), where there is an edge of `contrast`.
Mixture mixture(const std::uint8_t* at, const QSize& size, int x, int y, const Surroundings& near, int contrast) {
  const std::ptrdiff_t line = size.width();
  const bool east_west = near.runsEastWest();
  const std::ptrdiff_t across = east_west ? line : 1;
  const std::ptrdiff_t along = east_west ? 1 : line;
  const int position = east_west ? x : y;
  const int length = east_west ? size.width() : size.height();
  const int before = at[-across] - near.m;
  const int after = at[across] - near.m;
  Mixture mixture;
  mixture.neighbour = std::abs(before) >= std::abs(after) ? -across : across;
  const int steepness = std::max(std::abs(before), std::abs(after));

  // Half of the steepness for the sum of two pixels: a quarter of it for their mean.
  const int threshold = std::max(steepness / 2, 1);
  const EdgeEnd back = findEnd(at, mixture.neighbour, -along, position, threshold);
  const EdgeEnd ahead = findEnd(at, mixture.neighbour, along, length - 1 - position, threshold);
  const EdgeEnd& nearer = back.distance_px < ahead.distance_px ? back : ahead;
  const int span = back.distance_px + ahead.distance_px;
  // At the nearer end the edge steps away from this pixel, or towards it: then the neighbour is the one to be mixed.
  const bool darker_here = near.m < at[mixture.neighbour];
  if (nearer.change != 0 && (nearer.change < 0) != darker_here) {
    mixture.part = 0.5F - static_cast<float>(nearer.distance_px) / static_cast<float>(span);
  }
  const float speck = near.speck(contrast);
  const float eased = (3 - 2 * speck) * speck * speck;
  mixture.part = std::max(mixture.part, kSpeckPart * eased * eased);
  return mixture;
}

QRgb mixed(QRgb color, QRgb other, float part) {
  const auto mix = [part](int a, int b) { return qRound(static_cast<float>(a) + part * static_cast<float>(b - a)); };
  return qRgb(mix(qRed(color), qRed(other)), mix(qGreen(color), qGreen(other)), mix(qBlue(color), qBlue(other)));
}

/// For each pixel of a line but its ends: the contrast there if it is an edge, else 0. Most pixels are none: without
/// branches the processor looks at many of them at a time.
void findEdges(const std::uint8_t* line, int width, std::uint8_t* contrasts) {
  const std::uint8_t* above = line - width;
  const std::uint8_t* below = line + width;
  for (int x = 1; x + 1 < width; ++x) {
    const std::uint8_t least =
        std::min(std::min(std::min(above[x], below[x]), std::min(line[x - 1], line[x + 1])), line[x]);
    const std::uint8_t greatest =
        std::max(std::max(std::max(above[x], below[x]), std::max(line[x - 1], line[x + 1])), line[x]);
    const auto contrast = static_cast<std::uint8_t>(greatest - least);
    const auto limit = std::max(kLeastContrast, static_cast<std::uint8_t>(greatest / kContrastDivisor));
    contrasts[x] = contrast < limit ? std::uint8_t{0} : contrast;
  }
}

}  // namespace

QImage smoothEdges(const QImage& picture) {
  const QSize size = picture.size();
  if (size.width() < 3 || size.height() < 3) return picture;
  const std::vector<std::uint8_t> bright = brightness(picture);
  const QImage original = picture.copy();  // its lines follow each other without gaps, like those of `bright`
  QImage smoothed = original;
  std::vector<std::uint8_t> contrasts(static_cast<std::size_t>(size.width()));
  for (int y = 1; y + 1 < size.height(); ++y) {
    const std::uint8_t* line = bright.data() + static_cast<std::size_t>(y) * size.width();
    const auto* in = reinterpret_cast<const QRgb*>(original.constScanLine(y));
    auto* out = reinterpret_cast<QRgb*>(smoothed.scanLine(y));
    findEdges(line, size.width(), contrasts.data());
    for (int x = 1; x + 1 < size.width(); ++x) {
      const int contrast = contrasts[static_cast<std::size_t>(x)];
      if (contrast == 0) continue;
      const Mixture mix = mixture(line + x, size, x, y, Surroundings(line + x, size.width()), contrast);
      out[x] = mixed(in[x], in[x + mix.neighbour], mix.part);
    }
  }
  return smoothed;
}

}  // namespace hexoderm
