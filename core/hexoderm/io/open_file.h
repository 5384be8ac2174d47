#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"
#include "hexoderm/session/session.h"

#include <filesystem>
#include <memory>
#include <variant>

namespace hexoderm {

/// The content of a file: a session to solve, or a finished calibration.
using OpenedFile = std::variant<Session, std::shared_ptr<const Reconstruction>>;

/// Opens any file Hexoderm reads, told apart by its content: session store, session JSON, calibration JSON, TUM
/// SkinConfig XML (as a calibration). Changes nothing. Throws StorageError or FormatError.
OpenedFile openFile(const std::filesystem::path& path, const CellModel& model_for_tum);

/// Whether a name is that of a session: *.hexo or *.session.json.
bool isSessionFileName(const std::filesystem::path& path);

/// Writes the session as its name says: a new *.hexo (StorageError if it exists already: what was captured is never
/// replaced), else as session JSON, replacing what is there. Either whole or not at all. Throws StorageError.
void saveSession(const Session& session, const std::filesystem::path& path);

}  // namespace hexoderm
