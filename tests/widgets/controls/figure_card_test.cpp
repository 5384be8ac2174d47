#include "widgets/controls/figure_card.h"
#include "widgets/style/palette.h"

#include <gtest/gtest.h>
#include <QtWidgets>

namespace hexoderm {
namespace {

TEST(PlaceBeside, IsInsideTheViewAndNeverUnderTheMouse) {
  const QRect area(0, 0, 640, 480);
  const QSize card(260, 190);
  for (int x = 0; x < area.width(); x += 7) {
    for (int y = 0; y < area.height(); y += 7) {
      const QRect place = placeBeside({x, y}, card, area);
      ASSERT_FALSE(place.isNull()) << x << " " << y;
      EXPECT_EQ(place.size(), card);
      EXPECT_TRUE(area.contains(place)) << x << " " << y;
      EXPECT_FALSE(place.adjusted(-8, -8, 8, 8).contains(x, y)) << x << " " << y;
    }
  }
}

TEST(PlaceBeside, IsNowhereWhereThereIsNoRoom) {
  EXPECT_TRUE(placeBeside({160, 120}, {260, 190}, QRect(0, 0, 320, 240)).isNull());
  EXPECT_FALSE(placeBeside({160, 120}, {260, 60}, QRect(0, 0, 320, 240)).isNull());
  EXPECT_TRUE(placeBeside({10, 10}, {400, 20}, QRect(0, 0, 320, 240)).isNull());
}

TEST(FigureCard, IsAPlateInTheColoursOfTheTheme) {
  QWidget view;
  view.resize(640, 480);
  FigureCard card(FigureCard::Kind::Passing, &view);
  EXPECT_TRUE(card.testAttribute(Qt::WA_TransparentForMouseEvents));
  card.setContent("<b>Cell 1</b>", {});
  card.resize(card.sizeFor(view.size()));
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    card.setPalette(qtPalette(theme));
    card.setStyleSheet(styleSheet(theme));
    const QImage picture = card.grab().toImage();
    EXPECT_EQ(picture.pixelColor(picture.width() / 2, 4), Colors::of(theme).panel);
    bool is_written = false;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 8; x < picture.width() - 8; ++x) {
        const QColor at = picture.pixelColor(x, y);
        is_written = is_written || std::abs(at.lightness() - Colors::of(theme).text.lightness()) < 20;
      }
    }
    EXPECT_TRUE(is_written);
  }
}

TEST(FigureCard, IsNoWiderThanItsView) {
  QWidget view;
  FigureCard card(FigureCard::Kind::Passing, &view);
  card.setContent(QStringLiteral("word ").repeated(80), {});
  const QSize wide = card.sizeFor({1000, 800});
  const QSize narrow = card.sizeFor({200, 800});
  EXPECT_LE(narrow.width(), 200);
  EXPECT_GT(narrow.height(), wide.height());
}

}  // namespace
}  // namespace hexoderm
