#pragma once

#include "widgets/style/palette.h"

#include <QPolygonF>
#include <QString>
#include <QWidget>
#include <optional>

namespace hexoderm {

/// A cell or a link in the picture, as it is marked: in pixels of the view. Not there: empty.
struct SceneMark {
  QPolygonF line;       ///< outline of a cell, or the way of a link
  bool closed = true;   ///< an outline
  bool hidden = false;  ///< the cell is behind others, or seen from behind
  QString tag;          ///< written beside it; may be empty
  [[nodiscard]] bool isThere() const { return !line.isEmpty(); }
};

/// The outlines over the 3D scene: of what is picked, of what is under the mouse, and of the cell that an instruction
/// speaks of. Each is light and dark side by side, so that it stands out on every colour, and is seen through cells in
/// front of it, then dashed. Painted over the picture, so that nothing of the scene is drawn anew for them. Lets the
/// mouse through.
class PatchMarks : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    SceneMark picked;
    SceneMark hovered;
    SceneMark told;
  };

  explicit PatchMarks(QWidget* parent);

  void setContent(const Content& content);
  [[nodiscard]] const Content& content() const { return content_; }
  void setTheme(Theme theme);
  /// A frame that shows that the view has the keyboard.
  void setFocusShown(bool shown);
  /// Paints what stays when the mouse has gone, for a picture of the view.
  void paintLasting(QPainter& painter) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintOutline(QPainter& painter, const SceneMark& mark, const QColor& core, const QColor& halo,
                    double width) const;
  void paintTag(QPainter& painter, const SceneMark& mark, const QColor& ground, const QColor& ink) const;

  Content content_;
  Theme theme_ = Theme::Light;
  bool shows_focus_ = false;
};

}  // namespace hexoderm
