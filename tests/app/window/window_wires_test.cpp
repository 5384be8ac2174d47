// Devices on real wires: the emulator is a program of its own, as a device is, and the window is connected to it by its
// dialog. Nothing here is about how fast this computer is.

#include "hexoderm/base/units.h"
#include "tests/app/emulator/emulator_program.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/check_list.h"

#include <cmath>

namespace hexoderm {
namespace {

struct Wire {
  const char* name;
  const char* kind;                 ///< its name in the dialog
  std::vector<std::string> spoken;  ///< options of the emulator
};
void PrintTo(const Wire& wire, std::ostream* out) { *out << wire.name; }

const Wire kWires[] = {
    {"Udp", "Network, UDP", {"--udp"}},
    {"SerialPort", "Serial port", {"--pty"}},
    {"TcpInFrames", "Network, TCP", {"--tcp"}},
    {"TcpInLines", "Network, TCP", {"--json", "--tcp"}},
};

class WindowWiresTest : public WindowTest, public testing::WithParamInterface<Wire> {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    std::vector<std::string> arguments = GetParam().spoken;
    const bool is_serial = arguments.front() == "--pty";
    if (!is_serial) arguments.emplace_back("0");
    // Few samples, at four times the pace of life: the part is soon there, and a computer that is busy keeps up.
    for (const char* word : {"--patch", "x17", "--ideal", "--rate", "100", "--speed", "4"})
      arguments.emplace_back(word);
    emulator_ = std::make_unique<Emulator>(arguments);
    const QString address = QString::fromStdString(emulator_->address);
    address_ = "127.0.0.1:" + address.section(':', -1);
    if (!is_serial) return;
    // A serial port has a name in a folder as /dev/serial/by-id is.
    address_ = pathTo("usb-skin");
    ASSERT_TRUE(QFile::link(address.section(':', 1), address_));
  }
  /// The first pose is captured automatically, where the part lies.
  void connectDevice() {
    ASSERT_NO_FATAL_FAILURE(connectByDialog(GetParam().kind, address_, path()));
    ASSERT_TRUE(waitUntil([this] { return controller().liveSession().isLive(); }));
    // What went well is said for a moment only, and solving may take longer.
    ASSERT_TRUE(waitForMessage("Pose 1 captured: 17 cells."));
    ASSERT_TRUE(waitForPoses(1));
  }
  /// The second where the device is asked to turn itself to, as soon as it is there.
  void turnToTheSecondPose() {
    ASSERT_TRUE(waitUntil([this] { return action("actionTurn")->isEnabled(); }))
        << action("actionTurn")->toolTip().toStdString();
    advised_o_ = controller().liveSession().nextPose()->up;
    press(Qt::Key_T);
    ASSERT_TRUE(waitForMessage("Pose 2 captured: 17 cells."));
    EXPECT_THAT(message(), Not(HasText("repeats")));
    ASSERT_TRUE(waitForPoses(2));
  }
  [[nodiscard]] QString path() const { return pathTo("arm.hexo"); }
  bool isSaidByTheCheck(const QString& text) {
    for (const QLabel* label : find<CheckList>("checkList")->findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains(text)) return true;
    }
    return false;
  }

  std::unique_ptr<Emulator> emulator_;
  QString address_;  ///< as it is typed after the kind of connection
  Eigen::Vector3d advised_o_ = Eigen::Vector3d::Zero();
};

TEST_P(WindowWiresTest, ADeviceIsConnectedCheckedCapturedAndLeft) {
  ASSERT_NO_FATAL_FAILURE(connectDevice());
  EXPECT_EQ(labelText("liveState"), "Streaming");
  EXPECT_THAT(labelText("sourceStatus"), HasText("Streaming"));
  EXPECT_THAT(labelText("sourceStatus"), HasText("emulated skin"));
  EXPECT_THAT(labelText("sourceStatus"), HasText(address_));
  EXPECT_FALSE(find<QWidget>("liveStrip")->isVisible()) << labelText("liveText").toStdString();
  EXPECT_EQ(controller().reconstruction()->cellCount(), 17U);
  press(Qt::Key_2, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([this] { return isSaidByTheCheck("17 cells, 16 links, 1 patch"); }));
  EXPECT_TRUE(waitUntil([this] { return isSaidByTheCheck("All 17 cells send"); }));

  // Requests to the device arrive there.
  clickCellInGraph(CellId(3));
  ASSERT_TRUE(action("actionLightCell")->isEnabled()) << action("actionLightCell")->toolTip().toStdString();
  press(Qt::Key_L, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([this] { return emulator_->type("led 3") == "cell 3 #ffffff"; }));
  ASSERT_NO_FATAL_FAILURE(turnToTheSecondPose());
  const PatchReconstruction& patch = controller().reconstruction()->patches.at(0);
  ASSERT_EQ(patch.gravity.size(), 2U);
  EXPECT_LT(std::acos(std::clamp(patch.gravity[1].g_o.dot(advised_o_), -1.0, 1.0)), 10 * kDegree)
      << "an ideal device turns to where it is asked";
  EXPECT_EQ(controller().reconstruction()->assessment.level, VerdictLevel::Coarse) << "two poses";

  press(Qt::Key_A);
  ASSERT_FALSE(controller().liveSession().isAutomatic());
  action("actionDisconnect")->trigger();
  EXPECT_FALSE(controller().liveSession().source().isRunning());
  EXPECT_TRUE(waitUntil([this] { return action("actionCapture")->toolTip() == "No skin is connected"; }));
  EXPECT_EQ(posesShown(), 2U);
  ASSERT_TRUE(waitUntilKept());
  const Session kept = read(path());
  ASSERT_EQ(kept.poses().size(), 2U);
  for (const SessionPose& pose : kept.poses()) EXPECT_EQ(pose.capture->samples.size(), 17U);
  EXPECT_EQ(kept.neighbors(), controller().session()->neighbors());

  // Once more, as the dialog proposes: the same device, and the session that is open.
  press(Qt::Key_K, Qt::ControlModifier);
  auto* dialog = waitForDialog("connectDialog");
  QTest::keyClick(dialog->findChild<QComboBox*>("connectAddress"), Qt::Key_Return);
  ASSERT_TRUE(waitUntil([this] { return controller().liveSession().isLive(); }));
  ASSERT_TRUE(waitUntil([this] { return action("actionCapture")->isEnabled(); }));
  press(Qt::Key_Space);
  ASSERT_TRUE(waitForPoses(3));
  ASSERT_TRUE(waitForMessage("Pose 3 captured: 17 cells. It repeats pose 2"));
  ASSERT_TRUE(waitUntilKept());
  EXPECT_EQ(read(path()).poses().size(), 3U);
}

INSTANTIATE_TEST_SUITE_P(Wires, WindowWiresTest, testing::ValuesIn(kWires),
                         [](const testing::TestParamInfo<Wire>& wire) { return std::string(wire.param.name); });

}  // namespace
}  // namespace hexoderm
