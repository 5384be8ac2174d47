// Faults of a skin and of its poses, as the window reports them: every finding is listed with its words, picked by a
// key, and the rest of the skin is still there.

#include "hexoderm/solve/metrics/assess.h"
#include "tests/app/window/window_test.h"
#include "widgets/tables/finding_table.h"
#include "widgets/words/formatting.h"

namespace hexoderm {
namespace {

using Poses = std::vector<PoseCapture>;

class WindowFindingsTest : public WindowTest {
 protected:
  static Session withPoses(std::size_t count, const std::function<void(Poses&)>& edit) {
    const Session session = simulated(count, {}, 100);
    Poses poses;
    for (const SessionPose& pose : session.poses()) poses.push_back(*pose.capture);
    edit(poses);
    Session edited(session.model(), session.neighbors(), session.source());
    for (const PoseCapture& pose : poses) edited.addPose({std::make_shared<const PoseCapture>(pose)});
    return edited;
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
                                      : "Nothing was found that does not fit."))
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
      {"repeated_pose",
       FindingCode::RepeatedPose,
       {},
       withPoses(3,
                 [](Poses& poses) {
                   poses.push_back(poses[1]);
                   poses.back().id = PoseId(9);
                 })},
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

}  // namespace
}  // namespace hexoderm
