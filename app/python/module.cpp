#include "app/python/bindings.h"

#include "hexoderm/base/error.h"
#include "hexoderm/sim/simulated_source.h"

PYBIND11_MODULE(_core, module) {
  using namespace hexoderm::python;
  module.doc() =
      "Finds where every cell of a robot's artificial skin is.\n\n"
      "Lengths are in metres, angles in radians, accelerations in g, unless a name ends otherwise. Frames are\n"
      "right-handed. The frame of a cell has its origin at the centre of the hexagon's front face and z out of the "
      "skin;\n"
      "the frame of a patch is that of its origin cell. A position t and a rotation R map into the frame that is "
      "named:\n"
      "x_patch = R @ x_cell + t. How several patches lie to each other is not known, so each has arrays of its own.";
  module.attr("__version__") = HEXODERM_VERSION;
  hexoderm::addSimulatedSources();
  // Types are added before what names them, so that help() has their Python names.
  for (Bind* bind : {bindErrors, bindCellModel, bindSession, bindSimulate, bindPatch, bindCalibration, bindSolve,
                     bindExports, bindCapture}) {
    bind(module);
  }
}
