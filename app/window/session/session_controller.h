#pragma once

#include "app/window/files/job_queue.h"
#include "app/window/report/report.h"
#include "app/window/session/live_source.h"
#include "app/window/session/session_commands.h"
#include "app/window/session/session_journal.h"
#include "hexoderm/io/exporter.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/reconstruction/advice/pose_advisor.h"
#include "hexoderm/reconstruction/reconstruction_worker.h"

#include <QImage>
#include <QObject>
#include <QStringList>
#include <QTime>
#include <QUndoStack>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

/// What an export dialog asks for. Without a format: Hexoderm's own calibration file.
struct ExportRequest {
  std::optional<ExportFormat> format;
  QString path;
  ExportOptions options;
};

/// What the dialog that connects asks for.
struct ConnectRequest {
  QString address;  ///< as openSkinSource() takes it
  QString path;     ///< of the new *.hexo that the poses are kept in; empty: until it is saved, a scratch file
  bool continue_session = false;  ///< instead, the poses join the session that is open and kept in a file
  bool demo = false;              ///< the simulated skin that everything can be tried with
};

/// The only bridge between core and Qt. Owns the session (on the GUI thread), the worker that reconstructs it, the undo
/// stack, the skin that is connected, the file that the session is kept in, and the thread that files and the simulated
/// skin work on. Nothing here waits for any of them.
class SessionController : public QObject {
  Q_OBJECT

 public:
  explicit SessionController(QObject* parent = nullptr);
  ~SessionController() override;

  /// Null if nothing is open, or a calibration is.
  [[nodiscard]] const Session* session() const { return session_.get(); }
  /// The newest result; null until there is one.
  [[nodiscard]] const std::shared_ptr<const Reconstruction>& reconstruction() const { return reconstruction_; }
  [[nodiscard]] QUndoStack* undoStack() { return &undo_stack_; }

  [[nodiscard]] bool isEmpty() const { return !session_ && !reconstruction_; }
  [[nodiscard]] bool isDemo() const { return session_ && demo_; }
  [[nodiscard]] const SolverOptions& solverOptions() const { return options_; }
  /// The skin that is connected, or about to be.
  [[nodiscard]] const LiveSource& live() const { return live_; }
  /// The session grows by what a connected skin is captured in.
  [[nodiscard]] bool isLive() const { return session_ && live_session_ && live_.isRunning(); }
  /// The device can be asked to turn itself.
  [[nodiscard]] bool canTurn() const { return isLive() && live_.skin() && live_.skin()->can_turn; }
  [[nodiscard]] bool isAutomatic() const { return automatic_; }
  /// The device turns itself from pose to pose until there are enough.
  [[nodiscard]] bool isRobotOn() const { return robot_; }
  /// The skin as its readings of this moment alone show it, instead of the session's result.
  [[nodiscard]] bool isLiveMode() const { return live_mode_; }
  /// The pose that would help most, in the frame of the largest patch; none before the first result, or where no skin
  /// is connected.
  [[nodiscard]] const std::optional<PoseAdvice>& nextPose() const { return next_pose_; }
  /// Following that advice would help: not for the first pose, which may be any, nor where there are enough.
  [[nodiscard]] bool isNextPoseWanted() const { return next_pose_ && next_pose_wanted_; }
  /// The cell whose light was switched on.
  [[nodiscard]] std::optional<CellId> litCell() const { return lit_; }
  /// The pose that the next capture replaces.
  [[nodiscard]] std::optional<PoseId> recapturing() const { return recapturing_; }
  [[nodiscard]] std::size_t enabledPoses() const;
  /// The skin that is connected should be held for another pose, see enoughPoses().
  [[nodiscard]] bool wantsMorePoses() const;
  /// A change of the session has no result yet.
  [[nodiscard]] bool isSolving() const { return session_ && shown_revision_ < submitted_revision_; }
  /// The shown result is that of the session as it is now: no change is being solved, none failed.
  [[nodiscard]] bool isCurrent() const {
    return reconstruction_ && (!session_ || reconstruction_->revision == submitted_revision_);
  }
  /// What is being done in the background, in words; empty if nothing is.
  [[nodiscard]] QString activity() const { return activities_.isEmpty() ? QString() : activities_.front(); }
  [[nodiscard]] bool isWriting() const {
    return writing_ > 0 || (journal_ && journal_->isWaiting() && journal_->problem().isEmpty());
  }
  [[nodiscard]] QString name() const { return name_; }
  /// Where Save goes without asking; empty if it must ask.
  [[nodiscard]] QString sessionPath() const { return session_path_; }
  /// Of a session that is kept in a file: only what could not be written.
  [[nodiscard]] bool hasUnsavedChanges() const {
    return session_ && (isKept() ? isJournalStuck() : !undo_stack_.isClean());
  }
  /// The file that the calibration which is open was read from; empty if none is.
  [[nodiscard]] QString calibrationPath() const { return calibration_path_; }
  /// Every change is written to sessionPath() as it happens.
  [[nodiscard]] bool isKept() const { return session_ && journal_ && scratch_path_.isEmpty(); }
  /// When this session was saved, or its file was written to, last; invalid if it never was.
  [[nodiscard]] QTime savedAt() const { return saved_at_; }

