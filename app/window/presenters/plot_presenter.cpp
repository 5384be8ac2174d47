#include "app/window/presenters/presenters.h"

#include "hexoderm/reconstruction/evaluation/evaluation.h"
#include "widgets/scene/patch_moment.h"

#include <memory>
#include <optional>

namespace hexoderm {
namespace {

/// Opens and closes the plot of figures, and gives it what is no part of the result: the fitted surface of the step
/// Verify and the present readings.
class PlotPresenter : public Presenter {
 public:
  explicit PlotPresenter(const WindowParts& parts) : Presenter(parts) {
    connect(actions_.plot, &QAction::triggered, this, &PlotPresenter::toggle);
    connect(views_.verify_panel, &VerifyPanel::surfaceShown, this,
            [this](const std::optional<SurfaceEvaluation>& surface) {
              views_.plot->setSurface(surface ? std::make_shared<const SurfaceEvaluation>(*surface) : nullptr);
            });
    const LiveSource& source = controller_.liveSession().source();
    connect(&source, &LiveSource::previewChanged, this, &PlotPresenter::showReadings);
    connect(&source, &LiveSource::statusChanged, this, [this, &source] {
      // The last readings of a skin that does not send are not those of this moment.
      if (!source.isRunning() || source.status().state != SourceState::Streaming) views_.plot->setReadings(nullptr);
    });
  }

 private:
  /// Brings the plot to the front, with the keyboard; where it is there already, closes it.
  void toggle() {
    // Behind another tab it is neither hidden nor seen.
    const bool is_seen = panels_.plot().isVisible() && !views_.plot->visibleRegion().isEmpty();
    if (is_seen) {
      panels_.plot().close();
      return;
    }
    panels_.plot().show();
    panels_.plot().raise();
    views_.plot->setFocus(Qt::ShortcutFocusReason);
  }

  void showReadings() {
    if (!views_.plot->isVisible()) return;
    const SkinPreview& preview = controller_.liveSession().source().preview();
    views_.plot->setReadings(readingsOf(preview.means, preview.temperatures));
  }
};

}  // namespace

std::unique_ptr<Presenter> makePlotPresenter(const WindowParts& parts) {
  return std::make_unique<PlotPresenter>(parts);
}

}  // namespace hexoderm
