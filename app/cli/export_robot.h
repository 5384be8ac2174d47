#pragma once

#include "app/cli/command.h"

#include "hexoderm/io/exporter.h"

#include <string>
#include <vector>

namespace hexoderm::cli {

/// Whether the links that patches are fixed to are those of the robot that `--robot` names; nothing without it. Throws
/// InvalidArgument, and BadInput where the robot can't be read.
void requireLinksOfTheRobot(const std::vector<ExportFormat>& formats, const ExportOptions& options);

/// What is said where no place is known and a file for a robot joins the skin to a link all the same; empty elsewhere.
std::string joinedWithoutAPlace(const std::vector<ExportFormat>& formats, const ExportOptions& options);

/// Of an error about a file, whether it is the robot's.
bool isOfTheRobot(const Error& error, const ExportOptions& options);

/// Runs `write`, and turns what it throws about the robot's file into BadInput: what is wrong is not what is written.
template <class Write>
auto withRobotAsInput(const ExportOptions& options, Write&& write) {
  try {
    return write();
  } catch (const StorageError& error) {
    if (!isOfTheRobot(error, options)) throw;
    throw BadInput("--robot " + std::string(error.what()));
  } catch (const FormatError& error) {
    if (!isOfTheRobot(error, options)) throw;
    throw BadInput("--robot " + std::string(error.what()));
  }
}

}  // namespace hexoderm::cli
