#include "app/window/presenters/finding_presenter.h"

#include "app/window/guide/actions.h"
#include "app/window/guide/guide.h"
#include "app/window/presenters/review_presenter.h"
#include "app/window/session/session_controller.h"
#include "widgets/controls/selection.h"
#include "widgets/controls/step_panel.h"
#include "widgets/tables/finding_table.h"

#include <QTableView>
#include <algorithm>
#include <functional>
#include <iterator>

namespace hexoderm {
namespace {

bool namesLink(const Finding& finding) { return finding.cells.size() >= 2 && finding.ports.size() >= 2; }
LinkEnd firstEnd(const Finding& finding) { return {finding.cells[0], finding.ports[0]}; }
LinkEnd secondEnd(const Finding& finding) { return {finding.cells[1], finding.ports[1]}; }

/// It is about what the skin said of itself, before any pose was measured.
bool isAboutTheReport(const Finding& finding) { return finding.code <= FindingCode::ContradictsModel; }

}  // namespace

FindingPresenter::FindingPresenter(const Views& views, SessionController& controller, const WindowActions& actions,
                                   Selection& selection, ReviewPresenter& review)
    : views_(views), controller_(controller), actions_(actions), selection_(selection), review_(review) {
  for (FindingCards* cards : {&views_.in_check, &views_.in_review}) {
    connect(cards, &FindingCards::showWanted, &review_, &ReviewPresenter::showFinding);
    connect(cards, &FindingCards::remedyWanted, this, &FindingPresenter::apply);
    connect(cards, &FindingCards::allWanted, &review_, &ReviewPresenter::findingsWanted);
  }
  connect(&views_.in_table, &FindingCard::showWanted, &review_, &ReviewPresenter::showFinding);
  connect(&views_.in_table, &FindingCard::remedyWanted, this, &FindingPresenter::apply);
  connect(views_.table_view.selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &FindingPresenter::showPickedInTable);
  views_.in_table.setUnfolded(true);
  showPickedInTable();
}

void FindingPresenter::setReconstruction(const std::shared_ptr<const Reconstruction>& reconstruction) {
  known_.reset();
  by_weight_.clear();
  if (reconstruction) {
    std::ranges::copy_if(reconstruction->findings, std::back_inserter(by_weight_),
                         [](const Finding& finding) { return finding.severity != Severity::Info; });
    std::ranges::stable_sort(by_weight_, std::ranges::greater(), &Finding::severity);
  }
  refresh();
}

void FindingPresenter::refresh() {
  const LiveSession& live = controller_.liveSession();
  const auto now = std::make_tuple(controller_.submittedRevision(), live.isLive(), live.litCell(),
                                   actions_.show_next_pose->isEnabled());
  if (known_ == now) return;
  known_ = now;
  std::vector<FindingCards::Item> in_check;
  std::vector<FindingCards::Item> in_review;
  for (const Finding& finding : by_weight_) {
    const FindingCards::Item item{finding, offersFor(finding)};
    in_review.push_back(item);
    if (isAboutTheReport(finding)) in_check.push_back(item);
  }
  views_.in_check.setItems(in_check);
  views_.in_review.setItems(in_review);
  showPickedInTable();
}

/// Without a row that is picked it is about the first, which is the worst.
void FindingPresenter::showPickedInTable() {
  const QModelIndexList rows = views_.table_view.selectionModel()->selectedRows();
  const int row = rows.isEmpty() ? 0 : rows.front().row();
  const bool any = row < views_.table.rowCount();
  views_.in_table.setVisible(any);
  if (any) views_.in_table.setFinding(views_.table.findingAt(row), offersFor(views_.table.findingAt(row)));
}

std::optional<std::size_t> FindingPresenter::poseOf(const Finding& finding) const {
  if (finding.poses.empty() || !controller_.session()) return std::nullopt;
  const auto& poses = controller_.session()->poses();
  const auto found =
      std::ranges::find_if(poses, [&](const SessionPose& pose) { return pose.capture->id == finding.poses.front(); });
  return found == poses.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - poses.begin()));
}

std::vector<FindingOffer> FindingPresenter::offersFor(const Finding& finding) const {
  std::vector<FindingOffer> offers;
  for (const FindingRemedy remedy : adviceOn(finding.code).remedies) {
    if (const std::optional<QString> text = offer(remedy, finding)) offers.push_back({remedy, *text});
  }
  return offers;
}

std::optional<QString> FindingPresenter::offer(FindingRemedy remedy, const Finding& finding) const {
  const Session* session = controller_.session();
  const LiveSession& live = controller_.liveSession();
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
      if (!actions_.show_next_pose->isEnabled()) return std::nullopt;
      return session != nullptr && session->poses().empty() ? tr("Take the first pose") : tr("Take another pose");
    case FindingRemedy::LightCell:
      if (finding.cells.empty() || !live.isLive() || !live.source().skin() || !live.source().skin()->can_light_cells) {
        return std::nullopt;
      }
      return live.litCell() == finding.cells.front() ? tr("Light off")
                                                     : tr("Light cell %1").arg(finding.cells.front().value());
  }
  return std::nullopt;
}

void FindingPresenter::apply(const Finding& finding, FindingRemedy remedy) {
  // It may have gone since the button was drawn.
  if (!offer(remedy, finding)) return;
  switch (remedy) {
    case FindingRemedy::MuteLink: {
      const bool muted = controller_.session()->findMutedLink(firstEnd(finding), secondEnd(finding)) != nullptr;
      selection_.selectLink(firstEnd(finding), secondEnd(finding));
      controller_.setLinkMuted(firstEnd(finding), secondEnd(finding), !muted);
      break;
    }
    case FindingRemedy::DisablePose: {
      const std::size_t index = *poseOf(finding);
      controller_.setPoseDisabled(index, !controller_.session()->poses()[index].disabled);
      break;
    }
    case FindingRemedy::RecapturePose:
      review_.pickPose(finding.poses.front());
      if (actions_.recapture->isEnabled()) actions_.recapture->trigger();
      break;
    case FindingRemedy::TakePose:
      actions_.show_next_pose->trigger();
      break;
    case FindingRemedy::LightCell: {
      const CellId cell = finding.cells.front();
      const bool is_lit = controller_.liveSession().litCell() == cell;
      selection_.seekCell(cell);
      controller_.liveSession().lightCell(is_lit ? std::nullopt : std::optional(cell));
      break;
    }
  }
}

}  // namespace hexoderm
