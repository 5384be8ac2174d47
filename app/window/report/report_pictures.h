#pragma once

#include "app/window/report/report.h"
#include "widgets/controls/selection.h"
#include "widgets/graph/graph_view.h"

#include <QCoreApplication>
#include <QPainter>

namespace hexoderm {

struct ReportPictures {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ReportPictures)
};

/// As wide as the paper's column at the size that texts have there.
inline constexpr QSize kReportGraph(860, 400);

/// The picture that only a view can draw, the skin graph, for paper (the light colours, whatever the window has),
/// without anything that is there to be pressed. On the GUI thread. The patches are drawn with the report itself.
inline ReportPicture takeReportGraph(const std::shared_ptr<const Reconstruction>& reconstruction) {
  Selection nothing_picked;
  GraphView graph(&nothing_picked);
  graph.setPalette(qtPalette(Theme::Light));
  // Laid out as if it were shown, and not on any screen.
  graph.setAttribute(Qt::WA_DontShowOnScreen);
  graph.resize(kReportGraph);
  graph.show();
  graph.setReconstruction(reconstruction);
  graph.fit();
  return {ReportPictures::tr("Skin graph: the patches laid flat, their links by how well the poses determine them"),
          kReportGraph, [drawn = graph.picture()](QPainter& painter) { drawn.draw(painter); }};
}

}  // namespace hexoderm
