#pragma once

#include <QObject>

namespace hexoderm {

class CardDock;
class PlotView;
class SessionController;
class VerifyPanel;
class WindowActions;

/// Opens and closes the plot of figures, and gives it what is no part of the result: the fitted surface of the step
/// Verify and the present readings.
class PlotPresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    PlotView& plot;
    CardDock& dock;
    VerifyPanel& verify_panel;
  };
  /// All outlive the presenter.
  PlotPresenter(const Views& views, const SessionController& controller, const WindowActions& actions);

 private:
  /// Brings the plot to the front, with the keyboard; where it is there already, closes it.
  void toggle();
  void showReadings();

  Views views_;
  const SessionController& controller_;
};

}  // namespace hexoderm
