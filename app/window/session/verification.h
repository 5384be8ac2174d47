#pragma once

#include "app/window/files/session_paths.h"
#include "app/window/report/report.h"
#include "app/window/toolkit/newest_requests.h"
#include "hexoderm/base/error.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/solve/checks/calibration_check.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/checks/loop_search.h"
#include "hexoderm/solve/hold_out.h"
#include "hexoderm/solve/reconstructor.h"
#include "widgets/verify/verify_panel.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QObject>
#include <QStringList>
#include <algorithm>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

namespace hexoderm {

/// Computes the checks of the step Verify on a thread of its own and keeps them up to date with the reconstruction and
/// the session. The newest request for a check wins, see NewestRequests. An exception that a check throws becomes a
/// message.
class Verification : public QObject {
  Q_OBJECT

 public:
  /// The destructor waits for the running check to stop.
  explicit Verification(QObject* parent = nullptr) : QObject(parent) {}

  /// What is verified from now on; null: nothing. Loops, surface and comparison are computed anew; a hold-out that is
  /// running is cancelled. An old calibration is checked anew by setToday().
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
    reconstruction_ = std::move(reconstruction);
    cancel(VerifyCheck::HoldOut);
    if (!reconstruction_) {
      for (const VerifyCheck check :
           {VerifyCheck::Loops, VerifyCheck::Surface, VerifyCheck::Comparison, VerifyCheck::OldCalibration}) {
        cancel(check);
      }
      return;
    }
    request(VerifyCheck::Loops, [this, seen = reconstruction_](const std::stop_token&) -> Announcement {
      return [this, loops = findLoops(*seen)] {
        outcome_.loops = loops;
        emit loopsFound(loops);
      };
    });
    fitSurface();
    compare();
  }

  /// `session`: as it is now; it is solved with the options of the reconstruction. Nothing happens without one.
  void runHoldOut(std::shared_ptr<const SessionSnapshot> session, PoseId pose) {
    if (!reconstruction_) return;
    request(VerifyCheck::HoldOut,
            [this, session = std::move(session), pose,
             options = reconstruction_->options](const std::stop_token& stop) -> Announcement {
              return [this, result = evaluateHoldOut(*session, pose, options, stop)] {
                outcome_.hold_out = result;
                emit heldOut(result);
              };
            });
  }

  /// No kind: the most probable one of each patch.
  void setSurface(std::optional<SurfaceKind> kind, std::optional<double> true_radius_m) {
    wants_surface_ = true;
    surface_kind_ = kind;
    true_radius_m_ = true_radius_m;
    fitSurface();
  }

  void dropSurface() {
    wants_surface_ = false;
    cancel(VerifyCheck::Surface);
  }

  /// A calibration, or a session that is then solved with the options of the reconstruction. Stays in force until
  /// dropComparison().
  void compareWith(const QString& path) {
    reference_ = {path, nullptr, {}};
    compare();
  }

  void dropComparison() {
    reference_ = {};
    cancel(VerifyCheck::Comparison);
  }

  /// What compareWith() has read, from compared() on; null: nothing.
  [[nodiscard]] const std::shared_ptr<const Reconstruction>& reference() const { return reference_.calibration; }
  [[nodiscard]] QString referenceName() const { return QFileInfo(reference_.path).fileName(); }
  /// The session as it is now, whose poses an old calibration is compared with; null: there is none.
  void setToday(std::shared_ptr<const SessionSnapshot> today) {
    today_ = std::move(today);
    if (!today_) cancel(VerifyCheck::OldCalibration);
    checkToday();
  }

  /// Does this calibration still hold? Compares it, or a session solved as in compareWith(), with the newest `poses`
  /// poses of today that are enabled; no number: with all of them. Stays in force until dropOldCalibration().
  void checkOldCalibration(const QString& path, std::optional<std::size_t> poses) {
    if (path != old_.path) old_ = {path, nullptr, {}};
    newest_poses_ = poses;
    checkToday();
  }

  void dropOldCalibration() {
    old_ = {};
    cancel(VerifyCheck::OldCalibration);
  }

  void cancel(VerifyCheck check) {
    forgetOutcome(check);
    requests_.cancel(check);
  }

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
  /// A session is solved with the options of the result that it is compared with. Null if it was stopped.
  static std::shared_ptr<const Reconstruction> readReference(const QString& path, const SolverOptions& options,
                                                             const std::stop_token& stop) {
    const OpenedFile file = openFile(toPath(path), builtInCellModel("hex-bma150"));
    if (const auto* session = std::get_if<Session>(&file)) {
      return reconstruct(*session->snapshot(), options, nullptr, stop);
    }
    return std::get<std::shared_ptr<const Reconstruction>>(file);
  }

  /// The session with its newest enabled poses, no others being used; no number: as it is. A pose that is taken again
  /// stands where the old one stood, and so the newest are those with the largest IDs.
  static SessionSnapshot withNewestPoses(SessionSnapshot session, std::optional<std::size_t> count) {
    if (!count) return session;
    std::vector<PoseId> enabled;
    for (const SessionPose& pose : session.poses) {
      if (!pose.disabled) enabled.push_back(pose.capture->id);
    }
    if (enabled.size() <= *count) return session;
    std::ranges::sort(enabled);
    const PoseId oldest = enabled[enabled.size() - *count];
    for (SessionPose& pose : session.poses) pose.disabled = pose.disabled || pose.capture->id < oldest;
    return session;
  }

