#pragma once

#include "hexoderm/session/session.h"
#include "hexoderm/solve/global/sensor_sigmas.h"

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

namespace hexoderm {

/// The errors of the accelerometers of one lot, as sessions show them.
struct SensorStatistics {
  SensorSigmas sigmas;
  CellModel model;             ///< the sessions' cell model with these sigmas
  std::size_t cells = 0;       ///< of all sessions
  std::size_t cells_used = 0;  ///< with readings in two poses at least, and nothing against them
  std::size_t readings = 0;    ///< of these, mean readings of a pose
  int rounds = 0;
  bool settled = false;  ///< another round would change no sigma by more than a hundredth
  /// Sessions (indices, in ascending order) that have the same cells and links. If they are of the same skin its
  /// sensors count twice, and the ranges are too narrow for that.
  std::vector<std::pair<std::size_t, std::size_t>> same_cells;

  /// Something is known of any sigma.
  [[nodiscard]] bool knowsAnything() const;
};

/// Cells of one session that are looked at: of a larger skin so many that hang together. They show each sigma to a few
/// per cent, and time grows with their cube.
inline constexpr std::size_t kMaxCellsForSensors = 60;

/// Estimates the sigmas of the sensors' errors from sessions with one cell model: solves them, takes from each patch
/// what its readings say about its sensors, all else being as uncertain as it is (evidenceOfPatch()), finds the most
/// likely sigmas (estimateSensorSigmas()), and solves again with these, until they settle: the model's sigmas decide
/// what the solver takes for a broken sensor, and where all is linear.
///
/// Null if `stop` was requested. Throws InvalidArgument without a session, and for sessions whose cell models differ.
std::optional<SensorStatistics> estimateSensorStatistics(
    std::span<const std::shared_ptr<const SessionSnapshot>> sessions, const std::stop_token& stop = {});

}  // namespace hexoderm
