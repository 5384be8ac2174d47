// The lines by which the window says what it waits for, what blocks a capture, and what became of the device.

#include "hexoderm/base/units.h"
#include "tests/app/window/fake_device.h"
#include "tests/app/window/window_test.h"
#include "widgets/capture/hold_ring.h"
#include "widgets/controls/check_list.h"

namespace hexoderm {
namespace {

const Eigen::Vector3d kUp = Eigen::Vector3d::UnitZ();
const Eigen::Vector3d kSide = Eigen::Vector3d::UnitX();

class WindowMessagesTest : public WindowTest {
 protected:
  void connectDevice() {
    window_->connectTo({device_.address(), pathTo("arm.hexo"), false});
    ASSERT_NO_FATAL_FAILURE(device_.accept());
    device_.introduce();
    ASSERT_TRUE(waitUntil([this] { return controller().liveSession().isLive(); }));
    ASSERT_TRUE(waitUntilIdle());
  }
  /// With one pose taken, `kUp` up.
  void connectAndCapture() {
    ASSERT_NO_FATAL_FAILURE(connectDevice());
    device_.hold(3, kUp);
    ASSERT_TRUE(waitForPoses(1));
  }
  bool waitForText(const char* label, const QString& pattern) {
    const QRegularExpression expected(pattern);
    return waitUntil([&] { return expected.match(labelText(label)).hasMatch(); });
  }
  QString ring() {
    const HoldRing::Content& content = find<HoldRing>("holdRing")->content();
    return content.word + ", " + content.detail;
  }
  bool waitForRing(const QString& part) {
    return waitUntil([&] { return ring().contains(part); });
  }
  /// A tremor of so many g in every cell, the first one's smallest: it is the first that could be still.
  void shake(double seconds, double amplitude_g, const Eigen::Vector3d& up = kUp) {
    device_.send(seconds, [&](int cell, double time_s) {
      const double share = cell == 1 ? 0.8 : 1;
      return Eigen::Vector3d(FakeDevice::seenBy(cell, up) + share * amplitude_g * std::sqrt(2.0) *
                                                                std::sin(2 * M_PI * 17 * time_s) *
                                                                Eigen::Vector3d::UnitX());
    });
  }
  void turn(double seconds, double from_deg, double to_deg) {
    device_.send(seconds, [&](int cell, double time_s) {
      const double angle = (from_deg + (to_deg - from_deg) * time_s / seconds) * kDegree;
      return FakeDevice::seenBy(cell, Eigen::Vector3d(std::sin(angle), 0, std::cos(angle)));
    });
  }

