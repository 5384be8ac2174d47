#include "app/window/presenters/presenters.h"

#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <algorithm>

namespace hexoderm {
namespace {

void refreshName(const WindowParts& parts) {
  const QString name = parts.controller.isEmpty() ? WindowParts::tr("No skin") : parts.controller.file().name();
  parts.views.session_name->setText(parts.controller.isEmpty() ? QString() : name);
  parts.window.setWindowTitle(parts.controller.isEmpty() ? WindowParts::tr("Hexoderm")
                                                         : WindowParts::tr("%1[*] · Hexoderm").arg(name));
  parts.window.setWindowModified(parts.controller.file().hasUnsavedChanges());
  // Where a skin is connected, the presenter of the connection says more.
  if (parts.controller.liveSession().source().isRunning()) return;
  parts.views.status->setSource(QStringLiteral("● ") + (parts.controller.work().activity().isEmpty()
                                                            ? name
                                                            : parts.controller.work().activity() + "…"));
}

/// From a second on in seconds.
QString durationText(double seconds) {
  return seconds < 1 ? WindowParts::tr("%1 ms").arg(figureText(1e3 * seconds, 1))
                     : WindowParts::tr("%1 s").arg(figureText(seconds, 1));
}

void refreshResult(const WindowParts& parts) {
  const Reconstruction* result = parts.controller.reconstruction().get();
  if (!result) {
    parts.views.status->setCells({});
    parts.views.status->setSolve({});
    return;
  }
  std::size_t measured = 0;
  for (const PoseSummary& pose : result->poses) {
    if (pose.enabled) measured = std::max(measured, pose.cells_measured);
  }
  parts.views.status->setCells(
      result->poses.empty() ? QString() : WindowParts::tr("cells %1/%2").arg(measured).arg(result->cellCount()),
      WindowParts::tr("Cells that were measured in the fullest pose, of all cells"));
  parts.views.status->setSolve(
      parts.controller.session()
          ? WindowParts::tr("solved in %1 · %2")
                .arg(durationText(result->solve_seconds), QString::fromStdString(result->solver))
          : WindowParts::tr("%1, read from the file").arg(QString::fromStdString(result->solver)),
      WindowParts::tr(
          "How long the last result took to work out, and by which method: global uses all links and poses at once, "
          "tree "
          "goes from cell to cell as in the paper"));
}

QString savedText(const WindowParts& parts) {
  if (parts.controller.file().hasUnsavedChanges())
    return parts.controller.file().isKept() ? WindowParts::tr("not on disk") : WindowParts::tr("not saved");
  if (!parts.controller.file().savedAt().isValid()) return {};
  return WindowParts::tr("saved at %1").arg(parts.controller.file().savedAt().toString(QStringLiteral("HH:mm")));
}

void refreshPanels(const WindowParts& parts) {
  const Reconstruction* result = parts.controller.reconstruction().get();
  parts.panels.graph().setRemark(result ? words(sizeText(*result)) : QString());
  const bool has_poses = parts.controller.session() && !parts.controller.session()->poses().empty();
  const QString keys = parts.controller.liveSession().isLive()
                           ? WindowParts::tr("R recapture · Del disable · Ctrl+Z undo")
                           : WindowParts::tr("Del disable · Ctrl+Z undo");
  parts.panels.poses().setRemark(has_poses ? keys : QString());
  QTabBar& tabs = *parts.views.detail_tabs;
  tabs.setTabText(0,
                  result ? WindowParts::tr("Findings %1").arg(result->findings.size()) : WindowParts::tr("Findings"));
  tabs.setTabText(1, result ? WindowParts::tr("Links %1").arg(result->linkCount()) : WindowParts::tr("Links"));
  tabs.setTabText(2, result ? WindowParts::tr("Cells %1").arg(result->cellCount()) : WindowParts::tr("Cells"));
}

}  // namespace

void refreshStatus(const WindowParts& parts) {
  refreshName(parts);
  refreshResult(parts);
  refreshPanels(parts);
  parts.views.status->setSaved(savedText(parts));
}

}  // namespace hexoderm
