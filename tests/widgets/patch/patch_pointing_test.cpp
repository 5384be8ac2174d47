// Pointing in the 3D view: what is under the mouse, what is picked, and how the camera gets there.

#include "hexoderm/solve/metrics/cell_links.h"
#include "tests/support/picture_counter.h"
#include "tests/widgets/patch/patch_view_fixture.h"
#include "widgets/controls/figure_card.h"
#include "widgets/patch/patch_marks.h"
#include "widgets/style/color_maps.h"
#include "widgets/style/palette.h"
#include "widgets/style/scene_colors.h"
#include "widgets/words/formatting.h"

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

namespace hexoderm {
namespace {

class PatchPointingTest : public PatchViewFixture {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(PatchViewFixture::SetUp());
    view.setAnimated(false);
    show(shared(demoReconstruction()));
  }

  void show(std::shared_ptr<const Reconstruction> shown) {
    skin = std::move(shown);
    view.setReconstruction(skin);
    view.waitUntilUpToDate();
    view.drawNow();
  }
  vtkRenderer* renderer() { return canvas->renderWindow()->GetRenderers()->GetFirstRenderer(); }
  Eigen::Vector3d cameraAt() { return Eigen::Vector3d(renderer()->GetActiveCamera()->GetPosition()); }
  QPoint positionOf(const Eigen::Vector3d& point) {
    renderer()->SetWorldPoint(point.x(), point.y(), point.z(), 1);
    renderer()->WorldToDisplay();
    const double* pixel = renderer()->GetDisplayPoint();
    const double ratio = canvas->devicePixelRatioF();
    return {qRound(pixel[0] / ratio), qRound(canvas->height() - 1 - pixel[1] / ratio)};
  }
  Eigen::Vector3d centerOf(CellId cell) { return skin->find(cell).cell->T_o_u.t; }
  QPoint positionOf(CellId cell) { return positionOf(centerOf(cell)); }

  void leave() {
    QEvent event(QEvent::Leave);
    QCoreApplication::sendEvent(canvas, &event);
  }
  FigureCard* hoverCard() { return view.findChild<FigureCard*>("hoverCard"); }
  FigureCard* figureCard() { return view.findChild<FigureCard*>("figureCard"); }
  const PatchMarks::Content& marks() { return view.findChild<PatchMarks*>()->content(); }
  /// Moves the mouse there, until it is found there: the display's own mouse may leave the view meanwhile.
  template <class Condition>
  bool hoverUntil(const QPoint& at, Condition condition) {
    return test::waitUntil([&] {
      if (condition()) return true;
      test::moveMouse(canvas, at);
      return false;
    });
  }
  bool hover(const QPoint& at, const QString& title) {
    return hoverUntil(at, [&] { return hoverCard()->isVisible() && hoverCard()->text().contains(title); });
  }

