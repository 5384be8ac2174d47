#pragma once

#include <QStatusBar>
#include <QTimer>

class QLabel;

namespace hexoderm {

/// The line at the bottom of the window. Each setter replaces one part of it, which is hidden while its text is empty.
class StatusBar : public QStatusBar {
  Q_OBJECT

 public:
  explicit StatusBar(QWidget* parent = nullptr);

  /// Where the readings come from.
  void setSource(const QString& text, const QString& tool_tip = {});
  /// The readings that did not arrive.
  void setLosses(const QString& text, const QString& tool_tip = {});
  /// How many cells were measured.
  void setCells(const QString& text, const QString& tool_tip = {});
  /// How the result was solved.
  void setSolve(const QString& text, const QString& tool_tip = {});
  /// Whether the session is on disk.
  void setSaved(const QString& text);
  /// Shown for a few seconds.
  void say(const QString& text);

 private:
  QLabel* source_;
  QLabel* losses_;
  QLabel* cells_;
  QLabel* solve_;
  QLabel* said_;
  QLabel* saved_;
  QTimer said_timer_;
};

}  // namespace hexoderm
