#pragma once

#include "app/window/main_window.h"
#include "widgets/graph_view.h"

#include <gmock/gmock.h>

#include <QApplication>
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

  /// Lets the event loop run until it is so; false if that takes suspiciously long.
  template <class Condition>
  static bool waitUntil(Condition condition) {
    constexpr int kMilliseconds = 20000;
    return QTest::qWaitFor(condition, kMilliseconds);
  }
  bool waitUntilIdle() {
    return waitUntil([this] {
      return controller().activity().isEmpty() && !controller().isSolving() && controller().reconstruction();
    });
  }
  std::size_t posesShown() { return controller().reconstruction() ? controller().reconstruction()->poses.size() : 0; }
  bool waitForPoses(std::size_t count) {
    return waitUntilIdle() && waitUntil([&] { return posesShown() == count; });
  }

  void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }
  void clickBanner() { click(find<QPushButton>("bannerButton")); }
  /// Where there is no window manager, nobody gives the focus back when a dialog has closed.
  void activateWindow() {
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
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

  /// The demo with so many poses and no more: the first where the skin lies, the others where the advice says.
  void takeDemoPoses(std::size_t count) {
    controller().setAutomatic(false);
    clickBanner();
    ASSERT_TRUE(waitUntil([this] { return controller().isLive(); })) << message().toStdString();
    ASSERT_TRUE(waitForPoses(0));
    // At once: the demo is twenty times quicker than life, and a hand that drifts meanwhile takes one pose more.
    const auto one_is_enough = QObject::connect(&controller().live(), &LiveSource::poseCaptured, window_.get(),
                                                [this] { controller().setAutomatic(false); });
    for (std::size_t taken = 1; taken <= count; ++taken) {
      if (taken > 1) {
        ASSERT_TRUE(waitUntil([this] { return action("actionTurn")->isEnabled(); }));
        action("actionTurn")->trigger();
      }
      controller().setAutomatic(true);
      ASSERT_TRUE(waitForPoses(taken)) << message().toStdString();
    }
    QObject::disconnect(one_is_enough);
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
  std::unique_ptr<MainWindow> window_;
};

}  // namespace hexoderm