  std::shared_ptr<const Reconstruction> skin;
};

TEST_F(PatchPointingTest, ACardBesideTheMouseHasAllMetricsOfTheCellInTheWordsOfTheGraph) {
  for (const CellId cell : {CellId(1), CellId(4), CellId(9), CellId(17)}) {
    selection.seekCell(cell);
    selection.clear();
    view.drawNow();
    const QPoint mouse = positionOf(cell);
    ASSERT_TRUE(hover(mouse, QStringLiteral("<b>Cell %1</b>").arg(cell.value()))) << cell;
    EXPECT_TRUE(hoverCard()->text().startsWith(cellToolTip(*skin, cell))) << cell;
    EXPECT_TRUE(view.rect().contains(hoverCard()->geometry())) << cell;
    EXPECT_FALSE(hoverCard()->geometry().contains(mouse)) << cell;
    EXPECT_TRUE(marks().hovered.isThere()) << cell;
    EXPECT_TRUE(marks().hovered.line.containsPoint(mouse, Qt::OddEvenFill)) << cell;
    leave();
    EXPECT_FALSE(hoverCard()->isVisible()) << cell;
    EXPECT_FALSE(marks().hovered.isThere()) << cell;
  }
}

TEST_F(PatchPointingTest, BesideAPortItIsTheLink) {
  look(PatchView::StandardView::Front);
  const QPoint between = positionOf(0.5 * (centerOf(CellId(1)) + centerOf(CellId(2))));
  const LinkEstimate& link = skin->patches[0].links[0];
  ASSERT_EQ(link.target.cell, CellId(2));
  ASSERT_TRUE(hover(between, "<b>Link 1"));
  EXPECT_EQ(hoverCard()->text(), linkToolTip(*skin, link));
  QTest::mouseClick(canvas, Qt::LeftButton, {}, between);
  EXPECT_EQ(selection.link(), Selection::Link(link.source, link.target));
  EXPECT_TRUE(marks().picked.isThere());
  EXPECT_FALSE(marks().picked.closed);
}

TEST_F(PatchPointingTest, PointingDrawsNothingOfTheSceneAnew) {
  ASSERT_TRUE(test::waitUntil([this] { return canvas->isPictureSmoothed(); }));
  test::letTurnsPass();
  const test::PictureCounter drawn(*canvas);
  for (const CellId cell : {CellId(1), CellId(2), CellId(3)}) {
    ASSERT_TRUE(hover(positionOf(cell), QStringLiteral("<b>Cell %1</b>").arg(cell.value())));
  }
  leave();
  test::letTurnsPass();
  EXPECT_EQ(drawn.count(), 0);
  selection.selectCell(CellId(2));  // so that it would be counted
  EXPECT_TRUE(test::waitUntil([&] { return drawn.count() > 0; }));
}

TEST_F(PatchPointingTest, WhileTheSceneIsTurnedNothingIsPointedAt) {
  ASSERT_TRUE(hover(positionOf(CellId(1)), "<b>Cell 1</b>"));
  QTest::mousePress(canvas, Qt::LeftButton, {}, positionOf(CellId(1)));
  EXPECT_FALSE(hoverCard()->isVisible());
  test::moveMouse(canvas, positionOf(CellId(1)) + QPoint(30, 8), Qt::LeftButton);
  test::letTurnsPass();
  EXPECT_FALSE(hoverCard()->isVisible());
  EXPECT_FALSE(marks().hovered.isThere());
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, positionOf(CellId(1)) + QPoint(30, 8));
}

TEST_F(PatchPointingTest, InASmallViewTheCardIsShorterAndStillBesideTheMouse) {
  view.resize(330, 250);
  ASSERT_TRUE(test::waitUntil([this] { return canvas->width() == 330; }));
  view.drawNow();
  for (const CellId cell : {CellId(1), CellId(6), CellId(8)}) {
    const QPoint mouse = positionOf(cell);
    ASSERT_TRUE(hoverUntil(mouse, [this] { return marks().hovered.isThere(); })) << cell;
    EXPECT_TRUE(view.rect().contains(hoverCard()->geometry())) << cell;
    EXPECT_FALSE(hoverCard()->geometry().contains(mouse)) << cell;
    leave();
  }
}

/// The largest contrast between two pixels on a line across the middle of each edge of the outline; the least of the
/// edges.
double leastContrastAcross(const QImage& picture, const QPolygonF& outline) {
  const double ratio = picture.devicePixelRatio();
  double least = 21;
  for (int k = 0; k < outline.size(); ++k) {
    const QPointF a = outline[k];
    const QPointF b = outline[(k + 1) % outline.size()];
    const QPointF along = b - a;
    const double length = std::hypot(along.x(), along.y());
    if (length < 6) continue;
    const QPointF across(along.y() / length, -along.x() / length);
    // Contrasts to black; that between two colours is their quotient.
    double darkest = 21;
    double lightest = 1;
    for (double step = -6; step <= 6; step += 0.5) {
      const QPoint at = (ratio * (0.5 * (a + b) + step * across)).toPoint();
      if (!picture.valid(at)) continue;
      const double to_black = contrast(toRgb(picture.pixelColor(at)), {0, 0, 0});
      darkest = std::min(darkest, to_black);
      lightest = std::max(lightest, to_black);
    }
    least = std::min(least, lightest / darkest);
  }
  return least;
}

