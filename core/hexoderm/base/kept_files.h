#pragma once

// Which file a path or a descriptor is, files that SQLite may have open in this process, and files that nothing is
// written in the place of.

#include <sys/types.h>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace hexoderm {

/// What a file is, whatever it is called.
using FileIdentity = std::pair<dev_t, ino_t>;
/// Of a regular file, links followed; nullopt if there is none.
std::optional<FileIdentity> identityOf(const std::filesystem::path& path);
/// Of what is open, a pipe or a folder too.
std::optional<FileIdentity> identityOf(int descriptor);
/// Whether `path`, links followed, names what is open.
[[nodiscard]] bool isAt(const std::filesystem::path& path, int descriptor);
/// Where the open file is now; nullopt if that is not known, as a rule because it was removed.
[[nodiscard]] std::optional<std::filesystem::path> placeOf(int descriptor);

inline constexpr std::string_view kSqliteHeader("SQLite format 3\0", 16);
/// "HEXO", at byte 68 of every session store.
inline constexpr std::int64_t kStoreApplicationId = 0x4845584F;
/// What SQLite keeps beside a file.
inline constexpr std::array<const char*, 3> kBesideDatabases = {"-wal", "-shm", "-journal"};

/// Whether this process has it open for writing. SQLite's locks belong to the process and fall when *any* descriptor of
/// the file is closed there, so descriptors of such a file are closed only after it.
bool isOpenDatabase(const std::filesystem::path& path);
/// That it is open for writing, by this descriptor among others.
void addOpenDatabase(int descriptor);
/// Closes a descriptor, or lets it wait for the writer's.
void closeWhenHarmless(int descriptor, bool is_writer);

/// The first bytes of a file that is not open for writing here; fewer where it ends. Throws StorageError if it can't be
/// read.
std::string firstBytes(const std::filesystem::path& path, std::size_t count);

/// Throws if what lies at `path`, links followed, must not be replaced; `name` is what the error calls it.
/// StorageError: a session (*.hexo), told by its content, what SQLite keeps beside one, under whatever name, and a name
/// beside which such a file lies. InvalidArgument: a file that is kept.
void requireReplaceable(const std::filesystem::path& path, const std::string& name);
/// StorageError if a file that SQLite would take for its own lies beside a session that is to be made.
void requireNothingBeside(const std::filesystem::path& path);
/// It is kept, under whatever name.
[[nodiscard]] bool isKept(const std::filesystem::path& path);

/// Keeps a file, if there is one, as long as it lives: under whatever name, nothing replaces it.
class KeptFile {
 public:
  explicit KeptFile(const std::filesystem::path& path);
  ~KeptFile();
  KeptFile(const KeptFile&) = delete;
  KeptFile& operator=(const KeptFile&) = delete;

 private:
  std::optional<FileIdentity> identity_;
};

/// From now on every file that this process reads is kept to its end. For programs that run one command.
void keepWhatIsRead();
[[nodiscard]] bool keepsWhatIsRead();
/// That a file is an input. Whatever reads one says so.
void noteRead(const std::filesystem::path& path);

}  // namespace hexoderm
