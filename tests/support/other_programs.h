#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <optional>
#include <string>

namespace hexoderm::test {

struct ProgramOutcome {
  int exit_code = 0;
  std::string out;  ///< standard output and standard error
};

/// Runs a program that is no part of this project, as a second opinion on a file. nullopt: it is not installed.
inline std::optional<ProgramOutcome> runProgram(const std::string& command) {
  std::FILE* pipe = ::popen(("(" + command + ") 2>&1").c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  ProgramOutcome outcome;
  std::array<char, 4096> buffer{};
  for (std::size_t read = 0; (read = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    outcome.out.append(buffer.data(), read);
  }
  const int status = ::pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  constexpr int kNotFound = 127;
  if (outcome.exit_code == kNotFound) return std::nullopt;
  return outcome;
}

}  // namespace hexoderm::test
