#include "app/window/session/verification.h"

#include "app/window/files/session_paths.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/util/error.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QMetaObject>
#include <algorithm>
#include <utility>

namespace hexoderm {
namespace {

std::size_t slotOf(VerifyCheck check) { return static_cast<std::size_t>(check); }

/// A session is solved with the options of what it is compared with.
/// Null if it was stopped.
std::shared_ptr<const Reconstruction> readReference(const QString& path, const SolverOptions& options,
                                                    const std::stop_token& stop) {
  const OpenedFile file = openFile(toPath(path), builtInCellModel("hex-bma150"));
  if (const auto* session = std::get_if<Session>(&file)) {
    return reconstruct(*session->snapshot(), options, nullptr, stop);
  }
  return std::get<std::shared_ptr<const Reconstruction>>(file);
}

}  // namespace

Verification::Verification(QObject* parent)
    : QObject(parent), thread_([this](const std::stop_token& stop) { run(stop); }) {}

Verification::~Verification() {
  const std::lock_guard lock(mutex_);
  for (Slot& slot : slots_) slot.stop.request_stop();
}

void Verification::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  reconstruction_ = std::move(reconstruction);
  cancel(VerifyCheck::HoldOut);
  if (!reconstruction_) {
    for (const VerifyCheck check : {VerifyCheck::Loops, VerifyCheck::Surface, VerifyCheck::Comparison}) cancel(check);
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
  surface_kind_ = kind;
  true_radius_m_ = true_radius_m;
  if (kind) {
    fitSurface();
  } else {
    cancel(VerifyCheck::Surface);
  }
}

void Verification::fitSurface() {
  if (!reconstruction_ || !surface_kind_) return;
  request(VerifyCheck::Surface,
          [this, seen = reconstruction_, kind = *surface_kind_,
           radius = true_radius_m_](const std::stop_token& stop) -> Announcement {
            std::vector<SurfaceEvaluation> surfaces;
            QStringList remarks;
            for (const PatchReconstruction& patch : seen->patches) {
              if (stop.stop_requested()) break;
              try {
                surfaces.push_back(evaluateSurface(patch, kind, radius));
              } catch (const InvalidArgument& error) {
                remarks << tr("Patch %1: %2").arg(patch.id.value() + 1).arg(words(error));
              }
            }
            return [this, surfaces = std::move(surfaces), remarks] { emit surfacesFitted(surfaces, remarks); };
          });
}

void Verification::compareWith(const QString& path) {
  reference_path_ = path;
  reference_.reset();
  compare();
}

void Verification::dropComparison() {
  reference_path_.clear();
  reference_.reset();
  cancel(VerifyCheck::Comparison);
}

void Verification::compare() {
  if (!reconstruction_ || reference_path_.isEmpty()) return;
  if (reference_options_ != reconstruction_->options) reference_.reset();
  request(VerifyCheck::Comparison,
          [this, seen = reconstruction_, path = reference_path_,
           known = reference_](const std::stop_token& stop) -> Announcement {
            const std::shared_ptr<const Reconstruction> reference =
                known ? known : readReference(path, seen->options, stop);
            // Nobody waits for it any more, and comparing takes its time too.
            if (stop.stop_requested()) return [] {};
            return [this, path, seen, reference, comparisons = compareToReconstruction(*seen, *reference)] {
              reference_ = reference;
              reference_options_ = seen->options;
              emit compared(comparisons, QFileInfo(path).fileName());
            };
          });
}

void Verification::cancel(VerifyCheck check) {
  {
    const std::lock_guard lock(mutex_);
    Slot& slot = slots_.at(slotOf(check));
    slot.waiting = nullptr;
    slot.stop.request_stop();
    ++slot.newest;
  }
  setRunning(check, false);
}

void Verification::request(VerifyCheck check, Work work) {
  {
    const std::lock_guard lock(mutex_);
    Slot& slot = slots_.at(slotOf(check));
    slot.stop.request_stop();
    slot.stop = std::stop_source();
    slot.waiting = std::move(work);
    ++slot.newest;
  }
  arrived_.notify_one();
  setRunning(check, true);
}

void Verification::run(const std::stop_token& stop) {
  for (;;) {
    VerifyCheck check{};
    Work work;
    std::stop_token cancelled;
    std::uint64_t number = 0;
    {
      std::unique_lock lock(mutex_);
      const auto waiting = [this] {
        return std::ranges::find_if(slots_, [](const Slot& slot) { return static_cast<bool>(slot.waiting); });
      };
      arrived_.wait(lock, stop, [&] { return waiting() != slots_.end(); });
      if (stop.stop_requested()) return;
      const auto slot = waiting();
      check = static_cast<VerifyCheck>(slot - slots_.begin());
      work = std::exchange(slot->waiting, nullptr);
      cancelled = slot->stop.get_token();
      number = slot->newest;
    }
    Announcement announce;
    try {
      announce = work(cancelled);
    } catch (const std::exception& error) {
      announce = [this, check, message = words(error)] { emit failed(check, message); };
    }
    QMetaObject::invokeMethod(
        this, [this, check, number, announce = std::move(announce)] { finish(check, number, announce); },
        Qt::QueuedConnection);
  }
}

void Verification::finish(VerifyCheck check, std::uint64_t number, const Announcement& announce) {
  {
    const std::lock_guard lock(mutex_);
    if (slots_.at(slotOf(check)).newest != number) return;
  }
  setRunning(check, false);
  announce();
}

void Verification::setRunning(VerifyCheck check, bool running) {
  bool& told = slots_.at(slotOf(check)).running;  // touched on this thread alone
  if (std::exchange(told, running) != running) emit runningChanged(check, running);
}

}  // namespace hexoderm
