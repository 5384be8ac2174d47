#include "app/window/presenters/speech_presenter.h"

#include "app/window/guide/guide.h"
#include "app/window/presenters/preferences_presenter.h"
#include "app/window/session/session_controller.h"
#include "app/window/settings/preferences.h"
#include "app/window/settings/preferences_dialog.h"
#include "widgets/capture/capture_panel.h"
#include "widgets/capture/instruction_voice.h"

#include <QTimer>

namespace hexoderm {
namespace {

constexpr int kOpened_ms = 300;

}  // namespace

SpeechPresenter::SpeechPresenter(const Views& views, const SessionController& controller, const WindowActions& actions,
                                 const Preferences& preferences, const PreferencesPresenter& dialogs)
    : views_(views), controller_(controller), actions_(actions) {
  connect(&views_.panel, &CapturePanel::instructionChanged, this, &SpeechPresenter::refresh);
  connect(&preferences, &Preferences::speechChanged, &views_.voice, &InstructionVoice::setEnabled);
  connect(&dialogs, &PreferencesPresenter::dialogMade, this, [this](PreferencesDialog* dialog) {
    connect(&views_.voice, &InstructionVoice::lookedFor, dialog, &PreferencesDialog::setWhyNoSpeech);
    // Once the dialog is there: an engine may load much, and start a server first.
    QTimer::singleShot(kOpened_ms, this, [this] { views_.voice.lookForVoice(); });
  });
  views_.voice.setEnabled(preferences.speech());
}

void SpeechPresenter::refresh() { views_.voice.setInstruction(instruction()); }

QString SpeechPresenter::instruction() const {
  if (!controller_.liveSession().source().isRunning() || controller_.liveMode().isOn()) return {};
  const QString of_capture = controller_.poseGuide().isRobotOn() ? QString() : views_.panel.instruction();
  return of_capture.isEmpty() ? describeStand(controller_, actions_).sentence : of_capture;
}

}  // namespace hexoderm
