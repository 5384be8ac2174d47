// The window follows the light or dark setting of the desktop, which a portal announces on the session bus.

#include "tests/app/window/window_test.h"
#include "widgets/style/system_theme.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>

namespace hexoderm {
namespace {

/// A session bus of the test's own with a portal on it, before the window looks for one.
class WindowThemeTest : public WindowTest {
 protected:
  void SetUp() override {
    daemon_.start("dbus-daemon", {"--session", "--nofork", "--print-address"});
    ASSERT_TRUE(waitUntil([this] { return daemon_.canReadLine(); })) << daemon_.errorString().toStdString();
    const QByteArray address = daemon_.readLine().trimmed();
    qputenv("DBUS_SESSION_BUS_ADDRESS", address);
    portal_ =
        std::make_unique<QDBusConnection>(QDBusConnection::connectToBus(QString::fromLocal8Bit(address), "portal"));
    ASSERT_TRUE(portal_->isConnected());
    ASSERT_TRUE(portal_->registerService("org.freedesktop.portal.Desktop"));
    WindowTest::SetUp();
  }
  void TearDown() override {
    window_.reset();
    portal_.reset();
    QDBusConnection::disconnectFromBus("portal");
    daemon_.kill();
    daemon_.waitForFinished();
  }

  void announce(const char* space, const char* key, uint value) {
    QDBusMessage signal = QDBusMessage::createSignal("/org/freedesktop/portal/desktop",
                                                     "org.freedesktop.portal.Settings", "SettingChanged");
    signal << QLatin1String(space) << QLatin1String(key) << QVariant::fromValue(QDBusVariant(value));
    ASSERT_TRUE(portal_->send(signal));
  }
  void announceColorScheme(uint value) { announce("org.freedesktop.appearance", "color-scheme", value); }
  [[nodiscard]] static bool isShown(Theme theme) {
    return QApplication::palette().color(QPalette::Window) == Colors::of(theme).window;
  }

  QProcess daemon_;
  std::unique_ptr<QDBusConnection> portal_;
};

TEST_F(WindowThemeTest, FollowsTheDesktopAsLongAsThatIsChosen) {
  constexpr uint kNoPreference = 0;
  constexpr uint kDark = 1;
  constexpr uint kLight = 2;
  action("actionThemeSystem")->trigger();
  announceColorScheme(kDark);
  EXPECT_TRUE(waitUntil([] { return isShown(Theme::Dark); }));
  EXPECT_EQ(find<GraphView>("graphView")->palette().color(QPalette::Window), Colors::of(Theme::Dark).window);
  announceColorScheme(kLight);
  EXPECT_TRUE(waitUntil([] { return isShown(Theme::Light); }));
  announceColorScheme(kDark);
  EXPECT_TRUE(waitUntil([] { return isShown(Theme::Dark); }));
  announceColorScheme(kNoPreference);
  EXPECT_TRUE(waitUntil([] { return isShown(Theme::Light); }));

  // Chosen by hand it stays.
  const SystemThemeWatch watch;
  int announced = 0;
  QObject::connect(&watch, &SystemThemeWatch::changed, window_.get(), [&announced] { ++announced; });
  action("actionThemeLight")->trigger();
  announceColorScheme(kDark);
  ASSERT_TRUE(waitUntil([&] { return announced == 1; }));
  QCoreApplication::processEvents();
  EXPECT_TRUE(isShown(Theme::Light));
  // Announcements made meanwhile count once the system is chosen again; other settings don't.
  action("actionThemeSystem")->trigger();
  EXPECT_TRUE(isShown(Theme::Dark));
  announce("org.freedesktop.appearance", "contrast", kLight);
  announce("org.gnome.desktop.interface", "color-scheme", kLight);
  announceColorScheme(kDark);
  ASSERT_TRUE(waitUntil([&] { return announced == 2; }));
  EXPECT_TRUE(isShown(Theme::Dark));
  EXPECT_EQ(QSettings().value("view/theme").toString(), "system");
}

}  // namespace
}  // namespace hexoderm
