#include "app/window/presenters/presenters.h"

#include "app/window/guide/guide.h"
#include "app/window/presenters/review_presenter.h"

#include <QTableView>
#include <optional>

namespace hexoderm {
namespace {

/// Carries out the commands that change the pose, the link or the cell that is picked, or the pose that the assessment
/// picks.
class PickedCommands : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PickedCommands)

 public:
  PickedCommands(const WindowParts& parts, const ReviewPresenter& review) : Presenter(parts), review_(review) {
    views_.graph->setLinkActions({actions_.mute_link});
    views_.graph->setCellActions({actions_.light_cell});
    views_.tables.link_view->setContextMenuPolicy(Qt::ActionsContextMenu);
    views_.tables.link_view->addAction(actions_.mute_link);
    connect(actions_.toggle_pose, &QAction::triggered, this, &PickedCommands::togglePose);
    connect(actions_.delete_pose, &QAction::triggered, this, &PickedCommands::removePose);
    connect(actions_.recapture, &QAction::triggered, this, [this] { recapturePose(pickedPose()); });
    connect(actions_.retake, &QAction::triggered, this, [this] { recapturePose(controller_.indexToRetake()); });
    connect(actions_.mute_link, &QAction::triggered, this, &PickedCommands::muteLink);
    connect(actions_.light_cell, &QAction::triggered, this,
            [this](bool on) { controller_.liveSession().lightCell(on ? selection_.cell() : std::nullopt); });
    connect(&review_, &ReviewPresenter::pickedPoseChanged, this, &PickedCommands::refresh);
    connect(&selection_, &Selection::changed, this, [this] {
      // The light on the skin follows what is picked here.
      if (controller_.liveSession().litCell() && selection_.cell())
        controller_.liveSession().lightCell(selection_.cell());
      refresh();
    });
  }

  /// Tells the actions of the window which of them can be used with what is picked.
  void refresh() override {
    actions_.refresh(controller_, review_.pickedPoseRow(), selection_.cell());
    actions_.refreshLink(controller_, selection_.link());
    // An offer to call off a recapture that is done, or called off elsewhere.
    if (!controller_.liveSession().recapturing() && views_.messages->text() == recapture_offer_)
      views_.messages->hide();
  }

 private:
  /// Of the picked pose among the session's.
  std::optional<std::size_t> pickedPose() const {
    const std::optional<int> row = review_.pickedPoseRow();
    return row ? controller_.sessionIndexOfPoseRow(*row) : std::nullopt;
  }

  void togglePose() {
    const std::optional<std::size_t> index = pickedPose();
    if (index) controller_.setPoseDisabled(*index, !controller_.session()->poses()[*index].disabled);
  }

  void removePose() {
    if (const std::optional<std::size_t> index = pickedPose()) controller_.removePose(*index);
  }

  /// The pose at `index` of the session, or none any more, if it is that already.
  void recapturePose(std::optional<std::size_t> index) {
    if (!index) return;
    const PoseId pose = controller_.session()->poses()[*index].capture->id;
    if (controller_.liveSession().recapturing() == pose) {
      controller_.liveSession().cancelRecapture();
      return;
    }
    controller_.liveSession().recapturePose(*index);
    views_.steps->openStep(static_cast<int>(GuideStep::Capture));
    recapture_offer_ =
        tr("The next capture takes the place of pose %1. Hold the part as it was held then.").arg(pose.value());
    views_.messages->showMessage(Tone::Neutral, recapture_offer_, tr("Don't recapture"),
                                 [this] { controller_.liveSession().cancelRecapture(); });
  }

  void muteLink() {
    const std::optional<Selection::Link> link = selection_.link();
    if (!link || !controller_.session()) return;
    controller_.setLinkMuted(link->first, link->second,
                             !controller_.session()->findMutedLink(link->first, link->second));
  }

  const ReviewPresenter& review_;
  QString recapture_offer_;  ///< the message that offers to call the recapture off
};

}  // namespace

std::unique_ptr<Presenter> makePickedCommands(const WindowParts& parts, const ReviewPresenter& review) {
  return std::make_unique<PickedCommands>(parts, review);
}

}  // namespace hexoderm
