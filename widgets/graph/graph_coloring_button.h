#pragma once

#include "widgets/coloring/graph_coloring.h"

#include <QToolButton>

class QAction;
class QActionGroup;

namespace hexoderm {

/// The button over the graph that says what its colours show; its menu changes that.
class GraphColoringButton : public QToolButton {
  Q_OBJECT

 public:
  explicit GraphColoringButton(QWidget* parent);

  [[nodiscard]] GraphColoring coloring() const { return coloring_; }
  [[nodiscard]] bool marksTree() const;
  void setColoring(GraphColoring coloring);
  /// Without any, there is nothing to be coloured by.
  void setBodyPartsKnown(bool known);

 signals:
  void changed();

 private:
  void addColoring(GraphColoring coloring, QActionGroup* group);

  GraphColoring coloring_ = GraphColoring::Quality;
  std::vector<QAction*> actions_;  ///< in the order of graphColorings()
  QAction* tree_ = nullptr;
};

}  // namespace hexoderm
