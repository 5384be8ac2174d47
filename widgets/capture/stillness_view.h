#pragma once

#include "hexoderm/capture/stillness_trace.h"

#include <QTimer>
#include <QWidget>
#include <optional>

class QLabel;

namespace hexoderm {

/// A strip chart of the last ten seconds: how far the three axes of the cell that decides, or of the picked one, are
/// off their mean of the last second, each in a lane of its own with the limit as a band; when poses were captured,
/// when the next one was armed, when a motion made it start over; and whether the part was moving, still or being
/// captured.
class StillnessView : public QWidget {
  Q_OBJECT

 public:
  explicit StillnessView(QWidget* parent = nullptr);

  /// Cheap: at most 20 times a second. Drawn while visible, ten times a second.
  void add(const HoldStatus& hold, const SkinPreview& preview);
  /// `time_s`: device time, CapturedPose::end_s.
  void addCaptured(PoseId pose, double time_s);
  /// Clears the view for another source.
  void clear();

  /// "cell 7 · x y z, deviation from its mean, last 10 s, limit 30 mg".
  [[nodiscard]] QString header() const;
  [[nodiscard]] const StillnessTrace& trace() const { return trace_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 public slots:
  /// Shows a cell; none: the cell that decides.
  void setCell(std::optional<hexoderm::CellId> cell);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  class Strip;
  void refresh();

  StillnessTrace trace_;
  QLabel* header_;
  Strip* strip_;
  QLabel* nothing_;
  QTimer refresh_soon_;
};

}  // namespace hexoderm
