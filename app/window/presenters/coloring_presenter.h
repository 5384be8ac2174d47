#pragma once

#include "widgets/coloring/coloring.h"

#include <QObject>

namespace hexoderm {

class GraphView;
class PatchView;
class Preferences;
class ResultPresenter;
class ScaleRanges;
class SessionController;
class StepPanel;

/// What the cells in 3D are coloured by until the operator chooses something: the quality of links until Review, from
/// there on, as soon as that is the same everywhere and shows nothing more, how well the shape is known. And the ranges
/// of scales that the operator fixes, which graph and 3D view share, and which are kept for the next start.
class ColoringPresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    StepPanel& steps;
    PatchView& patch;
    GraphView& graph;
  };
  /// All outlive the presenter; the ranges outlive the views.
  ColoringPresenter(const Views& views, const SessionController& controller, const ResultPresenter& results,
                    const Preferences& preferences, ScaleRanges& ranges);

 private:
  void choose();
  [[nodiscard]] Coloring suggested() const;

  Views views_;
  const SessionController& controller_;
  bool is_chosen_ = false;  ///< by the operator
};

}  // namespace hexoderm
