#include "app/window/presenters/presenters.h"

#include "app/window/presenters/theme_presenter.h"
#include "app/window/settings/preferences_dialog.h"
#include "app/window/toolkit/deferred_dialog.h"
#include "widgets/patch/scene_widget.h"

#include <QTimer>

namespace hexoderm {
namespace {

/// Lets the operator change the preferences, which act at once.
class PreferencesPresenter : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PreferencesPresenter)

 public:
  PreferencesPresenter(const WindowParts& parts, ThemePresenter& themes) : Presenter(parts), themes_(themes) {
    connect(actions_.preferences, &QAction::triggered, this, &PreferencesPresenter::showDialog);
    controller_.setSolverOptions(preferences_.solverOptions());
    controller_.liveSession().setRecorderOptions(preferences_.recorderOptions());
    connect(&preferences_, &Preferences::solverOptionsChanged, &controller_, &SessionController::setSolverOptions);
    connect(&preferences_, &Preferences::recorderOptionsChanged, &controller_.liveSession(),
            &LiveSession::setRecorderOptions);
    // When the window is there, and can say so.
    QTimer::singleShot(0, this, &PreferencesPresenter::offerSoftwareOpenGl);
  }

 private:
  void showDialog() {
    if (auto* open = window_.findChild<PreferencesDialog*>()) {
      open->raise();
      open->activateWindow();
      return;
    }
    auto* dialog = new PreferencesDialog(preferences_, themes_.choice(), &window_);
    connect(dialog, &PreferencesDialog::themeChosen, this, [this, dialog](ThemeChoice choice) {
      themes_.setChoice(choice, true);
      dialog->showTheme(choice);
    });
    connect(actions_.themes, &QActionGroup::triggered, dialog, [this, dialog] { dialog->showTheme(themes_.choice()); });
    connect(views_.voice, &InstructionVoice::lookedFor, dialog, &PreferencesDialog::setWhyNoSpeech);
    // Once the dialog is there: an engine may load much, and start a server first.
    constexpr int kOpened_ms = 300;
    QTimer::singleShot(kOpened_ms, this, [this] { views_.voice->lookForVoice(); });
    openInTurns(dialog, Qt::NonModal);
  }

  /// Where the 3D view found no OpenGL, offers to draw it by the processor.
  void offerSoftwareOpenGl() {
    if (window_.findChild<SceneWidget*>()) return;
    const bool tried = qEnvironmentVariableIsSet("LIBGL_ALWAYS_SOFTWARE");
    const QString what = tr("There is no OpenGL 3.2 here, so the 3D view is empty; graph and tables work.");
    if (tried) {
      views_.messages->showMessage(Tone::Caution, tr("%1 Drawing by the processor did not help either.").arg(what));
      return;
    }
    views_.messages->showMessage(Tone::Caution, what, tr("Draw without the graphics card"), [this] {
      preferences_.set(Switch::SoftwareOpenGl, true);
      views_.messages->showMessage(
          Tone::Neutral, tr("From the next start on, the processor draws. Start Hexoderm again when it suits you."));
    });
  }

  ThemePresenter& themes_;
};

}  // namespace

std::unique_ptr<Presenter> makePreferencesPresenter(const WindowParts& parts, ThemePresenter& themes) {
  return std::make_unique<PreferencesPresenter>(parts, themes);
}

}  // namespace hexoderm
