#pragma once

#include "hexoderm/device/simulated_skin.h"
#include "hexoderm/reconstruction/reconstruction.h"

#include <QCoreApplication>
#include <QString>

namespace hexoderm {

/// The demo: the paper's 17 cells on a cylinder of 50.1 mm, simulated, held the way the window advises.
class DemoSkin {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::DemoSkin)

 public:
  DemoSkin();

  /// A session without poses that knows the truth.
  [[nodiscard]] Session makeSession() const;

  /// What the next pose of this session will be called.
  [[nodiscard]] static QString nextLabel(const Session& session);

  /// Turns the simulated part as `seen` advises (standing, where nothing was seen yet) and takes the pose. On one
  /// thread at a time.
  PoseCapture takePose(PoseId id, const QString& label, const Reconstruction& seen);

 private:
  SimulatedSkin skin_;
};

}  // namespace hexoderm
