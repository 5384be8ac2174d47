#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace hexoderm {

class SessionController;
class ViewMark;
class WindowActions;
class WorkNotice;

/// Says of the pictures when they are not what they usually are (live, without readings, preliminary, from before), and
/// what is being done while a result takes long.
class MarkPresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    WorkNotice& notice;
    ViewMark& middle;  ///< over what lies in the middle
    ViewMark& side;    ///< over what lies at the side
  };
  /// All outlive the presenter.
  MarkPresenter(const Views& views, SessionController& controller, const WindowActions& actions);

  void refresh();

 private:
  void refreshWork();
  void refreshMarks();
  void showProgress();
  /// The picture shows a result of another state of the session.
  [[nodiscard]] bool isOld() const;

  Views views_;
  SessionController& controller_;
  QTimer patience_;  ///< what is done before it ends is not worth a word
  QTimer tick_;
  QElapsedTimer since_;
  bool is_long_ = false;
};

}  // namespace hexoderm
