#pragma once

#include "tests/support/paths.h"

#include <QImage>
#include <QString>
#include <algorithm>
#include <cstdlib>

namespace hexoderm {

/// Share of the area's pixels, or of all, that differ by more than so much of 255 in any channel; 1 if the sizes do.
inline double differingShare(const QImage& a, const QImage& b, int slack, QRect area = {}) {
  if (a.size() != b.size()) return 1;
  if (area.isNull()) area = a.rect();
  int differing = 0;
  for (int y = area.top(); y <= area.bottom(); ++y) {
    for (int x = area.left(); x <= area.right(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      const auto off = {qRed(p) - qRed(q), qGreen(p) - qGreen(q), qBlue(p) - qBlue(q)};
      differing += std::ranges::any_of(off, [slack](int channel) { return std::abs(channel) > slack; });
    }
  }
  return differing / (static_cast<double>(area.width()) * area.height());
}

/// The share in which it differs from the picture of this name in tests/baselines, which HEXODERM_UPDATE_BASELINES=1
/// writes instead; a picture that differs in more than `most` is kept.
inline double differenceToBaseline(const QImage& picture, const QString& name, int slack, double most) {
  const QString path = QStringLiteral(HEXODERM_BASELINES "/%1.png").arg(name);
  if (std::getenv("HEXODERM_UPDATE_BASELINES") != nullptr) picture.save(path);
  const double share = differingShare(picture, QImage(path), slack);
  if (share > most) picture.save(name + "-actual.png");
  return share;
}

}  // namespace hexoderm
