#pragma once

#include "widgets/style/palette.h"

#include <QWidget>
#include <optional>

namespace hexoderm {

struct PoseCoverage;

/// The directions of gravity seen so far: both halves of the sphere as discs, since a sphere hides its far side, with
/// the poses as numbers, the next one as a dashed ring and the present direction as a moving dot. Below: the three
/// singular values with their limit, their class, and the missing direction in words. A click or the arrow keys pick a
/// pose.
class CoverageView : public QWidget {
  Q_OBJECT

 public:
  explicit CoverageView(QWidget* parent = nullptr);
  ~CoverageView() override;

  void setCoverage(const PoseCoverage& coverage);
  /// Shown in place of the class of an empty coverage, where there is no skin.
  void setEmptyHint(const QString& hint);
  /// What is going on while there is no result, in words, which stand in the hint's place; empty: nothing is.
  void setAwaited(const QString& awaited);
  /// Unit vectors in the frame of the coverage; none hides the mark. The present one is shown as CalmUp makes it.
  /// Cheap: may be called 20 times a second.
  void setCurrent(const std::optional<Eigen::Vector3d>& up_o);
  void setNext(const std::optional<Eigen::Vector3d>& up_o);
  void setPickedPose(std::optional<PoseId> pose);

  [[nodiscard]] std::optional<PoseId> pickedPose() const;
  /// Position of a direction, in the widget's coordinates.
  [[nodiscard]] QPointF placeOf(const Eigen::Vector3d& up_o) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 signals:
  /// By the mouse or by a key.
  void posePicked(hexoderm::PoseId pose);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
