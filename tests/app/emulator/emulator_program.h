#pragma once

// The real hexoderm-emulator, started as a user would and ended with the test.

#include "tests/support/child_process.h"
#include "tests/support/paths.h"

#include <string_view>

namespace hexoderm {

struct Program : test::ChildProcess {
  explicit Program(std::vector<std::string> arguments) : ChildProcess(withName(std::move(arguments))) {}
  ~Program() { kill(SIGTERM); }

 private:
  static std::vector<std::string> withName(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), HEXODERM_EMULATOR);
    return arguments;
  }
};

/// A running emulator and where it is.
struct Emulator : Program {
  explicit Emulator(std::vector<std::string> arguments) : Program(std::move(arguments)) {
    const std::string first = readLine();
    constexpr std::string_view kListening = "listening on ";
    if (!first.starts_with(kListening)) throw std::runtime_error("the emulator said: " + first);
    address = first.substr(kListening.size());
    about = readLine();
  }
  std::string address;
  std::string about;
};

}  // namespace hexoderm
