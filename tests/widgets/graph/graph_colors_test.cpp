// The graph's colours, its legend, its tooltips and its context menu.

#include "hexoderm/solve/result/reconstruction.h"
#include "tests/support/qt_wait.h"
#include "tests/widgets/graph/graph_view_fixture.h"
#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_ranges.h"
#include "widgets/style/color_maps.h"

namespace hexoderm {
namespace {

constexpr LinkEnd kFive{CellId(5), PortNumber(3)};
constexpr LinkEnd kNine{CellId(9), PortNumber(2)};

class GraphColorsTest : public GraphViewTest {
 protected:
  QToolButton* button() { return view_.findChild<QToolButton*>("graphColoring"); }
  QAction* colorAction(const QString& name) {
    for (QAction* action : button()->menu()->actions()) {
      if (action->text() == name) return action;
    }
    throw std::runtime_error("the menu has no " + name.toStdString());
  }
  /// The X17, each arm's links and cells with figures of their own.
  static std::shared_ptr<Reconstruction> withMetrics() {
    auto result = sampleX17();
    PatchReconstruction& patch = result->patches.front();
    for (CellPlacement& cell : patch.cells) {
      cell.cov_t_r = Matrix6d::Identity() * 1e-8;
      if (cell.cell != patch.origin) cell.predecessor = patch.origin;
    }
    patch.cells[8].cov_t_r = Matrix6d::Identity() * 1.0;  // cell 9: far beyond every scale
    patch.links[7].residual_rad = 50 * kDegree;           // 5 to 9
    patch.links[7].bend_rad = -80 * kDegree;
    return result;
  }
  QPoint linkTo9() { return view_.positionOf(kFive, kNine).value(); }
  QPoint linkTo2() { return view_.positionOf({CellId(1), PortNumber(1)}, {CellId(2), PortNumber(4)}).value(); }
};

QColor beyond(const ColorMap& map) { return toQColor(map.above); }

TEST_F(GraphColorsTest, LinksAreColouredByAFigureOnAScaleThatShowsWhatLiesBeyondIt) {
  show(withMetrics());
  view_.setColoring(Coloring::Residual);
  EXPECT_GT(countColor(image(), linkTo9(), 5, beyond(sequentialMap(Theme::Light))), 8) << "far from all others";
  EXPECT_EQ(countColor(image(), linkTo2(), 5, beyond(sequentialMap(Theme::Light))), 0);
  view_.setColoring(Coloring::Bend);
  EXPECT_GT(countColor(image(), linkTo9(), 5, toQColor(divergingMap(Theme::Light).below)), 8) << "bent the other way";
  view_.setColoring(Coloring::Residual);
  ScaleRanges ranges;
  view_.setScaleRanges(&ranges);
  ranges.fix(Coloring::Residual, {0, 2});  // 0.3 of 2 degrees: step 3 of 24
  EXPECT_GT(countColor(image(), linkTo2(), 5, toQColor(onScale(sequentialMap(Theme::Light).steps, 3.0 / 23))), 4);
  ranges.fix(Coloring::Residual, {0, 100});
  EXPECT_EQ(countColor(image(), linkTo9(), 5, beyond(sequentialMap(Theme::Light))), 0);
  view_.setColoring(Coloring::LinkQuality);
  EXPECT_GT(countColor(image(), linkTo2(), 5, linkStroke(EdgeQuality::Fully, Theme::Light).color), 8);
}

TEST_F(GraphColorsTest, CellsAreColouredByTheirUncertaintyAndLinksGoGrey) {
  show(withMetrics());
  // All others are alike: 0.196 mm on a scale from 0.145 to 0.250, 0.011 degrees on one from 0 to 0.1.
  for (const auto& [coloring, step] :
       {std::pair(Coloring::PositionUncertainty, 11), std::pair(Coloring::OrientationUncertainty, 3)}) {
    view_.setColoring(coloring);
    EXPECT_GT(countColor(image(), cell(9), 12, beyond(sequentialMap(Theme::Light))), 60);
    const Rgb color = onScale(sequentialMap(Theme::Light).steps, step / 23.0);
    EXPECT_GT(countColor(image(), cell(13), 12, toQColor(color)), 60) << step;
    EXPECT_EQ(countColor(image(), linkTo2(), 5, linkStroke(EdgeQuality::Fully, Theme::Light).color), 0);
  }
  show(sampleX17());  // states no uncertainty
  EXPECT_GT(countColor(image(), cell(9), 12, Colors::of(Theme::Light).cell_fill), 60) << "not known is no figure";
}

TEST_F(GraphColorsTest, BodyPartsCanBeChosenWhereTheyAreKnown) {
  show(sampleTwoPatches());
  EXPECT_FALSE(colorAction("body part")->isEnabled());
  EXPECT_THAT(colorAction("body part")->toolTip(), HasText("does not say"));
  auto parts = sampleTwoPatches();
  for (CellPlacement& cell : parts->patches[0].cells) cell.body_part = "forearm";
  for (CellPlacement& cell : parts->patches[1].cells) cell.body_part = "hand";
  show(parts);
  EXPECT_TRUE(colorAction("body part")->isEnabled());
  colorAction("body part")->trigger();
  EXPECT_EQ(view_.coloring(), Coloring::BodyPart);
  EXPECT_GT(countColor(image(), cell(2), 12, toQColor(classColors(Theme::Light)[0])), 60);
  EXPECT_GT(countColor(image(), cell(23), 12, toQColor(classColors(Theme::Light)[1])), 60);
}

TEST_F(GraphColorsTest, TheButtonSaysWhatTheColoursShowAndItsMenuChangesIt) {
  EXPECT_FALSE(button()->isVisible()) << "there is nothing to colour";
  show(sampleX17());
  EXPECT_TRUE(button()->isVisible());
  EXPECT_EQ(button()->text(), "Colour: link quality ▾");
  colorAction("yaw")->trigger();
  EXPECT_EQ(button()->text(), "Colour: yaw ▾");
  EXPECT_FALSE(button()->accessibleName().isEmpty());
  EXPECT_EQ(view_.coloring(), Coloring::Yaw);
  EXPECT_TRUE(view_.rect().contains(button()->geometry()));
}

TEST_F(GraphColorsTest, EveryColouringLooksDifferentAndHasALegend) {
  auto figures = withMetrics();
  figures->patches[0].cells[3].body_part = "hand";
  figures->patches[0].cells[5].placed_by = PlacedBy::Links;
  show(figures);
  std::vector<QImage> seen;
  for (const ColoringRow& row : coloringTable()) {
    if (row.graph_title == nullptr) continue;
    const Coloring coloring = row.coloring;
    view_.setColoring(coloring);
    const QImage now = image();
    for (const QImage& other : seen) EXPECT_NE(now, other) << coloringName(coloring).toStdString();
    seen.push_back(now);
    EXPECT_GT(markedPixels(now, QRect(0, now.height() - 26, now.width(), 20)), 300)
        << coloringName(coloring).toStdString();
  }
}

TEST_F(GraphColorsTest, LegendAndButtonGiveWayInASmallViewAndTheSkinKeepsClearOfThem) {
  show(sampleSheet(6, 6));
  for (std::uint32_t id = 1; id <= 36; ++id) {
    EXPECT_FALSE(button()->geometry().contains(cell(id))) << id;
    EXPECT_LT(cell(id).y(), view_.height() - 24) << "above the legend";
  }
  view_.resize(200, 130);
  ASSERT_TRUE(test::waitUntil([&] { return !button()->isVisible(); }));
  EXPECT_EQ(markedPixels(image(), QRect(0, view_.height() - 10, view_.width(), 10)), 0);
}

TEST_F(GraphColorsTest, ShortestPathsAreMarkedUnlessSwitchedOff) {
  show(sampleX17());
  const QColor band = Colors::of(Theme::Light).tree_band;
  const int marked = countColor(image(), linkTo2(), 8, band);
  test::part<QAction>(view_, "graphMarksTree")->trigger();
  EXPECT_GT(marked, countColor(image(), linkTo2(), 8, band) + 10);
}

TEST_F(GraphColorsTest, TheToolTipOfALinkHasAllItsMetrics) {
  auto result = withMetrics();
  LinkEstimate& link = result->patches[0].links[7];
  link.singular_values = {1.93, 1.05, 0.02};
  link.weight = 2;
  link.centred = true;
  link.supported = true;
  link.pose_residual_rad = {0.3 * kDegree, std::nullopt, 0.9 * kDegree};
  show(result);
  EXPECT_THAT(toolTipAt(linkTo9()),
              HasTexts({"Link 5 · port 3 — 9 · port 2", "Used, on the shortest paths", "partially defined",
                        "singular values 1.93, 1.05, 0.02", "weight 2", "Bend −80.0°, twist −0.4°, yaw 0.0°",
                        "Residual 50.0°, predicted deviation 0.7°", "Centred", "Support axes",
                        "Residual in pose 1: 0.3°, 3: 0.9°"}));
  link.pose_residual_rad.clear();
  for (int k = 0; k < 40; ++k) {
    link.pose_residual_rad.emplace_back(k * kDegree);
    result->poses.push_back({PoseId(100 + static_cast<std::uint32_t>(k)), {}, true, 17, 0, {}, {}});
  }
  result->poses.erase(result->poses.begin(), result->poses.begin() + 4);
  EXPECT_THAT(toolTipAt(linkTo9()), HasText("worst poses 139: 39.0°, 138: 38.0°"));
  QToolTip::hideText();
}

TEST_F(GraphColorsTest, TheToolTipOfAMutedLinkSaysWhyInTheFindingsWords) {
  auto result = sampleTwoPatches();
  LinkEstimate& link = result->patches[0].links[3];
  link.muted_by = FindingCode::LinkSetAside;
  result->findings.push_back(
      makeFinding(FindingCode::LinkSetAside,
                  Message::verbatim("The link 3 port 4 - 4 port 1 was set aside by hand (a cable); it is not used."),
                  {CellId(3), CellId(4)}, {PortNumber(4), PortNumber(1)}));
  show(result);
  const QPoint at = view_.positionOf({CellId(3), PortNumber(4)}, {CellId(4), PortNumber(1)}).value();
  EXPECT_THAT(toolTipAt(at), HasText("Muted: The link 3 port 4 - 4 port 1 was set aside by hand (a cable)"));
  QToolTip::hideText();
}

TEST_F(GraphColorsTest, TheToolTipOfACellHasAllItsMetrics) {
  auto result = withMetrics();
  CellPlacement& placement = result->patches[0].cells[12];
  placement.T_o_u = {rotationFromRpy({0.1, -0.2, 0.3}), {0.0123, -0.004, 0.00002}};
  placement.accel_offset_g = Eigen::Vector3d(0.061, -0.012, 0);
  placement.accel_scale = Eigen::Vector3d(1.01, 0.98, 1);
  result->patches[0].lot = {{0.03, -0.0101, 0}, {0.001, 0.002, 0.001}, 1.01, 0.004};
  const auto comeBefore = [&](std::initializer_list<std::uint32_t> path) {
    for (auto next = path.begin() + 1; next != path.end(); ++next) {
      result->patches[0].cells[*next - 1].predecessor = CellId(*(next - 1));
    }
  };
  comeBefore({1, 5, 9, 13});
  placement.body_part = "fore<arm>";
  show(result);
  EXPECT_THAT(toolTipAt(cell(13)),
              HasTexts({"Cell 13", "Patch 1", "On fore&lt;arm&gt;", "Placed by its own readings",
                        "At 12.3; −4.0; 0.0 mm", "Roll 5.7°, pitch −11.5°, yaw 17.2°", "Known to ±0.2 mm",
                        "Path from the origin: 1 → 5 → 9 → 13 (3 links)", "Accelerometer offset 61; −12; 0 mg",
                        "Accelerometer scale 1.010; 0.980; 1.000",
                        "Shared by its lot: offset 30.0, −10.1, 0.0 ± 2.0 mg, scale 1.010 ± 0.004 (1 sigma)"}));
  EXPECT_THAT(toolTipAt(cell(1)), HasText("Origin of patch 1"));
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  EXPECT_THAT(toolTipAt(cell(13)), HasText("12,3; −4,0; 0,0 mm"));
  QLocale::setDefault(QLocale::system());
  comeBefore({1, 5, 9, 2, 3, 4, 6, 7, 8, 10, 11, 12, 14, 13});
  EXPECT_THAT(toolTipAt(cell(13)), HasText("1 → 5 → 9 → 2 → … → 11 → 12 → 14 → 13 (13 links)"));
  QToolTip::hideText();
}

TEST_F(GraphColorsTest, ARightClickPicksWhatIsThereAndOffersWhatCanBeDoneWithIt) {
  QAction mute("Set link aside");
  QAction light("Light this cell");
  view_.setLinkActions({&mute});
  view_.setCellActions({&light});
  show(sampleX17());
  QSignalSpy muted(&mute, &QAction::triggered);
  const auto menuAt = [&](QPoint at, QContextMenuEvent::Reason reason = QContextMenuEvent::Mouse) {
    QContextMenuEvent event(reason, at, view_.mapToGlobal(at));
    QApplication::sendEvent(&view_, &event);
    return test::part<QMenu>(view_, "graphMenu");
  };
  const auto isClosed = [&] {
    return test::waitUntil([&] { return view_.findChild<QMenu*>("graphMenu") == nullptr; });
  };
  QMenu* menu = menuAt(linkTo9());
  EXPECT_EQ(selection_.link(), Selection::Link(kFive, kNine));
  EXPECT_TRUE(menu->actions().contains(&mute));
  EXPECT_FALSE(menu->actions().contains(&light));
  QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(&mute).center());
  EXPECT_EQ(muted.count(), 1);
  ASSERT_TRUE(isClosed());

