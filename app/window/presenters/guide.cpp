#include "app/window/presenters/presenters.h"

#include "app/window/guide/guide.h"

#include <algorithm>
#include <vector>

namespace hexoderm {
namespace {

/// Where to go on with what was just opened.
GuideStep firstStepOf(const SessionController& controller) {
  if (controller.liveSession().source().isRunning()) return GuideStep::Capture;
  const Session* session = controller.session();
  if (session == nullptr) return GuideStep::Export;
  // A robot was chosen, and its patches wait for their places.
  const bool waits_for_places =
      session->robot() && std::ranges::none_of(session->placements(), [](const PatchPlacement& placement) {
        return placement.place.has_value();
      });
  return waits_for_places ? GuideStep::Place : GuideStep::Review;
}

void refreshSpeech(const WindowParts& parts) {
  const SessionController& controller = parts.controller;
  QString instruction;
  if (controller.liveSession().source().isRunning() && !controller.liveMode().isOn()) {
    if (!controller.liveSession().isRobotOn()) instruction = parts.views.capture_panel->instruction();
    if (instruction.isEmpty()) instruction = describeStand(controller, parts.actions).sentence;
  }
  parts.views.voice->setInstruction(instruction);
}

}  // namespace

void connectGuide(const WindowParts& parts) {
  StepPanel* const steps = parts.views.steps;
  QObject::connect(&parts.controller, &SessionController::opened, steps, [steps, &controller = parts.controller] {
    steps->openStep(static_cast<int>(firstStepOf(controller)));
  });
  QObject::connect(parts.views.capture_panel, &CapturePanel::instructionChanged, &parts.wires,
                   [&parts] { refreshSpeech(parts); });
  const auto follow = [&parts] { parts.views.voice->setEnabled(parts.preferences.isOn(Switch::Speech)); };
  follow();
  QObject::connect(&parts.preferences, &Preferences::switched, &parts.wires, follow);
}

void refreshGuide(const WindowParts& parts) {
  parts.views.banner->setContent(describeStand(parts.controller, parts.actions));
  const std::shared_ptr<const Reconstruction>& result = parts.controller.reconstruction();
  const LiveSource& live = parts.controller.liveSession().source();
  const SkinCheck check =
      result ? checkSkin(*result, live.preview().means, live.hold().stillness.odd_cells) : SkinCheck{};
  parts.views.check_list->setCheck(check);
  const std::vector<Step> steps = describeSteps(parts.controller, parts.actions, check);
  parts.views.steps->setSteps(steps);
  // The keys to the steps are named after them.
  for (std::size_t k = 0; k < parts.actions.go_to_step.size(); ++k) {
    QAction* action = parts.actions.go_to_step[k];
    const bool is_there = k < steps.size();
    action->setVisible(is_there);
    action->setEnabled(is_there);
    if (is_there) action->setText(WindowParts::tr("Step &%1: %2").arg(k + 1).arg(steps[k].title));
  }
  refreshSpeech(parts);
}

}  // namespace hexoderm
