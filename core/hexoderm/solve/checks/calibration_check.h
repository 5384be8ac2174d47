#pragma once

#include "hexoderm/session/session.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace hexoderm {

/// What became of a cell since it was calibrated.
enum class CellChange {
  None,             ///< it is as calibrated, as far as the poses show
  Turned,           ///< it sits otherwise; an offset that drifted does not explain what it reads
  Drifted,          ///< the offset of its sensor is another one; a turn does not explain what it reads
  TurnedOrDrifted,  ///< either does: these poses can't tell
  Broken,           ///< what it reads is no gravity, or nothing comes
  NotTold,          ///< there is too little to compare
};
std::string_view cellChangeName(CellChange change);  ///< "none", "turned", "drifted", "turned_or_drifted", ...

/// What became of a cell since it was calibrated.
struct CheckedCell {
  CellId cell;
  CellChange change = CellChange::NotTold;
  Message words;          ///< the same in a few words, for a table: "turned by 9.8° +- 0.4°"
  std::size_t poses = 0;  ///< in which it was compared
  double deviate = 0;     ///< by how much it misses, as a standard normal deviate
  /// The turn that explains it best, and 1 sigma of its angle: of Turned and TurnedOrDrifted.
  struct Turn {
    double angle_rad = 0;
    double sigma_rad = 0;
    bool at_least = false;  ///< the poses don't show a turn about one axis, and it may have turned about that too
  };
  std::optional<Turn> turn;
  /// The drift of the offset that explains it best: of Drifted and TurnedOrDrifted.
  struct Drift {
    Eigen::Vector3d offset_g = Eigen::Vector3d::Zero();  ///< of today less the calibrated one, accelerometer axes
    double sigma_g = 0;                                  ///< 1 sigma of its length
  };
  std::optional<Drift> drift;
  /// A cell that turned by so much, about whatever axis, would be found with 95 %. Absent where some turn would not be
  /// found however large it is: one about gravity, if there is one pose.
  std::optional<double> noticed_turn_rad;
  /// What the poses say about a small turn of the cell: information, patch frame, rad^-2.
  Eigen::Matrix3d turn_information = Eigen::Matrix3d::Zero();
};

/// An old calibration, compared with new poses.
struct CalibrationCheck {
  std::vector<PoseId> poses;       ///< that were compared
  std::vector<CheckedCell> cells;  ///< all of the calibration, in ascending order
  std::vector<Message> remarks;    ///< on the poses and the links, one sentence each
  Message summary;                 ///< one sentence or a few
  Message advice;                  ///< what to do about it, in one sentence or a few
  bool changed = false;            ///< something is not as calibrated; which cell may not be known
  bool compared = false;           ///< something could be told of a cell
  /// By so many standard deviations, as a normal deviate, a cell misses before it is called changed: one check in 200
  /// of an unchanged skin names a cell, however many there are.
  double changed_from = 0;

  [[nodiscard]] std::size_t count(CellChange change) const;  ///< the number of cells with this change
};

/// Does a calibration still hold? Compares it with a few new poses (one to three do; more are taken, too) of the same
/// skin. Nothing is solved anew.
///
/// By the calibration, the reading y of a cell shows the specific force s = R_o_a gain^-1 (y - offset) in the patch
/// frame. All cells of a patch must see one motion of a rigid part, s = f + w x t: f is free in every pose, w little
/// (as in HoldOutResult). Each cell is compared with what the others foretell that agree (Consensus), in all poses at
/// once: the errors of attitude, offset and gains are those that the calibration's own poses leave (as in
/// HoldOutResult, see errorsOfCell()), alike in all poses, and the sensor's noise comes on top; where the cells that
/// agree show that noise to be larger than its samples say, it is. Offsets drift between sessions and are unstable
/// within one, by the cell model's sigmas: a sensor's own drift, alike in all poses, counts among its cell's errors,
/// and what all offsets of a patch drifted by together is found, as a vector in each pose, with the motion; a remark
/// says how large it is. A part that was moved as a whole, or sits otherwise on the robot, is no change.
///
/// A cell that misses by more than changed_from is explained by a turn (three angles) or by a drift of its sensor's
/// offset (three numbers), whichever leaves less; the other is ruled out where it is 20 times less likely. What neither
/// explains is broken, as is a sensor that is dead, stuck, saturated, noisy, silent or another's echo. Offsets are
/// those that the calibration holds; one of the tree solver holds none, and then they are expected with the cell
/// model's sigma, which hides all but large changes.
///
/// One pose shows no turn about gravity, and two poses a drift along gravity x gravity only as a turn. A drift that all
/// sensors share looks like another direction of gravity where they are parallel, and does no harm. Of a patch in which
/// half of the cells or more disagree with the rest, nothing is told by cell.
///
/// Uses the enabled poses of `today`, its topology and its cell model's geometry; the sensors' sigmas are the
/// calibration's. Throws InvalidArgument, naming what differs, if the skins are not the same (some cells or links may
/// be missing), if there is no enabled pose, or if the calibration is an imported one, which was not made of poses.
CalibrationCheck checkCalibration(const Reconstruction& calibration, const SessionSnapshot& today);

}  // namespace hexoderm
