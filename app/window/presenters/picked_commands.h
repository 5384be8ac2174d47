#pragma once

#include "app/window/guide/guide.h"
#include "app/window/presenters/presenter.h"
#include "app/window/presenters/review_presenter.h"

#include <QTableView>
#include <optional>

namespace hexoderm {

/// Carries out the commands that change the pose, the link or the cell that is picked, or the pose that the assessment
/// picks.
class PickedCommands : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PickedCommands)

 public:
  PickedCommands(const WindowParts& parts, const ReviewPresenter& review) : Presenter(parts), review_(review) {
    views.graph->setLinkActions({actions.exclude_link});
    views.graph->setCellActions({actions.light_cell});
    views.tables.link_view->setContextMenuPolicy(Qt::ActionsContextMenu);
    views.tables.link_view->addAction(actions.exclude_link);
    connect(actions.toggle_pose, &QAction::triggered, this, &PickedCommands::togglePose);
    connect(actions.delete_pose, &QAction::triggered, this, &PickedCommands::removePose);
    connect(actions.recapture, &QAction::triggered, this, [this] { recapturePose(pickedPose()); });
    connect(actions.retake, &QAction::triggered, this, [this] { recapturePose(controller.indexToRetake()); });
    connect(actions.exclude_link, &QAction::triggered, this, &PickedCommands::excludeLink);
    connect(actions.light_cell, &QAction::triggered, this,
            [this](bool on) { controller.liveSession().lightCell(on ? selection.cell() : std::nullopt); });
    connect(&review_, &ReviewPresenter::pickedPoseChanged, this, &PickedCommands::refresh);
    connect(&selection, &Selection::changed, this, [this] {
      // The light on the skin follows what is picked here.
      if (controller.liveSession().litCell() && selection.cell()) controller.liveSession().lightCell(selection.cell());
      refresh();
    });
  }

  /// Tells the actions of the window which of them can be used with what is picked.
  void refresh() {
    actions.refresh(controller, review_.pickedPoseRow(), selection.cell());
    actions.refreshLink(controller, selection.link());
    // An offer to call off a recapture that is done, or called off elsewhere.
    if (!controller.liveSession().recapturing() && views.messages->text() == recapture_offer_) views.messages->hide();
  }

 private:
  /// Of the picked pose among the session's.
  std::optional<std::size_t> pickedPose() const {
    const std::optional<int> row = review_.pickedPoseRow();
    return row ? controller.sessionIndexOfPoseRow(*row) : std::nullopt;
  }

  void togglePose() {
    const std::optional<std::size_t> index = pickedPose();
    if (index) controller.setPoseDisabled(*index, !controller.session()->poses()[*index].disabled);
  }

  void removePose() {
    if (const std::optional<std::size_t> index = pickedPose()) controller.removePose(*index);
  }

  /// The pose at `index` of the session, or none any more, if it is that already.
  void recapturePose(std::optional<std::size_t> index) {
    if (!index) return;
    const PoseId pose = controller.session()->poses()[*index].capture->id;
    if (controller.liveSession().recapturing() == pose) {
      controller.liveSession().cancelRecapture();
      return;
    }
    controller.liveSession().recapturePose(*index);
    views.steps->openStep(static_cast<int>(GuideStep::Capture));
    recapture_offer_ =
        tr("The next capture takes the place of pose %1. Hold the part as it was held then.").arg(pose.value());
    views.messages->showMessage(Tone::Neutral, recapture_offer_, tr("Don't recapture"),
                                [this] { controller.liveSession().cancelRecapture(); });
  }

  void excludeLink() {
    const std::optional<Selection::Link> link = selection.link();
    if (!link || !controller.session()) return;
    controller.setLinkMuted(link->first, link->second, !controller.session()->findMutedLink(link->first, link->second));
  }

  const ReviewPresenter& review_;
  QString recapture_offer_;  ///< the message that offers to call the recapture off
};

}  // namespace hexoderm
