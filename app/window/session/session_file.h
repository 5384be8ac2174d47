#pragma once

#include "app/window/files/session_paths.h"
#include "app/window/session/background_work.h"
#include "app/window/session/session_controller.h"
#include "app/window/session/session_journal.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/kinematics/demo_robot.h"
#include "hexoderm/kinematics/robot_model.h"
#include "hexoderm/session/session_edit.h"
#include "hexoderm/session/session_recorder.h"
#include "hexoderm/session/session_store.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/error.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QObject>
#include <QRegularExpression>
#include <QTime>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// The file that the open session is kept in.
///
/// A session *.hexo is kept: every edit is written to it as it happens. Any other session has a scratch file from its
/// first edit on, so that a killed program loses nothing, and is saved on the operator's request. If not even a scratch
/// file can be written, the session is in memory only, and the operator is told.
class SessionFile : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this object.
  SessionFile(SessionController& controller, BackgroundWork& work) : controller_(controller), work_(work) {}
  ~SessionFile() override {
    // The operator was asked before the window ended.
    dropJournal();
  }

  /// The name of what is open: its file's, or where it came from.
  [[nodiscard]] QString name() const { return name_; }
  /// The file to which Save writes without asking; empty if it must ask.
  [[nodiscard]] QString sessionPath() const { return session_path_; }
  /// The file that the open calibration was read from; empty if none is open.
  [[nodiscard]] QString calibrationPath() const { return calibration_path_; }
  /// Every change is written to sessionPath() as it happens.
  [[nodiscard]] bool isKept() const { return controller_.session() && journal_ && scratch_path_.isEmpty(); }
  /// For a session that is kept, only changes that could not be written count.
  [[nodiscard]] bool hasUnsavedChanges() const {
    return controller_.session() && (isKept() ? isJournalStuck() : !controller_.undoStack()->isClean());
  }

  [[nodiscard]] bool isWriting() const {
    return work_.isWriting() || (journal_ && journal_->isWaiting() && journal_->problem().isEmpty());
  }

  /// When the session was last saved, or its file last written to; invalid if it never was.
  [[nodiscard]] QTime savedAt() const { return saved_at_; }

  // For the other parts of the session.

  /// The file that is being opened is not to be shown any more.
  void cancelOpening() { ++asked_count_; }
  /// Nothing is open any more; a scratch file goes.
  void close() {
    ++opened_count_;
    calibration_path_.clear();
    session_path_.clear();
    saved_at_ = {};
    was_stuck_ = false;
    scratch_fails_ = false;
    saves_under_way_.clear();
    dropJournal();
  }

  void nameSession(const QString& name, const QString& path) {
    name_ = name;
    session_path_ = path;
  }

  void nameCalibration(const QString& path) {
    name_ = QFileInfo(path).fileName();
    calibration_path_ = path;
  }

  /// Makes a new file of the session that is open, and keeps it there.
  void keepIn(const QString& path) { beginJournal(path); }
  void keepInScratch(const QString& name) {
    scratch_path_ = newScratchPath(name);
    beginJournal(scratch_path_);
  }

  /// An edit that the session just got.
  void record(const SessionEdit& edit) {
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

 public slots:
  void openFile(const QString& path) {
    if (journal_ && isSameFile(path, journal_->path())) {
      emit noticed(tr("%1 is open already.").arg(journal_->path()));
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
          journal_ =
              std::make_unique<SessionJournal>(*this, work_.jobs(), path, std::move(*opened_file->store), told());
          emit changed();
        } else if (!opened_file->remark.empty()) {
          emit noticed(tr("Changes will not be kept in this file; save the session under another name. %1")
                           .arg(words(opened_file->remark)));
        }
      };
    });
  }

  /// A session of a simulated robot: a forearm with two patches and an elbow, in eight poses.
  void openRobotDemo() {
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

  void saveSession(const QString& path) {
    if (!controller_.session()) return;
    if (journal_ && isSameFile(path, journal_->path())) {
      retryWriting();
    } else if (path.endsWith(QStringLiteral(".hexo"))) {
      saveAsJournal(path);
    } else {
      saveAsJson(path);
    }
  }

  /// Writes what could not be written.
  void retryWriting() {
    if (!journal_) return;
    if (isJournalStuck()) {
      journal_->retry();
    } else {
      emit sessionSaved(journal_->path());
    }
  }

 signals:
  void changed();
  void failed(const QString& message);
  void noticed(const QString& text);
  void sessionSaved(const QString& path);
  /// The file can't be written; changes wait in memory. retryWriting() tries again.
  void journalStuck(const QString& why);
  /// The outcome of storing an added pose.
  void poseStored(hexoderm::PoseId pose, const hexoderm::StoreOutcome& outcome);
  /// No file keeps the session until it is saved; the operator was told.
  void keptInMemoryOnly();
  /// A session that was in memory only has a file that every change is written to.
  void keptInFile();

 private:
  /// With its robot and the joint angles, but without a place of any patch: that is what is to be tried.
  static Session simulateRobotDemo() {
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

  static Opened openToEdit(const std::filesystem::path& path) {
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

  [[nodiscard]] bool isJournalStuck() const {
    return journal_ && journal_->isWaiting() && !journal_->problem().isEmpty();
  }
  void append(const SessionEdit& edit) {
    SessionJournal::Written written;
    if (const auto* add = std::get_if<AddPose>(&edit)) {
      written = [this, id = add->pose.capture->id](const StoreOutcome& outcome) { emit poseStored(id, outcome); };
    }
    journal_->append(edit, std::move(written));
    emit changed();
  }

  void beginJournal(const QString& path) {
    const auto first = std::make_shared<const Session>(*controller_.session());
    SessionRecorder::Open open = [path = toPath(path), first] { return SessionStore::create(path, *first); };
    const auto opened = [this, first](const StoreOutcome& outcome) {
      if (outcome.error.empty()) tellStored(first->poses());
    };
    journal_ = std::make_unique<SessionJournal>(*this, work_.jobs(), path, std::move(open), opened, told());
  }

  void dropJournal() {
    journal_.reset();
    if (scratch_path_.isEmpty()) return;
    // After the journal has closed it, which happens on the same thread.
    work_.jobs().addEssential([path = toPath(std::exchange(scratch_path_, {}))] { removeSessionStore(path); });
  }

  [[nodiscard]] SessionJournal::Told told() {
    return [this](const QString& why) {
      if (!scratch_path_.isEmpty()) {
        if (why.isEmpty()) return;
        // The session can go on without a file.
        scratch_fails_ = true;
        dropJournal();
        emit noticed(tr("Until it is saved, this session is kept in memory only. %1").arg(why));
        emit keptInMemoryOnly();
        emit changed();
        return;
      }
      if (why.isEmpty()) {
        saved_at_ = QTime::currentTime();
        if (!journal_->isWaiting() && std::exchange(was_stuck_, false)) emit sessionSaved(journal_->path());
      } else if (journal_->isWaiting()) {
        was_stuck_ = true;
        emit journalStuck(why);
      } else {
        emit failed(why);
      }
      emit changed();
    };
  }

  void tellStored(const std::vector<SessionPose>& poses) {
    for (const SessionPose& pose : poses) emit poseStored(pose.capture->id, StoreOutcome{});
  }

  void saveAsJson(const QString& path) {
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

  void saveAsJournal(const QString& path) {
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

  [[nodiscard]] QString suggestedScratchName() const {
    QString name = controller_.liveSession().isDemo() ? QStringLiteral("demo")
                                                      : QFileInfo(name_).fileName().section(QLatin1Char('.'), 0, 0);
    name.replace(QRegularExpression(QStringLiteral("[^A-Za-z0-9_-]+")), QStringLiteral("_"));
    return name.isEmpty() ? QStringLiteral("session") : name.left(40);
  }

  SessionController& controller_;
  BackgroundWork& work_;
  QString name_;
  QString session_path_;
  QString calibration_path_;
  QTime saved_at_;
  QString scratch_path_;        ///< path of the journal, if it is only kept until the session is saved
  bool scratch_fails_ = false;  ///< told once
  bool was_stuck_ = false;      ///< the operator was told that something is not on disk
  /// For each new file that the session is being copied into, the edits since then. They belong to the job that makes
  /// the file, so that they go with a job that fails.
  std::vector<std::weak_ptr<std::vector<SessionEdit>>> saves_under_way_;
  std::uint64_t asked_count_ = 0;   ///< the last request to open something; answers to earlier ones are dropped
  std::uint64_t opened_count_ = 0;  ///< which session or calibration this is; late answers for others are dropped
  std::unique_ptr<SessionJournal> journal_;
};

}  // namespace hexoderm
