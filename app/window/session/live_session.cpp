#include "app/window/session/live_session.h"

#include "app/window/session/session_controller.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QMetaObject>
#include <QSettings>
#include <utility>

namespace hexoderm {

LiveSession::LiveSession(SessionController& controller) : controller_(controller), course_(*this) {
  connect(&source_, &LiveSource::skinDescribed, this, &LiveSession::showSkin);
  connect(&source_, &LiveSource::poseCaptured, this, [this](const CapturedPose& captured) {
    if (isLive()) course_.take(captured);
  });
  connect(&source_, &LiveSource::failed, &controller_, &SessionController::failed);
  connect(&source_, &LiveSource::statusChanged, this, [this] {
    course_.setSending(source_.status().state == SourceState::Streaming);
    emit controller_.changed();
  });
  connect(&source_, &LiveSource::commandAnswered, this,
          [this](const CommandOutcome& outcome) { course_.setOutcome(outcome); });
}

bool LiveSession::isDemo() const { return controller_.session() && demo_; }

void LiveSession::startDemo() {
  ConnectRequest request;
  request.address = QSettings().value(QStringLiteral("demo/source"), QStringLiteral("sim:x17")).toString();
  request.demo = true;
  connectTo(request);
}

void LiveSession::connectTo(const ConnectRequest& request) {
  controller_.file().cancelOpening();
  forgetSource();
  request_ = request;
  request_.continue_session = request.continue_session && controller_.file().isKept();
  request_revision_ = controller_.submittedRevision();
  LiveOptions options;
  options.address = request.address;
  options.recorder = recorder_options_;
  options.recorder.automatic = automatic_;
  if (request_.continue_session) {
    options.next_pose = controller_.session()->nextPoseId();
    options.earlier_poses = earlierPoses();
  }
  source_.start(options);
}

void LiveSession::disconnectSource() {
  forgetSource();
  source_.stop();
}

void LiveSession::forgetSource() {
  course_.end();
  lit_.reset();
  emit ended();
}

void LiveSession::forget() {
  forgetSource();
  course_.forget();
  demo_ = false;
}

void LiveSession::noteChange() {
  course_.noteChange();
  if (isLive()) source_.setEarlierPoses(earlierPoses());
}

void LiveSession::noteResult() { course_.setResult(controller_.reconstruction(), controller_.isCurrent()); }

void LiveSession::showSkin(const SkinDescription& skin) {
  if (course_.isOn()) {
    course_.describe(skin);
  } else if (!(request_.continue_session ? join(skin) : begin(skin))) {
    disconnectSource();
  }
}

bool LiveSession::join(const SkinDescription& skin) {
  if (!controller_.file().isKept()) return false;
  if (!course_.join(*controller_.session(), skin)) {
    emit controller_.failed(
        tr("%1 has other cells than the session %2, so nothing was added. Connect it with a session of its own.")
            .arg(words(skin.device), controller_.file().name()));
    return false;
  }
  demo_ = false;
  noteResult();
  emit controller_.changed();
  return true;
}

bool LiveSession::begin(const SkinDescription& skin) {
  SessionFile& file = controller_.file();
  if (file.hasUnsavedChanges() && controller_.submittedRevision() != request_revision_) {
    emit controller_.failed(
        tr("The session that is open was changed while the skin was being connected, so it stays. Save it, and "
           "connect again."));
    return false;
  }
  const ConnectRequest request = request_;
  auto session = std::make_unique<Session>(CaptureWorkflow::sessionOf(skin, source_.address().toStdString()));
  if (request.path.isEmpty()) {
    controller_.showSession(std::move(session), request.demo ? tr("Demo skin (simulated)") : source_.address(), {});
    file.keepInScratch(request.demo ? QStringLiteral("demo") : QStringLiteral("live"));
  } else {
    controller_.showSession(std::move(session), QFileInfo(request.path).fileName(), request.path);
    file.keepIn(request.path);
  }
  course_.begin(*controller_.session(), skin);
  demo_ = request.demo;
  emit controller_.changed();
  return true;
}

void LiveSession::perform(const std::vector<SessionEdit>& edits) {
  if (const auto* skin = std::get_if<SetSkin>(&edits.front())) {
    controller_.performForGood(*skin);
    return;
  }
  QString text;
  if (const auto* replaced = std::get_if<RemovePose>(&edits.front())) {
    text = tr("recapture pose %1").arg(controller_.session()->poses().at(replaced->index).capture->id.value());
  }
  controller_.perform(edits, text);
}

void LiveSession::retryWriting() { controller_.file().retryWriting(); }

void LiveSession::onWorkflowEvent(const WorkflowEvent& event) {
  if (const auto* taken = std::get_if<PoseTaken>(&event)) {
    emit poseTaken(taken->captured);
  } else if (const auto* kept = std::get_if<PoseKept>(&event)) {
    announce(*kept);
  } else if (const auto* lost = std::get_if<PoseLost>(&event)) {
    emit poseLost(lost->pose);
  } else if (const auto* renewed = std::get_if<FileRenewed>(&event)) {
    emit controller_.noticed(words(renewed->what));
  } else if (const auto* skin = std::get_if<SkinChanged>(&event)) {
    emit controller_.noticed(skin->other_model ? tr("The device says that it has another cell model; the poses stay.")
                             : skin->on_joining
                                 ? tr("The links are others than those of the session; the poses stay.")
                                 : tr("The device says that its cells or links have changed; the poses stay."));
  } else if (const auto* wanted = std::get_if<AdviceWanted>(&event)) {
    advise(wanted->question);
  } else if (std::holds_alternative<AdviceChanged>(event)) {
    emit nextPoseChanged();
  } else if (const auto* refused = std::get_if<TurnRefused>(&event)) {
    announce(*refused);
  } else if (std::holds_alternative<WorkflowFinished>(event)) {
    emit controller_.changed();
  }
}

void LiveSession::announce(const TurnRefused& refused) {
  const QString why = words(refused.why);
  emit controller_.noticed(
      refused.gave_up ? tr("The device refused to turn %1 times, so it is not asked any more. The last time: %2")
                            .arg(QString::number(refused.times), why)
                      : tr("The device does not turn there: %1. The next best pose is advised instead.").arg(why));
  if (refused.gave_up) emit controller_.changed();
}

void LiveSession::advise(const AdviceQuestion& question) {
  // The course takes the answer to its newest question alone.
  adviser_.submit([this, question](const std::stop_token&) {
    const AdviceAnswer answer = adviseOn(question);
    QMetaObject::invokeMethod(
        this, [this, answer] { course_.setAdvice(answer); }, Qt::QueuedConnection);
  });
}

void LiveSession::turnToNextPose() {
  if (isLive()) course_.turnToNextPose();
}

void LiveSession::turnTo(const Eigen::Vector3d& up_o) {
  if (!isLive()) return;
  const bool was_on = isRobotOn();
  course_.turnTo(up_o);
  if (was_on) emit controller_.changed();
}

void LiveSession::startRobot(bool on, std::size_t poses) {
  on = on && canTurn();
  if (on) setAutomatic(true);
  course_.setRobot(on, poses);
  emit controller_.changed();
}

void LiveSession::announce(const PoseKept& kept) {
  const PoseCapture& pose = *kept.captured.pose;
  const QString id = QString::number(pose.id.value());
  const QString cells = pose.samples.size() == 1 ? tr("1 cell") : tr("%1 cells").arg(pose.samples.size());
  QString text = kept.where == KeptIn::Memory ? tr("Pose %1 captured, in memory only: %2.").arg(id, cells)
                                              : tr("Pose %1 captured: %2.").arg(id, cells);
  if (!kept.captured.silent_cells.empty()) {
    text += QLatin1Char(' ') + tr("Nothing came from %1.").arg(words(Message("{}", {kept.captured.silent_cells})));
  }
  if (kept.captured.repeats) {
    text += QLatin1Char(' ') + tr("It repeats pose %1, which is only %2° away.")
                                   .arg(QString::number(kept.captured.repeats->value()),
                                        figureText(toDegrees(kept.captured.repeat_angle_rad), 1));
  }
  emit poseKept(kept.captured);
  emit captured(text, kept.captured.repeats || !kept.captured.silent_cells.empty());
}

std::vector<std::shared_ptr<const PoseCapture>> LiveSession::earlierPoses() const {
  std::vector<std::shared_ptr<const PoseCapture>> captures;
  for (const SessionPose& pose : controller_.session()->poses()) {
    // What is taken again is not to be told that it repeats itself.
    if (!pose.disabled && pose.capture->id != course_.recapturing()) captures.push_back(pose.capture);
  }
  return captures;
}

void LiveSession::captureNow() {
  if (isLive()) source_.captureNow();
}

void LiveSession::setAutomatic(bool automatic) {
  automatic_ = automatic;
  source_.setAutomatic(automatic);
  emit controller_.changed();
}

void LiveSession::recapturePose(std::size_t index) {
  if (!isLive() || index >= controller_.session()->poses().size()) return;
  course_.recapture(controller_.session()->poses()[index].capture->id);
  source_.setEarlierPoses(earlierPoses());
  emit controller_.changed();
}

void LiveSession::cancelRecapture() {
  if (!course_.recapturing()) return;
  course_.cancelRecapture();
  if (isLive()) source_.setEarlierPoses(earlierPoses());
  emit controller_.changed();
}

void LiveSession::lightCell(std::optional<CellId> cell) {
  if (!isLive() || !source_.skin() || !source_.skin()->can_light_cells || cell == lit_) return;
  if (lit_) source_.send(SetLed{*lit_, 0, 0, 0});
  if (cell) source_.send(SetLed{*cell, 255, 255, 255});
  lit_ = cell;
  emit controller_.changed();
}

LiveMode::LiveMode(SessionController& controller)
    : controller_(controller), worker_([this](ReconstructionOutcome outcome) {
        QMetaObject::invokeMethod(
            this, [this, outcome = std::move(outcome)] { receive(outcome); }, Qt::QueuedConnection);
      }) {}

void LiveMode::setOn(bool on) {
  on = on && controller_.liveSession().isLive();
  if (is_on_ == on) return;
  is_on_ = on;
  fails_ = false;
  emit toggled(on);
}

void LiveMode::solve() {
  const std::vector<CellSample>& means = controller_.liveSession().source().preview().means;
  if (!is_on_ || !controller_.session() || means.empty()) return;
  auto moment = std::make_shared<SessionSnapshot>(*controller_.session()->snapshot());
  auto capture = std::make_shared<PoseCapture>();
  capture->id = PoseId(1);
  capture->label = message("now");
  for (const CellSample& mean : means) {
    GravitySample sample;
    sample.cell = mean.cell;
    sample.mean_g = mean.acceleration_g;
    capture->samples.push_back(sample);
  }
  moment->poses = {{std::move(capture), false, {}}};
  SolverOptions options = controller_.solverOptions();
  options.solver = Solver::Tree;  // the paper's self-refreshing test; quick enough for every preview
  worker_.submit(std::move(moment), options);
}

void LiveMode::receive(const ReconstructionOutcome& outcome) {
  if (!is_on_) return;
  if (outcome.reconstruction) {
    fails_ = false;
    emit momentSolved(outcome.reconstruction);
  } else if (!std::exchange(fails_, true)) {
    emit controller_.noticed(
        tr("What is shown stands still: the skin as it is now can't be solved. %1").arg(words(outcome.error)));
  }
}

}  // namespace hexoderm
