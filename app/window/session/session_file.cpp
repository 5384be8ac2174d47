#include "app/window/session/session_file.h"

#include "app/window/files/session_paths.h"
#include "app/window/session/background_work.h"
#include "app/window/session/session_controller.h"
#include "hexoderm/base/error.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/robots/demo_robot.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/session/session_store.h"
#include "hexoderm/sim/simulated_session.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <filesystem>
#include <optional>
#include <utility>

namespace hexoderm {
namespace {

/// With its robot and the joint angles, but without a place of any patch: that is what is to be tried.
Session simulateRobotDemo() {
  constexpr std::size_t kPoses = 8;
  const RobotModel model = RobotModel::read(demoRobotFile());
  SimulatedRobotOptions options;
  options.mounts = demoMounts();
  SimulatedRobot robot(builtInCellModel("hex-bma150"), model, options);
  Session session = simulateRobotSession(robot, kPoses).session;
  session.setRobot(RobotDescription{model.file().string(), model.sha256(), {}});
  return session;
}

/// A file as it was opened; a session store that can be written stays open for what comes.
struct Opened {
  OpenedFile file;
  std::optional<SessionStore> store;
  Message remark;  ///< why it is not open for writing although it could be
};

Opened openToEdit(const std::filesystem::path& path) {
  if (!isSessionStore(path)) return {openFile(path, builtInCellModel("hex-bma150")), std::nullopt, {}};
  Message remark;
  try {
    SessionStore store = SessionStore::open(path);
    Session session = store.readSession();
    return {std::move(session), std::move(store), {}};
  } catch (const StorageError& error) {
    remark = messageOf(error);
  }
  return {readSessionStore(path), std::nullopt, remark};
}

}  // namespace

SessionFile::SessionFile(SessionController& controller, BackgroundWork& work) : controller_(controller), work_(work) {}

SessionFile::~SessionFile() {
  // The operator was asked before the window ended.
  dropJournal();
}

bool SessionFile::isKept() const { return controller_.session() && journal_ && scratch_path_.isEmpty(); }

bool SessionFile::isJournalStuck() const { return journal_ && journal_->isWaiting() && !journal_->problem().isEmpty(); }

bool SessionFile::hasUnsavedChanges() const {
  return controller_.session() && (isKept() ? isJournalStuck() : !controller_.undoStack()->isClean());
}

bool SessionFile::isWriting() const {
  return work_.isWriting() || (journal_ && journal_->isWaiting() && journal_->problem().isEmpty());
}

void SessionFile::close() {
  ++opened_count_;
  calibration_path_.clear();
  session_path_.clear();
  saved_at_ = {};
  was_stuck_ = false;
  scratch_fails_ = false;
  saves_under_way_.clear();
  dropJournal();
}

void SessionFile::nameSession(const QString& name, const QString& path) {
  name_ = name;
  session_path_ = path;
}

void SessionFile::nameCalibration(const QString& path) {
  name_ = QFileInfo(path).fileName();
  calibration_path_ = path;
}

void SessionFile::openFile(const QString& path) {
  if (journal_ && isSameFile(path, journal_->path())) {
    emit controller_.noticed(tr("%1 is open already.").arg(journal_->path()));
    return;
  }
  const std::uint64_t ticket = ++asked_count_;
  const QString name = QFileInfo(path).fileName();
  work_.start(tr("Opening %1").arg(name), [this, ticket, name, path]() -> BackgroundWork::Continuation {
    auto opened_file = std::make_shared<Opened>(openToEdit(toPath(path)));
    return [this, ticket, name, path, opened_file] {
      if (ticket != asked_count_) return;
      controller_.liveSession().disconnectSource();
      if (auto* session = std::get_if<Session>(&opened_file->file)) {
        controller_.showSession(std::make_unique<Session>(std::move(*session)), name, path);
      } else {
        controller_.showCalibration(std::get<std::shared_ptr<const Reconstruction>>(opened_file->file), path);
      }
      if (opened_file->store && isInUnsavedFolder(path)) {
        // Recovered: it goes on where it was, and still waits to be saved.
        scratch_path_ = path;
        session_path_.clear();
        name_ = tr("Recovered session");
        controller_.undoStack()->resetClean();
      }
      if (opened_file->store) {
        journal_ = std::make_unique<SessionJournal>(*this, work_.jobs(), path, std::move(*opened_file->store), told());
        emit controller_.changed();
      } else if (!opened_file->remark.empty()) {
        emit controller_.noticed(tr("Changes will not be kept in this file; save the session under another name. %1")
                                     .arg(words(opened_file->remark)));
      }
    };
  });
}

void SessionFile::openRobotDemo() {
  const std::uint64_t ticket = ++asked_count_;
  work_.start(tr("Simulating a robot"), [this, ticket]() -> BackgroundWork::Continuation {
    auto session = std::make_shared<Session>(simulateRobotDemo());
    return [this, ticket, session] {
      if (ticket != asked_count_) return;
      controller_.liveSession().disconnectSource();
      controller_.showSession(std::make_unique<Session>(std::move(*session)), tr("Simulated robot"), {});
    };
  });
}

void SessionFile::saveSession(const QString& path) {
  if (!controller_.session()) return;
  if (journal_ && isSameFile(path, journal_->path())) {
    retryWriting();
  } else if (path.endsWith(QStringLiteral(".hexo"))) {
    saveAsJournal(path);
  } else {
    saveAsJson(path);
  }
}

void SessionFile::saveAsJson(const QString& path) {
  // The copy shares the captures; what the operator does meanwhile is not in it and stays unsaved.
  work_.startWriting(tr("Saving %1").arg(QFileInfo(path).fileName()),
                     [this, path, copy = std::make_shared<const Session>(*controller_.session()),
                      ticket = opened_count_]() -> BackgroundWork::Continuation {
                       writeSessionJson(*copy, toPath(path));
                       return [this, path, ticket, copy] {
                         if (ticket != opened_count_ || !controller_.session()) return;
                         if (isKept() && !isJournalStuck()) {
                           // The session goes on in its own file, and this is a copy.
                           emit sessionSaved(path);
                           return;
                         }
                         // A scratch file goes on: for what will be changed after this.
                         if (scratch_path_.isEmpty()) journal_.reset();
                         session_path_ = path;
                         name_ = QFileInfo(path).fileName();
                         saved_at_ = QTime::currentTime();
                         if (controller_.session()->revision() == copy->revision()) {
                           controller_.undoStack()->setClean();
                         } else {
                           controller_.undoStack()->resetClean();
                         }
                         tellStored(copy->poses());
                         emit sessionSaved(path);
                       };
                     });
}

void SessionFile::saveAsJournal(const QString& path) {
  auto changed_meanwhile = std::make_shared<std::vector<SessionEdit>>();
  saves_under_way_.push_back(changed_meanwhile);
  work_.startWriting(tr("Saving %1").arg(QFileInfo(path).fileName()),
                     [this, path, changed_meanwhile = std::move(changed_meanwhile),
                      copy = std::make_shared<const Session>(*controller_.session()),
                      ticket = opened_count_]() -> BackgroundWork::Continuation {
                       auto store = std::make_shared<SessionStore>(SessionStore::create(toPath(path), *copy));
                       return [this, path, ticket, store, copy, changed_meanwhile] {
                         if (ticket != opened_count_ || !controller_.session()) return;
                         was_stuck_ = false;
                         dropJournal();
                         journal_ =
                             std::make_unique<SessionJournal>(*this, work_.jobs(), path, std::move(*store), told());
                         session_path_ = path;
                         name_ = QFileInfo(path).fileName();
                         saved_at_ = QTime::currentTime();
                         for (const SessionEdit& edit : std::exchange(*changed_meanwhile, {})) append(edit);
                         emit keptInFile();
                         // Captures that waited for the file before are in this one.
                         tellStored(copy->poses());
                         emit sessionSaved(path);
                       };
                     });
}

void SessionFile::tellStored(const std::vector<SessionPose>& poses) {
  for (const SessionPose& pose : poses) emit poseStored(pose.capture->id, StoreOutcome{});
}

void SessionFile::record(const SessionEdit& edit) {
  std::erase_if(saves_under_way_, [](const auto& save) { return save.expired(); });
  for (const auto& save : saves_under_way_) {
    if (const auto changed_meanwhile = save.lock()) changed_meanwhile->push_back(edit);
  }
  if (journal_) {
    append(edit);
  } else if (!scratch_fails_) {
    // The first change of a session that came from a file; the change is in the session already.
    keepInScratch(suggestedScratchName());
  }
}

void SessionFile::append(const SessionEdit& edit) {
  SessionJournal::Written written;
  if (const auto* add = std::get_if<AddPose>(&edit)) {
    written = [this, id = add->pose.capture->id](const StoreOutcome& outcome) { emit poseStored(id, outcome); };
  }
  journal_->append(edit, std::move(written));
  emit controller_.changed();
}

void SessionFile::keepInScratch(const QString& name) {
  scratch_path_ = newScratchPath(name);
  keepIn(scratch_path_);
}

void SessionFile::keepIn(const QString& path) {
  const auto first = std::make_shared<const Session>(*controller_.session());
  SessionRecorder::Open open = [path = toPath(path), first] { return SessionStore::create(path, *first); };
  const auto opened = [this, first](const StoreOutcome& outcome) {
    if (outcome.error.empty()) tellStored(first->poses());
  };
  journal_ = std::make_unique<SessionJournal>(*this, work_.jobs(), path, std::move(open), opened, told());
}

QString SessionFile::suggestedScratchName() const {
  QString name = controller_.liveSession().isDemo() ? QStringLiteral("demo")
                                                    : QFileInfo(name_).fileName().section(QLatin1Char('.'), 0, 0);
  name.replace(QRegularExpression(QStringLiteral("[^A-Za-z0-9_-]+")), QStringLiteral("_"));
  return name.isEmpty() ? QStringLiteral("session") : name.left(40);
}

void SessionFile::dropJournal() {
  journal_.reset();
  if (scratch_path_.isEmpty()) return;
  // After the journal has closed it, which happens on the same thread.
  work_.jobs().addEssential([path = toPath(std::exchange(scratch_path_, {}))] { removeSessionStore(path); });
}

SessionJournal::Told SessionFile::told() {
  return [this](const QString& why) {
    if (!scratch_path_.isEmpty()) {
      if (!why.isEmpty()) {
        // The session can go on without a file.
        scratch_fails_ = true;
        dropJournal();
        emit controller_.noticed(tr("Until it is saved, this session is kept in memory only. %1").arg(why));
        emit keptInMemoryOnly();
      }
      emit controller_.changed();
      return;
    }
    if (why.isEmpty()) {
      saved_at_ = QTime::currentTime();
      if (!journal_->isWaiting() && std::exchange(was_stuck_, false)) emit sessionSaved(journal_->path());
    } else if (journal_->isWaiting()) {
      was_stuck_ = true;
      emit journalStuck(why);
    } else {
      emit controller_.failed(why);
    }
    emit controller_.changed();
  };
}

void SessionFile::retryWriting() {
  if (!journal_) return;
  if (isJournalStuck()) {
    journal_->retry();
  } else {
    emit sessionSaved(journal_->path());
  }
}

}  // namespace hexoderm
