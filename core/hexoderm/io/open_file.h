#pragma once

#include "hexoderm/base/error.h"
#include "hexoderm/session/session.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <filesystem>
#include <memory>
#include <variant>

namespace hexoderm {

/// The content of a file: a session to solve, or a finished calibration.
using OpenedFile = std::variant<Session, std::shared_ptr<const Reconstruction>>;

/// What becomes of a TUM SkinConfig: its placements as a calibration, or its topology as a session.
enum class TumAs { Calibration, Session };

/// Opens any file Hexoderm reads, told apart by its content: session store, session JSON, calibration JSON, TUM
/// SkinConfig XML. Changes nothing. What is no regular file, such as a pipe, is opened and read once, to the limit of
/// readFile(). Throws StorageError or FormatError.
OpenedFile openFile(const std::filesystem::path& path, const CellModel& model_for_tum, TumAs tum = TumAs::Calibration);

/// openFile() for a session: FormatError for a calibration.
Session openSession(const std::filesystem::path& path);
/// openFile() for a calibration: FormatError for a session.
std::shared_ptr<const Reconstruction> openCalibration(const std::filesystem::path& path,
                                                      const CellModel& model_for_tum);
/// What openSession() throws for a calibration.
FormatError noSession(const std::filesystem::path& path);

/// Whether a name is that of a session: *.hexo or *.session.json.
bool isSessionFileName(const std::filesystem::path& path);

/// Writes the session as its name says: a new *.hexo (StorageError if it exists already: what was captured is never
/// replaced), else as session JSON, replacing what is there. Either whole or not at all. Throws StorageError, and
/// InvalidArgument naming file, pose and cell for readings that a file can't hold, such as NaN.
void saveSession(const Session& session, const std::filesystem::path& path);

}  // namespace hexoderm