  /// Place of a pose of the shown reconstruction among the session's poses, which may be ahead of it.
  [[nodiscard]] std::optional<std::size_t> sessionIndexOfPoseRow(int row) const;

 public slots:
  void startDemo();
  void openFile(const QString& path);
  void saveSession(const QString& path);
  void exportTo(const hexoderm::ExportRequest& request);
  void saveImage(const QImage& image, const QString& path);
  /// A table of the window, as CSV.
  void saveTable(const QByteArray& csv, const QString& path);
  /// Of what is shown now, with these pictures, as PDF or HTML by the ending of `path`.
  void writeReport(const std::vector<hexoderm::ReportPicture>& pictures, const QString& path);
  /// The next readings become a pose, moved or not. Nothing happens where no skin is connected.
  void captureNow();
  void setPoseDisabled(std::size_t index, bool disabled);
  void removePose(std::size_t index);
  /// Keeps a link out of the solution, or lets it in again.
  void setLinkMuted(LinkEnd a, LinkEnd b, bool muted);
  /// Calls `write` on the thread for files; false from it is a failure. `exported` follows, as after saveImage().
  void savePicture(std::function<bool()> write, const QString& path);

  /// The session that is open stays until the skin has described itself.
  void connectTo(const hexoderm::ConnectRequest& request);
  /// What was captured stays.
  void disconnectSource();
  /// Asks the device to turn itself to where the next pose helps most.
  void turnToNextPose();
  /// Asks the device to turn until `up_o` (unit, frame of the largest patch) points up.
  void turnTo(const Eigen::Vector3d& up_o);
  /// The part can't be brought there: advises the next best pose.
  void skipPose();
  void setRobot(bool on);
  void setAutomatic(bool automatic);
  void setLiveMode(bool on);
  /// The next capture takes the place of this pose.
  void recapturePose(std::size_t index);
  void cancelRecapture();
  /// Lights a cell of the connected skin, and darkens the one before.
  void lightCell(std::optional<hexoderm::CellId> cell);
  /// Of captures, from the next connection on.
  void setRecorderOptions(const hexoderm::PoseRecorderOptions& options) { recorder_options_ = options; }
  /// Solves anew with these.
  void setSolverOptions(const hexoderm::SolverOptions& options);
  /// Writes what could not be written to the session's file.
  void retryWriting();

 signals:
  /// Anything about session, files or background work changed.
  void changed();
  void reconstructionChanged(std::shared_ptr<const hexoderm::Reconstruction> reconstruction);
  /// Where it ends, the result that was not shown meanwhile is still the same.
  void liveModeChanged(bool on);
  /// In live mode, for every moment that was solved.
  void momentSolved(std::shared_ptr<const hexoderm::Reconstruction> reconstruction);
  void nextPoseChanged();
  void opened(const QString& name);
  void sessionSaved(const QString& path);
  void exported(const QString& path);
  /// One message for a person, as core said it.
  void failed(const QString& message);
  /// A live pose is on disk; `remarkable` if the operator should read the text.
  void captured(const QString& text, bool remarkable);
  /// The session's file can't be written; what was captured waits in memory. retryWriting() tries again.
  void journalStuck(const QString& why);
  /// Something that is no failure and should be known.
  void noticed(const QString& text);

