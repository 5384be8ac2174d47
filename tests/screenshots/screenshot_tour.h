#pragma once

#include <QDir>
#include <QSize>
#include <QString>
#include <QStringList>

class QAbstractButton;
class QWidget;

namespace hexoderm {

class MainWindow;

/// Leads the real window through the demo as a person would, by its buttons, and keeps a picture of every step and of
/// every dialog: for the user guide, and to see what the window looks like. At each stop it looks for texts that are
/// cut off or lie over each other, for what scrolls sideways, and for a window that has grown. It opens the steps that
/// the panel of steps offers, and that of the capture while poses are taken.
class ScreenshotTour {
 public:
  /// Pictures are named `prefix`-stop.png, and are made smaller if they are wider than `largest_width_px` (0: never).
  /// The window must outlive the tour.
  ScreenshotTour(MainWindow& window, const QDir& folder, const QString& prefix, int largest_width_px = 0)
      : window_(window), folder_(folder), prefix_(prefix), largest_width_px_(largest_width_px) {}

  /// Runs the event loop until the tour is through. Returns its failures, in words: what it found at its stops,
  /// pictures that could not be written, waits that had no end. Empty if all is well.
  QStringList run(QSize size);

 private:
  bool waitUntilIdle();
  void stop(QWidget& shown, const QString& name);
  /// Null beyond the last.
  [[nodiscard]] QAbstractButton* stepHead(int number) const;
  void visitSteps(const QString& stage);
  void visitTables();
  void visitLiveMode();
  void visitNotice();
  void visitDialogs();

  MainWindow& window_;
  QDir folder_;
  QString prefix_;
  int largest_width_px_;
  int stops_ = 0;
  QSize size_;
  QStringList problems_;
};

}  // namespace hexoderm
