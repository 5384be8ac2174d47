#include "app/window/session/session_controller.h"

#include "app/window/files/session_paths.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/session_store.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QMetaObject>
#include <QSettings>
#include <filesystem>
#include <utility>

namespace hexoderm {
namespace {

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

SessionController::SessionController(QObject* parent)
    : QObject(parent),
      undo_stack_(this),
      worker_([this](ReconstructionOutcome outcome) {
        QMetaObject::invokeMethod(
            this, [this, outcome = std::move(outcome)] { receive(outcome); }, Qt::QueuedConnection);
      }),
      moment_worker_([this](ReconstructionOutcome outcome) {
        QMetaObject::invokeMethod(
            this, [this, outcome = std::move(outcome)] { receiveMoment(outcome); }, Qt::QueuedConnection);
      }) {
  connect(&undo_stack_, &QUndoStack::indexChanged, this, [this] {
    if (session_) submit();
  });
  connect(&undo_stack_, &QUndoStack::cleanChanged, this, &SessionController::changed);
  connectLive();
}

SessionController::~SessionController() {
  // The stack says so when it is cleared, and by then the worker is gone.
  disconnect(&undo_stack_, nullptr, this, nullptr);
  // Whoever ends the window was asked first.
  dropJournal();
}

std::optional<std::size_t> SessionController::sessionIndexOfPoseRow(int row) const {
  if (!session_ || !reconstruction_ || row < 0 || static_cast<std::size_t>(row) >= reconstruction_->poses.size()) {
    return std::nullopt;
  }
  const auto index = static_cast<std::size_t>(row);
  const PoseId id = reconstruction_->poses[index].pose;
  const std::vector<SessionPose>& poses = session_->poses();
  // Several poses of a file may carry one number; as long as nothing changed, the row says which is meant.
  return index < poses.size() && poses[index].capture->id == id ? std::optional(index) : indexOf(id);
}

void SessionController::startDemo() {
  ConnectRequest request;
  request.address = QSettings().value(QStringLiteral("demo/source"), QStringLiteral("sim:x17")).toString();
  request.demo = true;
  connectTo(request);
}

void SessionController::openFile(const QString& path) {
  if (journal_ && isSameFile(path, journal_->path())) {
    emit noticed(tr("%1 is open already.").arg(journal_->path()));
    return;
  }
  const std::uint64_t ticket = ++asked_count_;
  const QString name = QFileInfo(path).fileName();
  start(tr("Opening %1").arg(name),
        [this, ticket, name, path]() -> Continuation {
          auto opened_file = std::make_shared<Opened>(openToEdit(toPath(path)));
          return [this, ticket, name, path, opened_file] {
            if (ticket != asked_count_) return;
            disconnectSource();
            if (auto* session = std::get_if<Session>(&opened_file->file)) {
              showSession(std::make_unique<Session>(std::move(*session)), name, path);
            } else {
              showCalibration(std::get<std::shared_ptr<const Reconstruction>>(opened_file->file), path);
            }
            if (opened_file->store && isInUnsavedFolder(path)) {
              // Recovered: it goes on where it was, and still waits to be saved.
              scratch_path_ = path;
              session_path_.clear();
              name_ = tr("Recovered session");
              undo_stack_.resetClean();
            }
            if (opened_file->store) {
              journal_ =
                  std::make_unique<SessionJournal>(*this, jobs_, path, std::move(*opened_file->store), journalTold());
              emit changed();
            } else if (!opened_file->remark.empty()) {
              emit noticed(tr("Changes will not be kept in this file; save the session under another name. %1")
                               .arg(words(opened_file->remark)));
            }
          };
        },
        {});
}

void SessionController::saveSession(const QString& path) {
  if (!session_) return;
  if (journal_ && isSameFile(path, journal_->path())) {
    retryWriting();
    return;
  }
  if (path.endsWith(QStringLiteral(".hexo"))) {
    saveAsJournal(path);
    return;
  }
  // The copy shares the captures; what the operator does meanwhile is not in it and stays unsaved.
  startWriting(tr("Saving %1").arg(QFileInfo(path).fileName()),
               [this, path, session = *session_, ticket = opened_count_]() -> Continuation {
                 writeSessionJson(session, toPath(path));
                 return [this, path, ticket, revision = session.revision()] {
                   if (ticket != opened_count_ || !session_) return;
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
                   if (session_->revision() == revision) {
                     undo_stack_.setClean();
                   } else {
                     undo_stack_.resetClean();
                   }
                   emit sessionSaved(path);
                 };
               });
}

void SessionController::exportTo(const ExportRequest& request) {
  if (!reconstruction_) return;
  startWriting(tr("Exporting %1").arg(QFileInfo(request.path).fileName()),
               [this, request, reconstruction = reconstruction_]() -> Continuation {
                 if (request.format) {
                   exportReconstruction(*reconstruction, *request.format, toPath(request.path), request.options);
                 } else {
                   writeCalibrationJson(*reconstruction, toPath(request.path));
                 }
                 return [this, path = request.path] { emit exported(path); };
               });
}

void SessionController::saveImage(const QImage& image, const QString& path) {
  savePicture([image, path] { return image.save(path, "PNG"); }, path);
}

void SessionController::savePicture(std::function<bool()> write, const QString& path) {
  startWriting(tr("Saving %1").arg(QFileInfo(path).fileName()),
               [this, write = std::move(write), path]() -> Continuation {
                 if (!write()) {
                   throw StorageError(
                       message("The picture {} could not be written: is the folder writable?", path.toStdString()));
                 }
                 return [this, path] { emit exported(path); };
               });
}

void SessionController::saveTable(const QByteArray& csv, const QString& path) {
  startWriting(tr("Saving %1").arg(QFileInfo(path).fileName()), [this, csv, path]() -> Continuation {
    writeFileAtomically(toPath(path), std::string_view(csv.constData(), static_cast<std::size_t>(csv.size())));
    return [this, path] { emit exported(path); };
  });
}

void SessionController::writeReport(const std::vector<ReportPicture>& pictures, const QString& path) {
  if (!reconstruction_) return;
  const ReportContent content{reconstruction_, name_, pictures, QDateTime::currentDateTime()};
  startWriting(tr("Writing the report %1").arg(QFileInfo(path).fileName()), [this, content, path]() -> Continuation {
    hexoderm::writeReport(content, path);
    return [this, path] { emit exported(path); };
  });
}

void SessionController::captureNow() {
  if (isLive()) live_.captureNow();
}

void SessionController::setPoseDisabled(std::size_t index, bool disabled) {
  if (!session_ || index >= session_->poses().size() || session_->poses()[index].disabled == disabled) return;
  undo_stack_.push(new SetPoseDisabledCommand(edited(), index, disabled));
}

void SessionController::removePose(std::size_t index) {
  if (!session_ || index >= session_->poses().size()) return;
  undo_stack_.push(new RemovePoseCommand(edited(), index));
}

void SessionController::setLinkMuted(LinkEnd a, LinkEnd b, bool muted) {
  if (!session_ || a == b || (session_->findMutedLink(a, b) != nullptr) == muted) return;
  undo_stack_.push(new MuteLinkCommand(edited(), a, b, muted));
}

void SessionController::start(const QString& activity, std::function<Continuation()> work, Continuation finally) {
  activities_.push_back(activity);
  emit changed();
  jobs_.add([this, work = std::move(work), finally = std::move(finally)] {
    Continuation then;
    try {
      then = work();
    } catch (const std::exception& error) {
      then = [this, message = words(error)] { emit failed(message); };
    }
    QMetaObject::invokeMethod(
        this,
        [this, then = std::move(then), finally] {
          activities_.pop_front();
          if (finally) finally();
          then();
          emit changed();
        },
        Qt::QueuedConnection);
  });
}

void SessionController::startWriting(const QString& activity, std::function<Continuation()> work) {
  ++writing_;
  start(activity, std::move(work), [this] { --writing_; });
}

void SessionController::closeCurrent() {
  ++opened_count_;
  worker_.cancel();
  moment_worker_.cancel();
  calibration_path_.clear();
  forgetSource();
  announcements_.clear();
  was_stuck_ = false;
  scratch_fails_ = false;
  saves_under_way_.clear();
  dropJournal();
  // The stack's commands refer to the session, so they go first; while there is no session nothing is submitted.
  const std::unique_ptr<Session> old = std::move(session_);
  undo_stack_.clear();
  demo_ = false;
  reconstruction_.reset();
  session_path_.clear();
  saved_at_ = {};
  first_revision_ = submitted_revision_ + 1;
  shown_revision_ = submitted_revision_;
}

void SessionController::showSession(std::unique_ptr<Session> session, const QString& name, const QString& path) {
  closeCurrent();
  session_ = std::move(session);
  name_ = name;
  session_path_ = path;
  emit reconstructionChanged(nullptr);
  submit();
  emit opened(name);
}

void SessionController::showCalibration(std::shared_ptr<const Reconstruction> calibration, const QString& path) {
  closeCurrent();
  name_ = QFileInfo(path).fileName();
  calibration_path_ = path;
  reconstruction_ = std::move(calibration);
  emit reconstructionChanged(reconstruction_);
  emit opened(name_);
}

void SessionController::submit() {
  auto snapshot = std::make_shared<SessionSnapshot>(*session_->snapshot());
  // Sessions count their own revisions from 1; results must be told apart across sessions too.
  snapshot->revision = ++submitted_revision_;
  worker_.submit(std::move(snapshot), options_);
  emit changed();
}

void SessionController::setSolverOptions(const SolverOptions& options) {
  options_ = options;
  if (session_) submit();
}

void SessionController::receive(const ReconstructionOutcome& outcome) {
  if (outcome.revision < first_revision_ || outcome.revision <= shown_revision_) return;
  shown_revision_ = outcome.revision;
  if (outcome.reconstruction) {
    reconstruction_ = outcome.reconstruction;
    adviseAnew();
    emit reconstructionChanged(reconstruction_);
  } else {
    emit failed(words(outcome.error));
  }
  emit changed();
}

}  // namespace hexoderm
