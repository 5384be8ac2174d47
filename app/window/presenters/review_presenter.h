#pragma once

#include "hexoderm/util/finding.h"

#include <QObject>
#include <optional>

namespace hexoderm {

class CheckList;
class CoverageView;
class FilePresenter;
class GraphView;
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
    GraphView& graph;
  };
  /// All outlive the presenter.
  ReviewPresenter(const Views& views, const SessionController& controller, const WindowActions& actions,
                  Selection& selection, FilePresenter& files, const ResultPresenter& results);

  /// Its row among the poses of the result that is shown.
  [[nodiscard]] std::optional<int> pickedPoseRow() const;
  void pickPose(PoseId pose);
  /// Picks what it is about, and lets the views turn to it.
  void showFinding(const Finding& finding);

 signals:
  void pickedPoseChanged();
  /// All findings are to be seen.
  void findingsWanted();

 private:
  void connectTables();
  void showPicks();
  void showPickedPose();
  void showPickedLink();
  void showPickedCell();
  void connectActions(const WindowActions& actions);
  void scrollToPicked();
  void showWorstFinding();
  void showWorstCell();
  void showFigures(bool shown);

  Views views_;
  const SessionController& controller_;
  Selection& selection_;
  std::optional<PoseId> picked_pose_;
};

}  // namespace hexoderm
