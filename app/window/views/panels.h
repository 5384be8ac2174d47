#pragma once

#include "widgets/controls/card_dock.h"

#include <QMainWindow>
#include <QSize>
#include <vector>

class QSettings;
class QScrollArea;
class QSplitter;
class QTableView;

namespace hexoderm {

class TableOrHint;
class ViewMark;
struct Views;

/// Lays the views out: one in the middle, the others in panels around it that the operator can move. While the step
/// Verify is open, its checks lie beside the middle and have the room of all panels but the steps.
class Panels : public QMainWindow {
  Q_OBJECT

 public:
  /// Takes over the views that it shows; the list of them outlives the panels.
  explicit Panels(const Views& views, QWidget* parent = nullptr);

  [[nodiscard]] CardDock& steps() { return *steps_; }
  [[nodiscard]] CardDock& graph() { return *graph_; }
  [[nodiscard]] CardDock& coverage() { return *coverage_; }
  /// Closed until somebody asks for it.
  [[nodiscard]] CardDock& plot() { return *plot_; }
  [[nodiscard]] CardDock& poses() { return *poses_; }
  [[nodiscard]] CardDock& details() { return *details_; }
  /// What lies in the middle: the 3D view or the graph. The robot takes its place.
  [[nodiscard]] QWidget& middle() { return *middle_; }
  /// Over what lies in the middle, and over what lies in the graph's panel.
  [[nodiscard]] ViewMark& middleMark() { return *middle_mark_; }
  [[nodiscard]] ViewMark& sideMark() { return *side_mark_; }
  /// The checks of the step Verify, which scroll.
  [[nodiscard]] QWidget& checks();
  [[nodiscard]] const std::vector<TableOrHint*>& tables() const { return tables_; }
  /// One a panel but the plot, which has an action of its own: shows or hides it.
  [[nodiscard]] std::vector<QAction*> toggleActions() const;

  /// As the operator left them at the last start.
  void restore(const QSettings& settings);
  void remember(QSettings& settings);
  /// As they are at the first start, in a window of this size.
  void reset();
  /// Exchanges the 3D view and the graph: one is in the middle, the other in the graph's panel. The settings remember
  /// it for the next start.
  void swapViews();

 private:
  /// A panel that gave its room to the checks.
  struct PutAway {
    CardDock* dock;
    QSize size;
    bool in_front;  ///< of the tabs in its place
  };

  void setVerifying(bool verifying);
  void makeRoomForChecks();
  void giveRoomBack();
  [[nodiscard]] QWidget* makeCentre(const Views& views);
  [[nodiscard]] QWidget* makeFindings(const Views& views);
  [[nodiscard]] CardDock* makeDetails(const Views& views);
  [[nodiscard]] TableOrHint* makeTable(QTableView* view, const QString& hint);
  void arrange();
  /// Among the panels, so that the middle has the greatest part in a small window as in a large one.
  void shareRoom();
  [[nodiscard]] std::vector<CardDock*> docks() const;
  void exchangeViews();
  void placeMarks();
  [[nodiscard]] bool isSwapped() const;

  const Views& views_;

  QWidget* middle_ = nullptr;
  QSplitter* centre_ = nullptr;
  QScrollArea* checks_ = nullptr;
  ViewMark* middle_mark_ = nullptr;
  ViewMark* side_mark_ = nullptr;
  bool is_verifying_ = false;
  std::vector<PutAway> before_checks_;
  CardDock* steps_;
  CardDock* graph_;
  CardDock* poses_;
  CardDock* coverage_;
  CardDock* plot_;
  CardDock* details_;
  std::vector<TableOrHint*> tables_;
};

}  // namespace hexoderm
