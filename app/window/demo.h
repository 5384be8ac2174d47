#pragma once

#include "hexoderm/device/simulated_skin.h"
#include "hexoderm/session/session.h"

#include <QCoreApplication>
#include <QString>
#include <map>

namespace hexoderm {

/// The demo: the paper's 17 cells on a cylinder of 50.1 mm, simulated, and a script of the ways in which to hold it.
/// `nextHold` belongs to the GUI thread; `record` is called on one thread at a time.
class DemoSkin {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::DemoSkin)

 public:
  DemoSkin();

  /// One way to hold the part.
  struct Hold {
    std::size_t index = 0;  ///< in the script
    Eigen::Vector3d up_b = Eigen::Vector3d::UnitZ();
    QString label;
  };

  /// A session without poses that knows the truth.
  [[nodiscard]] Session makeSession() const;

  /// The first hold of the script that no enabled pose of the session shows yet.
  [[nodiscard]] Hold nextHold(const Session& session) const;
  /// Says which hold a pose came from.
  void remember(PoseId pose, const Hold& hold);

  /// Turns the simulated part and takes the pose.
  PoseCapture record(PoseId pose, const Hold& hold);

 private:
  SimulatedSkin skin_;
  std::map<PoseId, std::size_t> hold_of_;
};

}  // namespace hexoderm
