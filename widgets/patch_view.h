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

  /// The scene as drawn, without the buttons on top.
  [[nodiscard]] QImage screenshot();

 public slots:
  void fit();
  void showStandardView(hexoderm::PatchView::StandardView view);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
