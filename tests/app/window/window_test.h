#pragma once

#include "app/window/main_window/main_window.h"
#include "tests/app/window/keyboard_keeper.h"
#include "tests/support/paths.h"
#include "tests/support/qt_wait.h"
#include "widgets/graph/graph_view.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <memory>
#include <optional>
#include <string>

namespace hexoderm {

/// The real main window, driven with mouse and keyboard, in a world of its own: empty settings and a folder for files.
class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().clear();
    QSettings().setValue(QStringLiteral("paths/last"), folder_.path());
    QSettings().setValue(QStringLiteral("view/theme"), QStringLiteral("light"));
    // A demo skin that turns within moments.
    QSettings().setValue(QStringLiteral("demo/source"), QStringLiteral("sim:x17?speed=20"));
    openWindow();
  }

  void openWindow() {
    window_ = std::make_unique<MainWindow>();
    window_->show();
    activateWindow();
  }

  SessionController& controller() { return window_->controller(); }
  [[nodiscard]] QString pathTo(const QString& name) const { return QDir(folder_.path()).filePath(name); }

  template <class T>
  T* find(const char* object_name) {
    T* widget = window_->findChild<T*>(QLatin1String(object_name));
    EXPECT_NE(widget, nullptr) << object_name;
    return widget;
  }
  QAction* action(const char* object_name) { return find<QAction>(object_name); }

  /// Lets the event loop run until it is so; false if it never comes. The window shows it then.
  template <class Condition>
  bool waitUntil(Condition condition) {
    const bool came = test::waitUntil(condition);
    if (window_) window_->showChanges();
    return came;
  }
  bool waitUntilIdle() {
    return waitUntil([this] {
      return controller().work().activity().isEmpty() && !controller().isSolving() && controller().reconstruction();
    });
  }
  std::size_t posesShown() { return controller().reconstruction() ? controller().reconstruction()->poses.size() : 0; }
  bool waitForPoses(std::size_t count) {
    return waitUntilIdle() && waitUntil([&] { return posesShown() == count; });
  }

  void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }
  void clickBanner() { click(find<QPushButton>("bannerButton")); }
  void activateWindow() {
    window_->activateWindow();
    ASSERT_TRUE(waitUntil([this] { return window_->isActiveWindow(); }));
  }
  /// A key for the window itself, whichever of its parts has the focus.
  void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    activateWindow();
    QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : window_.get(), Qt::Key(key), modifiers);
  }
  void clickRow(const char* view_name, int row) {
    auto* view = find<QTableView>(view_name);
    const QRect cell = view->visualRect(view->model()->index(row, 0));
    QTest::mouseClick(view->viewport(), Qt::LeftButton, Qt::NoModifier, cell.center());
  }
  void clickCellInGraph(CellId cell) {
    auto* graph = window_->findChild<GraphView*>();
    const std::optional<QPoint> position = graph->positionOf(cell);
    ASSERT_TRUE(position.has_value()) << "cell " << cell << " is not shown";
    QTest::mouseClick(graph, Qt::LeftButton, Qt::NoModifier, *position);
  }

  /// Lets the simulated part turn, as `ask` asks it to, and waits by its own clock until it is there. Tests that count
  /// poses then capture by themselves: a part in a hand drifts, and automatic capture takes it for another pose after
  /// some ten seconds of that clock, which are half a second here.
  template <class Ask>
  void turnBy(Ask ask) {
    constexpr std::uint64_t kLongestTurn = 3500;  // samples: half a turn, and what a status may be late
    ASSERT_TRUE(waitUntil([this] {
      return controller().liveSession().canTurn() && controller().poseGuide().nextPose() &&
             (action("actionTurn")->isEnabled() || !controller().poseGuide().wantsMorePoses());
    }));
    ask();
    const LiveSource& live = controller().liveSession().source();
    std::optional<std::uint64_t> from;
    const auto connection = QObject::connect(&live, &LiveSource::statusChanged, window_.get(), [&] {
      if (!from) from = live.status().frames;
    });
    EXPECT_TRUE(waitUntil([&] { return from && live.status().frames >= *from + kLongestTurn; }));
    QObject::disconnect(connection);
  }
  /// The pose that is advised; where there are enough, the one that would be.
  void takeNextPose() {
    const std::size_t before = posesShown();
    ASSERT_NO_FATAL_FAILURE(turnBy([this] {
      if (controller().poseGuide().wantsMorePoses()) {
        action("actionTurn")->trigger();
      } else {
        controller().poseGuide().turnTo(controller().poseGuide().nextPose()->up);
      }
    }));
    controller().liveSession().captureNow();
    ASSERT_TRUE(waitForPoses(before + 1)) << message().toStdString();
  }

  /// The demo with so many poses and no more: the first where the skin lies, the others where the advice says.
  void takeDemoPoses(std::size_t count) {
    controller().liveSession().setAutomatic(false);
    clickBanner();
    ASSERT_TRUE(waitUntil([this] { return controller().liveSession().isLive(); })) << message().toStdString();
    ASSERT_TRUE(waitForPoses(0));
    if (count == 0) return;
    controller().liveSession().captureNow();
    ASSERT_TRUE(waitForPoses(1)) << message().toStdString();
    for (std::size_t taken = 1; taken < count; ++taken) ASSERT_NO_FATAL_FAILURE(takeNextPose());
  }

  template <class T>
  T* waitForDialog(const char* object_name) {
    T* dialog = nullptr;
    EXPECT_TRUE(waitUntil([&] {
      dialog = window_->findChild<T*>(QLatin1String(object_name));
      return dialog && dialog->isVisible() && dialog->isActiveWindow();
    })) << object_name;
    return dialog;
  }
  /// Fills in the dialog that connects, and accepts it, as a person does. Without a path, the poses go to the session
  /// that is open.
  void connectByDialog(const QString& kind_name, const QString& address, const QString& path = {}) {
    press(Qt::Key_K, Qt::ControlModifier);
    auto* dialog = waitForDialog<QDialog>("connectDialog");
    ASSERT_NE(dialog, nullptr);
    auto* kind = dialog->findChild<QComboBox*>("connectKind");
    QTest::keyClick(kind, Qt::Key_Home);
    for (int k = 1; k < kind->count() && kind->currentText() != kind_name; ++k) QTest::keyClick(kind, Qt::Key_Down);
    ASSERT_EQ(kind->currentText(), kind_name);
    typeInto(dialog->findChild<QComboBox*>("connectAddress")->lineEdit(), address);
    auto* continues = dialog->findChild<QCheckBox*>("connectContinue");
    if (continues->isVisible() && continues->isChecked() != path.isEmpty()) QTest::keyClick(continues, Qt::Key_Space);
    if (!path.isEmpty()) typeInto(dialog->findChild<QLineEdit*>("connectPath"), path);
    auto* button = dialog->findChild<QPushButton*>("connectButton");
    ASSERT_TRUE(button->isEnabled()) << button->toolTip().toStdString();
    click(button);
    ASSERT_TRUE(waitUntil([this] { return window_->findChild<QDialog*>("connectDialog") == nullptr; }));
  }
  static void typeInto(QLineEdit* edit, const QString& text) {
    edit->selectAll();
    QTest::keyClicks(edit, text);
  }

  /// Types a path into Qt's own file dialog and confirms it.
  void typeIntoFileDialog(const char* object_name, const QString& path) {
    auto* dialog = waitForDialog<QDialog>(object_name);
    ASSERT_NE(dialog, nullptr);
    auto* edit = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    ASSERT_NE(edit, nullptr);
    edit->selectAll();
    QTest::keyClicks(edit, path);
    QTest::keyClick(edit, Qt::Key_Return);
  }

  /// Keeps a picture of a window or dialog as a build artefact.
  static void keepPicture(const QImage& picture, const QString& name) {
    const QDir folder(QStringLiteral(HEXODERM_SCREENSHOTS));
    ASSERT_TRUE(folder.mkpath("."));
    EXPECT_TRUE(picture.save(folder.filePath(name + ".png")));
  }

  bool waitForMessage(const QString& part) {
    return waitUntil([&] { return message().contains(part); });
  }
  QString labelText(const char* label) { return find<QLabel>(label)->text(); }
  QString message() {
    if (find<QWidget>("messageBar")->isVisible()) return find<QLabel>("messageText")->text();
    return find<QLabel>("saidStatus")->isVisible() ? find<QLabel>("saidStatus")->text() : QString();
  }
  QString writeFile(const QString& name, const QByteArray& content) {
    QFile file(pathTo(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(content);
    return file.fileName();
  }

  QTemporaryDir folder_;
  KeyboardKeeper keyboard_keeper_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace hexoderm
