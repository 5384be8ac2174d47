#include "widgets/graph/graph_view.h"

#include "tests/widgets/graph/graph_view_fixture.h"

namespace hexoderm {
namespace {

constexpr LinkEnd kLink5{CellId(5), PortNumber(3)};
constexpr LinkEnd kLink9{CellId(9), PortNumber(2)};

/// The pixels about the middle that are not ground: a text's, in any font.
int drawnPixels(const QImage& image) {
  QRect area(0, 0, 301, 61);
  area.moveCenter(image.rect().center());
  return markedPixels(image, area & image.rect());
}

TEST_F(GraphViewTest, ShowsAHintInsteadOfNothing) {
  const QImage empty = image();
  EXPECT_GT(drawnPixels(empty), 50);
  QTest::mouseClick(&view_, Qt::LeftButton, Qt::NoModifier, QPoint(50, 50));
  for (const int key : {Qt::Key_Left, Qt::Key_F, Qt::Key_Plus, Qt::Key_Escape}) {
    QTest::keyClick(&view_, static_cast<Qt::Key>(key));
  }
  wheel({100, 100}, 240);
  EXPECT_FALSE(selection_.cell());
  show(test::ResultBuilder().share());
  EXPECT_GT(drawnPixels(image()), 50);
  show(sampleX17());
  show(nullptr);
  EXPECT_EQ(image(), empty);
}

/// Waiting for the window to be painted does not include waiting for hundreds of hexagons.
TEST_F(GraphViewTest, ALargeSkinIsDrawnInATurnAfterTheOneThatPaintsTheWindow) {
  auto sheet = std::make_shared<Reconstruction>(cylinderSheet(20, 20));
  sheet->layout = computeFlatLayout(*sheet->model, sheet->patches);
  const QImage nothing = image();
  show(sheet);
  ASSERT_TRUE(test::waitUntil([&] { return image() != nothing; }));
  const QImage before = image();
  view_.resize(view_.size() + QSize(60, 40));
  const QImage meanwhile = image();
  const QRect middle(150, 100, 200, 160);
  EXPECT_EQ(meanwhile.copy(middle), before.copy(middle));
  EXPECT_EQ(meanwhile.pixelColor(view_.width() - 5, view_.height() - 5), Colors::of(Theme::Light).panel);
  ASSERT_TRUE(test::waitUntil([&] { return image() != meanwhile; }));
  // It looks as if the view had been as large from the start.
  const QImage after = image();
  GraphView other(&selection_);
  other.resize(view_.size());
  other.show();
  ASSERT_TRUE(test::waitUntilExposed(other));
  const auto seenOfOther = [&] { return other.grab().toImage().convertToFormat(after.format()); };
  static_cast<void>(seenOfOther());  // painted for the first time
  other.setReconstruction(sheet);
  EXPECT_NE(seenOfOther(), after);
  // A picture that is taken now does not wait.
  other.drawNow();
  EXPECT_EQ(seenOfOther(), after);
}

TEST_F(GraphViewTest, FitsTheWholeSkinIntoTheWidgetInItsPlaces) {
  show(sampleX17());
  for (std::uint32_t id = 1; id <= 17; ++id)
    EXPECT_TRUE(view_.rect().adjusted(15, 15, -15, -15).contains(cell(id))) << id;
  // The directions are those of the sheet: ports 1 and 2 lead to the right, 1 and 3 up.
  EXPECT_GT(cell(2).x(), cell(1).x());
  EXPECT_LT(cell(2).y(), cell(1).y());
  EXPECT_LT(cell(5).x(), cell(1).x());
  EXPECT_LT(cell(5).y(), cell(1).y());
  EXPECT_LT((cell(1) - view_.rect().center()).manhattanLength(), 40) << "the legend takes its room below";
  EXPECT_FALSE(view_.positionOf(CellId(99)));
}

TEST_F(GraphViewTest, AClickPicksACellALinkOrNothing) {
  show(sampleX17());
  QTest::mouseClick(&view_, Qt::LeftButton, Qt::NoModifier, cell(13));
  EXPECT_EQ(selection_.cell(), CellId(13));
  QTest::mouseClick(&view_, Qt::LeftButton, Qt::NoModifier, view_.positionOf(kLink5, kLink9).value());
  EXPECT_FALSE(selection_.cell());
  EXPECT_EQ(selection_.link(), Selection::Link(kLink5, kLink9));
  QTest::mouseClick(&view_, Qt::LeftButton, Qt::NoModifier, QPoint(view_.width() / 2, 10));
  EXPECT_FALSE(selection_.cell() || selection_.link());
}

TEST_F(GraphViewTest, WhatIsPickedElsewhereIsOutlinedHereInBlackOrWhite) {
  show(sampleX17());
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    view_.setPalette(qtPalette(theme));
    selection_.clear();
    const QColor color = Colors::of(theme).selection;
    const QPoint link = view_.positionOf(kLink5, kLink9).value();
    const int cell_before = countColor(image(), cell(9), 16, color);
    const int link_before = countColor(image(), link, 14, color);
    selection_.selectCell(CellId(9));
    EXPECT_GT(countColor(image(), cell(9), 16, color), cell_before + 60);
    selection_.selectLink(kLink9, kLink5);
    EXPECT_LE(countColor(image(), cell(9), 10, color), cell_before);
    EXPECT_GT(countColor(image(), link, 14, color), link_before + 25);
  }
}

TEST_F(GraphViewTest, AClosedSurfaceIsDrawnAsTwoStubsThatBothPickTheCutLink) {
  test::ResultBuilder ring;
  ring.patch(1).cells(1, 8);
  for (std::uint32_t id = 1; id <= 8; ++id) ring.link(id, 2, id % 8 + 1, 3, solvedLink());
  show(ring.laidOut().share());
  const LinkEnd five{CellId(5), PortNumber(2)};
  const LinkEnd six{CellId(6), PortNumber(3)};
  for (const auto& [end, inner] : {std::pair{5u, 4u}, std::pair{6u, 7u}}) {
    selection_.clear();
    const QPoint outside = cell(end) + (cell(end) - cell(inner)) * 0.42;
    QTest::mouseClick(&view_, Qt::LeftButton, Qt::NoModifier, outside);
    EXPECT_EQ(selection_.link(), Selection::Link(five, six)) << end;
  }
}

TEST_F(GraphViewTest, TheWheelZoomsAboutTheCursorAndDoubleClickFitsAgain) {
  show(sampleX17());
  const QPoint before = cell(14);
  const QPoint other = cell(15);
  wheel(before, 360);
  EXPECT_LT((cell(14) - before).manhattanLength(), 3);
  EXPECT_GT((cell(15) - before).manhattanLength(), 1.8 * (other - before).manhattanLength());
  QTest::mouseDClick(&view_, Qt::LeftButton, Qt::NoModifier, QPoint(30, 180));
  EXPECT_EQ(cell(15), other);
  wheel(before, -10000);
  EXPECT_GT((cell(14) - cell(15)).manhattanLength(), 50);  // it can't be lost
  QTest::keyClick(&view_, Qt::Key_F);
  EXPECT_EQ(cell(15), other);
}

TEST_F(GraphViewTest, DraggingPansAndPicksNothing) {
  show(sampleX17());
  const QPoint before = cell(2);
  test::dragMouse(&view_, cell(2), cell(2) + QPoint(-60, 40));
  EXPECT_EQ(cell(2), before + QPoint(-60, 40));
  EXPECT_FALSE(selection_.cell());
}

TEST_F(GraphViewTest, KeepsItsViewWhenOnlyMetricsChangeAndFitsANewSkin) {
  show(sampleX17());
  wheel(cell(9), 480);
  const QPoint zoomed = cell(9);
  const QPoint zoomed_other = cell(13);
  show(sampleX17());
  EXPECT_EQ(cell(9), zoomed);
  EXPECT_EQ(cell(13), zoomed_other);
  show(sampleSheet(5, 5));
  for (std::uint32_t id = 1; id <= 25; ++id) EXPECT_TRUE(view_.rect().contains(cell(id)));
}

TEST_F(GraphViewTest, FollowsItsSizeUntilSomebodyZooms) {
  show(sampleX17());
  view_.resize(300, 220);
  EXPECT_TRUE(test::waitUntil([&] { return view_.rect().contains(cell(16)) && view_.rect().contains(cell(17)); }));
}

TEST_F(GraphViewTest, ArrowKeysWalkAlongTheLinksFromTheOrigin) {
  show(sampleX17());
  view_.setFocus();
  const auto walk = [&](std::initializer_list<Qt::Key> keys) {
    for (const Qt::Key key : keys) QTest::keyClick(&view_, key);
    return selection_.cell();
  };
  EXPECT_EQ(walk({Qt::Key_Right}), CellId(1));
  EXPECT_THAT(walk({Qt::Key_Right, Qt::Key_Right}), testing::Optional(testing::AnyOf(CellId(6), CellId(8))));
  EXPECT_EQ(walk({Qt::Key_Left, Qt::Key_Left}), CellId(1));
  selection_.selectCell(CellId(9));
  EXPECT_EQ(walk({Qt::Key_Up}), CellId(13));
  EXPECT_EQ(walk({Qt::Key_Down}), CellId(9));
  selection_.selectLink(kLink5, kLink9);
  EXPECT_EQ(walk({Qt::Key_Right}), CellId(5));
  EXPECT_FALSE(walk({Qt::Key_Escape}));
}

TEST_F(GraphViewTest, ArrowKeysReachOtherPatches) {
  show(sampleTwoPatches());
  selection_.selectCell(CellId(23));
  QTest::keyClick(&view_, Qt::Key_Left);
  QTest::keyClick(&view_, Qt::Key_Left);
  EXPECT_LT(selection_.cell().value(), CellId(20));
}

TEST_F(GraphViewTest, TypingDigitsOrCtrlFFindsACellAndBringsItIntoView) {
  show(sampleSheet(30, 30));
  wheel(cell(1), 2400);
  EXPECT_FALSE(view_.rect().contains(cell(900)));
  auto* field = test::part<QLineEdit>(view_);
  EXPECT_FALSE(field->isVisible());
  QTest::keyClick(&view_, Qt::Key_9);
  EXPECT_TRUE(field->isVisible());
  EXPECT_EQ(field->text(), "9");
  QTest::keyClicks(field, "00x");
  EXPECT_EQ(field->text(), "900");
  EXPECT_EQ(selection_.cell(), CellId(900));
  QTest::keyClicks(field, "1");
  EXPECT_EQ(selection_.cell(), CellId(900));  // there is no cell 9001: said, not jumped
  QTest::keyClick(field, Qt::Key_Escape);
  EXPECT_FALSE(field->isVisible());
  QTest::keyClick(&view_, Qt::Key_F, Qt::ControlModifier);
  QTest::keyClicks(field, "900");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_FALSE(field->isVisible());
  EXPECT_TRUE(view_.rect().contains(cell(900)));
}

TEST_F(GraphViewTest, TellsScreenReadersWhatItShowsAndWhatIsPicked) {
  EXPECT_FALSE(view_.accessibleName().isEmpty());
  EXPECT_EQ(view_.accessibleDescription(), "No skin is open.");
  show(sampleX17());
  EXPECT_EQ(view_.accessibleDescription(), "17 cells, 16 links, 1 patch");
  selection_.selectCell(CellId(9));
  EXPECT_THAT(view_.accessibleDescription(), HasText("Picked: cell 9"));
  EXPECT_EQ(view_.focusPolicy(), Qt::StrongFocus);
}

TEST_F(GraphViewTest, DrawsTenThousandCellsAtEveryZoomAndPicksAmongThem) {
  show(sampleSheet(100, 100));
  QTest::mouseClick(&view_, Qt::LeftButton, Qt::NoModifier, cell(5050));
  EXPECT_EQ(selection_.cell(), CellId(5050));
  QTest::mouseClick(&view_, Qt::LeftButton, Qt::NoModifier, (cell(5050) + cell(5060)) / 2);
  EXPECT_TRUE(selection_.cell()) << "between dots a cell is meant, not a link";
  for (int step = 0; step < 12; ++step) {
    wheel(cell(5050), 240);
    EXPECT_FALSE(image().isNull());
  }
  QTest::mouseClick(&view_, Qt::LeftButton, Qt::NoModifier, cell(5050));
  EXPECT_EQ(selection_.cell(), CellId(5050));
}

}  // namespace
}  // namespace hexoderm
