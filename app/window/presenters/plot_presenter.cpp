#include "app/window/presenters/plot_presenter.h"

#include "app/window/guide/actions.h"
#include "app/window/session/session_controller.h"
#include "hexoderm/reconstruction/evaluation/evaluation.h"
#include "widgets/controls/card_dock.h"
#include "widgets/plot/plot_view.h"
#include "widgets/scene/patch_moment.h"
#include "widgets/verify/verify_panel.h"

#include <memory>
#include <optional>

namespace hexoderm {

PlotPresenter::PlotPresenter(const Views& views, const SessionController& controller, const WindowActions& actions)
    : views_(views), controller_(controller) {
  connect(actions.plot, &QAction::triggered, this, &PlotPresenter::toggle);
  connect(&views_.verify_panel, &VerifyPanel::surfaceShown, this,
          [this](const std::optional<SurfaceEvaluation>& surface) {
            views_.plot.setSurface(surface ? std::make_shared<const SurfaceEvaluation>(*surface) : nullptr);
          });
  const LiveSource& source = controller_.liveSession().source();
  connect(&source, &LiveSource::previewChanged, this, &PlotPresenter::showReadings);
  connect(&source, &LiveSource::statusChanged, this, [this, &source] {
    // The last readings of a skin that does not send are not those of this moment.
    if (!source.isRunning() || source.status().state != SourceState::Streaming) views_.plot.setReadings(nullptr);
  });
}

void PlotPresenter::toggle() {
  // Behind another tab it is neither hidden nor seen.
  const bool is_seen = views_.dock.isVisible() && !views_.plot.visibleRegion().isEmpty();
  if (is_seen) {
    views_.dock.close();
    return;
  }
  views_.dock.show();
  views_.dock.raise();
  views_.plot.setFocus(Qt::ShortcutFocusReason);
}

void PlotPresenter::showReadings() {
  if (!views_.plot.isVisible()) return;
  const SkinPreview& preview = controller_.liveSession().source().preview();
  views_.plot.setReadings(readingsOf(preview.means, preview.temperatures));
}

}  // namespace hexoderm
