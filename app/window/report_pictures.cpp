#include "app/window/report_pictures.h"

#include "hexoderm/reconstruction/pose_coverage.h"
#include "widgets/coverage_view.h"
#include "widgets/graph_view.h"
#include "widgets/patch_view.h"
#include "widgets/selection.h"

#include <QCoreApplication>
#include <QOpenGLWidget>

namespace hexoderm {
namespace {

struct ReportPictures {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ReportPictures)
};

constexpr QSize kSize(960, 720);

}  // namespace

std::vector<ReportPicture> takeReportPictures(const std::shared_ptr<const Reconstruction>& reconstruction) {
  std::vector<ReportPicture> pictures;
  Selection nothing_picked;
  PatchView patch(&nothing_picked);
  if (patch.findChild<QOpenGLWidget*>() != nullptr) {
    patch.resize(kSize);
    patch.setTheme(Theme::Light);
    patch.setReconstruction(reconstruction);
    for (const auto& [view, title] : {std::pair(PatchView::StandardView::Front, ReportPictures::tr("Patch, front")),
                                      std::pair(PatchView::StandardView::Side, ReportPictures::tr("Patch, side")),
                                      std::pair(PatchView::StandardView::Top, ReportPictures::tr("Patch, top"))}) {
      patch.showStandardView(view);
      patch.fit();
      pictures.push_back({title, patch.screenshot()});
    }
  }
  GraphView graph(&nothing_picked);
  graph.resize(kSize);
  graph.setTheme(Theme::Light);
  graph.setReconstruction(reconstruction);
  graph.fit();
  pictures.push_back({ReportPictures::tr("Skin graph"), graph.grab().toImage()});
  CoverageView coverage;
  coverage.resize(kSize);
  coverage.setTheme(Theme::Light);
  coverage.setCoverage(coverageOf(*reconstruction));
  pictures.push_back({ReportPictures::tr("Directions of gravity"), coverage.grab().toImage()});
  return pictures;
}

}  // namespace hexoderm
