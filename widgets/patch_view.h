#pragma once

#include "hexoderm/reconstruction/reconstruction.h"
#include "widgets/palette.h"

#include <QImage>
#include <QWidget>
#include <memory>

namespace hexoderm {

class Selection;

/// The patch in 3D: true hexagonal prisms with ports, IDs, origin and gravity. Shows the reconstruction it is given and
/// nothing else; without OpenGL it says so in words and stays empty.
class PatchView : public QWidget {
  Q_OBJECT

 public:
  enum class StandardView { Front, Side, Top };

  /// `selection` must outlive the view.
  explicit PatchView(Selection* selection, QWidget* parent = nullptr);
  ~PatchView() override;

  /// Null shows an empty scene with a hint.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  void setTheme(Theme theme);
  /// Which pose's gravity the arrow shows; the last one by default.
  void setPose(std::optional<PoseId> pose);

  /// Where up is now, a unit vector in the frame of the largest patch: the picture turns as the part is turned. None:
  /// it stays. Cheap: may be called 20 times a second.
  void setCurrentUp(const std::optional<Eigen::Vector3d>& up_o);
  /// Where up is to be in the next pose: shown as a ghost beside the skin that turns there. None: no ghost.
  void setNextUp(const std::optional<Eigen::Vector3d>& up_o);
  /// Whether turnRequested() is obeyed: then a button, Shift and the arrow keys turn the part instead of the picture.
  void setTurnable(bool turnable);
  /// Off: nothing moves by itself.
  void setAnimated(bool animated);
  [[nodiscard]] bool isAnimating() const;

  /// The scene as drawn, without the buttons on top.
  [[nodiscard]] QImage screenshot();

 public slots:
  void fit();
  void showStandardView(hexoderm::PatchView::StandardView view);

 signals:
  /// The part should be turned until this direction of the largest patch's frame points up; at most 20 times a second.
  void turnRequested(Eigen::Vector3d up_o);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
