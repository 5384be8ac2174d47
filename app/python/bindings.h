#pragma once

#include "app/python/casters.h"
#include "app/python/given.h"

#include "hexoderm/skin/cell_model.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <pybind11/pybind11.h>

#include <filesystem>
#include <memory>
#include <string>
#include <variant>

namespace hexoderm::python {

/// A result, as Python holds it: of a solve, or read from a file. Nothing that Python is shown of it changes it.
using Calibration = std::shared_ptr<Reconstruction>;
inline Calibration calibrationOf(std::shared_ptr<const Reconstruction> result) {
  return std::const_pointer_cast<Reconstruction>(std::move(result));
}

/// A cell model by itself, or as a built-in name or a file.
using ModelOrName = std::variant<CellModel, std::string, std::filesystem::path>;
/// Of the argument cell_model. Throws TypeError naming it.
CellModel modelFrom(const Argument<ModelOrName>& cell_model);

/// Each adds its part to the module.
using Bind = void(pybind11::module_& module);
Bind bindErrors, bindCellModel, bindSession, bindSimulate, bindJudgement, bindPatch, bindCalibration, bindSolve,
    bindExports, bindCapture;

}  // namespace hexoderm::python
