#include "app/window/toolkit/view_swap.h"

#include "widgets/controls/card_dock.h"

#include <QLayout>
#include <QSettings>

namespace hexoderm {
namespace {

const QString kSwapped = QStringLiteral("window/swapped");

}  // namespace

ViewSwap::ViewSwap(QWidget& patch_view, QWidget& graph_view, CardDock& graph_dock)
    : patch_view_(patch_view), graph_view_(graph_view), graph_dock_(graph_dock) {
  if (QSettings().value(kSwapped, false).toBool()) exchange();
}

bool ViewSwap::isSwapped() const { return graph_dock_.isAncestorOf(&patch_view_); }

void ViewSwap::swap() {
  exchange();
  QSettings().setValue(kSwapped, isSwapped());
}

void ViewSwap::exchange() {
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

}  // namespace hexoderm
