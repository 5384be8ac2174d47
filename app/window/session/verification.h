#pragma once

#include "app/window/report/report.h"
#include "hexoderm/reconstruction/check/calibration_check.h"
#include "hexoderm/reconstruction/evaluation/evaluation.h"
#include "hexoderm/reconstruction/evaluation/loop_search.h"
#include "hexoderm/reconstruction/hold_out.h"
#include "hexoderm/util/latest_worker.h"
#include "widgets/verify/verify_panel.h"

#include <QObject>
#include <QStringList>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace hexoderm {

/// Computes the checks of the step Verify on a thread of its own and keeps them up to date with the reconstruction and
/// the session. The newest request for a check wins: one that waits is dropped, one that runs is stopped, and its
/// result is not shown. An exception that a check throws becomes a message.
class Verification : public QObject {
  Q_OBJECT

 public:
  /// The destructor waits for the running check to stop.
  explicit Verification(QObject* parent = nullptr);

  /// What is verified from now on; null: nothing. Loops, surface and comparison are computed anew; a hold-out that is
  /// running is cancelled. An old calibration is checked anew by setToday().
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  /// `session`: as it is now; it is solved with the options of the reconstruction. Nothing happens without one.
  void runHoldOut(std::shared_ptr<const SessionSnapshot> session, PoseId pose);
  /// No kind: the most probable one of each patch.
  void setSurface(std::optional<SurfaceKind> kind, std::optional<double> true_radius_m);
  void dropSurface();
  /// A calibration, or a session that is then solved with the options of the reconstruction. Stays in force until
  /// dropComparison().
  void compareWith(const QString& path);
  void dropComparison();
  /// What compareWith() has read, from compared() on; null: nothing.
  [[nodiscard]] const std::shared_ptr<const Reconstruction>& reference() const { return reference_.calibration; }
  [[nodiscard]] QString referenceName() const;
  /// The session as it is now, whose poses an old calibration is compared with; null: there is none.
  void setToday(std::shared_ptr<const SessionSnapshot> today);
  /// Does this calibration still hold? Compares it, or a session solved as in compareWith(), with the newest `poses`
  /// poses of today that are enabled; no number: with all of them. Stays in force until dropOldCalibration().
  void checkOldCalibration(const QString& path, std::optional<std::size_t> poses);
  void dropOldCalibration();
  void cancel(VerifyCheck check);
  /// The results that are in force, for reports.
  [[nodiscard]] const VerifyOutcome& outcome() const { return outcome_; }

 signals:
  void runningChanged(hexoderm::VerifyCheck check, bool running);
  void heldOut(const hexoderm::HoldOutResult& result);
  void loopsFound(const std::vector<hexoderm::FoundLoop>& loops);
  void surfacesFitted(const std::vector<hexoderm::SurfaceEvaluation>& surfaces, const QStringList& remarks);
  void compared(const std::vector<hexoderm::Comparison>& comparisons, const QString& against);
  void oldCalibrationChecked(const hexoderm::CalibrationCheck& check, const QString& calibration);
  void failed(hexoderm::VerifyCheck check, const QString& message);

 private:
  using Announcement = std::function<void()>;
  using Work = std::function<Announcement(const std::stop_token&)>;
  /// A file of the operator's, with the calibration in it.
  struct Reference {
    QString path;                                       ///< empty: none is chosen
    std::shared_ptr<const Reconstruction> calibration;  ///< once it was read
    SolverOptions options;                              ///< that it was solved with, if it is a session
  };
  void request(VerifyCheck check, Work work);
  void finish(VerifyCheck check, std::uint64_t number, const Announcement& announce);
  void fitSurface();
  void compare();
  void checkToday();
  void setRunning(VerifyCheck check, bool running);
  void keepOutcome();
  void forgetOutcome(VerifyCheck check);

  std::shared_ptr<const Reconstruction> reconstruction_;
  bool wants_surface_ = false;
  std::optional<SurfaceKind> surface_kind_;
  std::optional<double> true_radius_m_;
  Reference reference_;  ///< to compare the result with
  Reference old_;        ///< to compare the poses of today with
  std::shared_ptr<const SessionSnapshot> today_;
  std::optional<std::size_t> newest_poses_;
  VerifyOutcome outcome_;

  static constexpr std::size_t kChecks = 5;
  std::array<std::uint64_t, kChecks> newest_{};  ///< request per check; results of older ones are dropped
  std::array<bool, kChecks> running_{};          ///< as runningChanged() last said
  LatestWorker worker_;  // a mailbox per check; last: it has ended before anything that it uses is destroyed
};

}  // namespace hexoderm
