#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <Eigen/Core>

#include <QElapsedTimer>
#include <QObject>
#include <cstdint>
#include <memory>
#include <optional>

namespace hexoderm {

class CapturePanel;
class CaptureTone;
class CardDock;
class CoverageView;
class PatchView;
class Preferences;
class Selection;
class SessionController;
class StepPanel;
class StillnessView;
class WindowActions;
struct CapturedPose;

/// Shows how the poses are captured: the part in the hand, the pose that is wanted next, the directions that were seen.
class CapturePresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    StepPanel& steps;
    CapturePanel& panel;
    CoverageView& coverage;
    CardDock& coverage_dock;
    StillnessView& stillness;
    PatchView& patch;
    CaptureTone& tone;
  };
  /// All outlive the presenter.
  CapturePresenter(const Views& views, SessionController& controller, const WindowActions& actions,
                   const Selection& selection, const Preferences& preferences);

  /// Shows the directions that its poses have seen; null: none.
  void setReconstruction(const std::shared_ptr<const Reconstruction>& reconstruction);

 private:
  void connectCommands(const WindowActions& actions);
  void connectPreferences(const Preferences& preferences);
  void showSource();
  /// The skin sends, so that what was read last is what there is at this moment.
  [[nodiscard]] bool isReading() const;
  void showHold();
  void showCaptured(const CapturedPose& captured);
  void showNextPose();
  void showAdvice();
  void showMoment();
  /// In the step Capture the picture turns as the part is turned.
  void followPart();

  Views views_;
  SessionController& controller_;
  std::optional<Eigen::Vector3d> current_up_;  ///< of the part just now, in the frame of the largest patch
  QElapsedTimer advice_age_;
  bool follows_part_ = false;
  std::optional<CellId> told_cell_;  ///< the cell that the advice speaks of
  std::uint64_t restarts_ = 0;       ///< of captures, as the recorder last said
};

}  // namespace hexoderm
