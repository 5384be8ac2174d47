#pragma once

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

}  // namespace hexoderm::test
