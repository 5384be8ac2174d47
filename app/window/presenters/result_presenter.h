#pragma once

#include "app/window/guide/guide.h"
#include "app/window/session/session_controller.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/controls/heavy_turn.h"

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace hexoderm {

/// Hands the reconstruction to every view that shows it, and as long as there is none, what is being done for one. This
/// is the only place where a view of the window gets them.
class ResultPresenter : public QObject {
  Q_OBJECT

 public:
  /// `controller` outlives the presenter, as every view that is added does.
  explicit ResultPresenter(SessionController& controller) : controller_(controller) {
    connect(&controller_, &SessionController::reconstructionChanged, this, &ResultPresenter::handOut);
    connect(&controller_, &SessionController::firstPlacementsChanged, this, [this] {
      if (!controller_.liveMode().isOn()) handToPictures(pictured());
    });
    connect(&controller_.liveMode(), &LiveMode::momentSolved, this, [this](const Result& moment) {
      if (controller_.liveMode().isOn()) handToPictures(moment);
    });
    connect(&controller_.liveMode(), &LiveMode::toggled, this, [this](bool on) {
      if (!on) handToPictures(pictured());
    });
  }

  /// The view shows the session's result. Views get it in the order in which they were added.
  template <class View>
  void add(View* view, bool is_picture = false) {
    receivers_.push_back({[view](const Result& result) { view->setReconstruction(result); }, is_picture});
  }
  /// The view shows the session's result, in live mode that of the moment, and before the first result of a large skin
  /// its cells as far as they are placed.
  template <class View>
  void addPicture(View* view) {
    add(view, true);
  }
  /// The view says what is awaited while there is no result.
  template <class View>
  void addWaiting(View* view) {
    waiting_.push_back([view](const QString& awaited) { view->setAwaited(awaited); });
  }

  /// Hands out what is awaited, if that has changed.
  void refresh() {
    const QString awaited = describeAwaited(controller_);
    if (std::exchange(awaited_, awaited) == awaited) return;
    for (const auto& tell : waiting_) tell(awaited);
  }

 signals:
  /// Every view has got the session's new result.
  void handedOut();

 private:
  using Result = std::shared_ptr<const Reconstruction>;
  struct Receiver {
    std::function<void(const Result&)> set;
    bool is_picture = false;
  };
  void handOut(const Result& result) {
    for (const Receiver& receiver : receivers_) {
      if (!receiver.is_picture || !controller_.liveMode().isOn()) receiver.set(result);
    }
    HeavyTurn::note();
    emit handedOut();
  }

  void handToPictures(const Result& result) {
    for (const Receiver& receiver : receivers_) {
      if (receiver.is_picture) receiver.set(result);
    }
  }

  /// What pictures show without live mode.
  [[nodiscard]] Result pictured() const {
    return controller_.firstPlacements() ? controller_.firstPlacements() : controller_.reconstruction();
  }

  SessionController& controller_;
  std::vector<Receiver> receivers_;
  std::vector<std::function<void(const QString&)>> waiting_;
  QString awaited_;
};

}  // namespace hexoderm
