#pragma once

#include "widgets/palette.h"
#include "widgets/scene_colors.h"

#include <QWidget>
#include <optional>

namespace hexoderm {

/// What is written over the 3D scene: the legend of its colours, the word beside the gravity arrow, and a hint where
/// there is nothing to see. Lets the mouse through.
class SceneOverlay : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString hint;          ///< instead of everything else, where not empty
    bool gravity = false;  ///< the arrow is there
    CellColoring coloring = CellColoring::LinkQuality;
    std::size_t patches = 0;
  };

  explicit SceneOverlay(QWidget* parent = nullptr);

  void setContent(const Content& content);
  void setTheme(Theme theme, const SceneColors& colors);
  /// The same picture into a screenshot of the given size.
  void paint(QPainter& painter, const QSize& area) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintQualityLegend(QPainter& painter, const QSize& area) const;
  void paintDeviationLegend(QPainter& painter, const QSize& area) const;
  void paintPatchLegend(QPainter& painter, const QSize& area) const;

  Content content_;
  Theme theme_ = Theme::Light;
  SceneColors colors_;
};

}  // namespace hexoderm