TEST_F(PatchPointingTest, ThePickedCellStandsOutOnEveryMapInBothThemes) {
  constexpr double kStandsOut = 7;  // the WCAG's for text that has to be read
  view.showStandardView(PatchView::StandardView::Front);
  int maps = 0;
  int would_not = 0;
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    view.setPalette(qtPalette(theme));
    for (const ColoringRow& row : coloringTable()) {
      if (row.patch_title == nullptr || !controls().action(row.coloring)->isEnabled()) continue;
      controls().action(row.coloring)->setChecked(true);
      ++maps;
      for (const CellId cell : {CellId(1), CellId(7)}) {
        selection.selectCell(cell);
        const QImage picked = view.screenshot();
        const QPolygonF outline = marks().picked.line;
        ASSERT_GE(outline.size(), 6);
        EXPECT_GT(leastContrastAcross(picked, outline), kStandsOut) << row.name << " " << static_cast<int>(theme);
        selection.clear();
        if (leastContrastAcross(view.screenshot(), outline) < kStandsOut) ++would_not;
      }
    }
  }
  EXPECT_GE(maps, 10);
  EXPECT_GT(would_not, 0) << "or cells that are not picked stand out as much";
}

TEST_F(PatchPointingTest, APickedCellThatIsHiddenIsSeenThroughTheOthersWithItsNumber) {
  view.showStandardView(PatchView::StandardView::Front);
  selection.selectCell(CellId(1));
  view.drawNow();
  EXPECT_FALSE(marks().picked.hidden);
  EXPECT_TRUE(marks().picked.tag.isEmpty()) << "it stands on the cell";
  // From the side the cylinder hides what is on its other side.
  look(PatchView::StandardView::Side);
  int hidden = 0;
  for (const CellPlacement& cell : skin->patches[0].cells) {
    selection.selectCell(cell.cell);
    ASSERT_TRUE(marks().picked.isThere()) << cell.cell;
    if (!marks().picked.hidden) continue;
    ++hidden;
    EXPECT_EQ(marks().picked.tag, QString::number(cell.cell.value()));
  }
  EXPECT_GT(hidden, 2);
}

TEST_F(PatchPointingTest, OfALargeSkinTheNumberOfThePickedCellIsThere) {
  show(shared(cylinderSheet(60, 50)));
  selection.selectCell(CellId(1500));
  EXPECT_EQ(marks().picked.tag, "1500");
  selection.seekCell(CellId(2999));
  view.drawNow();
  EXPECT_TRUE(marks().picked.tag.isEmpty()) << "it stands on the cell, which is near now";
  EXPECT_FALSE(marks().picked.hidden);
  EXPECT_GT(marks().picked.line.boundingRect().width(), 25);
}

TEST_F(PatchPointingTest, TheCameraTurnsToEveryCellThatIsSought) {
  int were_hidden = 0;
  for (const PatchView::StandardView from :
       {PatchView::StandardView::Front, PatchView::StandardView::Side, PatchView::StandardView::Top}) {
    for (const CellPlacement& cell : skin->patches[0].cells) {
      view.showStandardView(from);
      selection.selectCell(cell.cell);
      view.drawNow();
      if (marks().picked.hidden) ++were_hidden;
      selection.seekCell(cell.cell);
      view.drawNow();
      EXPECT_FALSE(marks().picked.hidden) << cell.cell;
      EXPECT_TRUE(view.rect().contains(positionOf(cell.cell))) << cell.cell;
    }
  }
  EXPECT_GT(were_hidden, 5) << "or nothing was turned to";
}

TEST_F(PatchPointingTest, WhatIsSeenAlreadyIsNotTurnedTo) {
  look(PatchView::StandardView::Front);
  const Eigen::Vector3d ahead(renderer()->GetActiveCamera()->GetDirectionOfProjection());
  selection.seekCell(CellId(2));
  const Eigen::Vector3d then(renderer()->GetActiveCamera()->GetDirectionOfProjection());
  EXPECT_LT((then - ahead).norm(), 1e-6);
}

TEST_F(PatchPointingTest, ADoubleClickGoesToTheCellAndEscComesBack) {
  ASSERT_NO_FATAL_FAILURE(activate());
  const Eigen::Vector3d before = cameraAt();
  const QPoint at = positionOf(CellId(10));
  QTest::mouseDClick(canvas, Qt::LeftButton, {}, at);
  const std::optional<CellId> picked = selection.cell();
  ASSERT_TRUE(picked);
  EXPECT_GT((cameraAt() - before).norm(), 1e-3);
  view.drawNow();
  EXPECT_LT((positionOf(*picked) - positionOf(Eigen::Vector3d(renderer()->GetActiveCamera()->GetFocalPoint())))
                .manhattanLength(),
            4);
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_LT((cameraAt() - before).norm(), 1e-6);
  EXPECT_EQ(selection.cell(), picked) << "Esc leads back, and the cell stays picked";
}

