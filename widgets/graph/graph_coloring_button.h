#pragma once

#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/coloring/coloring.h"
#include "widgets/controls/panel_parts.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QToolButton>
#include <map>

namespace hexoderm {

/// The button over the graph that names the colouring; its menu changes it.
class GraphColoringButton : public QToolButton {
  Q_OBJECT

 public:
  explicit GraphColoringButton(QWidget* parent) : QToolButton(parent) {
    setObjectName(QStringLiteral("graphColoring"));
    setToolTip(tr("What the colours of links and cells show"));
    setFocusPolicy(Qt::TabFocus);
    setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(this);
    menu->setToolTipsVisible(true);
    auto* group = new QActionGroup(menu);
    bool colors_links = true;
    for (const ColoringRow& row : coloringTable()) {
      if (row.graph_title == nullptr) continue;
      if (std::exchange(colors_links, row.colors_links) != row.colors_links) menu->addSeparator();
      QAction* action = menu->addAction(coloringName(row.coloring));
      action->setCheckable(true);
      group->addAction(action);
      connect(action, &QAction::triggered, this, [this, coloring = row.coloring] { setColoring(coloring); });
      actions_.emplace(row.coloring, action);
    }
    menu->addSeparator();
    tree_ = named(menu->addAction(tr("Mark the &shortest paths")), "graphMarksTree");
    tree_->setCheckable(true);
    tree_->setChecked(true);
    tree_->setToolTip(tr("A band under the links on the shortest paths to the origin"));
    connect(tree_, &QAction::toggled, this, &GraphColoringButton::changed);
    setMenu(menu);
    setColoring(Coloring::LinkQuality);
  }

  [[nodiscard]] Coloring coloring() const { return coloring_; }
  [[nodiscard]] bool marksTree() const { return tree_->isChecked(); }
  void setColoring(Coloring coloring) {
    coloring_ = coloring;
    actions_.at(coloring)->setChecked(true);
    setText(tr("Colour: %1 ▾").arg(coloringName(coloring)));
    setAccessibleName(tr("Colour of the graph: %1").arg(coloringName(coloring)));
    adjustSize();
    emit changed();
  }

  /// The graph can be coloured by body parts only if the skin says which these are.
  void setBodyPartsKnown(bool known) {
    QAction* action = actions_.at(Coloring::BodyPart);
    action->setEnabled(known);
    action->setToolTip(known ? QString() : tr("This skin does not say which body parts its cells are on"));
  }

 signals:
  void changed();

 private:
  Coloring coloring_ = Coloring::LinkQuality;
  std::map<Coloring, QAction*> actions_;
  QAction* tree_ = nullptr;
};

}  // namespace hexoderm
