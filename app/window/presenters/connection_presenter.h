#pragma once

#include "app/window/dialogs/connect_dialog.h"
#include "app/window/presenters/file_presenter.h"
#include "app/window/presenters/presenter.h"
#include "app/window/toolkit/dialogs.h"
#include "widgets/words/words.h"

#include <QDir>
#include <QString>
#include <algorithm>
#include <cstdint>
#include <utility>

namespace hexoderm {

/// Shows the connection to a skin, from the dialog that asks for its address to the words on what it captured.
class ConnectionPresenter : public Presenter {
  Q_OBJECT

 public:
  ConnectionPresenter(const WindowParts& parts, FilePresenter& files) : Presenter(parts), files_(files) {
    connect(actions.connect_skin, &QAction::triggered, this, &ConnectionPresenter::showDialog);
    connect(actions.disconnect_skin, &QAction::triggered, &controller.liveSession(), &LiveSession::disconnectSource);
    // While readings come these follow each other quickly, so only what shows them is refreshed, if it is not the same.
    connect(&controller.liveSession().source(), &LiveSource::holdChanged, this, [this] {
      if (controller.liveSession().source().hold().late_frames != late_frames_shown_) refresh();
    });
    connect(&controller.liveSession().source(), &LiveSource::statusChanged, this, &ConnectionPresenter::showViolations);
    connect(&controller.liveSession(), &LiveSession::captured, this, &ConnectionPresenter::showCaptured);
    connect(&controller, &SessionController::noticed, this,
            [this](const QString& text) { views.messages->showMessage(Tone::Caution, text); });
  }

  /// Asks first if poses would be lost.
  void connectTo(const ConnectRequest& request) {
    if (request.continue_session) {
      controller.liveSession().connectTo(request);
    } else {
      rememberFolder(request.path);
      files_.afterAskingToSave([this, request] { controller.liveSession().connectTo(request); });
    }
  }

  /// Shows where the connection stands. Cheap: may be called 20 times a second.
  void refresh() {
    const LiveSource& live = controller.liveSession().source();
    late_frames_shown_ = live.hold().late_frames;
    const SourceStatus& status = live.status();
    // While all is well the status bar says it, and the step Capture has a panel that says more.
    const bool is_well = controller.liveSession().isLive() && status.state == SourceState::Streaming;
    views.live_strip->setVisible(live.isRunning() && !is_well);
    views.status->setLosses(live.isRunning() ? lossesText(status, live.hold()) : QString(),
                            tr("Since the skin was connected: %1. Poses need no more than their own samples, so a few "
                               "lost ones do no harm; many speak of a slow network or cable.")
                                .arg(countersText(status, live.hold())));
    if (!live.isRunning()) return;
    views.live_strip->setStatus(status, live.hold());
    const QString device = live.skin() ? words(live.skin()->device) + QStringLiteral(" · ") : QString();
    const QString where = controller.liveSession().isDemo() ? tr("Demo skin") : device + live.address();
    views.status->setSource(
        QStringLiteral("%1 %2 · %3").arg(sourceStateSign(status.state), sourceStateWord(status.state), where),
        device + live.address() + QStringLiteral("\n") + words(status.message));
  }

 private:
  static QString folderForSessions() {
    const QString chosen = Preferences().sessionFolder();
    return !chosen.isEmpty() && QDir(chosen).exists() ? chosen : lastFolder();
  }

  void showDialog() {
    if (window.findChild<ConnectDialog*>()) return;
    auto* dialog = new ConnectDialog(folderForSessions(),
                                     controller.file().isKept() ? controller.file().name() : QString(), &window);
    connect(dialog, &ConnectDialog::connectRequested, this, &ConnectionPresenter::connectTo);
    openInTurns(dialog);
  }

  void showCaptured(const QString& text, bool remarkable) {
    if (remarkable && !views.messages->isUrgent()) {
      views.messages->showMessage(Tone::Caution, text);
    } else {
      // What went as it should is no reason to move the window's parts about.
      views.status->say(text);
      log.add(Severity::Info, text);
    }
  }

  void showViolations() {
    const std::vector<ProtocolViolation>& offences = controller.liveSession().source().status().offences;
    offences_shown_ = std::min(offences_shown_, offences.size());  // fewer: of another source
    bool is_first = true;
    for (; offences_shown_ < offences.size(); ++offences_shown_) {
      const QString text = tr("The device does something wrong: %1").arg(words(inWords(offences[offences_shown_])));
      if (std::exchange(is_first, false) && !views.messages->isUrgent()) {
        views.messages->showMessage(Tone::Caution, text);  // which the log repeats
      } else {
        log.add(Severity::Warning, text);
      }
    }
  }

  FilePresenter& files_;
  std::size_t offences_shown_ = 0;       ///< of those of the running source
  std::uint64_t late_frames_shown_ = 0;  ///< of the recorder
};

}  // namespace hexoderm
