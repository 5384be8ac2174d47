#pragma once

#include "app/window/files/session_paths.h"
#include "app/window/log/event_log.h"
#include "tests/app/window/window_test.h"

namespace hexoderm {

/// The main window without a log, recent files or unsaved sessions of earlier tests.
class PresenterTest : public WindowTest {
 protected:
  void SetUp() override {
    QDir(unsavedFolder()).removeRecursively();
    QDir(logFolder()).removeRecursively();
    WindowTest::SetUp();
  }
  void TearDown() override { QDir(unsavedFolder()).removeRecursively(); }

  void reopenWindow() {
    window_->close();
    window_.reset();
    openWindow();
  }
  using WindowTest::writeSession;
  QString writeSession(const QString& path, std::size_t poses) {
    QDir().mkpath(QFileInfo(path).absolutePath());
    return WindowTest::writeSession(path, simulated(poses));
  }
  QString logText() {
    QString text;
    for (const LogLine& line : window_->log().linesAfter(0)) text += asFileLine(line) + '\n';
    return text;
  }
  template <class T>
  T* visible(const char* name) {
    for (auto* widget : window_->findChildren<T*>(QLatin1String(name))) {
      if (widget->isVisible()) return widget;
    }
    return nullptr;
  }
};

}  // namespace hexoderm
