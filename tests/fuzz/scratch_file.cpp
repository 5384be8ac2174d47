#include "tests/fuzz/scratch_file.h"

#include "tests/fuzz/fuzz_checks.h"

#include <stdlib.h>

#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace hexoderm::fuzz {

ScratchFile::ScratchFile(const char* name) {
  std::error_code error;
  const std::filesystem::path memory = "/dev/shm";
  const bool in_memory = std::filesystem::is_directory(memory, error);
  std::string folder =
      ((in_memory ? memory : std::filesystem::temp_directory_path()) / "hexoderm-fuzz-XXXXXX").string();
  require(::mkdtemp(folder.data()) != nullptr, "a place for a temporary folder");
  folder_ = folder;
  path_ = folder_ / name;
}

ScratchFile::~ScratchFile() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void ScratchFile::write(std::span<const std::uint8_t> bytes) const {
  std::ofstream file(path_, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  require(!file.fail(), "the temporary file to be written");
}

bool ScratchFile::isAlone() const {
  std::filesystem::directory_iterator entries(folder_);
  return std::distance(begin(entries), end(entries)) == 1;
}

}  // namespace hexoderm::fuzz
