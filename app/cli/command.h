#pragma once

#include "hexoderm/io/open_file.h"
#include "hexoderm/reconstruction/result/reconstruction.h"
#include "hexoderm/session/session.h"
#include "hexoderm/util/error.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

namespace hexoderm::cli {

/// Exit codes of the program.
enum ExitCode : int {
  kDone = 0,
  kNotGoodEnough = 1,  ///< the verdict is not_enough or failed; the output is still written
  kUsage = 2,
  kBadInput = 3,
  kDevice = 4,
  kStorage = 5,
};

/// An input file could not be used: exit code 3, whatever the reason.
class BadInput : public Error {
  using Error::Error;
};

/// Options that every command has, and how it says things.
struct Common {
  bool json = false;
  bool quiet = false;
  int exit_code = kDone;  ///< set by the command that ran

  void addTo(CLI::App& command);
  /// A line on stderr that replaces the one before, if stderr is a terminal and --quiet is not given.
  void progress(const std::string& text) const;
  void endProgress() const;
  /// A remark on stderr, unless --quiet.
  void note(const std::string& text) const;
  /// A remark where stderr is no terminal, which would show progress().
  void logNote(const std::string& text) const;
};

void addSimulate(CLI::App& app, Common& common);
void addCapture(CLI::App& app, Common& common);
void addSolve(CLI::App& app, Common& common);
void addEvaluate(CLI::App& app, Common& common);
void addExport(CLI::App& app, Common& common);
void addConvert(CLI::App& app, Common& common);
void addInspect(CLI::App& app, Common& common);
void addReproduce(CLI::App& app, Common& common);

/// Runs `read` and turns what it throws about the file into BadInput.
template <class Read>
auto asInput(Read&& read) {
  try {
    return read();
  } catch (const StorageError& error) {
    throw BadInput(error.what());
  } catch (const FormatError& error) {
    throw BadInput(error.what());
  }
}

/// Opens an input; TUM files are read with the given cell model (a built-in name or a file).
OpenedFile openInput(const std::string& path, const std::string& cell_model = "hex-bma150");
Session openSession(const std::string& path);
std::shared_ptr<const Reconstruction> openCalibration(const std::string& path,
                                                      const std::string& cell_model = "hex-bma150");

int exitCodeOf(const Verdict& verdict);

/// Findings and verdict as text and as JSON, the same in every command.
void printFindings(const std::vector<Finding>& findings);
void printVerdict(const Verdict& verdict);
nlohmann::ordered_json toJson(const Finding& finding);
nlohmann::ordered_json toJson(const Verdict& verdict);
nlohmann::ordered_json toJson(const std::vector<Finding>& findings);
void printJson(const nlohmann::ordered_json& json);

std::string millimetres(double length_m, int decimals = 2);
std::string degrees(double angle_rad, int decimals = 2);

}  // namespace hexoderm::cli
