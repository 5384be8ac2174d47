#include "app/window/presenters/presenters.h"

#include "hexoderm/solve/checks/evaluation.h"
#include "widgets/scene/patch_moment.h"

#include <memory>
#include <optional>

namespace hexoderm {
namespace {

/// Brings the plot to the front, with the keyboard; where it is there already, closes it.
void togglePlot(CardDock& dock, PlotView& plot) {
  // Behind another tab it is neither hidden nor seen.
  if (dock.isVisible() && !plot.visibleRegion().isEmpty()) {
    dock.close();
    return;
  }
  dock.show();
  dock.raise();
  plot.setFocus(Qt::ShortcutFocusReason);
}

}  // namespace

void connectPlot(const WindowParts& parts) {
  PlotView* const plot = parts.views.plot;
  QObject::connect(parts.actions.plot, &QAction::triggered, &parts.wires,
                   [&parts, plot] { togglePlot(parts.panels.plot(), *plot); });
  QObject::connect(parts.views.verify_panel, &VerifyPanel::surfaceShown, &parts.wires,
                   [plot](const std::optional<SurfaceEvaluation>& surface) {
                     plot->setSurface(surface ? std::make_shared<const SurfaceEvaluation>(*surface) : nullptr);
                   });
  const LiveSource& source = parts.controller.liveSession().source();
  QObject::connect(&source, &LiveSource::previewChanged, &parts.wires, [plot, &source] {
    if (plot->isVisible()) plot->setReadings(readingsOf(source.preview().means, source.preview().temperatures));
  });
  QObject::connect(&source, &LiveSource::statusChanged, &parts.wires, [plot, &source] {
    // The last readings of a skin that does not send are not those of this moment.
    if (!source.isRunning() || source.status().state != SourceState::Streaming) plot->setReadings(nullptr);
  });
}

}  // namespace hexoderm
