#include "app/window/presenters/view_commands.h"

#include "app/window/guide/actions.h"
#include "app/window/toolkit/view_swap.h"
#include "widgets/controls/card_dock.h"
#include "widgets/controls/step_panel.h"
#include "widgets/graph/graph_view.h"
#include "widgets/patch/patch_view.h"
#include "widgets/robot/robot_view.h"

namespace hexoderm {

ViewCommands::ViewCommands(const Views& views, const WindowActions& actions) {
  connect(actions.fit, &QAction::triggered, &views.graph, &GraphView::fit);
  connect(actions.fit, &QAction::triggered, &views.patch, &PatchView::fit);
  connect(actions.fit, &QAction::triggered, &views.robot, &RobotView::fit);
  const auto look = [patch = &views.patch](QAction* action, PatchView::StandardView view) {
    connect(action, &QAction::triggered, patch, [patch, view] { patch->showStandardView(view); });
  };
  look(actions.front, PatchView::StandardView::Front);
  look(actions.side, PatchView::StandardView::Side);
  look(actions.top, PatchView::StandardView::Top);
  look(actions.back, PatchView::StandardView::Back);
  look(actions.isometric, PatchView::StandardView::Isometric);
  connect(actions.swap_views, &QAction::triggered, &views.swap, &ViewSwap::swap);
  connect(actions.find_cell, &QAction::triggered, this, [views] {
    views.graph_dock.show();
    views.graph_dock.raise();
    views.graph.findCell();
  });
  for (std::size_t k = 0; k < actions.go_to_step.size(); ++k) {
    connect(actions.go_to_step[k], &QAction::triggered, this, [views, k] {
      views.step_dock.show();
      views.step_dock.raise();
      views.steps.goToStep(static_cast<int>(k));
    });
  }
}

}  // namespace hexoderm
