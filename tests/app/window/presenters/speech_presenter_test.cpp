#include "app/window/settings/preferences.h"
#include "tests/app/window/presenters/presenter_test.h"
#include "widgets/capture/instruction_voice.h"

namespace hexoderm {
namespace {

class SpeechPresenterTest : public PresenterTest {
 protected:
  InstructionVoice* voice() { return window_->findChild<InstructionVoice*>(); }
};

TEST_F(SpeechPresenterTest, IsOffAtFirstAndSpeaksWhatTheStepCaptureSaysOnceItIsWanted) {
  EXPECT_FALSE(voice()->isEnabled());
  QStringList spoken;
  QObject::connect(voice(), &InstructionVoice::spoken, [&](const QString& sentence) { spoken << sentence; });
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  EXPECT_TRUE(spoken.isEmpty());
  window_->preferences().set(Switch::Speech, true);
  EXPECT_TRUE(waitUntil([&] { return !spoken.isEmpty(); }));
  EXPECT_TRUE(waitUntil([&] { return spoken.contains(labelText("captureWhat")); })) << spoken.join(" / ").toStdString();
  window_->preferences().set(Switch::Speech, false);
  EXPECT_FALSE(voice()->isEnabled());
}

TEST_F(SpeechPresenterTest, ThePreferencesSayWhyItIsNotAvailable) {
  press(Qt::Key_Comma, Qt::ControlModifier);
  auto* dialog = waitForDialog("preferencesDialog");
  auto* speech = dialog->findChild<QCheckBox*>("preferenceSpeech");
  auto* why = dialog->findChild<QLabel*>("preferenceWhyNoSpeech");
  EXPECT_FALSE(speech->isChecked());
  emit voice()->lookedFor("There is no engine.");
  EXPECT_FALSE(speech->isEnabled());
  EXPECT_EQ(why->text(), "Not available: There is no engine.");
  emit voice()->lookedFor({});
  EXPECT_TRUE(speech->isEnabled());
  EXPECT_TRUE(why->isHidden());
}

}  // namespace
}  // namespace hexoderm
