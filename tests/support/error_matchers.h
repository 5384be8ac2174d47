#pragma once

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

/// All of the parts occur in the text.
template <class... Parts>
auto saysAll(const Parts&... parts) {
  return ::testing::AllOf(::testing::HasSubstr(parts)...);
}

}  // namespace hexoderm::test
