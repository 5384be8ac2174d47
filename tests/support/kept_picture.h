#pragma once

#include "tests/support/paths.h"

#include <gtest/gtest.h>
#include <QDir>
#include <QImage>

namespace hexoderm {

/// Keeps a picture as a build artefact, to be looked at.
inline QImage keepPicture(const QImage& picture, const QString& name) {
  const QDir folder(QStringLiteral(HEXODERM_SCREENSHOTS));
  EXPECT_TRUE(folder.mkpath(".") && picture.save(folder.filePath(name + ".png"))) << name.toStdString();
  return picture;
}

}  // namespace hexoderm
