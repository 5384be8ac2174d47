// The part of MainWindow about the skin that is connected and the file that its poses are kept in.
#include "app/window/dialogs/connect_dialog.h"
#include "app/window/main_window/main_window.h"
#include "app/window/main_window/window_shell.h"
#include "app/window/settings/preferences.h"
#include "app/window/toolkit/deferred_dialog.h"
#include "widgets/capture/live_strip.h"
#include "widgets/controls/message_bar.h"
#include "widgets/graph/graph_view.h"
#include "widgets/patch/patch_view.h"
#include "widgets/words/core_words.h"

#include <QDir>
#include <QLabel>

namespace hexoderm {
namespace {

QString folderForSessions() {
  const QString chosen = Preferences().sessionFolder();
  return !chosen.isEmpty() && QDir(chosen).exists() ? chosen : lastFolder();
}

}  // namespace

void MainWindow::connectLive() {
  connect(actions_.connect_skin, &QAction::triggered, this, &MainWindow::showConnectDialog);
  connect(actions_.disconnect_skin, &QAction::triggered, &controller_.liveSession(), &LiveSession::disconnectSource);
  connect(actions_.turn, &QAction::triggered, &controller_.poseGuide(), &PoseGuide::turnToNextPose);
  connect(actions_.automatic, &QAction::triggered, &controller_.liveSession(), &LiveSession::setAutomatic);
  connect(actions_.capture, &QAction::triggered, &controller_.liveSession(), &LiveSession::captureNow);
  connect(actions_.skip_pose, &QAction::triggered, &controller_.poseGuide(), &PoseGuide::skipPose);
  connect(actions_.robot, &QAction::triggered, &controller_.poseGuide(), &PoseGuide::setRobot);
  connect(actions_.live_mode, &QAction::triggered, &controller_.liveMode(), &LiveMode::setOn);
  connect(actions_.light_cell, &QAction::triggered, this,
          [this](bool on) { controller_.liveSession().lightCell(on ? selection_.cell() : std::nullopt); });
  connect(actions_.show_next_pose, &QAction::triggered, this, [this] {
    openStep(GuideStep::Capture);
    patch_view_->fit();
  });
  connect(actions_.recapture, &QAction::triggered, this, [this] {
    const std::optional<int> row = pickedPoseRow();
    const std::optional<std::size_t> index = row ? controller_.sessionIndexOfPoseRow(*row) : std::nullopt;
    if (!index) return;
    if (controller_.liveSession().recapturing() == controller_.session()->poses()[*index].capture->id) {
      controller_.liveSession().cancelRecapture();
      return;
    }
    controller_.liveSession().recapturePose(*index);
    openStep(GuideStep::Capture);
    message_bar_->showMessage(Tone::Neutral,
                              tr("The next capture takes the place of pose %1. Hold the part as it was held then.")
                                  .arg(controller_.session()->poses()[*index].capture->id.value()),
                              tr("Don't recapture"), [this] { controller_.liveSession().cancelRecapture(); });
  });
  connect(&controller_.poseGuide(), &PoseGuide::nextPoseChanged, this, &MainWindow::refresh);
  connect(patch_view_, &PatchView::pictureRequested, this, [this] {
    askForPath(tr("Save a picture of the 3D view"), suggestedName() + tr("-3d"), tr("Pictures (*.png)"),
               QStringLiteral(".png"), [this](const QString& path) {
                 patch_view_->whenUpToDate(
                     [this, path] { controller_.resultFiles().saveImage(patch_view_->screenshot(), path); });
               });
  });
  connect(&controller_.liveMode(), &LiveMode::momentSolved, this,
          [this](const std::shared_ptr<const Reconstruction>& moment) {
            if (!controller_.liveMode().isOn()) return;
            graph_view_->setReconstruction(moment);
            patch_view_->setReconstruction(moment);
          });
  connect(&controller_.liveMode(), &LiveMode::toggled, this, [this](bool on) {
    if (on) return;
    graph_view_->setReconstruction(controller_.reconstruction());
    patch_view_->setReconstruction(controller_.reconstruction());
  });
  // While readings come these follow each other quickly, so only what shows them is refreshed.
  connect(&controller_.liveSession().source(), &LiveSource::holdChanged, this, &MainWindow::refreshLive);
  connect(&controller_.liveSession(), &LiveSession::captured, this, [this](const QString& text, bool remarkable) {
    if (remarkable && !message_bar_->isUrgent()) {
      message_bar_->showMessage(Tone::Caution, text);
    } else {
      // What went as it should is no reason to move the window's parts about.
      constexpr int kShown_ms = 6000;
      said_status_->setText(text);
      said_status_->show();
      said_timer_.start(kShown_ms);
      shell_->log().add(Severity::Info, text);
    }
  });
  connect(&controller_, &SessionController::noticed, this,
          [this](const QString& text) { message_bar_->showMessage(Tone::Caution, text); });
  connect(&controller_.file(), &SessionFile::journalStuck, this, [this](const QString& why) {
    after_saving_ = nullptr;
    may_close_ = close_when_written_ = false;
    message_bar_->showMessage(Tone::Bad, tr("Not on disk yet; it waits in memory and the work can go on. %1").arg(why),
                              tr("Try again"), [this] { controller_.file().retryWriting(); });
  });
}

void MainWindow::refreshLive() {
  const LiveSource& live = controller_.liveSession().source();
  const SourceStatus& status = live.status();
  // While all is well the status bar says it, and the step Capture has a panel that says more.
  const bool is_well = controller_.liveSession().isLive() && status.state == SourceState::Streaming;
  live_strip_->setVisible(live.isRunning() && !is_well);
  const QString losses = live.isRunning() ? lossesInWords(status, live.hold()) : QString();
  losses_status_->setVisible(!losses.isEmpty());
  losses_status_->setText(losses);
  losses_status_->setToolTip(
      tr("Since the skin was connected: %1. Poses need no more than their own samples, so a few lost ones do no harm; "
         "many speak of a slow network or cable.")
          .arg(countersInWords(status, live.hold())));
  if (!live.isRunning()) return;
  live_strip_->setStatus(status, live.hold());
  const QString device = live.skin() ? coreWords(live.skin()->device) + QStringLiteral(" · ") : QString();
  const QString where = controller_.liveSession().isDemo() ? tr("Demo skin") : device + live.address();
  source_status_->setText(
      QStringLiteral("%1 %2 · %3").arg(sourceStateSign(status.state), sourceStateWord(status.state), where));
  source_status_->setToolTip(device + live.address() + QStringLiteral("\n") + coreWords(status.text));
}

void MainWindow::showConnectDialog() {
  if (findChild<ConnectDialog*>()) return;
  auto* dialog =
      new ConnectDialog(folderForSessions(), controller_.file().isKept() ? controller_.file().name() : QString(), this);
  connect(dialog, &ConnectDialog::connectRequested, this, &MainWindow::connectTo);
  openInTurns(dialog);
}

void MainWindow::connectTo(const ConnectRequest& request) {
  if (request.continue_session) {
    controller_.liveSession().connectTo(request);
  } else {
    rememberFolder(request.path);
    afterAskingToSave([this, request] { controller_.liveSession().connectTo(request); });
  }
}

}  // namespace hexoderm
