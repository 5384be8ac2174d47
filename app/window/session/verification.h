#pragma once

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

/// Computes the checks of the step Verify on a thread of its own and keeps them up to date with the reconstruction. The
/// newest request for a check wins: one that waits is dropped, one that runs is stopped, and its result is not shown.
/// An exception that a check throws becomes a message.
class Verification : public QObject {
  Q_OBJECT

 public:
  /// The destructor waits for the running check to stop.
  explicit Verification(QObject* parent = nullptr);

  /// What is verified from now on; null: nothing. Loops, surface and comparison are computed anew; a hold-out that is
  /// running is cancelled.
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
  void cancel(VerifyCheck check);

 signals:
  void runningChanged(hexoderm::VerifyCheck check, bool running);
  void heldOut(const hexoderm::HoldOutResult& result);
  void loopsFound(const std::vector<hexoderm::FoundLoop>& loops);
  void surfacesFitted(const std::vector<hexoderm::SurfaceEvaluation>& surfaces, const QStringList& remarks);
  void compared(const std::vector<hexoderm::Comparison>& comparisons, const QString& against);
  void failed(hexoderm::VerifyCheck check, const QString& message);

 private:
  using Announcement = std::function<void()>;
  using Work = std::function<Announcement(const std::stop_token&)>;
  void request(VerifyCheck check, Work work);
  void finish(VerifyCheck check, std::uint64_t number, const Announcement& announce);
  void fitSurface();
  void compare();
  void setRunning(VerifyCheck check, bool running);

  std::shared_ptr<const Reconstruction> reconstruction_;
  bool wants_surface_ = false;
  std::optional<SurfaceKind> surface_kind_;
  std::optional<double> true_radius_m_;
  QString reference_path_;
  std::shared_ptr<const Reconstruction> reference_;  ///< of reference_path_, once it was read
  SolverOptions reference_options_;                  ///< that it was solved with, if it is a session

  static constexpr std::size_t kChecks = 4;
  std::array<std::uint64_t, kChecks> newest_{};  ///< request per check; results of older ones are dropped
  std::array<bool, kChecks> running_{};          ///< as runningChanged() last said
  LatestWorker worker_;  // a mailbox per check; last: it has ended before anything that it uses is destroyed
};

}  // namespace hexoderm
