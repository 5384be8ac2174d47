#pragma once

#include "hexoderm/util/finding.h"

#include <QPolygonF>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

namespace hexoderm {

/// A cell or a link in the picture, as it is marked: in pixels of the view. Not there: empty.
struct SceneMark {
  QPolygonF line;                ///< outline of a cell, or the way of a link
  bool closed = true;            ///< an outline
  bool hidden = false;           ///< the cell is behind others, or seen from behind
  QString tag;                   ///< written beside it; may be empty
  std::optional<Severity> sign;  ///< drawn before the tag: what was found there
  [[nodiscard]] bool isThere() const { return !line.isEmpty(); }
};

/// The outlines over the 3D scene: of what is picked, of what is under the mouse, of the cell that an instruction
/// speaks of, and of where something was found. Each is light and dark side by side, so that it stands out on every
/// colour, and is seen through cells in front of it, then dashed. Painted over the picture, so that nothing of the
/// scene is drawn anew for them. Lets the mouse through.
class PatchMarks : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    SceneMark picked;
    SceneMark hovered;
    SceneMark told;
    std::vector<SceneMark> found;
  };

  explicit PatchMarks(QWidget* parent);

  void setContent(const Content& content);
  [[nodiscard]] const Content& content() const { return content_; }
  /// Buttons lie there, under which a tag would not be read.
  void setTopMargin(int pixels);
  /// A frame that shows that the view has the keyboard.
  void setFocusShown(bool shown);
  /// Paints what stays when the mouse has gone, for a picture of the view.
  void paintLasting(QPainter& painter) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintOutline(QPainter& painter, const SceneMark& mark, const QColor& core, const QColor& halo,
                    double width) const;
  /// Where it covers none of `taken`, to which it is added.
  void paintTag(QPainter& painter, const SceneMark& mark, const QColor& ground, const QColor& ink,
                std::vector<QRectF>& taken) const;

  Content content_;
  bool shows_focus_ = false;
  int top_margin_ = 0;
};

}  // namespace hexoderm
