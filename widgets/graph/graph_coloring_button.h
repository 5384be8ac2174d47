#pragma once

#include "widgets/coloring/coloring.h"

#include <QToolButton>
#include <map>

class QAction;

namespace hexoderm {

/// The button over the graph that names the colouring; its menu changes it.
class GraphColoringButton : public QToolButton {
  Q_OBJECT

 public:
  explicit GraphColoringButton(QWidget* parent);

  [[nodiscard]] Coloring coloring() const { return coloring_; }
  [[nodiscard]] bool marksTree() const;
  void setColoring(Coloring coloring);
  /// The graph can be coloured by body parts only if the skin says which these are.
  void setBodyPartsKnown(bool known);

 signals:
  void changed();

 private:
  Coloring coloring_ = Coloring::LinkQuality;
  std::map<Coloring, QAction*> actions_;
  QAction* tree_ = nullptr;
};

}  // namespace hexoderm
