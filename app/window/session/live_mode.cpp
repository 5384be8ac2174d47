#include "app/window/session/live_mode.h"

#include "app/window/session/session_controller.h"
#include "widgets/words/words.h"

#include <QMetaObject>
#include <utility>

namespace hexoderm {

LiveMode::LiveMode(SessionController& controller)
    : controller_(controller), worker_([this](ReconstructionOutcome outcome) {
        QMetaObject::invokeMethod(
            this, [this, outcome = std::move(outcome)] { receive(outcome); }, Qt::QueuedConnection);
      }) {}

void LiveMode::setOn(bool on) {
  on = on && controller_.liveSession().isLive();
  if (is_on_ == on) return;
  is_on_ = on;
  fails_ = false;
  emit toggled(on);
}

void LiveMode::solve() {
  const std::vector<CellSample>& means = controller_.liveSession().source().preview().means;
  if (!is_on_ || !controller_.session() || means.empty()) return;
  auto moment = std::make_shared<SessionSnapshot>(*controller_.session()->snapshot());
  auto capture = std::make_shared<PoseCapture>();
  capture->id = PoseId(1);
  capture->label = message("now");
  for (const CellSample& mean : means) {
    GravitySample sample;
    sample.cell = mean.cell;
    sample.mean_g = mean.acceleration_g;
    capture->samples.push_back(sample);
  }
  moment->poses = {{std::move(capture), false, {}}};
  SolverOptions options = controller_.solverOptions();
  options.solver = Solver::Tree;  // the paper's self-refreshing test; quick enough for every preview
  worker_.submit(std::move(moment), options);
}

void LiveMode::receive(const ReconstructionOutcome& outcome) {
  if (!is_on_) return;
  if (outcome.reconstruction) {
    fails_ = false;
    emit momentSolved(outcome.reconstruction);
  } else if (!std::exchange(fails_, true)) {
    emit controller_.noticed(
        tr("What is shown stands still: the skin as it is now can't be solved. %1").arg(words(outcome.error)));
  }
}

}  // namespace hexoderm
