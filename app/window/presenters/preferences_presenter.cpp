#include "app/window/presenters/preferences_presenter.h"

#include "app/window/guide/actions.h"
#include "app/window/presenters/theme_presenter.h"
#include "app/window/session/session_controller.h"
#include "app/window/settings/preferences.h"
#include "app/window/settings/preferences_dialog.h"
#include "app/window/toolkit/deferred_dialog.h"
#include "widgets/controls/message_bar.h"
#include "widgets/patch/scene_widget.h"

#include <QTimer>

namespace hexoderm {

PreferencesPresenter::PreferencesPresenter(const Views& views, SessionController& controller,
                                           const WindowActions& actions, Preferences& preferences,
                                           ThemePresenter& themes)
    : views_(views), actions_(actions), preferences_(preferences), themes_(themes) {
  connect(actions_.preferences, &QAction::triggered, this, &PreferencesPresenter::showDialog);
  controller.setSolverOptions(preferences_.solverOptions());
  controller.liveSession().setRecorderOptions(preferences_.recorderOptions());
  connect(&preferences_, &Preferences::solverOptionsChanged, &controller, &SessionController::setSolverOptions);
  connect(&preferences_, &Preferences::recorderOptionsChanged, &controller.liveSession(),
          &LiveSession::setRecorderOptions);
  // When the window is there, and can say so.
  QTimer::singleShot(0, this, &PreferencesPresenter::offerSoftwareOpenGl);
}

void PreferencesPresenter::showDialog() {
  if (auto* open = views_.window.findChild<PreferencesDialog*>()) {
    open->raise();
    open->activateWindow();
    return;
  }
  auto* dialog = new PreferencesDialog(preferences_, themes_.choice(), &views_.window);
  connect(dialog, &PreferencesDialog::themeChosen, this, [this, dialog](ThemeChoice choice) {
    themes_.setChoice(choice, true);
    dialog->showTheme(choice);
  });
  connect(actions_.themes, &QActionGroup::triggered, dialog, [this, dialog] { dialog->showTheme(themes_.choice()); });
  emit dialogMade(dialog);
  openInTurns(dialog, Qt::NonModal);
}

void PreferencesPresenter::offerSoftwareOpenGl() {
  if (views_.window.findChild<SceneWidget*>()) return;
  const bool tried = qEnvironmentVariableIsSet("LIBGL_ALWAYS_SOFTWARE");
  const QString what = tr("There is no OpenGL 3.2 here, so the 3D view is empty; graph and tables work.");
  if (tried) {
    views_.messages.showMessage(Tone::Caution, tr("%1 Drawing by the processor did not help either.").arg(what));
    return;
  }
  views_.messages.showMessage(Tone::Caution, what, tr("Draw without the graphics card"), [this] {
    preferences_.setSoftwareOpenGl(true);
    views_.messages.showMessage(
        Tone::Neutral, tr("From the next start on, the processor draws. Start Hexoderm again when it suits you."));
  });
}

}  // namespace hexoderm
