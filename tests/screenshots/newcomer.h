#pragma once

#include "app/window/settings/theme.h"

#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>

namespace hexoderm {

/// Settings and style as a newcomer has them, for pictures of the window, and gone with this. Before the QApplication.
class Newcomer {
 public:
  Newcomer() {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings_.path());
    installStyle();
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
    QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
    QCoreApplication::setOrganizationName(QStringLiteral("Hexoderm"));
    QCoreApplication::setApplicationName(QStringLiteral("hexoderm"));
  }

 private:
  QTemporaryDir settings_;
};

}  // namespace hexoderm