  FakeDevice device_;
};

TEST_F(WindowMessagesTest, WhatTurnsOrShakesIsNamedWithItsLimitAndAHeldKeyTakesOnePoseAllTheSame) {
  ASSERT_NO_FATAL_FAILURE(connectDevice());
  turn(3, 0, 60);
  ASSERT_TRUE(waitForText("captureWait", "^Waiting: the part turns by (19|20|21)\\.\\d °/s, limit 1\\.0 °/s$"));
  shake(4, 0.09);
  ASSERT_TRUE(waitForText("captureWait", "^Waiting: cell 1 moves \\d+ mg, limit 30 mg$"));
  ASSERT_TRUE(waitForRing("Hold still")) << ring().toStdString();
  EXPECT_EQ(controller().session()->poses().size(), 0U);
  EXPECT_EQ(action("actionCapture")->text().remove('&'), "Capture now");
  EXPECT_TRUE(action("actionCapture")->isEnabled());
  keepPicture(window_->picture(), "waits-for-stillness");

  activateWindow();
  const auto hold_down = [this](int key, const QString& letter) {
    for (int k = 0; k < 20; ++k) QTest::simulateEvent(window_.get(), true, key, Qt::NoModifier, letter, k > 0);
    QTest::simulateEvent(window_.get(), false, key, Qt::NoModifier, letter, false);
  };
  hold_down(Qt::Key_A, "a");
  EXPECT_FALSE(controller().liveSession().isAutomatic()) << "switched once, not to and fro";
  hold_down(Qt::Key_Space, " ");
  // The key has to arrive before the readings that it asks for.
  ASSERT_TRUE(waitUntil([this] {
    shake(0.2, 0.09);
    return controller().session()->poses().size() == 1;
  }));
  EXPECT_TRUE(waitForMessage("Pose 1 captured: 3 cells"));
  // Time enough for others, if they had been asked for.
  const double taken_s = controller().liveSession().source().preview().time_s;
  ASSERT_TRUE(waitUntil([&] {
    shake(0.2, 0.09);
    return controller().liveSession().source().preview().time_s > taken_s + 5;
  }));
  EXPECT_EQ(controller().session()->poses().size(), 1U);
}

TEST_F(WindowMessagesTest, APartThatWasNotMovedIsAskedToMoveAndAPoseThatRepeatsAnotherIsNamed) {
  ASSERT_NO_FATAL_FAILURE(connectAndCapture());
  device_.hold(2, kUp);
  ASSERT_TRUE(waitForText("captureWait", "^Waiting: moved \\d\\.\\d° since the last pose, needs 5°$"));
  ASSERT_TRUE(waitForRing("Turn the part")) << ring().toStdString();
  EXPECT_EQ(controller().session()->poses().size(), 1U) << "nothing is taken twice";
  turn(1, 0, 30);
  turn(1, 30, 3);
  turn(3, 3, 3);
  ASSERT_TRUE(waitForPoses(2));
  ASSERT_TRUE(waitForMessage("It repeats pose 1, which is only 3."));
  EXPECT_EQ(labelText("captureRemark"), "It repeats pose 1.");
}

TEST_F(WindowMessagesTest, AStepStaysOpenWhateverHappens) {
  ASSERT_NO_FATAL_FAILURE(connectDevice());
  const auto* steps = window_->findChild<StepPanel*>();
  EXPECT_EQ(steps->openIndex(), 2) << "connected: poses are what comes next";
  press(Qt::Key_2, Qt::ControlModifier);
  for (const Eigen::Vector3d& up : {kUp, kSide, Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(-1, -1, -1)}) {
    const std::size_t before = controller().session()->poses().size();
    device_.hold(3, up);
    ASSERT_TRUE(waitForPoses(before + 1));
    EXPECT_EQ(steps->openIndex(), 1) << "somebody reads it";
  }
  device_.unplug();
  ASSERT_TRUE(waitForText("liveState", "^Connecting$"));
  EXPECT_EQ(steps->openIndex(), 1);
}

TEST_F(WindowMessagesTest, CellsWithoutGravityOrWithoutAWordAreNamedAndNotWaitedFor) {
  ASSERT_NO_FATAL_FAILURE(connectDevice());
  device_.send(
      6, [](int cell, double) { return cell == 3 ? Eigen::Vector3d::Zero().eval() : FakeDevice::seenBy(cell, kUp); });
  ASSERT_TRUE(waitForText("captureOdd", "^Not waited for: cell 3 \\(reads no gravity\\)$"));
  ASSERT_TRUE(waitForPoses(1));
  press(Qt::Key_2, Qt::ControlModifier);
  auto* list = find<CheckList>("checkList");
  ASSERT_TRUE(waitUntil([&] {
    const auto labels = list->findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text().contains("Cell 3 reads 0.0");
    });
  }));
  device_.send(5, [](int cell, double) { return cell == 3 ? FakeDevice::nothing() : FakeDevice::seenBy(cell, kSide); });
  ASSERT_TRUE(waitForPoses(2));
  ASSERT_TRUE(waitForMessage("Nothing came from 3"));
  ASSERT_TRUE(waitForText("stepBecause2", "2 of 3 cells send"));
}

TEST_F(WindowMessagesTest, StepsSayWhyTheyAreReadyOrBlocked) {
  const auto because = [&](int step) {
    press(Qt::Key_0 + step, Qt::ControlModifier);
    const QLabel* label = find<QLabel>(qPrintable(QStringLiteral("stepBecause%1").arg(step)));
    EXPECT_TRUE(label->isVisible()) << step;
    return label->text().toStdString();
  };
  EXPECT_EQ(because(1), "… Waiting: Nothing is connected and nothing is open yet.");
  for (int step = 2; step <= 7; ++step) {
    EXPECT_THAT(because(step), StartsWith("■ Blocked: ")) << step;
  }
  ASSERT_NO_FATAL_FAILURE(connectDevice());
  EXPECT_THAT(because(1), StartsWith("✓ Ready: "));
  EXPECT_EQ(because(2), "… Waiting: No readings have come yet.");
  EXPECT_EQ(because(3), "… Waiting: The first readings are on their way.");
  ASSERT_TRUE(waitUntilIdle());
  for (const int step : {4, 5, 6}) EXPECT_EQ(because(step), "■ Blocked: No pose has been captured yet.");
  EXPECT_EQ(because(7), "▲ Possible: Without a pose, a file only holds what follows from the ports.");
  device_.hold(3, kSide);
  ASSERT_TRUE(waitForPoses(1));
  ASSERT_TRUE(waitUntil([&] { return because(2) == "✓ Ready: Every cell sends."; })) << because(2);
  EXPECT_EQ(because(3), "✓ Ready: The skin sends.");
  EXPECT_EQ(because(4), "✓ Ready: There is a result of 1 pose.");
  EXPECT_EQ(because(6), "✓ Ready: There is a result to place.");
  EXPECT_THAT(because(7), StartsWith("▲ Possible: ")) << "gravity along the sheet leaves open how it is bent";
  device_.unplug();
  ASSERT_TRUE(waitUntil([&] { return because(3).find("■ Blocked: The skin does not send") == 0; })) << because(3);
  EXPECT_THAT(because(1), StartsWith("■ Blocked: "));
  EXPECT_THAT(because(4), StartsWith("✓ Ready: ")) << "what was captured can be reviewed";
}

