#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

namespace hexoderm {

class SessionController;

/// Hands the reconstruction to every view that shows it. This is the only place where a view of the window gets one.
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
  /// The view shows the session's result, or in live mode that of the moment.
  template <class View>
  void addPicture(View* view) {
    receivers_.push_back({setterOf(view), true});
  }

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

  SessionController& controller_;
  std::vector<Receiver> receivers_;
};

}  // namespace hexoderm
