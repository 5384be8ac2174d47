#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/message.h"
#include "hexoderm/base/units.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace hexoderm {

/// A single cell may turn at this many times the drift limit.
inline constexpr double kRestlessTimesLimit = 2;

/// Conditions under which a part counts as still.
struct StillnessOptions {
  double drift_limit_rad_s = 1 * kDegree;  ///< the patch's direction turns slower than this
  double excess_limit_g = 0.030;           ///< rms per axis beyond a cell's noise floor
  double hold_s = 0.5;                     ///< for so long
  double drift_window_s = 0.75;  ///< the drift is that of the last so many seconds, at least hold_s, at most 1.5;
                                 ///< longer than hold_s, so that tremor of 4 Hz and more is not taken for a turn, and
                                 ///< up to 5 s or kSlots slots where noise asks for it
  double rearm_angle_rad = 5 * kDegree;  ///< after a capture, a move by more than this
  double release_factor = 1.25;          ///< a still part stays still up to this multiple of the limits
  double quiet_fraction = 0.1;           ///< this share of the cells must be below the excess limit, or ...
  std::size_t quiet_cells = 20;          ///< ... so many, if that is less; see StillnessDetector
  double patience_s = 3;                 ///< a cell that misbehaves for so long while the rest is still is set aside
  double silent_after_s = 1;             ///< a cell that was not heard for so long is silent

  /// Throws InvalidArgument naming the option.
  void validate() const;
};

/// How a cell differs from the others while the part is held.
enum class OddCellKind {
  Dead,      ///< reads no gravity; value: norm of the mean, g
  Stuck,     ///< repeated one reading while the part moved
  Noisy,     ///< scatters several times as much as the rest; value: rms per axis, g
  Restless,  ///< turns while the rest is still; value: rad/s
  Silent,    ///< value: seconds since it was heard
};

/// A cell that does not behave as the rest of the patch. It is sampled like the others, but capture does not wait for
/// it.
struct OddCell {
  CellId cell;
  OddCellKind kind{};
  double value = 0;
};

/// "Cell 7 is noisy: it scatters by 220 mg rms while the rest is still".
Message describe(const OddCell& odd);

/// The obstacle that keeps a capture from starting.
enum class Blocker {
  None,
  Waiting,      ///< too few samples to judge, for their number or for how they scatter
  NotMoved,     ///< since the last capture
  Turning,      ///< the whole patch does
  Shaking,      ///< the cells scatter
  CellTurning,  ///< one cell turns against the rest
};
/// "none", "waiting", "not_moved", "turning", "shaking", "cell_turning": for files and machines.
std::string_view blockerName(Blocker blocker);
std::string_view oddCellName(OddCellKind kind);  ///< the kind in words without spaces, for files

/// The detector's judgement, with the numbers behind it.
struct Stillness {
  bool still = false;
  bool armed = true;  ///< true if the part has moved enough since the last capture, or there was none
  Blocker blocker = Blocker::Waiting;
  Message message = hexoderm::message("Waiting for samples");  ///< the obstacle, for people; empty if there is none

  double time_s = 0;       ///< device time of this judgement
  double still_for_s = 0;  ///< 0 if not still
  double steady_for_s =
      0;  ///< time for which the cells have stayed near their present readings; grows before `still` is true
  double window_s = 0;  ///< length of the samples that a judgement needs now

  double drift_rad_s = 0;  ///< 0 where noise leaves no telling
  double drift_limit_rad_s = 0;
  double excess_g = 0;
  double excess_limit_g = 0;
  CellId excess_cell;        ///< the cell that decides about the excess
  CellId turning_cell;       ///< set if blocker is CellTurning
  double turning_rad_s = 0;  ///< rate of that cell
  double moved_rad = 0;      ///< since the last capture
  double rearm_rad = 0;

  double rate_hz = 0;                ///< samples per second and cell, each counted once; median over the cells
  std::size_t cells = 0;             ///< cells heard recently
  std::size_t cells_used = 0;        ///< cells that counted in this judgement
  std::vector<OddCell> odd_cells{};  ///< in order of their IDs

  /// Whether an automatic capture may start.
  [[nodiscard]] bool ready() const { return still && armed; }
};

}  // namespace hexoderm
