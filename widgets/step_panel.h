#pragma once

#include "widgets/palette.h"

#include <QScrollArea>
#include <vector>

class QAction;
class QVBoxLayout;

namespace hexoderm {

enum class StepState { Waiting, Current, Done };

/// One step from "connect" to "export": what it is, where it stands, what to do and why.
struct Step {
  QString title;
  QString note;  ///< one line under the title: "17 cells, 16 links, 1 patch"
  StepState state = StepState::Waiting;
  QString what;  ///< what to do now
  QString why;   ///< why, or what it is waiting for
  std::vector<QAction*> actions;
};

/// The steps from top to bottom; the current one is open, any other opens when it is clicked.
class StepPanel : public QScrollArea {
  Q_OBJECT

 public:
  explicit StepPanel(QWidget* parent = nullptr);

  void setSteps(const std::vector<Step>& steps);
  void setTheme(Theme theme);

 private:
  class Row;
  void showOpenRow();

  QVBoxLayout* layout_;
  std::vector<Row*> rows_;
  std::size_t current_ = 0;
  std::size_t open_ = 0;
  Theme theme_ = Theme::Light;
};

}  // namespace hexoderm
