#include "app/window/presenters/presenters.h"

#include "app/window/presenters/theme_presenter.h"
#include "app/window/settings/preferences_dialog.h"
#include "app/window/toolkit/dialogs.h"
#include "widgets/patch/scene_widget.h"

#include <QTimer>

namespace hexoderm {
namespace {

void showPreferences(const WindowParts& parts, ThemePresenter& themes) {
  if (auto* open = parts.window.findChild<PreferencesDialog*>()) {
    bringToFront(open);
    return;
  }
  auto* dialog = new PreferencesDialog(parts.preferences, themes.choice(), &parts.window);
  QObject::connect(dialog, &PreferencesDialog::themeChosen, &themes, [&themes, dialog](ThemeChoice choice) {
    themes.setChoice(choice, true);
    dialog->showTheme(choice);
  });
  QObject::connect(parts.actions.themes, &QActionGroup::triggered, dialog,
                   [&themes, dialog] { dialog->showTheme(themes.choice()); });
  InstructionVoice* const voice = parts.views.voice;
  QObject::connect(voice, &InstructionVoice::lookedFor, dialog, &PreferencesDialog::setWhyNoSpeech);
  // Once the dialog is there: an engine may load much, and start a server first.
  constexpr int kOpened_ms = 300;
  QTimer::singleShot(kOpened_ms, voice, &InstructionVoice::lookForVoice);
  openInTurns(dialog, Qt::NonModal);
}

/// Where the 3D view found no OpenGL, offers to draw it by the processor.
void offerSoftwareOpenGl(const WindowParts& parts) {
  if (parts.window.findChild<SceneWidget*>()) return;
  MessageBar* const messages = parts.views.messages;
  const QString what = WindowParts::tr("There is no OpenGL 3.2 here, so the 3D view is empty; graph and tables work.");
  if (qEnvironmentVariableIsSet("LIBGL_ALWAYS_SOFTWARE")) {
    messages->showMessage(Tone::Caution, WindowParts::tr("%1 Drawing by the processor did not help either.").arg(what));
    return;
  }
  messages->showMessage(Tone::Caution, what, WindowParts::tr("Draw without the graphics card"), [&parts, messages] {
    parts.preferences.set(Switch::SoftwareOpenGl, true);
    messages->showMessage(
        Tone::Neutral,
        WindowParts::tr("From the next start on, the processor draws. Start Hexoderm again when it suits you."));
  });
}

}  // namespace

void connectPreferences(const WindowParts& parts, ThemePresenter& themes) {
  SessionController& controller = parts.controller;
  const Preferences& preferences = parts.preferences;
  QObject::connect(parts.actions.preferences, &QAction::triggered, &parts.wires,
                   [&parts, &themes] { showPreferences(parts, themes); });
  controller.setSolverOptions(preferences.solverOptions());
  controller.liveSession().setRecorderOptions(preferences.recorderOptions());
  QObject::connect(&preferences, &Preferences::solverOptionsChanged, &controller, &SessionController::setSolverOptions);
  QObject::connect(&preferences, &Preferences::recorderOptionsChanged, &controller.liveSession(),
                   &LiveSession::setRecorderOptions);
  // When the window is there, and can say so.
  QTimer::singleShot(0, &parts.wires, [&parts] { offerSoftwareOpenGl(parts); });
}

}  // namespace hexoderm
