#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"
#include "widgets/controls/finding_card.h"

#include <QObject>
#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

class QTableView;

namespace hexoderm {

class FindingTable;
class ReviewPresenter;
class Selection;
class SessionController;
class StepPanel;
class WindowActions;

/// The cards of findings: says what can be done about each just now, and does it.
class FindingPresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    StepPanel& steps;
    FindingCards& in_check;   ///< those about cells and links as they were reported
    FindingCards& in_review;  ///< the worst
    FindingCard& in_table;    ///< the one that is picked in the table of findings
    FindingTable& table;
    QTableView& table_view;
  };
  /// All outlive the presenter.
  FindingPresenter(const Views& views, SessionController& controller, const WindowActions& actions,
                   Selection& selection, ReviewPresenter& review);

  /// The table of findings must have got it already.
  void setReconstruction(const std::shared_ptr<const Reconstruction>& reconstruction);
  /// What can be done may have changed. The actions have to know already which of them can be used.
  void refresh();

 private:
  [[nodiscard]] std::vector<FindingOffer> offersFor(const Finding& finding) const;
  [[nodiscard]] std::optional<QString> offer(FindingRemedy remedy, const Finding& finding) const;
  void apply(const Finding& finding, FindingRemedy remedy);
  void showPickedInTable();
  /// Of the first pose that the finding names, among the session's.
  [[nodiscard]] std::optional<std::size_t> poseOf(const Finding& finding) const;

  Views views_;
  SessionController& controller_;
  const WindowActions& actions_;
  Selection& selection_;
  ReviewPresenter& review_;
  std::vector<Finding> by_weight_;  ///< of the result, the worst first; remarks left out
  /// What decides on what can be done: the revision of the session, a skin that is connected, its lit cell, and whether
  /// a pose can be taken. While a skin streams, nothing of it changes.
  std::optional<std::tuple<std::uint64_t, bool, std::optional<CellId>, bool>> known_;
};

}  // namespace hexoderm