TEST_F(PatchPointingTest, AfterFitThereIsNothingToComeBackTo) {
  ASSERT_NO_FATAL_FAILURE(activate());
  selection.seekCell(CellId(16));
  view.fit();
  view.drawNow();
  const Eigen::Vector3d fitted = cameraAt();
  QTest::keyClick(&view, Qt::Key_Escape);
  view.drawNow();
  EXPECT_LT((cameraAt() - fitted).norm(), 1e-9);
}

TEST_F(PatchPointingTest, TheCameraGlidesToWhereItWouldHaveJumped) {
  look(PatchView::StandardView::Side);
  selection.seekCell(CellId(15));
  const Eigen::Vector3d jumped = cameraAt();
  look(PatchView::StandardView::Side);
  const Eigen::Vector3d before = cameraAt();
  view.setAnimated(true);
  selection.seekCell(CellId(15));
  EXPECT_TRUE(view.isAnimating());
  EXPECT_LT((cameraAt() - before).norm(), (cameraAt() - jumped).norm()) << "it has only begun";
  ASSERT_TRUE(test::waitUntil([this] { return !view.isAnimating(); }));
  EXPECT_LT((cameraAt() - jumped).norm(), 1e-6);
}

TEST_F(PatchPointingTest, ArrowKeysWalkToTheNeighbourThatLiesThere) {
  look(PatchView::StandardView::Front);
  EXPECT_EQ(view.focusPolicy(), Qt::StrongFocus);
  QTest::keyClick(&view, Qt::Key_Right);
  EXPECT_EQ(selection.cell(), CellId(1)) << "the origin, where nothing is picked";
  const std::pair<Qt::Key, QPoint> ways[] = {
      {Qt::Key_Right, {1, 0}}, {Qt::Key_Left, {-1, 0}}, {Qt::Key_Up, {0, -1}}, {Qt::Key_Down, {0, 1}}};
  int steps = 0;
  for (const auto& [key, way] : ways) {
    selection.selectCell(CellId(1));
    for (int k = 0; k < 3; ++k) {
      const CellId from = *selection.cell();
      const QPoint here = positionOf(from);
      QTest::keyClick(&view, key);
      const CellId to = *selection.cell();
      if (to == from) break;
      ++steps;
      view.drawNow();
      const auto links = linksOf(*skin, from);
      EXPECT_TRUE(
          std::ranges::any_of(links, [&](const LinkEstimate* link) { return neighborAcross(*link, from) == to; }))
          << from << " to " << to;
      if (k == 0) {
        EXPECT_GT(QPoint::dotProduct(positionOf(to) - here, way), 0) << from << " to " << to;
      }
    }
  }
  EXPECT_GE(steps, 8);
  selection.selectLink({CellId(1), PortNumber(1)}, {CellId(2), PortNumber(4)});
  QTest::keyClick(&view, Qt::Key_Right);
  EXPECT_TRUE(selection.cell() == CellId(1) || selection.cell() == CellId(2));
}

TEST_F(PatchPointingTest, TheMetricsOfWhatIsPickedAreKeptAndLeadToTheNeighbours) {
  ASSERT_NO_FATAL_FAILURE(activate());
  selection.selectCell(CellId(6));
  EXPECT_FALSE(figureCard()->isVisible());
  QTest::keyClick(&view, Qt::Key_Return);
  ASSERT_TRUE(figureCard()->isVisible());
  EXPECT_TRUE(figureCard()->text().startsWith(cellToolTip(*skin, CellId(6))));
  EXPECT_TRUE(view.rect().contains(figureCard()->geometry()));
  EXPECT_FALSE(figureCard()->geometry().intersects(marks().picked.line.boundingRect().toAlignedRect()));
  auto* ten = test::part<QToolButton>(*figureCard(), "neighbor10");
  EXPECT_FALSE(ten->accessibleName().isEmpty());
  EXPECT_NE(ten->focusPolicy() & Qt::TabFocus, 0) << "reached by the keyboard";
  ten->click();
  EXPECT_EQ(selection.cell(), CellId(10));
  EXPECT_TRUE(figureCard()->text().contains("<b>Cell 10</b>"));
  selection.selectLink({CellId(1), PortNumber(1)}, {CellId(2), PortNumber(4)});
  EXPECT_TRUE(figureCard()->text().contains("<b>Link 1"));
  EXPECT_NE(figureCard()->findChild<QToolButton*>("neighbor2"), nullptr);
  const QList<QToolButton*> buttons = figureCard()->findChildren<QToolButton*>(QRegularExpression("^neighbor"));
  EXPECT_EQ(std::ranges::count_if(buttons, [](const QToolButton* button) { return !button->isHidden(); }), 2)
      << "those of the cell's other neighbours are hidden";
  selection.clear();
  EXPECT_FALSE(figureCard()->isVisible());
  selection.selectCell(CellId(3));
  EXPECT_TRUE(figureCard()->isVisible());
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_FALSE(figureCard()->isVisible());
  EXPECT_FALSE(view.areMetricsShown());
  view.setMetricsShown(true);
  test::part<QToolButton>(*figureCard(), "closeFigures")->click();
  EXPECT_FALSE(view.areMetricsShown());
}

