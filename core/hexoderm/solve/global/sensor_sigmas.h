#pragma once

#include "hexoderm/solve/global/sensor_evidence.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <Eigen/Core>
#include <optional>
#include <span>

namespace hexoderm {

/// How much readings tell of a sigma.
enum class SigmaKnowledge {
  Measured,  ///< it is estimated
  AtMost,    ///< no more than that it is below the cell model's, and by how much
  Unknown,   ///< nothing to speak of: the cell model's stands
};

/// A sigma of a population of sensors as readings have it, in the unit of the cell model's.
struct SigmaEstimate {
  SigmaKnowledge knowledge = SigmaKnowledge::Unknown;
  double sigma = 0;    ///< the most likely one; of an unknown one the cell model's
  double low_95 = 0;   ///< within these with 95 % confidence, where it is measured; below the upper one, where it is
  double high_95 = 0;  ///< no more than bounded
  /// As many exactly known errors, one of each axis or axes' pair, would tell as much (its degrees of freedom).
  double worth = 0;

  /// What a cell model should say: the estimate, or the bound, or what it said before.
  [[nodiscard]] double forModel() const { return knowledge == SigmaKnowledge::AtMost ? high_95 : sigma; }
};

/// The sigmas of the sensors' errors.
struct SensorSigmas {
  SigmaEstimate offset_g;         ///< of all of it: what is a sensor's own and what is shared
  SigmaEstimate shared_offset_g;  ///< three numbers of one lot say little about lots: see its range
  SigmaEstimate scale;            ///< of a sensor's own, beside the shared one
  SigmaEstimate shared_scale;     ///< one number of one lot says less still
  SigmaEstimate cross_axis;
  std::optional<LotEstimate> lot;  ///< absent where readings don't tell it

  /// The cell model's accelerometer with these sigmas. Shared ones are written if they are measured; what is only
  /// bounded counts as the sensors' own. Where the shared scale can't be told, the model's stands as a whole.
  [[nodiscard]] Accelerometer inModel(Accelerometer accelerometer) const;
};

/// The most likely variances of the sensors' errors, given what their readings say of them: of all patches in
/// `evidence` together, whose sensors are of one lot.
///
/// Model: offsets b = m + e, with m the lot's, normal about 0 with variance w per axis and e a sensor's own, with
/// variance t; scale errors likewise, with one number of the lot for all axes; cross-axis errors are independent. These
/// five variances maximise the likelihood that is left when all errors are integrated out. That is where expectation
/// maximisation settles, each variance being the mean over its errors of posterior mean squared plus posterior
/// variance; it is found by Fisher scoring, because plain expectation maximisation takes thousands of rounds where
/// readings say little. Ranges follow from the Fisher information, as of a chi-squared with as many degrees of freedom
/// (Satterthwaite); a bound is where the likelihood has fallen by as much as at a normal estimate's 95 % limit.
///
/// `model`: what the cell model says of them; it counts as a thousandth of one error, which keeps a variance that the
/// readings don't show where it is.
SensorSigmas estimateSensorSigmas(std::span<const SensorEvidence> evidence, const Accelerometer& model);

}  // namespace hexoderm
