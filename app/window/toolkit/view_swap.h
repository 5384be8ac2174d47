#pragma once

#include <QObject>

class QWidget;

namespace hexoderm {

class CardDock;

/// Exchanges the places of the 3D view and the skin graph: one in the middle of the window, the other in a panel.
class ViewSwap : public QObject {
  Q_OBJECT

 public:
  /// The views already lie in a layout each, that of the graph inside `graph_dock`. All must outlive this object.
  /// Begins as the settings remember it.
  ViewSwap(QWidget& patch_view, QWidget& graph_view, CardDock& graph_dock);

  /// The 3D view is in the panel.
  [[nodiscard]] bool isSwapped() const;
  /// The settings remember it for the next start.
  void swap();

 signals:
  /// What lies above the middle has to be raised again.
  void swapped();

 private:
  void exchange();

  QWidget& patch_view_;
  QWidget& graph_view_;
  CardDock& graph_dock_;
};

}  // namespace hexoderm
