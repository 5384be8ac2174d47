#include "widgets/style/system_theme.h"

#ifdef HEXODERM_HAS_DBUS
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>
#include <QVariant>
#endif

namespace hexoderm {

#ifdef HEXODERM_HAS_DBUS

namespace {

const QString kService = QStringLiteral("org.freedesktop.portal.Desktop");
const QString kPath = QStringLiteral("/org/freedesktop/portal/desktop");
const QString kSettings = QStringLiteral("org.freedesktop.portal.Settings");
const QString kAppearance = QStringLiteral("org.freedesktop.appearance");
const QString kColorScheme = QStringLiteral("color-scheme");

/// The session bus, if there is one: without this variable libdbus would start a bus of its own.
std::optional<QDBusConnection> sessionBus() {
  if (qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS")) return std::nullopt;
  QDBusConnection bus = QDBusConnection::sessionBus();
  return bus.isConnected() ? std::optional(bus) : std::nullopt;
}

std::optional<Theme> themeOf(QVariant color_scheme) {
  // Portals wrap the value in one variant or in two.
  while (color_scheme.canConvert<QDBusVariant>()) color_scheme = color_scheme.value<QDBusVariant>().variant();
  switch (color_scheme.toUInt()) {
    case 1:
      return Theme::Dark;
    case 2:
      return Theme::Light;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<Theme> desktopPortalTheme() {
  const std::optional<QDBusConnection> bus = sessionBus();
  if (!bus) return std::nullopt;
  QDBusMessage question = QDBusMessage::createMethodCall(kService, kPath, kSettings, QStringLiteral("Read"));
  question << kAppearance << kColorScheme;
  constexpr int kPatience_ms = 250;
  const QDBusMessage answer = bus->call(question, QDBus::Block, kPatience_ms);
  if (answer.type() != QDBusMessage::ReplyMessage || answer.arguments().isEmpty()) return std::nullopt;
  return themeOf(answer.arguments().constFirst());
}

SystemThemeWatch::SystemThemeWatch(QObject* parent) : QObject(parent) {
  std::optional<QDBusConnection> bus = sessionBus();
  if (!bus) return;
  bus->connect(kService, kPath, kSettings, QStringLiteral("SettingChanged"), this, SLOT(settingChanged(QDBusMessage)));
}

void SystemThemeWatch::settingChanged(const QDBusMessage& message) {
  const QVariantList arguments = message.arguments();
  if (arguments.size() < 3 || arguments[0].toString() != kAppearance || arguments[1].toString() != kColorScheme) return;
  // A desktop that takes its preference back shows what it shows by default, and that is light.
  emit changed(themeOf(arguments[2]).value_or(Theme::Light));
}

#else

std::optional<Theme> desktopPortalTheme() { return std::nullopt; }
SystemThemeWatch::SystemThemeWatch(QObject* parent) : QObject(parent) {}
void SystemThemeWatch::settingChanged(const QDBusMessage& /*message*/) {}

#endif

}  // namespace hexoderm
