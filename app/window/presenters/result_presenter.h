#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

namespace hexoderm {

class SessionController;

/// Hands the reconstruction to every view that shows it, and as long as there is none, what is being done for one. This
/// is the only place where a view of the window gets them.
class ResultPresenter : public QObject {
  Q_OBJECT

 public:
  /// `controller` outlives the presenter, as every view that is added does.
  explicit ResultPresenter(SessionController& controller);

  /// The view shows the session's result. Views get it in the order in which they were added.
  template <class View>
  void add(View* view) {
    receivers_.push_back({setterOf(view), false});
  }
  /// The view shows the session's result, in live mode that of the moment, and before the first result of a large skin
  /// its cells as far as they are placed.
  template <class View>
  void addPicture(View* view) {
    receivers_.push_back({setterOf(view), true});
  }
  /// The view says what is awaited while there is no result.
  template <class View>
  void addWaiting(View* view) {
    waiting_.push_back([view](const QString& awaited) { view->setAwaited(awaited); });
  }
  /// Hands out what is awaited, if that has changed.
  void refresh();

 signals:
  /// Every view has got the session's new result.
  void handedOut();

 private:
  using Result = std::shared_ptr<const Reconstruction>;
  using Setter = std::function<void(const Result&)>;
  struct Receiver {
    Setter set;
    bool is_picture = false;
  };
  template <class View>
  static Setter setterOf(View* view) {
    return [view](const Result& result) { view->setReconstruction(result); };
  }
  void handOut(const Result& result);
  void handToPictures(const Result& result);
  /// What pictures show without live mode.
  [[nodiscard]] Result pictured() const;

  SessionController& controller_;
  std::vector<Receiver> receivers_;
  std::vector<std::function<void(const QString&)>> waiting_;
  QString awaited_;
};

}  // namespace hexoderm