  menu = menuAt(cell(13));
  EXPECT_EQ(selection_.cell(), CellId(13));
  EXPECT_TRUE(menu->actions().contains(&light));
  QTest::keyClick(menu, Qt::Key_Escape);
  ASSERT_TRUE(isClosed());
  menu = menuAt({3, 3}, QContextMenuEvent::Keyboard);  // the menu key opens it for what is picked
  EXPECT_EQ(selection_.cell(), CellId(13));
  QTest::keyClick(menu, Qt::Key_Escape);
}

TEST_F(GraphColorsTest, PointingDrawsNoMoreThanWhatItTouches) {
  show(sampleSheet(20, 20));
  view_.setFocus();
  struct PaintedArea : QObject {
    QRect area;
    bool eventFilter(QObject*, QEvent* event) override {
      if (event->type() == QEvent::Paint) area |= static_cast<QPaintEvent*>(event)->rect();
      return false;
    }
  } painted;
  view_.installEventFilter(&painted);
  // On a busy machine the last paint events of showing the view come while the mouse moves already, so that one move
  // proves nothing; if pointing drew too much, every move would.
  const auto drawsLittle = [&] {
    test::moveMouse(&view_, cell(30));
    QApplication::processEvents();
    painted.area = {};
    test::moveMouse(&view_, cell(31));
    QApplication::processEvents();
    return painted.area.contains(cell(31)) && painted.area.width() < view_.width() / 2;
  };
  EXPECT_TRUE(test::waitUntil(drawsLittle)) << painted.area.width() << " of " << view_.width() << " pixels";
}

TEST_F(GraphColorsTest, ThePictureIsCopiedAsItIsSeen) {
  show(sampleX17());
  selection_.clear();
  view_.copyPicture();
  const QImage copied = QApplication::clipboard()->image();
  EXPECT_EQ(copied.size(), view_.size());
  EXPECT_GT(countColor(copied, linkTo2(), 5, linkStroke(EdgeQuality::Fully, Theme::Light).color), 8);
}

}  // namespace
}  // namespace hexoderm
