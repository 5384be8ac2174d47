#pragma once

// Private to reconstruction: testRigidity() of kLanes links at a time.

#include "hexoderm/geometry/lanes.h"

namespace hexoderm {

struct RigidityKernelOptions {
  double precision[12];          ///< of the prior: (b_i, D_i0, D_i1, D_i2) of axis i at 4 i
  double R_a_u[9];               ///< row by row: cell to accelerometer axes
  double least_information = 0;  ///< rad^-2: a turn that no reading shows takes nothing away
};

/// Numbers of kLanes links side by side: value k of lane l is at [kLanes * k + l].
struct RigidityKernelInput {
  int poses = 0;
  const double* c_g = nullptr;          ///< poses x 3, source cell, in its frame
  const double* n_g = nullptr;          ///< poses x 3, target cell
  const double* variance_g2 = nullptr;  ///< poses
  const double* R_c_n = nullptr;        ///< 9, row by row
};
struct RigidityKernelOutput {
  double chi_squared[kLanes];
  double usual[kLanes];  ///< 1, or 0 where the link needs a more careful look
};

/// Two at a time, on any machine.
void testRigidityByTwo(const RigidityKernelOptions& options, const RigidityKernelInput& in, RigidityKernelOutput& out);
/// All at once; only where hasVectorInstructions().
void testRigidityByFour(const RigidityKernelOptions& options, const RigidityKernelInput& in, RigidityKernelOutput& out);

}  // namespace hexoderm
