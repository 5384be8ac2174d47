#pragma once

// findAttitude() (rigidity.h) of kLanes cells at a time.

#include "hexoderm/base/lanes.h"

namespace hexoderm {

inline constexpr int kMaxAttitudeSteps = 15;

struct AttitudeKernelOptions {
  double precision[12];        ///< of the prior: (b_i, D_i0, D_i1, D_i2) of axis i at 4 i
  double min_information = 0;  ///< rad^-2: a turn that no reading shows takes nothing away
};

/// Numbers of kLanes cells side by side: value k of lane l is at [kLanes * k + l].
struct OwnAttitudeKernelInput {
  int readings = 0;
  const double* f_o = nullptr;         ///< readings x 3, specific forces in the patch's frame
  const double* y_g = nullptr;         ///< readings x 3, accelerometer axes
  const double* precision = nullptr;   ///< readings, 1/g^2; 0 for one that a cell doesn't have
  const double* R_start = nullptr;     ///< 9, row by row, accelerometer to patch
  int most_steps = kMaxAttitudeSteps;  ///< of Gauss-Newton
};
struct OwnAttitudeKernelOutput {
  double R[9 * kLanes];            ///< row by row, accelerometer to patch
  double information[6 * kLanes];  ///< upper half, row by row, rad^-2
  double offset_g[3 * kLanes];
  double gain[9 * kLanes];  ///< row by row
  double usual[kLanes];     ///< 1, or 0 where the cell needs a more careful look
};

/// Two at a time, on any machine.
void findAttitudesByTwo(const AttitudeKernelOptions& options, const OwnAttitudeKernelInput& in,
                        OwnAttitudeKernelOutput& out);
/// All at once; only where hasVectorInstructions().
void findAttitudesByFour(const AttitudeKernelOptions& options, const OwnAttitudeKernelInput& in,
                         OwnAttitudeKernelOutput& out);

}  // namespace hexoderm
