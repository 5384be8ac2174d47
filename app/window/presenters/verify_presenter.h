#pragma once

#include <QObject>
#include <functional>

class QWidget;

namespace hexoderm {

class FilePresenter;
class PatchView;
class SessionController;
class Verification;
class VerifyPanel;

/// Runs the checks of the step Verify, as its panel asks for them.
class VerifyPresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    QWidget& window;  ///< dialogs belong to it
    VerifyPanel& panel;
    PatchView& patch;
  };
  /// All outlive the presenter.
  VerifyPresenter(const Views& views, const SessionController& controller, Verification& verification,
                  FilePresenter& files);

 private:
  void connectResults();
  void askForComparison();
  void askForOldCalibration();
  /// Opens a dialog for a file and hands over the one that is chosen.
  void askForFile(const char* name, const QString& title, const QString& filter,
                  const std::function<void(const QString&)>& take);

  Views views_;
  const SessionController& controller_;
  Verification& verification_;
};

}  // namespace hexoderm
