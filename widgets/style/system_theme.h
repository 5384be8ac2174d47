#pragma once

#include "widgets/style/palette.h"

#include <QObject>
#include <optional>

class QDBusMessage;

namespace hexoderm {

/// The colour scheme that the desktop asks for through org.freedesktop.portal.Settings. Absent where there is no
/// session bus, no portal, no preference, no answer within a quarter of a second, or no QtDBus to ask with.
std::optional<Theme> desktopPortalTheme();

/// Says when the desktop changes its colour scheme; silent wherever desktopPortalTheme() is.
class SystemThemeWatch : public QObject {
  Q_OBJECT

 public:
  explicit SystemThemeWatch(QObject* parent = nullptr);

 signals:
  void changed(hexoderm::Theme theme);

 private slots:
  void settingChanged(const QDBusMessage& message);
};

}  // namespace hexoderm
