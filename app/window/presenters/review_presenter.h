#pragma once

#include "hexoderm/util/ids.h"

#include <QObject>
#include <optional>

namespace hexoderm {

class CheckList;
class CoverageView;
class FilePresenter;
class PatchView;
class ResidualView;
class ResultPresenter;
class ResultTables;
class Selection;
class SessionController;
class StepPanel;
class WindowActions;

/// Keeps the same pose, link or cell picked in all the views that a result is reviewed in.
class ReviewPresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    StepPanel& steps;
    CheckList& check_list;
    ResultTables& tables;
    ResidualView& residuals;
    CoverageView& coverage;
    PatchView& patch;
  };
  /// All outlive the presenter.
  ReviewPresenter(const Views& views, const SessionController& controller, const WindowActions& actions,
                  Selection& selection, FilePresenter& files, const ResultPresenter& results);

  /// Its row among the poses of the result that is shown.
  [[nodiscard]] std::optional<int> pickedPoseRow() const;

 signals:
  void pickedPoseChanged();

 private:
  void connectTables();
  void showPicks();
  void showPickedPose();
  void showPickedLink();
  void showPickedCell();
  void pickPose(PoseId pose);
  void pickFromFinding(int row);
  void showWorstFinding();

  Views views_;
  const SessionController& controller_;
  Selection& selection_;
  std::optional<PoseId> picked_pose_;
};

}  // namespace hexoderm