TEST_F(PatchPointingTest, TheColourOfTheCellIsOnItsCardAsAFigure) {
  controls().action(Coloring::Residual)->setChecked(true);
  selection.selectCell(CellId(2));
  view.setMetricsShown(true);
  EXPECT_THAT(figureCard()->text(), HasText("0.40°"));
  read(readingsOf({{CellId(2), {0.1, 0.2, 0.93}}}));
  controls().action(Coloring::ReadingZ)->setChecked(true);
  EXPECT_THAT(figureCard()->text(), HasText("0.93"));
  read(readingsOf({{CellId(2), {0.1, 0.2, -0.51}}}));
  EXPECT_THAT(figureCard()->text(), HasText("−0.51"));
}

TEST_F(PatchPointingTest, TheCellThatAnInstructionSpeaksOfIsLitAndNamed) {
  view.showStandardView(PatchView::StandardView::Front);
  const QImage before = view.screenshot();
  const QPoint at = positionOf(CellId(7));
  moment.told_cell = CellId(7);
  view.setMoment(moment);
  const QImage told = view.screenshot();
  EXPECT_EQ(marks().told.tag, "cell 7");
  ASSERT_TRUE(marks().told.line.containsPoint(at, Qt::OddEvenFill));
  const QColor accent = Colors::of(Theme::Light).accent;
  const auto distanceToAccent = [&](const QImage& picture) {
    const QColor color = picture.pixelColor(at * picture.devicePixelRatio() + QPoint(0, 9));
    return std::abs(color.red() - accent.red()) + std::abs(color.green() - accent.green()) +
           std::abs(color.blue() - accent.blue());
  };
  EXPECT_LT(distanceToAccent(told), distanceToAccent(before));
  moment.told_cell.reset();
  view.setMoment(moment);
  EXPECT_FALSE(marks().told.isThere());
  EXPECT_EQ(view.screenshot(), before);
}

TEST_F(PatchPointingTest, WhereSomethingWasFoundIsPointedOutAlsoWhereItIsHidden) {
  EXPECT_THAT(marks().found, testing::IsEmpty());
  const QImage before = view.screenshot();
  auto faulty = std::make_shared<Reconstruction>(*skin);
  faulty->findings.push_back(makeFinding(FindingCode::DeadSensor, {}, {CellId(7)}));
  show(faulty);
  for (const auto side : {PatchView::StandardView::Front, PatchView::StandardView::Side}) {
    look(side);
    ASSERT_EQ(marks().found.size(), 1u);
    EXPECT_EQ(marks().found.front().tag, "7");
    EXPECT_EQ(marks().found.front().sign, Severity::Error);
    EXPECT_TRUE(marks().found.front().line.containsPoint(positionOf(CellId(7)), Qt::OddEvenFill));
  }
  EXPECT_NE(view.screenshot(), before);
  selection.selectCell(CellId(7));
  EXPECT_TRUE(marks().picked.isThere());
  EXPECT_TRUE(marks().picked.tag.isEmpty()) << "its number is there already";
}

TEST_F(PatchPointingTest, WhileMeasuringLinksAreNotPicked) {
  look(PatchView::StandardView::Front);
  const QPoint between = positionOf(0.5 * (centerOf(CellId(1)) + centerOf(CellId(2)))) + QPoint(1, 0);
  controls().measureAction()->trigger();
  test::moveMouse(canvas, between);
  QTest::mouseClick(canvas, Qt::LeftButton, {}, between);
  EXPECT_FALSE(selection.link());
}

}  // namespace
}  // namespace hexoderm
