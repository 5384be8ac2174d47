#pragma once

#include "app/python/given.h"

#include "hexoderm/graph/cell_model.h"
#include "hexoderm/reconstruction/result/reconstruction.h"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>

namespace hexoderm::python {

/// A result, as Python holds it: of a solve, or read from a file. Immutable.
struct Calibration {
  std::shared_ptr<const Reconstruction> result;  ///< never null
};

/// A patch of a result, which it keeps alive.
struct PatchOf {
  std::shared_ptr<const Reconstruction> result;
  std::size_t index = 0;
  [[nodiscard]] const PatchReconstruction& patch() const { return result->patches.at(index); }
};

/// A cell model by itself, or as a built-in name or a file.
using ModelOrName = std::variant<CellModel, std::string, std::filesystem::path>;
/// Of the argument cell_model. Throws TypeError naming it.
CellModel modelFrom(const Given<ModelOrName>& cell_model);

/// Each adds its part to the module. Types are added before what names them, so that help() has their Python names.
void bindErrors(pybind11::module_& module);
void bindCellModel(pybind11::module_& module);
void bindSession(pybind11::module_& module);
void bindSimulate(pybind11::module_& module);
void bindJudgement(pybind11::module_& module);
void bindPatch(pybind11::module_& module);
void bindCalibration(pybind11::module_& module);
void bindSolve(pybind11::module_& module);
void bindExports(pybind11::module_& module);
void bindCapture(pybind11::module_& module);

}  // namespace hexoderm::python
