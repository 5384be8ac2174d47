#pragma once

#include "widgets/controls/card_dock.h"

#include <QLayout>
#include <QObject>
#include <QSettings>

class QWidget;

namespace hexoderm {

/// Exchanges the places of the 3D view and the skin graph: one in the middle of the window, the other in a panel.
class ViewSwap : public QObject {
  Q_OBJECT

 public:
  /// The views already lie in a layout each, that of the graph inside `graph_dock`. All must outlive this object.
  /// Begins as the settings remember it.
  ViewSwap(QWidget& patch_view, QWidget& graph_view, CardDock& graph_dock)
      : patch_view_(patch_view), graph_view_(graph_view), graph_dock_(graph_dock) {
    if (QSettings().value(kSwapped, false).toBool()) exchange();
  }

  /// The 3D view is in the panel.
  [[nodiscard]] bool isSwapped() const { return graph_dock_.isAncestorOf(&patch_view_); }
  /// The settings remember it for the next start.
  void swap() {
    exchange();
    QSettings().setValue(kSwapped, isSwapped());
  }

 signals:
  /// What lies above the middle has to be raised again.
  void swapped();

 private:
  static inline const QString kSwapped = QStringLiteral("window/swapped");

  void exchange() {
    QWidget* of_patch = patch_view_.parentWidget();
    QWidget* of_graph = graph_view_.parentWidget();
    of_patch->layout()->removeWidget(&patch_view_);
    of_graph->layout()->removeWidget(&graph_view_);
    of_patch->layout()->addWidget(&graph_view_);
    of_graph->layout()->addWidget(&patch_view_);
    graph_view_.show();
    patch_view_.show();
    graph_dock_.setHeading(graph_dock_.isAncestorOf(&patch_view_) ? tr("Skin patch") : tr("Skin graph"));
    graph_view_.setAccessibleName(tr("Skin graph"));
    patch_view_.setAccessibleName(tr("The patch in three dimensions"));
    emit swapped();
  }

  QWidget& patch_view_;
  QWidget& graph_view_;
  CardDock& graph_dock_;
};

}  // namespace hexoderm
