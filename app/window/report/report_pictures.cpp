#include "app/window/report/report_pictures.h"

#include "hexoderm/reconstruction/advice/pose_coverage.h"
#include "widgets/capture/coverage_view.h"
#include "widgets/controls/selection.h"
#include "widgets/graph/graph_view.h"
#include "widgets/patch/patch_view.h"
#include "widgets/patch/scene_widget.h"

#include <QCoreApplication>

namespace hexoderm {
namespace {

struct ReportPictures {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ReportPictures)
};

// Twice the room on the page: sharp in print, and texts in it can still be read.
constexpr QSize kSize(600, 450);

/// Laid out and drawn as if it were shown, and not on any screen.
void showNowhere(QWidget& view, QSize size) {
  view.setAttribute(Qt::WA_DontShowOnScreen);
  view.resize(size);
  view.show();
}

}  // namespace

std::vector<ReportPicture> takeReportPictures(const std::shared_ptr<const Reconstruction>& reconstruction) {
  std::vector<ReportPicture> pictures;
  Selection nothing_picked;
  PatchView patch(&nothing_picked);
  if (patch.findChild<SceneWidget*>() != nullptr) {
    showNowhere(patch, kSize);
    patch.setTheme(Theme::Light);
    patch.setReconstruction(reconstruction);
    patch.waitUntilUpToDate();
    for (const auto& [view, title] : {std::pair(PatchView::StandardView::Front, ReportPictures::tr("Patch, front")),
                                      std::pair(PatchView::StandardView::Side, ReportPictures::tr("Patch, side")),
                                      std::pair(PatchView::StandardView::Top, ReportPictures::tr("Patch, top"))}) {
      patch.showStandardView(view);
      patch.fit();
      pictures.push_back({title, patch.screenshot()});
    }
  }
  GraphView graph(&nothing_picked);
  showNowhere(graph, kSize);
  graph.setTheme(Theme::Light);
  graph.setReconstruction(reconstruction);
  graph.fit();
  pictures.push_back({ReportPictures::tr("Skin graph"), graph.grab().toImage()});
  CoverageView coverage;
  coverage.setTheme(Theme::Light);
  coverage.setCoverage(coverageOf(*reconstruction));
  showNowhere(coverage, QSize(kSize.width(), coverage.heightForWidth(kSize.width())));
  pictures.push_back({ReportPictures::tr("Directions of gravity"), coverage.grab().toImage()});
  return pictures;
}

}  // namespace hexoderm
