// Faults of a skin and of its poses, as the window reports them, and the way from a cell or a finding to its place, its
// figures and what can be done about it.

#include "app/window/toolkit/result_tables.h"
#include "hexoderm/solve/metrics/assess.h"
#include "hexoderm/solve/metrics/cell_links.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/figure_card.h"
#include "widgets/controls/finding_card.h"
#include "widgets/patch/patch_marks.h"
#include "widgets/patch/patch_view.h"
#include "widgets/patch/scene_widget.h"
#include "widgets/tables/cell_table.h"
#include "widgets/tables/finding_table.h"
#include "widgets/words/formatting.h"

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

namespace hexoderm {
namespace {

class WindowFindingsTest : public WindowTest {
 protected:
  static Session withARepeatedPose() {
    Session session = simulated(3, {}, 100);
    auto again = std::make_shared<PoseCapture>(*session.poses()[1].capture);
    again->id = PoseId(9);
    session.addPose({again});
    return session;
  }
  static Session withDeadCell() {
    SimulatedSkinOptions options;
    options.faults = {{SkinFault::Dead, CellId(7)}};
    return simulated(6, options, 100);
  }
  /// A joint at port 1 of cell 1.
  static Session withJoint() {
    SimulatedSkinOptions options;
    options.seed = 4;
    options.link_faults = {{LinkFaultKind::Joint, {CellId(1), PortNumber(1)}}};
    return simulated(6, options, 100);
  }
  static std::string textOf(const QModelIndex& index) { return index.data().toString().toStdString(); }
  bool isSaidIn(const char* step, const QString& text) {
    const auto labels = find<QWidget>(step)->findChildren<QLabel*>();
    return std::ranges::any_of(labels, [&](const QLabel* each) { return each->isVisible() && each->text() == text; });
  }
  void expectIsNamedAndPicked(FindingCode code, const std::vector<CellId>& cells);
};

/// Of the result that is shown: a finding of this code is listed with the number of one of the cells, if any are
/// given, and with its poses, is picked by keys, and the worst is said by the step Review.
void WindowFindingsTest::expectIsNamedAndPicked(FindingCode code, const std::vector<CellId>& cells) {
  const Reconstruction& result = *controller().reconstruction();
  auto* view = find<QTableView>("findingView");
  ASSERT_TRUE(view->isVisible());
  const auto* table = qobject_cast<FindingTable*>(view->model());
  ASSERT_NE(table, nullptr);
  int row = -1;
  std::string listed;
  for (int k = 0; k < table->rowCount(); ++k) {
    const Finding& finding = table->findingAt(k);
    listed += std::string(codeName(finding.code)) + ": " + finding.message.english() + '\n';
    if (row < 0 && finding.code == code) row = k;
  }
  ASSERT_GE(row, 0) << "found only\n" << listed;
  EXPECT_TRUE(find<QTabBar>("detailTabs")->tabText(0).contains(QString::number(table->rowCount())));

  // Its line says how bad it is and which cell it is about, and the keys pick that.
  const Finding& finding = table->findingAt(row);
  EXPECT_FALSE(textOf(table->index(row, 0)).empty());
  const std::string line = textOf(table->index(row, 1)) + ' ' + textOf(table->index(row, 2));
  EXPECT_GT(textOf(table->index(row, 1)).size(), 15U) << line;
  window_->selection().clear();
  view->setFocus(Qt::TabFocusReason);
  press(Qt::Key_Home, Qt::ControlModifier);
  for (int k = 0; k < row; ++k) press(Qt::Key_Down);
  press(Qt::Key_Return);
  ASSERT_EQ(view->currentIndex().row(), row);
  if (!finding.cells.empty()) {
    EXPECT_TRUE(window_->selection().cell() || window_->selection().link()) << line;
  }
  if (!cells.empty()) {
    const bool named = std::ranges::any_of(cells, [&](CellId cell) {
      return std::ranges::count(finding.cells, cell) > 0 &&
             line.find(std::to_string(cell.value())) != std::string::npos;
    });
    EXPECT_TRUE(named) << line;
  }
  for (const PoseId pose : finding.poses) {
    EXPECT_NE(line.find(std::to_string(pose.value())), std::string::npos) << line;
  }

  // The step Review says the worst of them.
  press(Qt::Key_4, Qt::ControlModifier);
  const Finding* worst = worstFinding(result);
  // The verdict itself stands in the banner alone.
  EXPECT_TRUE(isSaidIn("step4", worst ? unbroken(QString::fromStdString(worst->message.english()))
                                : result.findings.empty()
                                    ? "Nothing was found that does not fit."
                                    : "Nothing was found that does not fit. There are notes only."))
      << listed;
}

// Every way in which a finding has its place: a cell, a link, a pose, none of these. That each fault is found is for
// the tests of the reconstruction to show.
TEST_F(WindowFindingsTest, OfEveryKindAreNamedAndPicked) {
  const struct {
    const char* name;
    FindingCode code;
    std::vector<CellId> cells;  ///< one of these is named; empty: not looked at
    Session session;
  } cases[] = {
      {"dead_cell", FindingCode::DeadSensor, {CellId(7)}, withDeadCell()},
      {"joint", FindingCode::LinkNotRigid, {CellId(1)}, withJoint()},
      {"repeated_pose", FindingCode::RepeatedPose, {}, withARepeatedPose()},
      {"no_poses", FindingCode::NoPoses, {}, simulated(0)},
  };
  for (const auto& fault : cases) {
    SCOPED_TRACE(fault.name);
    ASSERT_NO_FATAL_FAILURE(openSession(QStringLiteral("%1.session.json").arg(fault.name), fault.session));
    ASSERT_NO_FATAL_FAILURE(expectIsNamedAndPicked(fault.code, fault.cells));
  }
}

TEST_F(WindowFindingsTest, TooFewPosesAreSaidWithWhatToDoNext) {
  for (const std::size_t poses : {0U, 1U}) {
    ASSERT_NO_FATAL_FAILURE(openSession(QStringLiteral("%1.session.json").arg(poses), simulated(poses, {}, 100)));
    const Assessment& verdict = controller().reconstruction()->assessment;
    press(Qt::Key_3, Qt::ControlModifier);
    EXPECT_TRUE(isSaidIn("step3", QString::fromStdString(verdict.next_action.english()))) << verdict.next_action;
    EXPECT_FALSE(bannerButton().contains("Export")) << "not good enough to offer it";
  }
}

class WindowInspectTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    patch_ = window_->findChild<PatchView*>();
    patch_->setAnimated(false);
  }

