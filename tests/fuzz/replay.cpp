// Gives every file of a folder to a fuzz target, without libFuzzer; with a number, so many inputs that are made of them
// by mutated(), the same in every run. A crash fails; the last input that was named is the one that crashes. Usage:
// PROGRAM FOLDER [MUTATIONS]

#include "hexoderm/base/file.h"
#include "tests/fuzz/fuzz_checks.h"
#include "tests/fuzz/mutations.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace {

void give(const std::string& bytes) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return EXIT_FAILURE;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) files.push_back(entry.path());
  std::ranges::sort(files);
  const std::size_t mutations = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 0;
  std::size_t count = 0;
  if (mutations == 0) {
    for (const std::filesystem::path& file : files) {
      std::cout << file.string() << std::endl;
      give(hexoderm::readFile(file));
      ++count;
    }
  }
  for (; count < mutations && !files.empty(); ++count) {
    const std::filesystem::path& file = files[count % files.size()];
    std::cout << file.filename().string() << ", mutation " << count << std::endl;
    std::mt19937_64 random(count);
    give(hexoderm::fuzz::mutated(hexoderm::readFile(file), random));
  }
  std::cout << count << " inputs given\n";
  return count > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
