// Faults of a skin and of its poses, as the window reports them: every finding is listed with its words, picked by a
// key, and the rest of the skin is still there.

#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/geometry/se3.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/reconstruction/advice/assess.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/units.h"
#include "tests/app/window/window_test.h"
#include "widgets/tables/finding_table.h"
#include "widgets/words/formatting.h"

#include <QTabBar>
#include <algorithm>
#include <functional>

namespace hexoderm {
namespace {

using Poses = std::vector<PoseCapture>;

Session simulated(const SimulatedSkinOptions& options = {}, std::size_t poses = 4) {
  SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
  return simulateSession(skin, poses);
}

Session withNeighbors(const std::function<void(NeighborList&)>& edit) {
  const Session session = simulated();
  NeighborList neighbors = session.neighbors();
  edit(neighbors);
  Session edited(session.model(), neighbors, session.source());
  for (const SessionPose& pose : session.poses()) edited.addPose(pose);
  return edited;
}

Session withPoses(std::size_t count, const std::function<void(Poses&)>& edit) {
  const Session session = simulated({}, count);
  Poses poses;
  for (const SessionPose& pose : session.poses()) poses.push_back(*pose.capture);
  edit(poses);
  Session edited(session.model(), session.neighbors(), session.source());
  for (const PoseCapture& pose : poses) edited.addPose({std::make_shared<const PoseCapture>(pose)});
  return edited;
}

Session withFault(SkinFault kind, std::size_t poses = 4) {
  SimulatedSkinOptions options;
  options.faults = {{kind, CellId(7)}};
  return simulated(options, poses);
}

/// Breaks the link at port 1 of a cell in an arm. With this seed a cable lets its far side lie as no mould would.
Session withLinkFault(LinkFaultKind kind, std::uint32_t cell) {
  SimulatedSkinOptions options;
  options.seed = 4;
  options.link_faults = {{kind, {CellId(cell), PortNumber(1)}}};
  return simulated(options, 6);
}

CellReport& report(NeighborList& neighbors, std::uint32_t cell) {
  return *std::find_if(neighbors.begin(), neighbors.end(), [&](const CellReport& at) { return at.id == CellId(cell); });
}
/// A port at which nothing is.
PortNumber freePort(const CellReport& cell) {
  for (std::uint32_t port = 1;; ++port) {
    if (std::none_of(cell.neighbors.begin(), cell.neighbors.end(),
                     [&](const NeighborReport& at) { return at.port == PortNumber(port) && at.cell.value() != 0; })) {
      return PortNumber(port);
    }
  }
}

struct Case {
  const char* name;
  std::vector<FindingCode> codes;  ///< any of them is right
  std::vector<CellId> cells;       ///< one of these is named; empty: not looked at
  std::function<Session()> session;
};
void PrintTo(const Case& fault, std::ostream* out) { *out << fault.name; }

const Case kCases[] = {
    {"DuplicateCell",
     {FindingCode::DuplicateCell},
     {CellId(4)},
     [] { return withNeighbors([](NeighborList& list) { list.push_back(report(list, 4)); }); }},
    {"SelfLink",
     {FindingCode::SelfLink},
     {CellId(17)},
     [] {
       return withNeighbors([](NeighborList& list) {
         CellReport& cell = report(list, 17);
         cell.neighbors.push_back({freePort(cell), cell.id, freePort(cell)});
       });
     }},
    {"OneSidedLink",
     {FindingCode::OneSidedLink},
     {CellId(17)},
     [] { return withNeighbors([](NeighborList& list) { report(list, 17).neighbors.clear(); }); }},
    {"ContradictoryLink",
     {FindingCode::ContradictoryLink},
     {CellId(17)},
     [] {
       return withNeighbors([](NeighborList& list) {
         for (NeighborReport& at : report(list, 17).neighbors) {
           if (at.cell.value() != 0) at.cell_port = PortNumber(at.cell_port == PortNumber(1) ? 2 : 1);
         }
       });
     }},
    {"UnknownPort",
     {FindingCode::UnknownPort},
     {CellId(17)},
     [] {
       return withNeighbors([](NeighborList& list) {
         report(list, 17).neighbors.push_back({PortNumber(9), CellId(1), PortNumber(1)});
       });
     }},
    {"UnknownCell",
     {FindingCode::UnknownCell},
     {CellId(17), CellId(99)},
     [] {
       return withNeighbors([](NeighborList& list) {
         CellReport& cell = report(list, 17);
         cell.neighbors.push_back({freePort(cell), CellId(99), PortNumber(1)});
       });
     }},
    {"DeadCell", {FindingCode::DeadSensor}, {CellId(7)}, [] { return withFault(SkinFault::Dead); }},
    {"StuckCell", {FindingCode::StuckSensor}, {CellId(7)}, [] { return withFault(SkinFault::Stuck); }},
    {"SaturatedCell", {FindingCode::SaturatedSensor}, {CellId(7)}, [] { return withFault(SkinFault::Saturated); }},
    {"NoisyCell", {FindingCode::NoisySensor}, {CellId(7)}, [] { return withFault(SkinFault::Noisy); }},
    {"SilentCell", {FindingCode::NoSamples}, {CellId(7)}, [] { return withFault(SkinFault::NoSamples); }},
    {"DeadAxis", {FindingCode::DeadAxis}, {CellId(7)}, [] { return withFault(SkinFault::DeadAxis, 6); }},
    {"WrongGain",
     {FindingCode::WrongGain, FindingCode::WrongNorm},
     {CellId(7)},
     [] { return withFault(SkinFault::WrongGain, 6); }},
    {"WrongNorm",
     {FindingCode::WrongNorm, FindingCode::WrongGain},
     {CellId(7)},
     [] {
       return withPoses(4, [](Poses& poses) {
         for (PoseCapture& pose : poses) {
           for (GravitySample& sample : pose.samples) {
             if (sample.cell == CellId(7)) sample.mean_g *= 0.5;
           }
         }
       });
     }},
    {"CellWithoutSamplesInAPose",
     {FindingCode::MissingSamples},
     {CellId(7)},
     [] {
       return withPoses(4, [](Poses& poses) {
         std::erase_if(poses[1].samples, [](const GravitySample& sample) { return sample.cell == CellId(7); });
       });
     }},
    {"ReadingsOfAnotherSkin",
     {FindingCode::SampleOfUnknownCell},
     {CellId(99)},
     [] {
       return withPoses(4, [](Poses& poses) {
         GravitySample stray;
         stray.cell = CellId(99);
         stray.mean_g = {0, 0, 1};
         poses[0].samples.push_back(stray);
       });
     }},
    {"TwoReadingsOfACell",
     {FindingCode::DuplicateSample},
     {},
     [] { return withPoses(4, [](Poses& poses) { poses[0].samples.push_back(poses[0].samples[3]); }); }},
    {"TwoPosesOfOneNumber",
     {FindingCode::DuplicatePose},
     {},
     [] { return withPoses(4, [](Poses& poses) { poses[3].id = poses[2].id; }); }},
    {"RepeatedPose",
     {FindingCode::RepeatedPose},
     {},
     [] {
       return withPoses(3, [](Poses& poses) {
         poses.push_back(poses[1]);
         poses.back().id = PoseId(9);
       });
     }},
    {"PartMoved",
     {FindingCode::PartMoved},
     {},
     [] {
       return withPoses(4, [](Poses& poses) {
         for (GravitySample& sample : poses[2].samples) {
           sample.cov_g2 = 0.4 * 0.4 / 100 * Eigen::Matrix3d::Identity();
           sample.count = 100;
         }
       });
     }},
    {"PoseThatContradictsItself",
     {FindingCode::InconsistentPose, FindingCode::PartMoved},
     {},
     [] {
       return withPoses(6, [](Poses& poses) {
         double angle = 0;
         for (GravitySample& sample : poses[3].samples) {
           angle += 2.4;  // every cell another way
           sample.mean_g = expSO3({0.35 * std::cos(angle), 0.35 * std::sin(angle), 0}) * sample.mean_g;
         }
       });
     }},
    {"Joint", {FindingCode::LinkNotRigid}, {CellId(1)}, [] { return withLinkFault(LinkFaultKind::Joint, 1); }},
    {"Cable",
     {FindingCode::ImplausibleBend, FindingCode::ImplausibleTwist, FindingCode::ImplausibleYaw},
     {CellId(7)},
     [] { return withLinkFault(LinkFaultKind::Cable, 7); }},
    {"WrongPort",
     {FindingCode::ImplausibleYaw, FindingCode::ImplausibleTwist, FindingCode::ImplausibleBend},
     {CellId(7)},
     [] { return withLinkFault(LinkFaultKind::WrongPort, 7); }},
    {"NoPoses", {FindingCode::NoPoses}, {}, [] { return simulated({}, 0); }},
    {"OnePose", {FindingCode::TooFewDirections}, {}, [] { return simulated({}, 1); }},
    {"OppositePoses",
     {FindingCode::TooFewDirections},
     {},
     [] {
       return withPoses(2, [](Poses& poses) {
         for (std::size_t k = 0; k < poses[0].samples.size(); ++k) {
           poses[1].samples[k].mean_g = -poses[0].samples[k].mean_g;
         }
       });
     }},
};

class WindowFindingsTest : public WindowTest, public testing::WithParamInterface<Case> {
 protected:
  /// Opens it as a file, as somebody who sends it would.
  void open(const Session& session) {
    const QString path = pathTo("skin.session.json");
    writeSessionJson(session, path.toStdString());
    window_->openFile(path);
    ASSERT_TRUE(waitUntil([this] { return controller().file().name() == "skin.session.json"; }))
        << message().toStdString();
    ASSERT_TRUE(waitForPoses(session.poses().size())) << message().toStdString();
  }
  static std::string textOf(const QModelIndex& index) { return index.data().toString().toStdString(); }
};

void expectFinite(const Reconstruction& result) {
  for (const PatchReconstruction& patch : result.patches) {
    for (const CellPlacement& cell : patch.cells) {
      EXPECT_TRUE(cell.T_o_u.t.allFinite() && cell.T_o_u.R.allFinite()) << "cell " << cell.cell;
    }
  }
}

TEST_P(WindowFindingsTest, IsNamedPickedAndTheRestIsStillReconstructed) {
  ASSERT_NO_FATAL_FAILURE(open(GetParam().session()));
  const Reconstruction& result = *controller().reconstruction();
  EXPECT_EQ(result.cellCount(), 17U);
  expectFinite(result);

  auto* view = find<QTableView>("findingView");
  ASSERT_TRUE(view->isVisible());
  const auto* table = qobject_cast<FindingTable*>(view->model());
  ASSERT_NE(table, nullptr);
  int row = -1;
  std::string listed;
  for (int k = 0; k < table->rowCount(); ++k) {
    const Finding& finding = table->findingAt(k);
    listed += std::string(codeName(finding.code)) + ": " + finding.message.english() + '\n';
    if (std::count(GetParam().codes.begin(), GetParam().codes.end(), finding.code) > 0 && row < 0) row = k;
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
  if (!GetParam().cells.empty()) {
    bool named = false;
    for (const CellId cell : GetParam().cells) {
      named = named || (std::count(finding.cells.begin(), finding.cells.end(), cell) > 0 &&
                        line.find(std::to_string(cell.value())) != std::string::npos);
    }
    EXPECT_TRUE(named) << line;
  }
  for (const PoseId pose : finding.poses) {
    EXPECT_NE(line.find(std::to_string(pose.value())), std::string::npos) << line;
  }

  // The step Review says the worst of them.
  press(Qt::Key_4, Qt::ControlModifier);
  const Finding* worst = worstFinding(result);
  const auto labels = find<QWidget>("step4")->findChildren<QLabel*>();
  // The verdict itself stands in the banner alone.
  const QString said = worst ? unbroken(QString::fromStdString(worst->message.english()))
                             : QStringLiteral("Nothing was found that does not fit.");
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
    return label->isVisible() && label->text() == said;
  })) << listed;
  EXPECT_EQ(find<QLabel>("bannerSentence")->text().toStdString(), result.assessment.reason.english());
}

