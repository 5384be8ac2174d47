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

void connectViewCommands(const WindowParts& parts) {
  const WindowActions& actions = parts.actions;
  Panels* const panels = &parts.panels;
  PatchView* const patch = parts.views.patch;
  GraphView* const graph = parts.views.graph;
  StepPanel* const steps = parts.views.steps;
  QObject::connect(actions.fit, &QAction::triggered, graph, &GraphView::fit);
  QObject::connect(actions.fit, &QAction::triggered, patch, &PatchView::fit);
  QObject::connect(actions.fit, &QAction::triggered, parts.views.robot, &RobotView::fit);
  const std::pair<QAction*, PatchView::StandardView> looks[] = {
      {actions.front, PatchView::StandardView::Front},
      {actions.side, PatchView::StandardView::Side},
      {actions.top, PatchView::StandardView::Top},
      {actions.back, PatchView::StandardView::Back},
      {actions.isometric, PatchView::StandardView::Isometric}};
  for (const auto& [action, view] : looks) {
    QObject::connect(action, &QAction::triggered, patch, [patch, look = view] { patch->showStandardView(look); });
  }
  QObject::connect(actions.swap_views, &QAction::triggered, panels, &Panels::swapViews);
  QObject::connect(actions.find_cell, &QAction::triggered, graph, [panels, graph] {
    panels->graph().show();
    panels->graph().raise();
    graph->findCell();
  });
  for (std::size_t k = 0; k < actions.go_to_step.size(); ++k) {
    QObject::connect(actions.go_to_step[k], &QAction::triggered, steps, [panels, steps, k] {
      panels->steps().show();
      panels->steps().raise();
      steps->goToStep(static_cast<int>(k));
    });
  }

  PlotView* const plot = parts.views.plot;
  QObject::connect(actions.plot, &QAction::triggered, &parts.wires,
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
