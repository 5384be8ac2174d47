#pragma once

#include "app/window/guide/guide.h"
#include "app/window/presenters/presenter.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/controls/view_mark.h"
#include "widgets/words/formatting.h"

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>

namespace hexoderm {

/// Says of the pictures when they are not what they usually are (live, without readings, preliminary, from before), and
/// what is being done while a result takes long.
class MarkPresenter : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::MarkPresenter)

 public:
  explicit MarkPresenter(const WindowParts& parts) : Presenter(parts) {
    constexpr int kPatience_ms = 700;
    constexpr int kTick_ms = 500;
    tick_.setInterval(kTick_ms);
    setUpOnce(patience_, kPatience_ms, this, [this] {
      is_long_ = true;
      tick_.start();
      refresh();
    });
    connect(&tick_, &QTimer::timeout, this, &MarkPresenter::showProgress);
    connect(views.work_notice, &WorkNotice::cancelled, &controller, &SessionController::cancelSolving);
    connect(actions.cancel_solving, &QAction::triggered, &controller, &SessionController::cancelSolving);
    connect(actions.solve_again, &QAction::triggered, &controller, &SessionController::solveAgain);
  }

  void refresh() {
    refreshWork();
    refreshMarks();
  }

 private:
  void refreshWork() {
    if (!controller.isSolving()) {
      patience_.stop();
      tick_.stop();
      is_long_ = false;
      views.work_notice->hide();
    } else if (is_long_) {
      showProgress();
    } else if (!patience_.isActive()) {
      since_.start();
      patience_.start();
    }
  }

  static QString stageText(const SolveProgress& progress) {
    switch (progress.stage()) {
      case SolveStage::Links:
        return tr("estimating every link");
      case SolveStage::Patches:
        return progress.patches() < 2
                   ? tr("placing all cells together")
                   : tr("placing the cells of patch %1 of %2").arg(progress.patch() + 1).arg(progress.patches());
      case SolveStage::Findings:
        return tr("looking for what does not fit");
      case SolveStage::Figures:
        return tr("working out how certain it is");
    }
    return {};
  }

  void showProgress() {
    const SolveProgress& progress = controller.progress();
    constexpr qint64 kSecond_ms = 1000;
    const QString what = tr("Working out the result of %1: %2 · %3 s")
                             .arg(posesText(controller.enabledPoses()), stageText(progress),
                                  QLocale().toString(since_.elapsed() / kSecond_ms));
    const bool counts = progress.stage() == SolveStage::Patches;
    views.work_notice->showWork(what, static_cast<int>(progress.patch()),
                                counts ? static_cast<int>(progress.patches()) : 0);
  }

  /// The picture shows a result of another state of the session.
  bool isOld() const {
    if (!controller.reconstruction() || controller.isCurrent()) return false;
    return is_long_ || !controller.isSolving();
  }

  void refreshMarks() {
    std::optional<ViewMark::Content> middle;
    std::optional<ViewMark::Content> side;
    if (isDeviceLost(controller)) {
      middle = {Tone::Bad, tr("✕ No readings from the skin: check cable, power and address"), true, false};
      side = {Tone::Bad, tr("✕ No readings"), true, false};
    } else if (controller.liveMode().isOn()) {
      middle = {Tone::Neutral, tr("● Live: the readings of this moment, not the result"), true, false};
      side = {Tone::Neutral, tr("● Live"), true, false};
    } else if (controller.firstPlacements()) {
      middle = {Tone::Caution, tr("preliminary: not fully checked yet, without uncertainty"), false, true};
      side = {Tone::Caution, tr("preliminary"), false, true};
    } else if (isOld()) {
      const auto& poses = controller.reconstruction()->poses;
      const auto used = static_cast<std::size_t>(std::ranges::count(poses, true, &PoseSummary::enabled));
      middle = side = {Tone::Caution, tr("from before: %1").arg(posesText(used)), false, true};
    }
    panels.middleMark().setContent(middle);
    panels.sideMark().setContent(side);
  }

  QTimer patience_;  ///< what is done before it ends is not worth a word
  QTimer tick_;
  QElapsedTimer since_;
  bool is_long_ = false;
};

}  // namespace hexoderm