  void open(const SimulatedSkinOptions& options, std::size_t poses = 4) {
    ASSERT_NO_FATAL_FAILURE(openSession("arm.session.json", simulated(poses, options, 100)));
    patch_->drawNow();
  }
  Eigen::Vector3d cameraAt() {
    auto* canvas = patch_->findChild<SceneWidget*>();
    return Eigen::Vector3d(
        canvas->renderWindow()->GetRenderers()->GetFirstRenderer()->GetActiveCamera()->GetPosition());
  }
  const PatchMarks::Content& marks() { return patch_->findChild<PatchMarks*>()->content(); }
  FigureCard* figureCard() { return patch_->findChild<FigureCard*>("figureCard"); }
  std::optional<CellId> picked() { return window_->selection().cell(); }
  /// The cell whose row is picked in the table of cells.
  std::optional<CellId> rowPicked() {
    const QModelIndexList rows = find<QTableView>("cellView")->selectionModel()->selectedRows();
    if (rows.size() != 1) return std::nullopt;
    return window_->findChild<CellTableModel*>()->cellAt(sourceRow(rows.front()));
  }
  PatchView* patch_ = nullptr;
};

TEST_F(WindowInspectTest, OneKeyLeadsToTheWorstCellItsMetricsAndItsNeighbours) {
  EXPECT_FALSE(action("actionWorstCell")->isEnabled());
  ASSERT_NO_FATAL_FAILURE(open({}));
  const Reconstruction& result = *controller().reconstruction();
  const std::vector<CellId> worst = worstCells(result);
  ASSERT_FALSE(worst.empty());
  // The verdict names it.
  EXPECT_THAT(labelText("bannerSentence"), AllOf(HasText("worst"), HasText(QString::number(worst.front().value()))));
  const Eigen::Vector3d before = cameraAt();
  press(Qt::Key_W);
  EXPECT_EQ(picked(), worst.front());
  ASSERT_TRUE(figureCard()->isVisible());
  EXPECT_TRUE(figureCard()->text().startsWith(cellToolTip(result, worst.front())));
  for (const LinkEstimate* link : linksOf(result, worst.front())) {
    const auto name = QStringLiteral("neighbor%1").arg(neighborAcross(*link, worst.front()).value());
    EXPECT_NE(figureCard()->findChild<QToolButton*>(name), nullptr) << name.toStdString();
  }
  EXPECT_GT((cameraAt() - before).norm(), 1e-4);
  patch_->drawNow();
  EXPECT_FALSE(marks().picked.hidden);
  EXPECT_EQ(rowPicked(), worst.front());
  EXPECT_TRUE(patch_->hasFocus());
}

