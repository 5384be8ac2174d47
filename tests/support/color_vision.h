#pragma once

#include "widgets/style/scene_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hexoderm {

// Colours (sRGB, 0 to 1) as they look to eyes that can't tell all of them apart: G. Machado, M. Oliveira,
// L. Fernandes, "A physiologically-based model for simulation of color vision deficiency", IEEE TVCG 15, 2009, with
// severity 1.

using ColorMatrix = std::array<std::array<double, 3>, 3>;

constexpr ColorMatrix kProtanopia = {{{0.152286, 1.052583, -0.204868},  //
                                      {0.114503, 0.786281, 0.099216},
                                      {-0.003882, -0.048116, 1.051998}}};
constexpr ColorMatrix kDeuteranopia = {{{0.367322, 0.860646, -0.227968},  //
                                        {0.280085, 0.672501, 0.047413},
                                        {-0.011820, 0.042940, 0.968881}}};
constexpr ColorMatrix kTritanopia = {{{1.255528, -0.076749, -0.178779},  //
                                      {-0.078411, 0.930809, 0.147602},
                                      {0.004733, 0.691367, 0.303900}}};
constexpr ColorMatrix kAllColours = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

inline double toLinear(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }
inline double toEncoded(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

inline Rgb times(const ColorMatrix& m, const Rgb& v) {
  Rgb result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t k = 0; k < 3; ++k) result.at(row) += m.at(row).at(k) * v.at(k);
  }
  return result;
}

inline Rgb seenBy(const ColorMatrix& eyes, const Rgb& color) {
  Rgb seen = times(eyes, {toLinear(color[0]), toLinear(color[1]), toLinear(color[2])});
  for (double& channel : seen) channel = toEncoded(std::clamp(channel, 0.0, 1.0));
  return seen;
}

/// CIE L*a*b*.
using Lab = std::array<double, 3>;
inline Lab toLab(const Rgb& color) {
  constexpr ColorMatrix kToXyz = {{{0.4124564, 0.3575761, 0.1804375},  //
                                   {0.2126729, 0.7151522, 0.0721750},
                                   {0.0193339, 0.1191920, 0.9503041}}};
  const Rgb xyz = times(kToXyz, {toLinear(color[0]), toLinear(color[1]), toLinear(color[2])});
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f(xyz[0] / 0.95047);
  const double y = f(xyz[1]);
  const double z = f(xyz[2] / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

}  // namespace hexoderm
