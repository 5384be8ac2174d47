#include "app/window/presenters/presenters.h"

namespace hexoderm {

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
}

}  // namespace hexoderm