TEST_F(WindowInspectTest, ADoubleClickOnARowAndTheFindFieldGoToTheCell) {
  ASSERT_NO_FATAL_FAILURE(open({}));
  showTab("Cells");
  auto* table = find<QTableView>("cellView");
  ASSERT_TRUE(waitUntil([&] { return table->isVisible(); }));
  const Eigen::Vector3d before = cameraAt();
  const QRect row = table->visualRect(table->model()->index(1, 0));
  QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, row.center());
  ASSERT_TRUE(picked());
  EXPECT_LT((cameraAt() - before).norm(), 1e-9) << "a click picks";
  QTest::mouseDClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, row.center());
  EXPECT_GT((cameraAt() - before).norm(), 1e-4);
  const Eigen::Vector3d there = cameraAt();
  press(Qt::Key_F, Qt::ControlModifier);
  QTest::keyClicks(QApplication::focusWidget(), "16");
  EXPECT_EQ(picked(), CellId(16));
  EXPECT_GT((cameraAt() - there).norm(), 1e-4);
  EXPECT_EQ(rowPicked(), CellId(16));
  // Scrolled into view.
  const QModelIndexList rows = table->selectionModel()->selectedRows();
  ASSERT_EQ(rows.size(), 1);
  EXPECT_TRUE(table->viewport()->rect().intersects(table->visualRect(rows.front())));
}

TEST_F(WindowInspectTest, AFindingIsACardThatLeadsToItsCellAndSoDoesTheBanner) {
  SimulatedSkinOptions options;
  options.faults = {{SkinFault::Dead, CellId(7)}};
  ASSERT_NO_FATAL_FAILURE(open(options, 6));
  press(Qt::Key_4, Qt::ControlModifier);
  auto* cards = find<FindingCards>("reviewFindings");
  ASSERT_TRUE(waitUntil([&] { return cards->isVisible() && !cards->cards().empty(); }));
  FindingCard* card = cards->cards().front();
  EXPECT_EQ(card->finding().code, FindingCode::DeadSensor);
  EXPECT_TRUE(card->findChild<QLabel*>("findingWhy")->isVisible());
  EXPECT_TRUE(card->findChild<QLabel*>("findingToDo")->isVisible());
  const Eigen::Vector3d before = cameraAt();
  click(card->findChild<QPushButton*>("findingShow"));
  EXPECT_EQ(picked(), CellId(7));
  EXPECT_GT((cameraAt() - before).norm(), 1e-4);
  // The same beside the table of findings.
  showTab("Findings");
  auto* beside = find<QTableView>("findingView")->parentWidget()->parentWidget()->findChild<FindingCard*>();
  ASSERT_NE(beside, nullptr);
  EXPECT_TRUE(beside->isVisible());
  EXPECT_EQ(beside->finding().code, FindingCode::DeadSensor);
  // And on top.
  window_->selection().clear();
  EXPECT_EQ(bannerButton(), "Show what does not fit");
  clickBanner();
  EXPECT_EQ(picked(), CellId(7));
}

TEST_F(WindowInspectTest, WhatCanBeDoneAboutALinkIsDoneFromItsCard) {
  SimulatedSkinOptions options;
  options.seed = 4;
  options.link_faults = {{LinkFaultKind::Joint, {CellId(1), PortNumber(1)}}};
  ASSERT_NO_FATAL_FAILURE(open(options, 6));
  press(Qt::Key_4, Qt::ControlModifier);
  auto* cards = find<FindingCards>("reviewFindings");
  ASSERT_TRUE(waitUntil([&] { return cards->isVisible(); }));
  const auto buttons = cards->findChildren<QPushButton*>();
  const auto remedy =
      std::ranges::find_if(buttons, [](const QPushButton* each) { return each->text() == "Set link aside"; });
  ASSERT_NE(remedy, buttons.end());
  const auto muted = [&] { return controller().session()->mutedLinks().size(); };
  const std::size_t before = muted();
  for (FindingCard* card : cards->cards()) card->setUnfolded(true);
  click(*remedy);
  EXPECT_EQ(muted(), before + 1);
  EXPECT_TRUE(window_->selection().link());
  ASSERT_TRUE(waitUntilIdle());
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(muted(), before) << "it can be undone";
}

TEST_F(WindowInspectTest, TheCellThatTheInstructionSpeaksOfIsLitWhileItStands) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  press(Qt::Key_3, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([this] { return marks().told.isThere(); }));
  const QString cell = marks().told.tag;
  EXPECT_THAT(labelText("captureWhat"), HasText(cell));
  press(Qt::Key_2, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([this] { return !marks().told.isThere(); })) << "the instruction is not there any more";
}

}  // namespace
}  // namespace hexoderm
