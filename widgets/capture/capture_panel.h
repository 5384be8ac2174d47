#pragma once

#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/device/skin_source.h"
#include "hexoderm/solve/metrics/pose_coverage.h"

#include <QTimer>
#include <QWidget>
#include <optional>

class QAction;
class QBoxLayout;
class QLabel;

namespace hexoderm {

class HoldRing;

/// The operator's view of capturing: the next pose, readable from three metres, with its reason; the hold ring; the
/// condition that is awaited, with cell, value and limit; and the buttons for it. Without a source it says that no skin
/// is connected.
class CapturePanel : public QWidget {
  Q_OBJECT

 public:
  /// `automatic` can be checked: it becomes the switch. Null leaves a thing out. The actions must outlive the panel.
  struct Actions {
    QAction* automatic = nullptr;
    QAction* capture = nullptr;
    QAction* skip = nullptr;
    QAction* turn = nullptr;
  };
  explicit CapturePanel(const Actions& actions, QWidget* parent = nullptr);

  /// The state of the source; none: no skin is connected.
  void setSource(const std::optional<SourceStatus>& status);
  /// Cheap: at most 20 times a second. Shown while the source streams.
  void setHold(const HoldStatus& hold);
  /// Nothing: advice is still being worked out.
  void setAdvice(const std::optional<NextPose>& next);
  /// The ring says that the pose is being written, until showCaptured() or a motion.
  void showWriting(PoseId pose);
  /// The pose will not be written.
  void endWriting(PoseId pose);
  /// The ring says for a moment that the pose is captured; `remark` ("Pose 4 repeats pose 2") stays until the next
  /// pose.
  void showCaptured(PoseId pose, const QString& remark = {});

  /// What the operator is to do or should know now, in one sentence for the ear; empty without a skin that sends.
  [[nodiscard]] QString instruction() const;

 signals:
  void instructionChanged(const QString& instruction);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void refreshAdvice();
  void tellInstruction();
  void fitText();

  QBoxLayout* columns_;
  QLabel* what_;
  QLabel* turn_;
  QLabel* why_;
  QLabel* sigma_;
  HoldRing* ring_;
  QLabel* wait_;
  QLabel* odd_;
  QLabel* remark_;
  QTimer captured_timer_;
  std::optional<SourceStatus> source_;
  HoldStatus hold_;
  std::optional<NextPose> next_;
  std::optional<PoseId> writing_;
  std::optional<PoseId> captured_;
  QString instruction_;  ///< as instructionChanged() last said
};

}  // namespace hexoderm
