#pragma once

#include "app/window/settings/preferences.h"
#include "app/window/settings/theme.h"

#include <QCoreApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace hexoderm {

/// Settings, folders and style as a newcomer has them, gone with this: for programs that drive the real window. Before
/// the QApplication.
class Newcomer {
 public:
  Newcomer() {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
    QStandardPaths::setTestModeEnabled(true);
    installStyle();
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
    QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
    QCoreApplication::setOrganizationName(QStringLiteral("Hexoderm"));
    QCoreApplication::setApplicationName(QStringLiteral("hexoderm"));
  }

  /// A folder for files of the program's own.
  [[nodiscard]] QString folder() const { return folder_.path(); }

 private:
  QTemporaryDir folder_;
};

}  // namespace hexoderm
