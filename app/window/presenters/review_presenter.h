#pragma once

#include "app/window/presenters/presenter.h"
#include "hexoderm/base/finding.h"

#include <optional>

namespace hexoderm {

class FilePresenter;
class ResultPresenter;

/// Keeps the same pose, link or cell picked in all the views that a result is reviewed in.
class ReviewPresenter : public Presenter {
  Q_OBJECT

 public:
  ReviewPresenter(const WindowParts& parts, FilePresenter& files, const ResultPresenter& results);

  /// Its row among the poses of the result that is shown.
  [[nodiscard]] std::optional<int> pickedPoseRow() const;
  void pickPose(PoseId pose);
  /// Picks what it is about, and lets the views turn to it.
  void showFinding(const Finding& finding);

 signals:
  void pickedPoseChanged();

 private:
  void connectTables();
  void showPicks();
  void showPickedPose();
  void showPickedLink();
  void showPickedCell();
  void connectActions();
  void scrollToPicked();
  void showWorstFinding();
  void showWorstCell();
  void showMetrics(bool shown);

  std::optional<PoseId> picked_pose_;
};

}  // namespace hexoderm
