#pragma once

#include "app/window/guide/guide.h"
#include "app/window/main_window/main_window.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/session_store.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/sim/simulated_skin.h"
#include "tests/app/window/keyboard_keeper.h"
#include "tests/support/kept_picture.h"
#include "tests/support/qt_text.h"
#include "tests/support/qt_wait.h"
#include "widgets/controls/step_panel.h"
#include "widgets/graph/graph_view.h"

#include <algorithm>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace hexoderm {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// The real main window, driven with mouse and keyboard, in a world of its own: empty settings and a folder for files.
class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().clear();
    QSettings().setValue("paths/last", folder_.path());
    QSettings().setValue("view/theme", "light");
    // A demo skin that turns within moments.
    QSettings().setValue("demo/source", "sim:x17?speed=20");
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

  /// Lets the event loop run until it is so; the window shows it then. False if it never comes: then what the window
  /// says instead is printed.
  template <class Condition>
  bool waitUntil(Condition condition) {
    const bool came = test::waitUntil(condition);
    if (window_) window_->showChanges();
    if (!came && window_) {
      for (const char* label :
           {"messageText", "saidStatus", "bannerSentence", "liveState", "liveText", "captureWait"}) {
        const auto* said = window_->findChild<QLabel*>(QLatin1String(label));
        if (said != nullptr) std::cout << label << ": " << said->text().toStdString() << '\n';
      }
    }
    return came;
  }
  bool waitUntilIdle() {
    return waitUntil([this] {
      return controller().work().activity().isEmpty() && !controller().isSolving() && controller().reconstruction();
    });
  }
  /// Until nothing waits any more to be written into the session's file.
  bool waitUntilKept() {
    return waitUntilIdle() && waitUntil([this] {
             return controller().file().isKept() && !controller().file().isWriting() &&
                    !controller().file().hasUnsavedChanges();
           });
  }
  std::size_t posesShown() { return controller().reconstruction() ? controller().reconstruction()->poses.size() : 0; }
  bool waitForPoses(std::size_t count) {
    return waitUntilIdle() && waitUntil([&] { return posesShown() == count; });
  }

  static Session simulated(std::size_t poses, const SimulatedSkinOptions& options = {}, std::size_t frames = 20) {
    SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
    return simulateSession(skin, poses, frames);
  }
  /// Into a file of the kind that its name has; returns its path.
  QString writeSession(const QString& name, const Session& session) {
    const QString path = pathTo(name);
    if (name.endsWith(QLatin1String(".json"))) {
      writeSessionJson(session, path.toStdString());
    } else {
      writeSessionStore(session, path.toStdString());
    }
    return path;
  }
  /// Opens a file and waits for its result.
  void openFile(const QString& path) {
    window_->openFile(path);
    const QString name = QFileInfo(path).fileName();
    ASSERT_TRUE(waitUntil([&] { return controller().file().name() == name; })) << name.toStdString();
    ASSERT_TRUE(waitUntilIdle()) << name.toStdString();
  }
  void openSession(const QString& name, const Session& session) {
    ASSERT_NO_FATAL_FAILURE(openFile(writeSession(name, session)));
    ASSERT_TRUE(waitForPoses(session.poses().size())) << name.toStdString();
  }
  void dropFile(const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    const QPoint at(200, 200);
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    for (QDropEvent* event : std::initializer_list<QDropEvent*>{&enter, &drop}) {
      QApplication::sendEvent(window_.get(), event);
      EXPECT_TRUE(event->isAccepted());
    }
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
  void disablePose(int row) {
    clickRow("poseView", row);
    press(Qt::Key_Delete);
    ASSERT_TRUE(waitUntilIdle());
  }
  void openStep(GuideStep step) { window_->findChild<StepPanel*>()->openStep(static_cast<int>(step)); }
  QDialog* openExportDialog() {
    press(Qt::Key_E, Qt::ControlModifier);
    return waitForDialog("exportDialog");
  }
  static Session read(const QString& path) { return readSessionStore(path.toStdString()); }
  /// A page of the panel below, whose name begins so.
  void showTab(const QString& name) {
    auto* tabs = find<QTabBar>("detailTabs");
    for (int k = 0; k < tabs->count(); ++k) {
      if (!tabs->tabText(k).startsWith(name)) continue;
      QTest::mouseClick(tabs, Qt::LeftButton, Qt::NoModifier, tabs->tabRect(k).center());
      return;
    }
    FAIL() << "no tab " << name.toStdString();
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
      return controller().liveSession().canTurn() && controller().liveSession().nextPose() &&
             (action("actionTurn")->isEnabled() || !controller().liveSession().wantsMorePoses());
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
      if (controller().liveSession().wantsMorePoses()) {
        action("actionTurn")->trigger();
      } else {
        controller().liveSession().turnTo(controller().liveSession().nextPose()->up);
      }
    }));
    controller().liveSession().captureNow();
    ASSERT_TRUE(waitForPoses(before + 1));
  }

  /// The demo with so many poses and no more: the first where the skin lies, the others where the advice says.
  void takeDemoPoses(std::size_t count) {
    controller().liveSession().setAutomatic(false);
    clickBanner();
    ASSERT_TRUE(waitUntil([this] { return controller().liveSession().isLive(); }));
    ASSERT_TRUE(waitForPoses(0));
    if (count == 0) return;
    controller().liveSession().captureNow();
    ASSERT_TRUE(waitForPoses(1));
    for (std::size_t taken = 1; taken < count; ++taken) ASSERT_NO_FATAL_FAILURE(takeNextPose());
  }

  /// The demo with so many poses, disconnected: nothing but the test changes anything.
  void restWithDemoPoses(std::size_t count) {
    ASSERT_NO_FATAL_FAILURE(takeDemoPoses(count));
    controller().liveSession().disconnectSource();
    ASSERT_TRUE(waitUntilIdle());
    test::letTurnsPass();
  }

  /// Throws, which ends the test, if it does not come.
  template <class T = QDialog>
  T* waitForDialog(const char* object_name) {
    T* dialog = nullptr;
    const bool came = waitUntil([&] {
      dialog = window_->findChild<T*>(QLatin1String(object_name));
      return dialog && dialog->isVisible() && dialog->isActiveWindow();
    });
    if (!came) throw std::runtime_error(std::string("there is no dialog ") + object_name);
    return dialog;
  }
  bool waitUntilGone(const char* object_name) {
    return waitUntil([&] { return window_->findChild<QDialog*>(QLatin1String(object_name)) == nullptr; });
  }
  /// Fills in the dialog that connects, and accepts it, as a person does. Without a path, the poses go to the session
  /// that is open.
  void connectByDialog(const QString& kind_name, const QString& address, const QString& path = {}) {
    press(Qt::Key_K, Qt::ControlModifier);
    auto* dialog = waitForDialog("connectDialog");
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
    ASSERT_TRUE(waitUntilGone("connectDialog"));
  }
  static void typeInto(QLineEdit* edit, const QString& text) {
    edit->selectAll();
    QTest::keyClicks(edit, text);
  }

  /// Types a path into Qt's own file dialog and confirms it.
  void typeIntoFileDialog(const char* object_name, const QString& path) {
    auto* edit = waitForDialog(object_name)->findChild<QLineEdit*>("fileNameEdit");
    ASSERT_NE(edit, nullptr);
    typeInto(edit, path);
    QTest::keyClick(edit, Qt::Key_Return);
  }

  bool waitForMessage(const QString& part) {
    return waitUntil([&] { return message().contains(part); });
  }
  QString labelText(const char* label) { return find<QLabel>(label)->text(); }
  QString bannerButton() { return find<QPushButton>("bannerButton")->text(); }
  void closeMessage() { click(find<QWidget>("messageClose")); }
  void expectDisabled(const char* name, const QString& why) {
    EXPECT_FALSE(action(name)->isEnabled()) << name;
    EXPECT_THAT(action(name)->toolTip(), HasText(why)) << name;
  }
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
  static QByteArray contentOf(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
  }

  QTemporaryDir folder_;
  KeyboardKeeper keyboard_keeper_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace hexoderm
