#include "app/window/presenters/presenters.h"

#include "app/window/guide/guide.h"

#include <algorithm>
#include <vector>

namespace hexoderm {
namespace {

/// Leads the operator from step to step: the banner, the steps, the list of what was checked.
class GuidePresenter : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::GuidePresenter)

 public:
  explicit GuidePresenter(const WindowParts& parts) : Presenter(parts) {
    connect(&controller_, &SessionController::opened, this, [this] {
      const Session* session = controller_.session();
      // A robot was chosen, and its patches wait for their places.
      const bool waits_for_places = session != nullptr && session->robot() &&
                                    std::ranges::none_of(session->placements(), [](const PatchPlacement& placement) {
                                      return placement.place.has_value();
                                    });
      const GuideStep step = controller_.liveSession().source().isRunning() ? GuideStep::Capture
                             : waits_for_places                             ? GuideStep::Place
                             : session != nullptr                           ? GuideStep::Review
                                                                            : GuideStep::Export;
      views_.steps->openStep(static_cast<int>(step));
    });
  }

  /// Shows where the operator stands. The actions have to know already which of them can be used.
  void refresh() override {
    views_.banner->setContent(describeStand(controller_, actions_));
    const std::shared_ptr<const Reconstruction>& result = controller_.reconstruction();
    const LiveSource& live = controller_.liveSession().source();
    const SkinCheck check =
        result ? checkSkin(*result, live.preview().means, live.hold().stillness.odd_cells) : SkinCheck{};
    views_.check_list->setCheck(check);
    const std::vector<Step> steps = describeSteps(controller_, actions_, check);
    views_.steps->setSteps(steps);
    nameStepActions(steps);
  }

 private:
  /// The keys to the steps are named after them.
  void nameStepActions(const std::vector<Step>& steps) const {
    for (std::size_t k = 0; k < actions_.go_to_step.size(); ++k) {
      QAction* action = actions_.go_to_step[k];
      const bool is_there = k < steps.size();
      action->setVisible(is_there);
      action->setEnabled(is_there);
      if (is_there) action->setText(tr("Step &%1: %2").arg(k + 1).arg(steps[k].title));
    }
  }
};

}  // namespace

std::unique_ptr<Presenter> makeGuidePresenter(const WindowParts& parts) {
  return std::make_unique<GuidePresenter>(parts);
}

}  // namespace hexoderm
