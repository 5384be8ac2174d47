#include "app/window/presenters/presenters.h"

#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <algorithm>

namespace hexoderm {
namespace {

/// Says beside the views what is open, in the title of the window, the status bar, the headings of the panels.
class StatusPresenter : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::StatusPresenter)

 public:
  explicit StatusPresenter(const WindowParts& parts) : Presenter(parts) {}

  void refresh() override {
    refreshName();
    refreshResult();
    refreshPanels();
    views_.status->setSaved(savedInWords());
  }

 private:
  void refreshName() const {
    const QString name = controller_.isEmpty() ? tr("No skin") : controller_.file().name();
    views_.session_name->setText(controller_.isEmpty() ? QString() : name);
    window_.setWindowTitle(controller_.isEmpty() ? tr("Hexoderm") : tr("%1[*] · Hexoderm").arg(name));
    window_.setWindowModified(controller_.file().hasUnsavedChanges());
    // Where a skin is connected, the presenter of the connection says more.
    if (controller_.liveSession().source().isRunning()) return;
    views_.status->setSource(QStringLiteral("● ") +
                             (controller_.work().activity().isEmpty() ? name : controller_.work().activity() + "…"));
  }

  /// From a second on in seconds.
  static QString durationInWords(double seconds) {
    return seconds < 1 ? tr("%1 ms").arg(figureInWords(1e3 * seconds, 1)) : tr("%1 s").arg(figureInWords(seconds, 1));
  }

  void refreshResult() const {
    const Reconstruction* result = controller_.reconstruction().get();
    if (!result) {
      views_.status->setCells({});
      views_.status->setSolve({});
      return;
    }
    std::size_t measured = 0;
    for (const PoseSummary& pose : result->poses) {
      if (pose.enabled) measured = std::max(measured, pose.cells_measured);
    }
    views_.status->setCells(
        result->poses.empty() ? QString() : tr("cells %1/%2").arg(measured).arg(result->cellCount()),
        tr("Cells that were measured in the fullest pose, of all cells"));
    views_.status->setSolve(
        controller_.session() ? tr("solved in %1 · %2")
                                    .arg(durationInWords(result->solve_seconds), QString::fromStdString(result->solver))
                              : tr("%1, read from the file").arg(QString::fromStdString(result->solver)),
        tr("How long the last result took to work out, and by which method: global uses all links and poses at once, "
           "tree "
           "goes from cell to cell as in the paper"));
  }

  QString savedInWords() const {
    if (controller_.file().hasUnsavedChanges())
      return controller_.file().isKept() ? tr("not on disk") : tr("not saved");
    if (!controller_.file().savedAt().isValid()) return {};
    return tr("saved at %1").arg(controller_.file().savedAt().toString(QStringLiteral("HH:mm")));
  }

  void refreshPanels() const {
    const Reconstruction* result = controller_.reconstruction().get();
    panels_.graph().setRemark(result ? words(sizeInWords(*result)) : QString());
    const bool has_poses = controller_.session() && !controller_.session()->poses().empty();
    const QString keys = controller_.liveSession().isLive() ? tr("R recapture · Del disable · Ctrl+Z undo")
                                                            : tr("Del disable · Ctrl+Z undo");
    panels_.poses().setRemark(has_poses ? keys : QString());
    QTabBar& tabs = *views_.detail_tabs;
    tabs.setTabText(0, result ? tr("Findings %1").arg(result->findings.size()) : tr("Findings"));
    tabs.setTabText(1, result ? tr("Links %1").arg(result->linkCount()) : tr("Links"));
    tabs.setTabText(2, result ? tr("Cells %1").arg(result->cellCount()) : tr("Cells"));
  }
};

}  // namespace

std::unique_ptr<Presenter> makeStatusPresenter(const WindowParts& parts) {
  return std::make_unique<StatusPresenter>(parts);
}

}  // namespace hexoderm
