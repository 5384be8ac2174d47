#pragma once

#include "tests/support/paths.h"

#include <gtest/gtest.h>
#include <QDir>
#include <QImage>
#include <set>

namespace hexoderm {

/// Keeps a picture as a build artefact, to be looked at.
inline QImage keepPicture(const QImage& picture, const QString& name) {
  const QDir folder(QStringLiteral(HEXODERM_SCREENSHOTS));
  EXPECT_TRUE(folder.mkpath(".") && picture.save(folder.filePath(name + ".png"))) << name.toStdString();
  return picture;
}

/// How many colours a picture has: one of something has many.
inline std::size_t coloursIn(const QImage& picture) {
  std::set<QRgb> colours;
  for (int y = 0; y < picture.height(); y += 2) {
    for (int x = 0; x < picture.width(); x += 2) colours.insert(picture.pixel(x, y));
  }
  return colours.size();
}

}  // namespace hexoderm
