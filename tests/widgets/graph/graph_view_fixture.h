#pragma once

#include "tests/support/hand_made_skins.h"
#include "tests/support/qt_text.h"
#include "tests/support/qt_wait.h"
#include "widgets/controls/selection.h"
#include "widgets/graph/graph_view.h"

namespace hexoderm {

/// A graph view on the screen, with hands.
class GraphViewTest : public testing::Test {
 protected:
  GraphViewTest() : view_(&selection_) {
    QApplication::setPalette(qtPalette(Theme::Light));
    view_.resize(500, 360);
    view_.show();
    EXPECT_TRUE(test::waitUntilExposed(view_));
  }

  void show(std::shared_ptr<const Reconstruction> reconstruction) {
    view_.setReconstruction(std::move(reconstruction));
    QApplication::processEvents();
  }
  void wheel(QPoint at, int delta) { test::turnWheel(&view_, at, delta); }
  [[nodiscard]] QPoint cell(std::uint32_t id) const { return view_.positionOf(CellId(id)).value(); }
  /// The text that appears where the mouse rests, without its markup.
  QString toolTipAt(QPoint position) {
    QHelpEvent event(QEvent::ToolTip, position, view_.mapToGlobal(position));
    QApplication::sendEvent(&view_, &event);
    return QToolTip::text();
  }
  [[nodiscard]] QImage image() { return view_.grab().toImage().convertToFormat(QImage::Format_RGB32); }

  Selection selection_;
  GraphView view_;
};

/// Pixels of a colour within `reach` of a point; drawn edges are smoothed, so near is enough.
inline int countColor(const QImage& image, QPoint around, int reach, const QColor& color) {
  int count = 0;
  for (int y = around.y() - reach; y <= around.y() + reach; ++y) {
    for (int x = around.x() - reach; x <= around.x() + reach; ++x) {
      if (!image.valid(x, y)) continue;
      const QColor pixel = image.pixelColor(x, y);
      const int difference = std::abs(pixel.red() - color.red()) + std::abs(pixel.green() - color.green()) +
                             std::abs(pixel.blue() - color.blue());
      if (difference < 48) ++count;
    }
  }
  return count;
}

/// Pixels that are not ground.
inline int markedPixels(const QImage& image, const QRect& area) {
  const QRgb ground = Colors::of(Theme::Light).panel.rgb();
  int count = 0;
  for (int y = area.top(); y <= area.bottom(); ++y) {
    for (int x = area.left(); x <= area.right(); ++x) count += image.pixel(x, y) == ground ? 0 : 1;
  }
  return count;
}

}  // namespace hexoderm
