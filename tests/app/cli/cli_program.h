#pragma once

// The real program hexoderm-cli, run as a user would, in a folder of its own.

#include "hexoderm/base/file.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

namespace hexoderm {

using ::testing::ContainsRegex;
using ::testing::Not;

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Of nine numbers, row by row.
inline Eigen::Matrix3d matrixOf(const nlohmann::json& numbers) {
  const auto R = numbers.get<std::vector<double>>();
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(R.data());
}
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
  /// Runs it to this exit code. What it says on standard output, there as JSON, or on standard error.
  std::string outputOf(const std::string& arguments, int exit_code = 0, const std::string& before = "") const {
    return runTo(exit_code, arguments, before).out;
  }
  nlohmann::json jsonOf(const std::string& arguments, int exit_code = 0, const std::string& before = "") const {
    return nlohmann::json::parse(outputOf(arguments, exit_code, before));
  }
  std::string errorOf(const std::string& arguments, int exit_code, const std::string& before = "") const {
    return runTo(exit_code, arguments, before).err;
  }

  /// What it says on standard error where it has to end with this code, in one line.
  std::string complaint(const std::string& arguments, int exit_code) const {
    const std::string said = errorOf(arguments, exit_code);
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << arguments << '\n' << said;
    return said;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

  test::TemporaryFolder folder_;
  std::string program_ = HEXODERM_CLI;

 private:
  Outcome runTo(int exit_code, const std::string& arguments, const std::string& before) const {
    Outcome outcome = run(arguments, before);
    EXPECT_EQ(outcome.exit_code, exit_code) << arguments << '\n' << outcome.err;
    return outcome;
  }
};

/// With a simulated skin: as a session of either kind, and solved.
class CliWithSkin : public Cli {
 protected:
  void SetUp() override {
    ASSERT_EQ(run("simulate --poses 3 --seed 4 -o arm.session.json").exit_code, 0);
    ASSERT_EQ(run("simulate --poses 3 --seed 4 -o arm.hexo").exit_code, 0);
    ASSERT_EQ(run("solve arm.session.json -o arm.calibration.json").exit_code, 0);
  }

  /// Of everything in the folder, that lies in folders too; without what this test's own runs print to.
  [[nodiscard]] std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
      if (entry.path().filename() == "stderr.txt") continue;
      std::error_code ignored;  // of links that lead nowhere
      found[entry.path().string()] = entry.is_regular_file(ignored) ? readFile(entry.path()) : "";
    }
    return found;
  }
};

}  // namespace hexoderm
