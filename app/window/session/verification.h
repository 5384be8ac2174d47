#pragma once

#include "hexoderm/reconstruction/evaluation/evaluation.h"
#include "hexoderm/reconstruction/evaluation/loop_search.h"
#include "hexoderm/reconstruction/hold_out.h"
#include "widgets/verify/verify_panel.h"

#include <QObject>
#include <QStringList>
#include <array>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace hexoderm {

/// Computes the checks of the step Verify on a thread of its own and keeps them up to date with the reconstruction.
/// Each check has a mailbox for one request, and the newest wins; what is running for an older one is asked to stop,
/// and its result dropped. What a check throws becomes a message.
class Verification : public QObject {
  Q_OBJECT

 public:
  explicit Verification(QObject* parent = nullptr);
  /// Waits for what is running to stop; a solve runs to its end.
  ~Verification() override;

  /// What is verified from now on; null: nothing. Loops, surface and comparison are computed anew; a hold-out that is
  /// running is cancelled.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  /// `session`: as it is now; it is solved with the options of the reconstruction. Nothing happens without one.
  void runHoldOut(std::shared_ptr<const SessionSnapshot> session, PoseId pose);
  /// No kind: none from now on.
  void setSurface(std::optional<SurfaceKind> kind, std::optional<double> true_radius_m);
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
  struct Slot {
    Work waiting;
    std::stop_source stop;
    std::uint64_t newest = 0;  ///< results of older requests are dropped
    bool running = false;      ///< as it was told
  };

  void request(VerifyCheck check, Work work);
  void run(const std::stop_token& stop);
  void finish(VerifyCheck check, std::uint64_t number, const Announcement& announce);
  void fitSurface();
  void compare();
  void setRunning(VerifyCheck check, bool running);

  std::shared_ptr<const Reconstruction> reconstruction_;
  std::optional<SurfaceKind> surface_kind_;
  std::optional<double> true_radius_m_;
  QString reference_path_;
  std::shared_ptr<const Reconstruction> reference_;  ///< of reference_path_, once it was read
  SolverOptions reference_options_;                  ///< that it was solved with, if it is a session

  std::mutex mutex_;  ///< guards the slots
  std::condition_variable_any arrived_;
  std::array<Slot, 4> slots_;
  std::jthread thread_;  // last: joined before what it uses goes
};

}  // namespace hexoderm
