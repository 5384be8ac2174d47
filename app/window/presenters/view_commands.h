#pragma once

#include <QObject>

namespace hexoderm {

class CardDock;
class GraphView;
class PatchView;
class RobotView;
class StepPanel;
class ViewSwap;
class WindowActions;

/// Carries out the commands that change how something is seen, which nothing but views know.
class ViewCommands : public QObject {
  Q_OBJECT

 public:
  struct Views {
    PatchView& patch;
    RobotView& robot;
    GraphView& graph;
    CardDock& graph_dock;
    StepPanel& steps;
    CardDock& step_dock;
    ViewSwap& swap;
  };
  /// All outlive this object.
  ViewCommands(const Views& views, const WindowActions& actions);
};

}  // namespace hexoderm
