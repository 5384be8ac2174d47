#include "widgets/capture/instruction_voice.h"

#include "tests/support/qt_wait.h"
#include "widgets/capture/speaker.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

/// Notes what it is asked to say; what it says lasts until it is stopped.
class FakeSpeaker : public Speaker {
 public:
  void lookForVoice() override { emit lookedFor(why_not); }
  void say(const QString& sentence) override {
    said.push_back(sentence.toStdString());
    is_speaking = true;
  }
  void stop() override {
    if (is_speaking) ++cut_off;
    is_speaking = false;
  }

  std::vector<std::string> said;
  int cut_off = 0;
  bool is_speaking = false;
  QString why_not;
};

class InstructionVoiceTest : public testing::Test {
 protected:
  /// Lets an instruction stand until it has been spoken.
  bool isSpoken(const char* sentence) {
    return test::waitUntil([&] { return !speaker->said.empty() && speaker->said.back() == sentence; });
  }
  FakeSpeaker* speaker = new FakeSpeaker;
  InstructionVoice voice{speaker};
};

TEST_F(InstructionVoiceTest, IsOffUntilItIsSwitchedOn) {
  voice.setInstruction("Turn the part.");
  voice.setInstruction("Hold it.");
  test::letTurnsPass();
  EXPECT_TRUE(speaker->said.empty());
  voice.setEnabled(true);
  EXPECT_TRUE(isSpoken("Hold it.")) << "what stands when it is switched on";
  EXPECT_EQ(speaker->said.size(), 1U);
}

TEST_F(InstructionVoiceTest, SpeaksAnInstructionOnceHoweverOftenItIsGiven) {
  voice.setEnabled(true);
  for (int k = 0; k < 20; ++k) voice.setInstruction("Hold it.");
  ASSERT_TRUE(isSpoken("Hold it."));
  for (int k = 0; k < 20; ++k) voice.setInstruction("Hold it.");
  voice.setInstruction("Turn it.");
  ASSERT_TRUE(isSpoken("Turn it."));
  EXPECT_THAT(speaker->said, testing::ElementsAre("Hold it.", "Turn it."));
}

TEST_F(InstructionVoiceTest, WhatIsOnlyPassedByIsNotSpokenAndNothingQueuesUp) {
  voice.setEnabled(true);
  for (int k = 0; k < 50; ++k) voice.setInstruction(QStringLiteral("Turn by %1°.").arg(k));
  voice.setInstruction("It is there.");
  ASSERT_TRUE(isSpoken("It is there."));
  EXPECT_EQ(speaker->said.size(), 1U);
}

TEST_F(InstructionVoiceTest, WhatIsNoLongerTrueIsCutOffAtOnce) {
  voice.setEnabled(true);
  voice.setInstruction("Turn the part.");
  ASSERT_TRUE(isSpoken("Turn the part."));
  ASSERT_TRUE(speaker->is_speaking);
  voice.setInstruction("Pose 3 captured.");
  EXPECT_FALSE(speaker->is_speaking);
  EXPECT_EQ(speaker->cut_off, 1);
  ASSERT_TRUE(isSpoken("Pose 3 captured."));
  voice.setInstruction({});
  EXPECT_FALSE(speaker->is_speaking) << "the skin was disconnected";
}

TEST_F(InstructionVoiceTest, SwitchedOffItFallsSilent) {
  voice.setEnabled(true);
  voice.setInstruction("Turn the part.");
  ASSERT_TRUE(isSpoken("Turn the part."));
  voice.setEnabled(false);
  EXPECT_FALSE(speaker->is_speaking);
  voice.setInstruction("Hold it.");
  voice.setEnabled(true);
  EXPECT_TRUE(isSpoken("Hold it."));
}

TEST_F(InstructionVoiceTest, SaysWhyThereIsNoVoice) {
  QSignalSpy looked(&voice, &InstructionVoice::lookedFor);
  speaker->why_not = "There is no engine.";
  voice.lookForVoice();
  ASSERT_EQ(looked.count(), 1);
  EXPECT_EQ(looked[0][0].toString(), "There is no engine.");
}

/// Whatever this computer has: an answer comes, and nothing waits for it.
TEST(SystemSpeaker, AnswersWhetherItHasAVoice) {
  QObject owner;
  Speaker* speaker = makeSystemSpeaker(QLocale(QLocale::English), &owner);
  QSignalSpy looked(speaker, &Speaker::lookedFor);
  speaker->lookForVoice();
  EXPECT_TRUE(test::waitUntil([&] { return looked.count() == 1; }));
  speaker->stop();
}

}  // namespace
}  // namespace hexoderm