  /// What `work` finds wrong with the file is said with its name.
  template <class Work>
  static auto aboutFile(const QString& path, const Work& work) {
    try {
      return work();
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(located(QFileInfo(path).fileName().toStdString(), error.message()));
    }
  }

  using Announcement = NewestRequests<VerifyCheck>::Announcement;
  /// A file of the operator's, with the calibration in it.
  struct Reference {
    QString path;                                       ///< empty: none is chosen
    std::shared_ptr<const Reconstruction> calibration;  ///< once it was read
    SolverOptions options;                              ///< that it was solved with, if it is a session
  };
  void request(VerifyCheck check, NewestRequests<VerifyCheck>::Work work) {
    forgetOutcome(check);
    requests_.request(check, std::move(work));
  }

  void fitSurface() {
    if (!reconstruction_ || !wants_surface_) return;
    request(VerifyCheck::Surface,
            [this, seen = reconstruction_, kind = surface_kind_,
             radius = true_radius_m_](const std::stop_token& stop) -> Announcement {
              std::vector<SurfaceEvaluation> surfaces;
              QStringList remarks;
              for (const PatchReconstruction& patch : seen->patches) {
                if (stop.stop_requested()) break;
                try {
                  surfaces.push_back(checkSurface(patch, kind, radius));
                } catch (const InvalidArgument& error) {
                  remarks << tr("Patch %1: %2").arg(patch.id.value() + 1).arg(words(error));
                }
              }
              return [this, surfaces = std::move(surfaces), remarks] {
                outcome_.surfaces = surfaces;
                outcome_.surface_remarks = remarks;
                emit surfacesFitted(surfaces, remarks);
              };
            });
  }

  void compare() {
    if (!reconstruction_ || reference_.path.isEmpty()) return;
    if (reference_.options != reconstruction_->options) reference_.calibration.reset();
    request(VerifyCheck::Comparison,
            [this, seen = reconstruction_, path = reference_.path,
             known = reference_.calibration](const std::stop_token& stop) -> Announcement {
              const std::shared_ptr<const Reconstruction> reference =
                  known ? known : readReference(path, seen->options, stop);
              // Nobody waits for it any more, and comparing takes its time too.
              if (stop.stop_requested()) return [] {};
              return [this, path, seen, reference, comparisons = compareToReconstruction(*seen, *reference)] {
                reference_ = {path, reference, seen->options};
                outcome_.comparisons = comparisons;
                outcome_.compared_with = referenceName();
                emit compared(comparisons, referenceName());
              };
            });
  }

  void checkToday() {
    if (!reconstruction_ || !today_ || old_.path.isEmpty()) return;
    if (old_.options != reconstruction_->options) old_.calibration.reset();
    request(VerifyCheck::OldCalibration,
            [this, path = old_.path, known = old_.calibration, options = reconstruction_->options, today = today_,
             poses = newest_poses_](const std::stop_token& stop) -> Announcement {
              const std::shared_ptr<const Reconstruction> calibration =
                  known ? known : readReference(path, options, stop);
              if (stop.stop_requested()) return [] {};
              return [this, path, calibration, options,
                      check = aboutFile(
                          path, [&] { return checkCalibration(*calibration, withNewestPoses(*today, poses)); })] {
                old_ = {path, calibration, options};
                outcome_.old_calibration = check;
                outcome_.old_calibration_name = QFileInfo(path).fileName();
                emit oldCalibrationChecked(check, outcome_.old_calibration_name);
              };
            });
  }

  void forgetOutcome(VerifyCheck check) {
    switch (check) {
      case VerifyCheck::HoldOut:
        outcome_.hold_out.reset();
        break;
      case VerifyCheck::Loops:
        outcome_.loops.reset();
        break;
      case VerifyCheck::Surface:
        outcome_.surfaces.reset();
        outcome_.surface_remarks.clear();
        break;
      case VerifyCheck::Comparison:
        outcome_.comparisons.reset();
        break;
      case VerifyCheck::OldCalibration:
        outcome_.old_calibration.reset();
        break;
    }
  }

  std::shared_ptr<const Reconstruction> reconstruction_;
  bool wants_surface_ = false;
  std::optional<SurfaceKind> surface_kind_;
  std::optional<double> true_radius_m_;
  Reference reference_;  ///< to compare the result with
  Reference old_;        ///< to compare the poses of today with
  std::shared_ptr<const SessionSnapshot> today_;
  std::optional<std::size_t> newest_poses_;
  VerifyOutcome outcome_;

  NewestRequests<VerifyCheck> requests_{
      *this, [this](VerifyCheck check, bool running) { emit runningChanged(check, running); },
      [this](VerifyCheck check, const QString& why) { emit failed(check, why); }};
};

}  // namespace hexoderm
