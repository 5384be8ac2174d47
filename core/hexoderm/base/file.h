#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace hexoderm {

/// The most that is read of a document.
inline constexpr std::uintmax_t kMaxFileBytes = 256'000'000;
/// The most that is read of a session or a calibration: a calibration of 100,000 cells has a third of it.
inline constexpr std::uintmax_t kMaxSkinBytes = 1'000'000'000;

/// The whole file as bytes, opened and read once: a pipe will do. Throws StorageError naming the file if it is missing,
/// a folder or unreadable, FormatError if it has more than `most` bytes or does not end.
std::string readFile(const std::filesystem::path& path, std::uintmax_t most = kMaxFileBytes);

/// Writes a document. What `path` is decides how:
/// - nothing, or a file: a new file is written, read back and compared byte for byte, synced, and then gets the name,
///   and the folder is synced. At any moment either the old or the new content is there, whole; a killed program leaves
///   nothing, or what the next one that writes into the folder removes. The rights, and as far as this user may the
///   owner and the group, of a file that is replaced stay. A session (*.hexo), and what the user may not write, is
///   refused.
/// - a link to a file: that file is replaced, the link stays. One that leads nowhere or in a circle is refused.
/// - a FIFO or a character device (/dev/null, a terminal): it is written into.
/// - anything else (a folder, a disk, a socket) is refused.
/// Throws StorageError naming the file and the reason.
void writeFileAtomically(const std::filesystem::path& path, std::string_view content);

/// Takes the next bytes of a document.
using WriteBytes = std::function<void(std::string_view bytes)>;
/// Gives all bytes of a document to `write`, in pieces: the same ones whenever it is called.
using ProduceBytes = std::function<void(const WriteBytes& write)>;

/// The same for a document that is not in memory as a whole; its bytes are not compared. What `produce` throws leaves
/// everything as it was: for a FIFO or a character device, which could not be taken back, it is called once in vain
/// before anything is written.
void writeFileAtomically(const std::filesystem::path& path, const ProduceBytes& produce);

}  // namespace hexoderm
