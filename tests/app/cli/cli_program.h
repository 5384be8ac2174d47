#pragma once

// The real program hexoderm-cli, run as a user would, in a folder of its own.

#include "hexoderm/util/file.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

namespace hexoderm {

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

class Cli : public ::testing::Test {
 protected:
  /// `before`: what the shell is to run in front of the program, for example "sender | ".
  Outcome run(const std::string& arguments, const std::string& before = "") const {
    const std::string errors = path("stderr.txt");
    const std::string command =
        "cd '" + folder_.path().string() + "' && " + before + "'" + program_ + "' " + arguments + " 2>" + errors;
    Outcome result;
    std::FILE* pipe = ::popen(command.c_str(), "r");
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
      result.out.append(buffer.data(), count);
    }
    result.exit_code = WEXITSTATUS(::pclose(pipe));
    result.err = readFile(errors);
    return result;
  }
  /// What it says on standard error where it has to end with this code, in one line.
  std::string complaint(const std::string& arguments, int exit_code) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << arguments << '\n' << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << arguments << '\n' << outcome.err;
    return outcome.err;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

  test::TemporaryFolder folder_;
  std::string program_ = HEXODERM_CLI;
};

}  // namespace hexoderm
