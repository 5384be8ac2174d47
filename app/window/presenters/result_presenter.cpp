#include "app/window/presenters/result_presenter.h"

#include "app/window/guide/guide.h"
#include "app/window/session/session_controller.h"
#include "widgets/controls/heavy_turn.h"

#include <utility>

namespace hexoderm {

ResultPresenter::ResultPresenter(SessionController& controller) : controller_(controller) {
  connect(&controller_, &SessionController::reconstructionChanged, this, &ResultPresenter::handOut);
  connect(&controller_, &SessionController::firstPlacementsChanged, this, [this] {
    if (!controller_.liveMode().isOn()) handToPictures(pictured());
  });
  connect(&controller_.liveMode(), &LiveMode::momentSolved, this, [this](const Result& moment) {
    if (controller_.liveMode().isOn()) handToPictures(moment);
  });
  connect(&controller_.liveMode(), &LiveMode::toggled, this, [this](bool on) {
    if (!on) handToPictures(pictured());
  });
}

void ResultPresenter::refresh() {
  const QString awaited = describeAwaited(controller_);
  if (std::exchange(awaited_, awaited) == awaited) return;
  for (const auto& tell : waiting_) tell(awaited);
}

void ResultPresenter::handOut(const Result& result) {
  for (const Receiver& receiver : receivers_) {
    if (!receiver.is_picture || !controller_.liveMode().isOn()) receiver.set(result);
  }
  HeavyTurn::note();
  emit handedOut();
}

ResultPresenter::Result ResultPresenter::pictured() const {
  return controller_.firstPlacements() ? controller_.firstPlacements() : controller_.reconstruction();
}

void ResultPresenter::handToPictures(const Result& result) {
  for (const Receiver& receiver : receivers_) {
    if (receiver.is_picture) receiver.set(result);
  }
}

}  // namespace hexoderm
