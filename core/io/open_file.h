#pragma once

#include "hexoderm/reconstruction/reconstruction.h"
#include "hexoderm/session/session.h"

#include <filesystem>
#include <memory>
#include <variant>

namespace hexoderm {

/// What a file turned out to hold: a session to solve, or a finished calibration.
using OpenedFile = std::variant<Session, std::shared_ptr<const Reconstruction>>;

/// Opens any file Hexoderm reads, told apart by its content: session JSON, calibration JSON, TUM SkinConfig XML (as a
/// calibration). Throws StorageError or FormatError.
OpenedFile openFile(const std::filesystem::path& path, const CellModel& model_for_tum);

}  // namespace hexoderm
