#pragma once

#include <QCoreApplication>
#include <QString>

class QLabel;
class QTabBar;
class QWidget;

namespace hexoderm {

class CardDock;
class SessionController;
class StatusBar;

/// Says beside the views what is open, in the title of the window, the status bar, the headings of the panels.
class StatusPresenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::StatusPresenter)

 public:
  struct Views {
    QWidget& window;  ///< its title
    QLabel& session_name;
    StatusBar& status;
    CardDock& graph_dock;
    CardDock& pose_dock;
    QTabBar& detail_tabs;  ///< findings, links, cells, ...
  };
  /// All outlive the presenter.
  StatusPresenter(const Views& views, const SessionController& controller);

  void refresh() const;

 private:
  void refreshName() const;
  void refreshResult() const;
  void refreshPanels() const;
  [[nodiscard]] static QString durationInWords(double seconds);
  [[nodiscard]] QString savedInWords() const;

  Views views_;
  const SessionController& controller_;
};

}  // namespace hexoderm
