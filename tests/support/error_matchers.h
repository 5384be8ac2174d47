#pragma once

#include "hexoderm/base/error.h"

#include <gmock/gmock.h>

#include <exception>
#include <string>

namespace hexoderm::test {

/// The message of the `Expected` that `call` throws; a failure, and an empty text, if it throws nothing or another
/// kind.
template <class Expected, class Call>
std::string messageOf(Call&& call) {
  try {
    call();
  } catch (const Expected& error) {
    return error.what();
  } catch (const std::exception& error) {
    ADD_FAILURE() << "another kind of exception: " << error.what();
    return {};
  }
  ADD_FAILURE() << "no exception";
  return {};
}

/// `text` with its first `from` replaced; fails the test if there is none.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << "nothing to replace: " << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// The complaints of a reader that refuses a text wherever it is cut off before `end` begin as said.
template <class Parse>
void expectRefusedWhereverCutOff(const std::string& text, std::size_t end, const std::string& begin, Parse parse,
                                 std::size_t step = 1) {
  for (std::size_t size = 0; size <= end; size += step) {
    EXPECT_THAT(messageOf<FormatError>([&] { parse(text.substr(0, size)); }), ::testing::StartsWith(begin))
        << "cut after " << size << " bytes";
  }
}

/// All of the parts occur in the text.
template <class... Parts>
auto saysAll(const Parts&... parts) {
  return ::testing::AllOf(::testing::HasSubstr(parts)...);
}

}  // namespace hexoderm::test
