#pragma once

// `solve` of many sessions at once.

#include "app/cli/command.h"

#include "hexoderm/solve/reconstructor.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hexoderm::cli {

struct SolveBatch {
  std::vector<std::string> inputs;
  std::string folder;  ///< where the calibrations go, made if it is not there; empty: nowhere
  SolverOptions solver;
  std::size_t jobs = 1;  ///< sessions that are solved at the same time, each on a thread of its own; at least 1
};

/// The file of each input's calibration: NAME.calibration.json in the folder for NAME.session.json or NAME.hexo. Where
/// two inputs have one name, all keep the folders below the one that they have in common; what is called alike even
/// then gets a number, NAME-2. No two are the same file.
std::vector<std::filesystem::path> calibrationsOf(const std::vector<std::string>& inputs,
                                                  const std::filesystem::path& folder);

/// Solves every session as `solve` does a single one, and says what came of it in a line (with --json: an object in a
/// line), in the order of the inputs. A session that can't be read, solved or written is named on standard error; the
/// others go on. At most as many sessions are in memory as there are jobs. Ctrl+C lets nothing new begin.
/// Returns the largest exit code of all sessions, or kEndedByForce if it was interrupted. Throws InvalidArgument for a
/// folder that can't be one, and StorageError if it can't be made.
int solveBatch(const SolveBatch& batch, const Common& common);

}  // namespace hexoderm::cli