 private:
  using Continuation = std::function<void()>;
  /// Runs `work` on the job thread, then `finally` and what `work` returned on the GUI thread; what it throws becomes
  /// `failed`.
  void start(const QString& activity, std::function<Continuation()> work, Continuation finally);
  void startWriting(const QString& activity, std::function<Continuation()> work);
  void showSession(std::unique_ptr<Session> session, const QString& name, const QString& path);
  void showCalibration(std::shared_ptr<const Reconstruction> calibration, const QString& path);
  void closeCurrent();
  void submit();
  void receive(const ReconstructionOutcome& outcome);
  void receiveMoment(const ReconstructionOutcome& outcome);

  void connectLive();
  /// What was asked of the skin that was connected, and what it could not do, says nothing about the next.
  void forgetSource();
  void showSkin(const SkinDescription& skin);
  [[nodiscard]] bool beginLiveSession(const SkinDescription& skin);
  void replaceSkin(const SkinDescription& skin);
  void addCapture(const CapturedPose& captured);
  /// Of the pose among the session's.
  [[nodiscard]] std::optional<std::size_t> indexOf(PoseId pose) const;
  /// Named by how the part is held, where that is known.
  [[nodiscard]] std::shared_ptr<const PoseCapture> withLabel(std::shared_ptr<const PoseCapture> pose) const;
  void announce(PoseId pose);
  void announceAll();
  [[nodiscard]] std::vector<std::shared_ptr<const PoseCapture>> enabledCaptures() const;

  void adviseAnew();
  void letRobotTurn();
  void sendTurn(const Eigen::Vector3d& up_o);
  void solveMoment();

  [[nodiscard]] EditedSession edited();
  void record(StoreOperation operation);
  void appendToJournal(StoreOperation operation);
  [[nodiscard]] SessionJournal::Told journalTold();
  [[nodiscard]] bool isJournalStuck() const {
    return journal_ && journal_->isWaiting() && !journal_->problem().isEmpty();
  }
  void saveAsJournal(const QString& path);
  void beginScratch(const QString& name);
  [[nodiscard]] QString suggestedScratchName() const;
  void dropJournal();

  std::unique_ptr<Session> session_;
  bool demo_ = false;
  SolverOptions options_;
  PoseRecorderOptions recorder_options_;
  std::shared_ptr<const Reconstruction> reconstruction_;
  QUndoStack undo_stack_;
  QString name_;
  QString session_path_;
  QString calibration_path_;
  QTime saved_at_;
  QStringList activities_;
  int writing_ = 0;
  QString scratch_path_;        ///< of the journal, where it is only kept until the session is saved
  bool scratch_fails_ = false;  ///< said once

  ConnectRequest connect_request_;
  std::uint64_t connect_revision_ = 0;  ///< submitted last when it was made
  bool live_session_ = false;           ///< the session is that of the connected skin
  bool automatic_ = true;
  bool robot_ = false;
  bool live_mode_ = false;
  bool moment_fails_ = false;  ///< said once
  std::optional<PoseId> recapturing_;
  std::optional<CellId> lit_;
  std::optional<PoseAdvice> next_pose_;
  bool next_pose_wanted_ = false;
  std::uint64_t advice_asked_ = 0;  ///< answers to earlier questions are dropped
  struct Announcement {
    QString text;
    bool remarkable = false;
  };
  std::map<PoseId, Announcement> announcements_;  ///< of captures that are not on disk yet
  bool was_stuck_ = false;                        ///< the operator was told that something is not on disk
  std::uint32_t asked_turn_ = 0;
  Eigen::Vector3d asked_up_ = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> unreachable_;
  /// For each new file that the session is being copied into: what was changed meanwhile. Belongs to the job that makes
  /// it, so that it goes with a job that fails.
  std::vector<std::weak_ptr<std::vector<StoreOperation>>> saves_under_way_;

  std::uint64_t asked_count_ = 0;         ///< the last request to open something: earlier ones are dropped
  std::uint64_t opened_count_ = 0;        ///< which session or calibration this is: late answers for others are dropped
  std::uint64_t submitted_revision_ = 0;  ///< counts over all sessions, unlike the session's own
  std::uint64_t first_revision_ = 1;      ///< of the session that is open
  std::uint64_t shown_revision_ = 0;

  // Last, so that their threads have ended before anything they report to goes. The journal leaves its end to the jobs.
  ReconstructionWorker worker_;
  ReconstructionWorker moment_worker_;
  JobQueue advice_jobs_;
  LiveSource live_;
  JobQueue jobs_;
  std::unique_ptr<SessionJournal> journal_;
};

}  // namespace hexoderm
