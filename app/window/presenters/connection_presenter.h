#pragma once

#include "app/window/dialogs/connect_dialog.h"
#include "app/window/presenters/file_presenter.h"
#include "app/window/presenters/presenter.h"
#include "app/window/toolkit/deferred_dialog.h"
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
    connect(actions_.connect_skin, &QAction::triggered, this, &ConnectionPresenter::showDialog);
    connect(actions_.disconnect_skin, &QAction::triggered, &controller_.liveSession(), &LiveSession::disconnectSource);
    // While readings come these follow each other quickly, so only what shows them is refreshed, if it is not the same.
    connect(&controller_.liveSession().source(), &LiveSource::holdChanged, this, [this] {
      if (controller_.liveSession().source().hold().late_frames != late_frames_shown_) refresh();
    });
    connect(&controller_.liveSession().source(), &LiveSource::statusChanged, this, &ConnectionPresenter::showOffences);
    connect(&controller_.liveSession(), &LiveSession::captured, this, &ConnectionPresenter::showCaptured);
    connect(&controller_, &SessionController::noticed, this,
            [this](const QString& text) { views_.messages->showMessage(Tone::Caution, text); });
  }

  /// Asks first if poses would be lost.
  void connectTo(const ConnectRequest& request) {
    if (request.continue_session) {
      controller_.liveSession().connectTo(request);
    } else {
      rememberFolder(request.path);
      files_.afterAskingToSave([this, request] { controller_.liveSession().connectTo(request); });
    }
  }

  /// Shows where the connection stands. Cheap: may be called 20 times a second.
  void refresh() override {
    const LiveSource& live = controller_.liveSession().source();
    late_frames_shown_ = live.hold().late_frames;
    const SourceStatus& status = live.status();
    // While all is well the status bar says it, and the step Capture has a panel that says more.
    const bool is_well = controller_.liveSession().isLive() && status.state == SourceState::Streaming;
    views_.live_strip->setVisible(live.isRunning() && !is_well);
    views_.status->setLosses(live.isRunning() ? lossesInWords(status, live.hold()) : QString(),
                             tr("Since the skin was connected: %1. Poses need no more than their own samples, so a few "
                                "lost ones do no harm; many speak of a slow network or cable.")
                                 .arg(countersInWords(status, live.hold())));
    if (!live.isRunning()) return;
    views_.live_strip->setStatus(status, live.hold());
    const QString device = live.skin() ? words(live.skin()->device) + QStringLiteral(" · ") : QString();
    const QString where = controller_.liveSession().isDemo() ? tr("Demo skin") : device + live.address();
    views_.status->setSource(
        QStringLiteral("%1 %2 · %3").arg(sourceStateSign(status.state), sourceStateWord(status.state), where),
        device + live.address() + QStringLiteral("\n") + words(status.message));
  }

 private:
  static QString folderForSessions() {
    const QString chosen = Preferences().sessionFolder();
    return !chosen.isEmpty() && QDir(chosen).exists() ? chosen : lastFolder();
  }

  void showDialog() {
    if (window_.findChild<ConnectDialog*>()) return;
    auto* dialog = new ConnectDialog(folderForSessions(),
                                     controller_.file().isKept() ? controller_.file().name() : QString(), &window_);
    connect(dialog, &ConnectDialog::connectRequested, this, &ConnectionPresenter::connectTo);
    openInTurns(dialog);
  }

  void showCaptured(const QString& text, bool remarkable) {
    if (remarkable && !views_.messages->isUrgent()) {
      views_.messages->showMessage(Tone::Caution, text);
    } else {
      // What went as it should is no reason to move the window's parts about.
      views_.status->say(text);
      log_.add(Severity::Info, text);
    }
  }

  void showOffences() {
    const std::vector<Offence>& offences = controller_.liveSession().source().status().offences;
    offences_shown_ = std::min(offences_shown_, offences.size());  // fewer: of another source
    bool is_first = true;
    for (; offences_shown_ < offences.size(); ++offences_shown_) {
      const QString text = tr("The device does something wrong: %1").arg(words(inWords(offences[offences_shown_])));
      if (std::exchange(is_first, false) && !views_.messages->isUrgent()) {
        views_.messages->showMessage(Tone::Caution, text);  // which the log repeats
      } else {
        log_.add(Severity::Warning, text);
      }
    }
  }

  FilePresenter& files_;
  std::size_t offences_shown_ = 0;       ///< of those of the running source
  std::uint64_t late_frames_shown_ = 0;  ///< of the recorder
};

}  // namespace hexoderm
