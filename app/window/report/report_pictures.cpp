#include "app/window/report/report_pictures.h"

#include "widgets/controls/selection.h"
#include "widgets/graph/graph_view.h"

#include <QCoreApplication>
#include <QPainter>

namespace hexoderm {
namespace {

struct ReportPictures {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ReportPictures)
};

/// As wide as the paper's column at the size that texts have there.
constexpr QSize kGraph(860, 400);

}  // namespace

std::vector<ReportPicture> takeReportPictures(const std::shared_ptr<const Reconstruction>& reconstruction) {
  Selection nothing_picked;
  GraphView graph(&nothing_picked);
  graph.setPalette(qtPalette(Theme::Light));
  // Laid out as if it were shown, and not on any screen.
  graph.setAttribute(Qt::WA_DontShowOnScreen);
  graph.resize(kGraph);
  graph.show();
  graph.setReconstruction(reconstruction);
  graph.fit();
  ReportPicture picture;
  picture.title =
      ReportPictures::tr("Skin graph: the patches laid flat, their links by how well the poses determine them");
  picture.size = kGraph;
  picture.draw = [drawn = graph.picture()](QPainter& painter) { drawn.draw(painter); };
  return {picture};
}

}  // namespace hexoderm
