#pragma once

#include "hexoderm/solve/metrics/review_summary.h"

#include <QWidget>
#include <memory>

class QwtPlot;

namespace hexoderm {

class Selection;

/// Three plots of the residuals: per pose (box: quartiles, whiskers: all links), per link (sorted, log scale, beside
/// the prediction), and the number of links by ratio of residual to prediction. A click picks the link or the pose.
/// Data for a plot that is not seen is not gathered.
class ResidualPlots : public QWidget {
  Q_OBJECT

 public:
  /// `selection` must outlive the view.
  explicit ResidualPlots(Selection* selection, QWidget* parent = nullptr);
  ~ResidualPlots() override;

  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  /// For tests: the plot with the links, and what is picked by a click at this rank (0: the worst).
  [[nodiscard]] QwtPlot* linkPlot() const;
  [[nodiscard]] QPoint positionOfRank(std::size_t rank) const;  ///< on the link plot's canvas

 signals:
  void posePicked(hexoderm::PoseId pose);

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Parts;
  void refresh();
  void showPicked();
  void dress();

  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
