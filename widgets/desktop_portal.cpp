#include "widgets/desktop_portal.h"

#ifdef HEXODERM_HAS_DBUS
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>
#include <QVariant>
#endif

namespace hexoderm {

#ifdef HEXODERM_HAS_DBUS

std::optional<Theme> desktopPortalTheme() {
  // Without this variable libdbus would start a bus of its own.
  if (qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS")) return std::nullopt;
  QDBusConnection bus = QDBusConnection::sessionBus();
  if (!bus.isConnected()) return std::nullopt;
  QDBusMessage question = QDBusMessage::createMethodCall(
      QStringLiteral("org.freedesktop.portal.Desktop"), QStringLiteral("/org/freedesktop/portal/desktop"),
      QStringLiteral("org.freedesktop.portal.Settings"), QStringLiteral("Read"));
  question << QStringLiteral("org.freedesktop.appearance") << QStringLiteral("color-scheme");
  constexpr int kPatience_ms = 250;
  const QDBusMessage answer = bus.call(question, QDBus::Block, kPatience_ms);
  if (answer.type() != QDBusMessage::ReplyMessage || answer.arguments().isEmpty()) return std::nullopt;
  // Portals wrap the value in one variant or in two.
  QVariant value = answer.arguments().constFirst();
  while (value.canConvert<QDBusVariant>()) value = value.value<QDBusVariant>().variant();
  switch (value.toUInt()) {
    case 1:
      return Theme::Dark;
    case 2:
      return Theme::Light;
    default:
      return std::nullopt;
  }
}

#else

std::optional<Theme> desktopPortalTheme() { return std::nullopt; }

#endif

}  // namespace hexoderm
