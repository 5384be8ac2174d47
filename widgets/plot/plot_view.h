#pragma once

#include "hexoderm/solve/checks/evaluation.h"
#include "widgets/plot/plot_data.h"

#include <QWidget>
#include <memory>

class QwtPlot;

namespace hexoderm {

/// Any figure of cells or links against any other, or how often its values occur. What is picked anywhere is marked, a
/// click or the arrow keys pick, and a rectangle drawn with the mouse, or Shift with the arrow keys, brushes cells,
/// which all views then mark. Data for a plot that is not seen is not gathered.
class PlotView : public QWidget {
  Q_OBJECT

 public:
  /// `selection` must outlive the view.
  explicit PlotView(Selection* selection, QWidget* parent = nullptr);
  ~PlotView() override;

  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  /// A fitted surface, from which cells have a distance; null: none.
  void setSurface(const std::shared_ptr<const SurfaceEvaluation>& surface);
  /// The cells' present readings; null: none. Cheap: may be called 20 times a second. Drawn a few times a second, if
  /// they are plotted.
  void setReadings(const std::shared_ptr<const CellReadings>& readings);

  [[nodiscard]] const PlotChoice& choice() const;
  void setChoice(const PlotChoice& choice);
  /// The points that are shown.
  [[nodiscard]] const PlotData& data() const;
  [[nodiscard]] QwtPlot* plot() const;
  /// Position of a point on the plot's canvas.
  [[nodiscard]] QPoint positionOf(std::size_t point) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
