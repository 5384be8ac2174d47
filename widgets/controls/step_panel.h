#pragma once

#include <QScrollArea>
#include <QTimer>
#include <vector>

class QAction;
class QVBoxLayout;

namespace hexoderm {

enum class StepState { Waiting, Current, Done };

/// Whether a step can be taken. Possible: allowed, but not recommended yet. Waiting: allowed as soon as something
/// arrives that is on its way. Blocked: somebody has to do something first.
enum class Readiness { Ready, Possible, Waiting, Blocked };

/// One step from "connect" to "export": what it is, where it stands, what to do and why.
struct Step {
  QString title;
  QString note;  ///< one line under the title: "17 cells, 16 links, 1 patch"
  StepState state = StepState::Waiting;
  QString what;  ///< the present task
  QString why;   ///< why, or what it is waiting for
  Readiness readiness = Readiness::Blocked;
  QString because;  ///< why, as a sentence; empty: nothing is said
  std::vector<QAction*> actions;
};

/// The steps from top to bottom. One is open: the one that was clicked, or that openStep() named; a step never gives
/// way to another by itself, while somebody reads it. Its width is its place's: no text and no body widens it.
class StepPanel : public QScrollArea {
  Q_OBJECT

 public:
  explicit StepPanel(QWidget* parent = nullptr);

  /// Property of the buttons that open a step: pressing it would change nothing.
  static constexpr const char* kIsOpen = "stepIsOpen";

  void setSteps(const std::vector<Step>& steps);
  /// Sets the content of a step beside its words, once there is such a step; the panel takes ownership.
  void setBody(int step, QWidget* body);
  [[nodiscard]] int openIndex() const { return static_cast<int>(open_); }

 public slots:
  /// Nothing happens if there is no such step.
  void openStep(int step);
  /// Opens a step, and moves the keyboard to its heading.
  void goToStep(int step);

 signals:
  void opened(int step);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  class Row;
  void showOpenRow();
  /// If the open step does not fit below the steps before it, these give way; its widget with the focus stays in view.
  void makeRoom();
  void makeRoomSoon();
  [[nodiscard]] bool isFocusElsewhere() const;  ///< at the heading of another step

  QVBoxLayout* layout_;
  std::vector<Row*> rows_;
  std::vector<QWidget*> bodies_;  ///< by step; null where there is none
  std::size_t open_ = 0;
  QTimer make_room_;
  int placed_at_ = 0;  ///< the scroll bar's value as it was set here, as long as nobody else scrolls
};

}  // namespace hexoderm
