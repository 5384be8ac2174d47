#pragma once

#include "widgets/patch/patch_legend.h"
#include "widgets/style/palette.h"

#include <QStringList>
#include <QWidget>
#include <optional>

namespace hexoderm {

/// The texts over the 3D scene: the legend of its colours, a line for each thing drawn over the cells, the word beside
/// the gravity arrow, and a hint if there is nothing to see. Lets the mouse through.
class PatchCaptions : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString hint;          ///< instead of everything else, where not empty
    bool gravity = false;  ///< the arrow is there
    QStringList notes;
    QString message;  ///< the message of a tool; emphasised above the notes
    LegendContent legend;
  };

  explicit PatchCaptions(QWidget* parent = nullptr);

  void setContent(const Content& content);
  void setTheme(Theme theme, const SceneColors& colors);
  /// Kept free for the buttons.
  void setTopMargin(int pixels);
  /// Paints the same texts into a screenshot of the given size.
  void paint(QPainter& painter, const QSize& area) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintNotes(QPainter& painter, const QSize& area) const;
  /// What the legend covers in an area of this size.
  [[nodiscard]] QRect legendRect(const QSize& area) const;
  void paintLegendOnPlate(QPainter& painter, const QSize& area) const;

  Content content_;
  Theme theme_ = Theme::Light;
  SceneColors colors_;
  int top_margin_ = 0;
  mutable QSize legend_area_;  ///< of legend_rect_; empty: it has to be found anew
  mutable QRect legend_rect_;
};

}  // namespace hexoderm
