#include "app/window/presenters/mark_presenter.h"

#include "app/window/guide/actions.h"
#include "app/window/guide/guide.h"
#include "app/window/session/session_controller.h"
#include "widgets/controls/view_mark.h"
#include "widgets/controls/work_notice.h"
#include "widgets/words/formatting.h"

#include <QLocale>
#include <algorithm>

namespace hexoderm {
namespace {

QString stageInWords(const SolveProgress& progress) {
  switch (progress.stage()) {
    case SolveStage::Links:
      return MarkPresenter::tr("estimating every link");
    case SolveStage::Patches:
      return progress.patches() < 2 ? MarkPresenter::tr("placing all cells together")
                                    : MarkPresenter::tr("placing the cells of patch %1 of %2")
                                          .arg(progress.patch() + 1)
                                          .arg(progress.patches());
    case SolveStage::Findings:
      return MarkPresenter::tr("looking for what does not fit");
    case SolveStage::Figures:
      return MarkPresenter::tr("working out how certain it is");
  }
  return {};
}

}  // namespace

MarkPresenter::MarkPresenter(const Views& views, SessionController& controller, const WindowActions& actions)
    : views_(views), controller_(controller) {
  constexpr int kPatience_ms = 700;
  constexpr int kTick_ms = 500;
  patience_.setSingleShot(true);
  patience_.setInterval(kPatience_ms);
  tick_.setInterval(kTick_ms);
  connect(&patience_, &QTimer::timeout, this, [this] {
    is_long_ = true;
    tick_.start();
    refresh();
  });
  connect(&tick_, &QTimer::timeout, this, &MarkPresenter::showProgress);
  connect(&views_.notice, &WorkNotice::cancelled, &controller_, &SessionController::cancelSolving);
  connect(actions.cancel_solving, &QAction::triggered, &controller_, &SessionController::cancelSolving);
  connect(actions.solve_again, &QAction::triggered, &controller_, &SessionController::solveAgain);
}

void MarkPresenter::refresh() {
  refreshWork();
  refreshMarks();
}

void MarkPresenter::refreshWork() {
  if (!controller_.isSolving()) {
    patience_.stop();
    tick_.stop();
    is_long_ = false;
    views_.notice.hide();
  } else if (is_long_) {
    showProgress();
  } else if (!patience_.isActive()) {
    since_.start();
    patience_.start();
  }
}

void MarkPresenter::showProgress() {
  const SolveProgress& progress = controller_.progress();
  constexpr qint64 kSecond_ms = 1000;
  const QString what = tr("Working out the result of %1: %2 · %3 s")
                           .arg(posesInWords(controller_.enabledPoses()), stageInWords(progress),
                                QLocale().toString(since_.elapsed() / kSecond_ms));
  const bool counts = progress.stage() == SolveStage::Patches;
  views_.notice.showWork(what, static_cast<int>(progress.patch()), counts ? static_cast<int>(progress.patches()) : 0);
}

bool MarkPresenter::isOld() const {
  if (!controller_.reconstruction() || controller_.isCurrent()) return false;
  return is_long_ || !controller_.isSolving();
}

void MarkPresenter::refreshMarks() {
  std::optional<ViewMark::Content> middle;
  std::optional<ViewMark::Content> side;
  if (isDeviceLost(controller_)) {
    middle = {Tone::Bad, tr("✕ No readings from the skin: check cable, power and address"), true, false};
    side = {Tone::Bad, tr("✕ No readings"), true, false};
  } else if (controller_.liveMode().isOn()) {
    middle = {Tone::Neutral, tr("● Live: the readings of this moment, not the result"), true, false};
    side = {Tone::Neutral, tr("● Live"), true, false};
  } else if (controller_.firstPlacements()) {
    middle = {Tone::Caution, tr("preliminary: not fully checked yet, without uncertainty"), false, true};
    side = {Tone::Caution, tr("preliminary"), false, true};
  } else if (isOld()) {
    const auto& poses = controller_.reconstruction()->poses;
    const auto used = static_cast<std::size_t>(std::ranges::count(poses, true, &PoseSummary::enabled));
    middle = side = {Tone::Caution, tr("from before: %1").arg(posesInWords(used)), false, true};
  }
  views_.middle.setContent(middle);
  views_.side.setContent(side);
}

}  // namespace hexoderm
