#include "app/window/toolkit/status_bar.h"

#include "widgets/controls/elided_label.h"

#include <QLabel>

namespace hexoderm {
namespace {

/// A long address or message ends in dots instead of widening the window.
QLabel* makePart(const char* object_name) {
  auto* part = new ElidedLabel;
  part->setObjectName(QLatin1String(object_name));
  return part;
}

void showIn(QLabel* part, const QString& text, const QString& tool_tip) {
  // Setting what is there already would lay the bar out anew, and tell whoever listens to tool tips.
  if (part->text() != text) part->setText(text);
  if (part->toolTip() != tool_tip) part->setToolTip(tool_tip);
  if (part->isHidden() != text.isEmpty()) part->setVisible(!text.isEmpty());
}

}  // namespace

StatusBar::StatusBar(QWidget* parent)
    : QStatusBar(parent),
      source_(makePart("sourceStatus")),
      losses_(makePart("lossesStatus")),
      cells_(makePart("cellsStatus")),
      solve_(makePart("solveStatus")),
      said_(makePart("saidStatus")),
      saved_(makePart("savedStatus")) {
  setSizeGripEnabled(false);
  for (QLabel* part : {source_, losses_, cells_, solve_}) addWidget(part);
  for (QLabel* part : {said_, saved_}) addPermanentWidget(part);
  for (QLabel* part : {losses_, cells_, solve_, said_}) part->hide();
  said_timer_.setSingleShot(true);
  connect(&said_timer_, &QTimer::timeout, said_, &QWidget::hide);
}

void StatusBar::setSource(const QString& text, const QString& tool_tip) { showIn(source_, text, tool_tip); }
void StatusBar::setLosses(const QString& text, const QString& tool_tip) { showIn(losses_, text, tool_tip); }
void StatusBar::setCells(const QString& text, const QString& tool_tip) { showIn(cells_, text, tool_tip); }
void StatusBar::setSolve(const QString& text, const QString& tool_tip) { showIn(solve_, text, tool_tip); }
void StatusBar::setSaved(const QString& text) { showIn(saved_, text, {}); }

void StatusBar::say(const QString& text) {
  constexpr int kShown_ms = 6000;
  showIn(said_, text, {});
  said_timer_.start(kShown_ms);
}

}  // namespace hexoderm
