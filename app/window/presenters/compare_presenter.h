#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

class QDialog;
class QWidget;

namespace hexoderm {

class CompareView;
class Selection;
class SessionController;
class Verification;
class WindowActions;

/// Before and after in a window of its own, made when it is first asked for: the result of now beside the one before
/// the last change, or beside the calibration that the step Verify compares with.
class ComparePresenter : public QObject {
  Q_OBJECT

 public:
  /// All outlive the presenter; the comparison's window belongs to `window`.
  ComparePresenter(QWidget& window, const SessionController& controller, const WindowActions& actions,
                   Selection& selection, const Verification& verification);
  /// The comparison's window goes before what its views refer to.
  ~ComparePresenter() override;

 private:
  enum class Source { LastChange, Calibration };

  void open();
  void note(const std::shared_ptr<const Reconstruction>& reconstruction);
  void refresh();

  QWidget& window_;
  const SessionController& controller_;
  Selection& selection_;
  const Verification& verification_;
  QDialog* dialog_ = nullptr;  ///< once it was asked for
  CompareView* view_ = nullptr;
  std::shared_ptr<const Reconstruction> now_;
  std::shared_ptr<const Reconstruction> before_;  ///< the last change of the same session
  Source chosen_ = Source::LastChange;
  std::vector<Source> sources_;  ///< as the view lists them
};

}  // namespace hexoderm
