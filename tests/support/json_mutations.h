#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <string>

namespace hexoderm::test {

/// Calls `check(text, what)` with the document after each single change: every value replaced by each of some that
/// readers must be ready for, and every key or item left out. The first and the last item of an array stand for all.
/// Returns the number of changes.
template <class Check>
std::size_t forEachMutation(const nlohmann::json& document, Check check) {
  static const std::array kValues = {
      nlohmann::json(nullptr),    nlohmann::json(true),       nlohmann::json("text"),  nlohmann::json(""),
      nlohmann::json(0),          nlohmann::json(-1),         nlohmann::json(0.5),     nlohmann::json(1e300),
      nlohmann::json(4294967296), nlohmann::json(4294967295), nlohmann::json::array(), nlohmann::json::object(),
  };
  std::size_t count = 0;
  const auto descend = [&](const auto& self, const nlohmann::json& value, const std::string& pointer) -> void {
    const nlohmann::json::json_pointer at(pointer);
    for (const nlohmann::json& replacement : kValues) {
      nlohmann::json changed = document;
      changed[at] = replacement;
      check(changed.dump(), pointer + " = " + replacement.dump());
      ++count;
    }
    if (!value.is_structured()) return;
    for (const auto& [key, item] : value.items()) {
      if (value.is_array() && key != "0" && key != std::to_string(value.size() - 1)) continue;
      nlohmann::json changed = document;
      if (value.is_object()) {
        changed[at].erase(key);
      } else {
        changed[at].erase(static_cast<std::size_t>(std::stoul(key)));
      }
      check(changed.dump(), pointer + " without " + key);
      ++count;
      self(self, item, pointer + "/" + key);
    }
  };
  descend(descend, document, "");
  return count;
}

}  // namespace hexoderm::test
