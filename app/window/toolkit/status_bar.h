#pragma once

#include "widgets/controls/elided_label.h"
#include "widgets/controls/panel_parts.h"

#include <QLabel>
#include <QStatusBar>
#include <QTimer>

namespace hexoderm {

/// The line at the bottom of the window. Each setter replaces one part of it, which is hidden while its text is empty.
class StatusBar : public QStatusBar {
  Q_OBJECT

 public:
  explicit StatusBar(QWidget* parent = nullptr) : QStatusBar(parent) {
    setSizeGripEnabled(false);
    for (QLabel* part : {source_, losses_, cells_, solve_}) addWidget(part);
    for (QLabel* part : {said_, saved_}) addPermanentWidget(part);
    for (QLabel* part : {losses_, cells_, solve_, said_}) part->hide();
    constexpr int kShown_ms = 6000;
    setUpOnce(said_timer_, kShown_ms, said_, &QWidget::hide);
  }

  /// Where the readings come from.
  void setSource(const QString& text, const QString& tool_tip = {}) { showIn(source_, text, tool_tip); }
  /// The readings that did not arrive.
  void setLosses(const QString& text, const QString& tool_tip = {}) { showIn(losses_, text, tool_tip); }
  /// How many cells were measured.
  void setCells(const QString& text, const QString& tool_tip = {}) { showIn(cells_, text, tool_tip); }
  /// How the result was solved.
  void setSolve(const QString& text, const QString& tool_tip = {}) { showIn(solve_, text, tool_tip); }
  /// Whether the session is on disk.
  void setSaved(const QString& text) { showIn(saved_, text, {}); }
  /// Shown for a few seconds.
  void say(const QString& text) {
    showIn(said_, text, {});
    said_timer_.start();
  }

 private:
  static void showIn(QLabel* part, const QString& text, const QString& tool_tip) {
    // Setting what is there already would lay the bar out anew, and tell whoever listens to tool tips.
    if (part->text() != text) part->setText(text);
    if (part->toolTip() != tool_tip) part->setToolTip(tool_tip);
    if (part->isHidden() != text.isEmpty()) part->setVisible(!text.isEmpty());
  }

  // A long address or message ends in dots instead of widening the window.
  QLabel* source_ = named(new ElidedLabel, "sourceStatus");
  QLabel* losses_ = named(new ElidedLabel, "lossesStatus");
  QLabel* cells_ = named(new ElidedLabel, "cellsStatus");
  QLabel* solve_ = named(new ElidedLabel, "solveStatus");
  QLabel* said_ = named(new ElidedLabel, "saidStatus");
  QLabel* saved_ = named(new ElidedLabel, "savedStatus");
  QTimer said_timer_;
};

}  // namespace hexoderm
