#pragma once

#include <QMainWindow>
#include <memory>
#include <vector>

class QSettings;
class QTableView;

namespace hexoderm {

class CardDock;
class TableOrHint;
class ViewSwap;
struct Views;

/// Lays the views out: one in the middle, the others in panels around it that the operator can move.
class Panels : public QMainWindow {
  Q_OBJECT

 public:
  /// Takes over the views that it shows.
  explicit Panels(const Views& views, QWidget* parent = nullptr);
  ~Panels() override;

  [[nodiscard]] CardDock& steps() { return *steps_; }
  [[nodiscard]] CardDock& graph() { return *graph_; }
  [[nodiscard]] CardDock& coverage() { return *coverage_; }
  /// Closed until somebody asks for it.
  [[nodiscard]] CardDock& plot() { return *plot_; }
  [[nodiscard]] CardDock& poses() { return *poses_; }
  [[nodiscard]] CardDock& details() { return *details_; }
  [[nodiscard]] ViewSwap& swap() { return *swap_; }
  /// What lies in the middle: the 3D view or the graph. The robot takes its place.
  [[nodiscard]] QWidget& middle() { return *middle_; }
  [[nodiscard]] const std::vector<TableOrHint*>& tables() const { return tables_; }
  /// One a panel but the plot, which has an action of its own: shows or hides it.
  [[nodiscard]] std::vector<QAction*> toggleActions() const;

  /// As the operator left them at the last start.
  void restore(const QSettings& settings);
  void remember(QSettings& settings) const;

 private:
  [[nodiscard]] QWidget* makeCentre(const Views& views);
  [[nodiscard]] CardDock* makeDetails(const Views& views);
  [[nodiscard]] TableOrHint* makeTable(QTableView* view, const QString& hint);
  void arrange();

  QWidget* middle_ = nullptr;
  CardDock* steps_;
  CardDock* graph_;
  CardDock* poses_;
  CardDock* coverage_;
  CardDock* plot_;
  std::unique_ptr<ViewSwap> swap_;
  CardDock* details_;
  std::vector<TableOrHint*> tables_;
};

}  // namespace hexoderm
