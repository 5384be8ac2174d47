#include "widgets/graph/graph_coloring_button.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

namespace hexoderm {

GraphColoringButton::GraphColoringButton(QWidget* parent) : QToolButton(parent) {
  setObjectName(QStringLiteral("graphColoring"));
  setToolTip(tr("What the colours of links and cells show"));
  setFocusPolicy(Qt::TabFocus);
  setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(this);
  menu->setToolTipsVisible(true);
  auto* group = new QActionGroup(menu);
  bool cells = false;
  for (const GraphColoring coloring : graphColorings()) {
    if (colorsCells(coloring) && !cells) menu->addSeparator();
    cells = colorsCells(coloring);
    addColoring(coloring, group);
    menu->addAction(actions_.back());
  }
  menu->addSeparator();
  tree_ = menu->addAction(tr("Mark the &shortest paths"));
  tree_->setObjectName(QStringLiteral("graphMarksTree"));
  tree_->setCheckable(true);
  tree_->setChecked(true);
  tree_->setToolTip(tr("A band under the links on the shortest paths to the origin"));
  connect(tree_, &QAction::toggled, this, &GraphColoringButton::changed);
  setMenu(menu);
  setColoring(GraphColoring::Quality);
}

void GraphColoringButton::addColoring(GraphColoring coloring, QActionGroup* group) {
  auto* action = new QAction(coloringName(coloring), group);
  action->setCheckable(true);
  connect(action, &QAction::triggered, this, [this, coloring] { setColoring(coloring); });
  actions_.push_back(action);
}

bool GraphColoringButton::marksTree() const { return tree_->isChecked(); }

void GraphColoringButton::setColoring(GraphColoring coloring) {
  coloring_ = coloring;
  actions_[static_cast<std::size_t>(coloring)]->setChecked(true);
  setText(tr("Colour: %1 ▾").arg(coloringName(coloring)));
  setAccessibleName(tr("Colour of the graph: %1").arg(coloringName(coloring)));
  adjustSize();
  emit changed();
}

void GraphColoringButton::setBodyPartsKnown(bool known) {
  QAction* action = actions_[static_cast<std::size_t>(GraphColoring::BodyPart)];
  action->setEnabled(known);
  action->setToolTip(known ? QString() : tr("This skin does not say which body parts its cells are on"));
}

}  // namespace hexoderm
