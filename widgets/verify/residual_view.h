#pragma once

#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/style/palette.h"

#include <QStackedWidget>
#include <QTableView>
#include <QToolButton>
#include <QWidget>
#include <memory>

namespace hexoderm {

class ResidualPlots;
class ResidualTable;
class Selection;
class SortedTable;

/// Viridis for a residual, on the scale that all views share, and what can be read on it.
QColor residualColor(double residual_deg);

/// Residuals of each link in each pose, as a matrix of numbers and colours, or as plots. Picking a cell of the matrix
/// picks the link, and its pose by posePicked(); a link that is picked elsewhere is picked here.
class ResidualView : public QWidget {
  Q_OBJECT

 public:
  /// `selection` must outlive the view.
  explicit ResidualView(Selection* selection, QWidget* parent = nullptr);
  ~ResidualView() override;

  void setReconstruction(const std::shared_ptr<const Reconstruction>& reconstruction);
  /// The matrix, for the actions on tables.
  [[nodiscard]] QTableView* matrix() const { return matrix_; }

 public slots:
  void showMatrix();
  void showPlots();

 signals:
  void posePicked(hexoderm::PoseId pose);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* buildHeader();
  void pickCurrent(const QModelIndex& current);
  void showPicked();
  void fitColumns();

  Selection* selection_;
  ResidualTable* table_;
  SortedTable* sorted_;
  QTableView* matrix_ = new QTableView;
  ResidualPlots* plots_;
  QStackedWidget* pages_ = new QStackedWidget;
  QToolButton* matrix_button_ = nullptr;
  QToolButton* plots_button_ = nullptr;
  QWidget* legend_;
  bool following_ = false;  ///< the matrix is being moved to what was picked elsewhere
};

}  // namespace hexoderm
