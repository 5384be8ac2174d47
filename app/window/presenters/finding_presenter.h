#pragma once

#include "app/window/presenters/presenter.h"
#include "app/window/presenters/result_presenter.h"
#include "app/window/presenters/review_presenter.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/tables/finding_table.h"

#include <QTableView>
#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <tuple>
#include <vector>

namespace hexoderm {

/// The cards of findings: says what can be done about each just now, and does it.
class FindingPresenter : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::FindingPresenter)

 public:
  FindingPresenter(const WindowParts& parts, const ResultPresenter& results, ReviewPresenter& review)
      : Presenter(parts), review_(review) {
    for (FindingCards* cards : {views.check_findings, views.review_findings}) {
      connect(cards, &FindingCards::showWanted, &review_, &ReviewPresenter::showFinding);
      connect(cards, &FindingCards::remedyWanted, this, &FindingPresenter::apply);
      connect(cards, &FindingCards::allWanted, this, &FindingPresenter::showAll);
    }
    connect(views.finding_card, &FindingCard::showWanted, &review_, &ReviewPresenter::showFinding);
    connect(views.finding_card, &FindingCard::remedyWanted, this, &FindingPresenter::apply);
    connect(views.tables.finding_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &FindingPresenter::showPickedInTable);
    connect(&results, &ResultPresenter::handedOut, this, &FindingPresenter::takeFindings);
    views.finding_card->setUnfolded(true);
    showPickedInTable();
  }

  /// What can be done may have changed. The actions have to know already which of them can be used.
  void refresh() {
    const LiveSession& live = controller.liveSession();
    const auto now = std::make_tuple(controller.submittedRevision(), live.isLive(), live.litCell(),
                                     actions.show_next_pose->isEnabled());
    if (known_ == now) return;
    known_ = now;
    std::vector<FindingCards::Item> in_check;
    std::vector<FindingCards::Item> in_review;
    for (const Finding& finding : by_weight_) {
      const FindingCards::Item item{finding, offersFor(finding)};
      in_review.push_back(item);
      if (isAboutTheReport(finding)) in_check.push_back(item);
    }
    views.check_findings->setItems(in_check);
    views.review_findings->setItems(in_review);
    showPickedInTable();
  }

 private:
  static bool namesLink(const Finding& finding) { return finding.cells.size() >= 2 && finding.ports.size() >= 2; }
  static LinkEnd firstEnd(const Finding& finding) { return {finding.cells[0], finding.ports[0]}; }
  static LinkEnd secondEnd(const Finding& finding) { return {finding.cells[1], finding.ports[1]}; }

  /// It is about the topology or a link, not about a cell's readings, a pose or the estimate, by the order of codes.
  static bool isAboutTheReport(const Finding& finding) { return finding.code <= FindingCode::TornSkin; }

  void showAll() {
    panels.details().show();
    panels.details().raise();
    views.detail_tabs->setCurrentIndex(0);
  }

  void takeFindings() {
    const std::shared_ptr<const Reconstruction>& reconstruction = controller.reconstruction();
    known_.reset();
    by_weight_.clear();
    if (reconstruction) {
      std::ranges::copy_if(reconstruction->findings, std::back_inserter(by_weight_),
                           [](const Finding& finding) { return finding.severity != Severity::Info; });
      std::ranges::stable_sort(by_weight_, std::ranges::greater(), &Finding::severity);
    }
    refresh();
  }

  /// Without a row that is picked it is about the first, which is the worst.
  void showPickedInTable() {
    const QModelIndexList rows = views.tables.finding_view->selectionModel()->selectedRows();
    const int row = rows.isEmpty() ? 0 : rows.front().row();
    const bool any = row < views.tables.findings->rowCount();
    views.finding_card->setVisible(any);
    if (!any) return;
    const Finding& finding = views.tables.findings->findingAt(row);
    views.finding_card->setFinding(finding, offersFor(finding));
  }

  /// Of the first pose that the finding names, among the session's.
  std::optional<std::size_t> poseOf(const Finding& finding) const {
    if (finding.poses.empty() || !controller.session()) return std::nullopt;
    const auto& poses = controller.session()->poses();
    const auto found =
        std::ranges::find_if(poses, [&](const SessionPose& pose) { return pose.capture->id == finding.poses.front(); });
    return found == poses.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - poses.begin()));
  }

  std::vector<FindingOffer> offersFor(const Finding& finding) const {
    std::vector<FindingOffer> offers;
    for (const FindingRemedy remedy : descriptionOf(finding.code).remedies) {
      if (const std::optional<QString> text = offer(remedy, finding)) offers.push_back({remedy, *text});
    }
    return offers;
  }

  std::optional<QString> offer(FindingRemedy remedy, const Finding& finding) const {
    const Session* session = controller.session();
    const LiveSession& live = controller.liveSession();
    switch (remedy) {
      case FindingRemedy::MuteLink:
        if (session == nullptr || !namesLink(finding)) return std::nullopt;
        return session->findMutedLink(firstEnd(finding), secondEnd(finding)) != nullptr ? tr("Take link back")
                                                                                        : tr("Set link aside");
      case FindingRemedy::DisablePose:
        if (const auto index = poseOf(finding)) {
          const bool disabled = session->poses()[*index].disabled;
          return (disabled ? tr("Enable pose %1") : tr("Disable pose %1")).arg(finding.poses.front().value());
        }
        return std::nullopt;
      case FindingRemedy::RecapturePose:
        if (!live.isLive() || !poseOf(finding)) return std::nullopt;
        return tr("Take pose %1 again").arg(finding.poses.front().value());
      case FindingRemedy::TakePose:
        if (!actions.show_next_pose->isEnabled()) return std::nullopt;
        return session != nullptr && session->poses().empty() ? tr("Take the first pose") : tr("Take another pose");
      case FindingRemedy::LightCell:
        if (finding.cells.empty() || !live.isLive() || !live.source().skin() ||
            !live.source().skin()->can_light_cells) {
          return std::nullopt;
        }
        return live.litCell() == finding.cells.front() ? tr("Light off")
                                                       : tr("Light cell %1").arg(finding.cells.front().value());
    }
    return std::nullopt;
  }

  void apply(const Finding& finding, FindingRemedy remedy) {
    // It may have gone since the button was drawn.
    if (!offer(remedy, finding)) return;
    switch (remedy) {
      case FindingRemedy::MuteLink: {
        const bool excluded = controller.session()->findMutedLink(firstEnd(finding), secondEnd(finding)) != nullptr;
        selection.selectLink(firstEnd(finding), secondEnd(finding));
        controller.setLinkMuted(firstEnd(finding), secondEnd(finding), !excluded);
        break;
      }
      case FindingRemedy::DisablePose: {
        const std::size_t index = *poseOf(finding);
        controller.setPoseDisabled(index, !controller.session()->poses()[index].disabled);
        break;
      }
      case FindingRemedy::RecapturePose:
        review_.pickPose(finding.poses.front());
        if (actions.recapture->isEnabled()) actions.recapture->trigger();
        break;
      case FindingRemedy::TakePose:
        actions.show_next_pose->trigger();
        break;
      case FindingRemedy::LightCell: {
        const CellId cell = finding.cells.front();
        const bool is_lit = controller.liveSession().litCell() == cell;
        selection.seekCell(cell);
        controller.liveSession().lightCell(is_lit ? std::nullopt : std::optional(cell));
        break;
      }
    }
  }

  ReviewPresenter& review_;
  std::vector<Finding> by_weight_;  ///< of the result, the worst first; remarks left out
  /// What decides on what can be done: the revision of the session, a skin that is connected, its lit cell, and whether
  /// a pose can be taken. While a skin streams, nothing of it changes.
  std::optional<std::tuple<std::uint64_t, bool, std::optional<CellId>, bool>> known_;
};

}  // namespace hexoderm
