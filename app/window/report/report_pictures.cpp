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

/// Of the graph in pixels of the screen: as wide as the paper's column at the size that texts have there.
constexpr QSize kGraph(860, 400);
/// Dots for a pixel: sharp in print.
constexpr double kFineness = 3;

/// Laid out and drawn as if it were shown, and not on any screen.
void showNowhere(QWidget& view, QSize size) {
  view.setAttribute(Qt::WA_DontShowOnScreen);
  view.resize(size);
  view.show();
}

template <class Draw>
QImage fineImage(QSize size, Draw draw) {
  QImage image(size * kFineness, QImage::Format_RGB32);
  image.setDevicePixelRatio(kFineness);
  image.fill(Colors::of(Theme::Light).panel);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  draw(painter);
  painter.end();
  // On paper it is as large as its place, whatever its pixels were.
  image.setDevicePixelRatio(1);
  return image;
}

}  // namespace

std::vector<ReportPicture> takeReportPictures(const std::shared_ptr<const Reconstruction>& reconstruction) {
  std::vector<ReportPicture> pictures;
  Selection nothing_picked;
  GraphView graph(&nothing_picked);
  showNowhere(graph, kGraph);
  graph.setTheme(Theme::Light);
  graph.setReconstruction(reconstruction);
  graph.fit();
  pictures.push_back({ReportPictures::tr("Skin graph: the patches laid flat, their links by how well the poses "
                                         "determine them"),
                      fineImage(kGraph, [&](QPainter& painter) { graph.picture().draw(painter); })});
  return pictures;
}

}  // namespace hexoderm