INSTANTIATE_TEST_SUITE_P(Faults, WindowFindingsTest, testing::ValuesIn(kCases),
                         [](const testing::TestParamInfo<Case>& fault) { return std::string(fault.param.name); });

using WindowVerdictTest = WindowTest;

TEST_F(WindowVerdictTest, TooFewPosesAreSaidWithWhatToDoNext) {
  const std::pair<std::size_t, const char*> few[] = {{0, "none.session.json"}, {1, "one.session.json"}};
  for (const auto& [poses, name] : few) {
    writeSessionJson(simulated({}, poses), pathTo(name).toStdString());
    window_->openFile(pathTo(name));
    ASSERT_TRUE(waitUntil([&, file = QString(name)] { return controller().file().name() == file; }));
    ASSERT_TRUE(waitForPoses(poses));
    const Assessment& verdict = controller().reconstruction()->assessment;
    EXPECT_EQ(verdict.level, VerdictLevel::NotEnough);
    EXPECT_FALSE(verdict.next_action.empty());
    press(Qt::Key_3, Qt::ControlModifier);
    const auto labels = find<QWidget>("step3")->findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
      return label->isVisible() && label->text().toStdString() == verdict.next_action.english();
    })) << verdict.next_action;
    EXPECT_FALSE(find<QPushButton>("bannerButton")->text().contains("Export")) << "not good enough to offer it";
  }
}

TEST_F(WindowVerdictTest, AGoodSkinHasNothingToComplainAbout) {
  // So that the cases above can't be right by complaining always.
  writeSessionJson(simulated({}, 6), pathTo("good.session.json").toStdString());
  window_->openFile(pathTo("good.session.json"));
  ASSERT_TRUE(waitForPoses(6));
  EXPECT_EQ(worstFinding(*controller().reconstruction()), nullptr)
      << worstFinding(*controller().reconstruction())->message.english();
}

}  // namespace
}  // namespace hexoderm
