#pragma once

#include "tests/fuzz/mutations.h"
#include "tests/support/testing.h"

#include <nlohmann/json.hpp>

namespace hexoderm::test {

/// A value in the place of a document's own, and what is said of it.
struct BadValue {
  const char* pointer;
  nlohmann::json value;
  std::vector<std::string> says;
};

template <class Parse>
void expectComplaints(const nlohmann::json& document, const std::vector<BadValue>& values, Parse parse) {
  for (const BadValue& bad : values) {
    SCOPED_TRACE(std::string(bad.pointer) + " = " + bad.value.dump());
    nlohmann::json json = document;
    json.at(nlohmann::json::json_pointer(bad.pointer)) = bad.value;
    const std::string message = messageOf<FormatError>([&] { parse(json.dump()); });
    for (const std::string& words : bad.says) EXPECT_THAT(message, ::testing::HasSubstr(words));
  }
}

/// Calls `check(text, what)` with the document after each single change: every value replaced by each of some that
/// readers must be ready for, and every key or item left out. The first and the last item of an array stand for all.
template <class Check>
void forEachMutation(const nlohmann::json& document, Check check) {
  static const std::array kValues = {
      nlohmann::json(nullptr),    nlohmann::json(true),       nlohmann::json("text"),  nlohmann::json(""),
      nlohmann::json(0),          nlohmann::json(-1),         nlohmann::json(0.5),     nlohmann::json(1e300),
      nlohmann::json(4294967296), nlohmann::json(4294967295), nlohmann::json::array(), nlohmann::json::object(),
  };
  const auto descend = [&](const auto& self, const nlohmann::json& value, const std::string& pointer) -> void {
    const nlohmann::json::json_pointer at(pointer);
    for (const nlohmann::json& replacement : kValues) {
      nlohmann::json changed = document;
      changed[at] = replacement;
      check(changed.dump(), pointer + " = " + replacement.dump());
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
      self(self, item, pointer + "/" + key);
    }
  };
  descend(descend, document, "");
}

/// Of a text with one change or a few, what is read can be written and read again, or it is refused in the name of the
/// file. `rewritten`: reads a text and writes what it has read.
template <class Rewritten>
void expectReadAgainOrRefused(const std::string& text, const std::string& file, Rewritten rewritten) {
  std::size_t read = 0;
  std::size_t refused = 0;
  const auto check = [&](const std::string& changed, const std::string& what) {
    SCOPED_TRACE(what);
    std::string written;
    try {
      written = rewritten(changed);
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), StartsWith(file + ": "));
      ++refused;
      return;
    }
    ++read;
    EXPECT_NO_THROW(rewritten(written));
  };
  forEachMutation(nlohmann::json::parse(text), check);
  std::mt19937_64 random(1);
  for (int k = 0; k < 3000 && !::testing::Test::HasFailure(); ++k) {
    const std::string changed = fuzz::mutated(text, random);
    check(changed, changed);
  }
  EXPECT_GT(read, 50U);
  EXPECT_GT(refused, 500U);
}

}  // namespace hexoderm::test