TEST_F(WindowMessagesTest, ADeviceOfAnotherVersionIsSaidWithBothNumbersAndNotTriedAgain) {
  window_->connectTo({device_.address(), pathTo("arm.hexo"), false});
  ASSERT_NO_FATAL_FAILURE(device_.accept());
  device_.say("{\"major\": 2, \"hello\": {\"device\": \"of the future\"}}\n");
  ASSERT_TRUE(waitForText("liveState", "^Incompatible$"));
  EXPECT_TRUE(labelText("liveText").contains('2') && labelText("liveText").contains('1'))
      << labelText("liveText").toStdString();
  EXPECT_THAT(labelText("liveText"), HasText("not trying again"));
  EXPECT_EQ(bannerButton(), "Disconnect");
}

TEST_F(WindowMessagesTest, GarbageAndWrongChecksumsAreSaidAndLoseNothing) {
  ASSERT_NO_FATAL_FAILURE(connectAndCapture());
  device_.hangUp();
  ASSERT_NO_FATAL_FAILURE(device_.accept());
  // The acknowledgement of the protocol's own example, with one bit of its checksum turned.
  const QByteArray broken = QByteArray::fromHex("1c000000010608021a127468657265206973206e6f2063656c6c2037ff4eadff");
  ASSERT_TRUE(waitUntil([&] {
    device_.say(broken);
    return labelText("liveText").contains("broken");
  }));
  EXPECT_EQ(posesShown(), 1U);
  device_.hangUp();
  ASSERT_NO_FATAL_FAILURE(device_.accept());
  device_.say(QByteArray::fromHex("0200000001060000"));  // no message is as short as this one claims to be
  ASSERT_TRUE(waitForText("liveText", "broken"));
  ASSERT_NO_FATAL_FAILURE(device_.accept());
  device_.introduce();
  device_.hold(4, kSide);
  EXPECT_TRUE(waitForPoses(2));
}

TEST_F(WindowMessagesTest, EveryButtonThatCanNotBePressedSaysWhy) {
  const auto expectReasons = [this](const char* when) {
    for (const QAction* action : window_->QWidget::actions()) {
      if (action->isEnabled() || !action->isVisible()) continue;
      EXPECT_FALSE(action->toolTip().isEmpty()) << when << ": " << action->objectName().toStdString();
      EXPECT_NE(action->toolTip(), action->property("purpose").toString())
          << when << ": " << action->objectName().toStdString() << " says what it is for and not why it can't be used";
    }
    for (int step = 1; step <= 6; ++step) {
      press(Qt::Key_0 + step, Qt::ControlModifier);
      for (const auto* button : window_->findChildren<QAbstractButton*>()) {
        // The arrows beside tabs that find no room say it themselves.
        if (!button->isVisible() || button->isEnabled() || qobject_cast<QTabBar*>(button->parentWidget())) continue;
        EXPECT_FALSE(button->toolTip().isEmpty())
            << when << ", step " << step << ": " << button->objectName().toStdString() << " \""
            << button->text().toStdString() << "\" is grey and does not say why";
      }
    }
  };
  expectReasons("at the start");
  ASSERT_NO_FATAL_FAILURE(connectDevice());
  expectReasons("connected");
  device_.hold(3, kUp);
  ASSERT_TRUE(waitForPoses(1));
  expectReasons("with a pose");
  device_.unplug();
  ASSERT_TRUE(waitForText("liveState", "^Connecting$"));
  expectReasons("unplugged");
  action("actionDisconnect")->trigger();
  expectReasons("disconnected");
  ASSERT_NO_FATAL_FAILURE(openFile(HEXODERM_TEST_DATA "/two_patches.tum.xml"));
  expectReasons("with a calibration");
}

}  // namespace
}  // namespace hexoderm
