#pragma once

#include <span>
#include <string_view>

namespace hexoderm {

struct BuiltInModel {
  std::string_view name;
  std::string_view json;
};

/// The files of resources/cell_models as they were when the library was built.
std::span<const BuiltInModel> builtInModels();

}  // namespace hexoderm
