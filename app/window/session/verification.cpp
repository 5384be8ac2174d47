#include "app/window/session/verification.h"

#include "app/window/files/session_paths.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/util/error.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QMetaObject>
#include <algorithm>
#include <exception>
#include <utility>

namespace hexoderm {
namespace {

std::size_t slotOf(VerifyCheck check) { return static_cast<std::size_t>(check); }

/// A session is solved with the options of the result that it is compared with. Null if it was stopped.
std::shared_ptr<const Reconstruction> readReference(const QString& path, const SolverOptions& options,
                                                    const std::stop_token& stop) {
  const OpenedFile file = openFile(toPath(path), builtInCellModel("hex-bma150"));
  if (const auto* session = std::get_if<Session>(&file)) {
    return reconstruct(*session->snapshot(), options, nullptr, stop);
  }
  return std::get<std::shared_ptr<const Reconstruction>>(file);
}

/// The session with its newest enabled poses, no others being used; no number: as it is. A pose that is taken again
/// stands where the old one stood, and so the newest are those with the largest IDs.
SessionSnapshot withNewestPoses(SessionSnapshot session, std::optional<std::size_t> count) {
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
auto aboutFile(const QString& path, const Work& work) {
  try {
    return work();
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(located(QFileInfo(path).fileName().toStdString(), error.message()));
  }
}

}  // namespace

Verification::Verification(QObject* parent) : QObject(parent), worker_(kChecks) { keepOutcome(); }

void Verification::keepOutcome() {
  connect(this, &Verification::heldOut, this, [this](const HoldOutResult& result) { outcome_.hold_out = result; });
  connect(this, &Verification::loopsFound, this,
          [this](const std::vector<FoundLoop>& loops) { outcome_.loops = loops; });
  connect(this, &Verification::surfacesFitted, this,
          [this](const std::vector<SurfaceEvaluation>& surfaces, const QStringList& remarks) {
            outcome_.surfaces = surfaces;
            outcome_.surface_remarks = remarks;
          });
  connect(this, &Verification::compared, this,
          [this](const std::vector<Comparison>& comparisons, const QString& against) {
            outcome_.comparisons = comparisons;
            outcome_.compared_with = against;
          });
  connect(this, &Verification::oldCalibrationChecked, this,
          [this](const CalibrationCheck& check, const QString& calibration) {
            outcome_.old_calibration = check;
            outcome_.old_calibration_name = calibration;
          });
}

void Verification::forgetOutcome(VerifyCheck check) {
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

void Verification::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
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
    return [this, loops = findLoops(*seen)] { emit loopsFound(loops); };
  });
  fitSurface();
  compare();
}

void Verification::runHoldOut(std::shared_ptr<const SessionSnapshot> session, PoseId pose) {
  if (!reconstruction_) return;
  request(VerifyCheck::HoldOut,
          [this, session = std::move(session), pose,
           options = reconstruction_->options](const std::stop_token& stop) -> Announcement {
            return [this, result = evaluateHoldOut(*session, pose, options, stop)] { emit heldOut(result); };
          });
}

void Verification::setSurface(std::optional<SurfaceKind> kind, std::optional<double> true_radius_m) {
  wants_surface_ = true;
  surface_kind_ = kind;
  true_radius_m_ = true_radius_m;
  fitSurface();
}

void Verification::dropSurface() {
  wants_surface_ = false;
  cancel(VerifyCheck::Surface);
}

void Verification::fitSurface() {
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
            return [this, surfaces = std::move(surfaces), remarks] { emit surfacesFitted(surfaces, remarks); };
          });
}

void Verification::compareWith(const QString& path) {
  reference_ = {path, nullptr, {}};
  compare();
}

void Verification::dropComparison() {
  reference_ = {};
  cancel(VerifyCheck::Comparison);
}

QString Verification::referenceName() const { return QFileInfo(reference_.path).fileName(); }

void Verification::compare() {
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
              emit compared(comparisons, QFileInfo(path).fileName());
            };
          });
}

void Verification::setToday(std::shared_ptr<const SessionSnapshot> today) {
  today_ = std::move(today);
  if (!today_) cancel(VerifyCheck::OldCalibration);
  checkToday();
}

void Verification::checkOldCalibration(const QString& path, std::optional<std::size_t> poses) {
  if (path != old_.path) old_ = {path, nullptr, {}};
  newest_poses_ = poses;
  checkToday();
}

void Verification::dropOldCalibration() {
  old_ = {};
  cancel(VerifyCheck::OldCalibration);
}

void Verification::checkToday() {
  if (!reconstruction_ || !today_ || old_.path.isEmpty()) return;
  if (old_.options != reconstruction_->options) old_.calibration.reset();
  request(
      VerifyCheck::OldCalibration,
      [this, path = old_.path, known = old_.calibration, options = reconstruction_->options, today = today_,
       poses = newest_poses_](const std::stop_token& stop) -> Announcement {
        const std::shared_ptr<const Reconstruction> calibration = known ? known : readReference(path, options, stop);
        if (stop.stop_requested()) return [] {};
        return
            [this, path, calibration, options,
             check = aboutFile(path, [&] { return checkCalibration(*calibration, withNewestPoses(*today, poses)); })] {
              old_ = {path, calibration, options};
              emit oldCalibrationChecked(check, QFileInfo(path).fileName());
            };
      });
}

void Verification::cancel(VerifyCheck check) {
  const std::size_t slot = slotOf(check);
  worker_.cancel(slot);
  ++newest_.at(slot);
  forgetOutcome(check);
  setRunning(check, false);
}

void Verification::request(VerifyCheck check, Work work) {
  const std::size_t slot = slotOf(check);
  worker_.cancel(slot);
  const std::uint64_t number = ++newest_.at(slot);
  forgetOutcome(check);
  worker_.submit(
      [this, check, number, work = std::move(work)](const std::stop_token& stop) {
        Announcement announce;
        try {
          announce = work(stop);
        } catch (const std::exception& error) {
          announce = [this, check, message = words(error)] { emit failed(check, message); };
        }
        QMetaObject::invokeMethod(
            this, [this, check, number, announce = std::move(announce)] { finish(check, number, announce); },
            Qt::QueuedConnection);
      },
      slot);
  setRunning(check, true);
}

void Verification::finish(VerifyCheck check, std::uint64_t number, const Announcement& announce) {
  if (newest_.at(slotOf(check)) != number) return;
  setRunning(check, false);
  announce();
}

void Verification::setRunning(VerifyCheck check, bool running) {
  bool& told = running_.at(slotOf(check));
  if (std::exchange(told, running) != running) emit runningChanged(check, running);
}

}  // namespace hexoderm
