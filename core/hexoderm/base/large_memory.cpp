#include "hexoderm/base/large_memory.h"

// The address sanitizer watches over what operator new gives, and not over pages.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
#define HEXODERM_LARGE_PAGES
#include <sys/mman.h>
#endif

#include <cstdint>

namespace hexoderm {
namespace {

constexpr std::align_val_t kAlignment{64};

#ifdef HEXODERM_LARGE_PAGES

constexpr std::size_t kLargePage_bytes = std::size_t{2} << 20;
constexpr std::size_t kPage_bytes = std::size_t{64} << 10;  // a multiple of any system's: the rest lies in small pages
constexpr std::size_t kMin_bytes = 2 * kLargePage_bytes;    // less has hardly a whole one in it

std::size_t inWholePages(std::size_t bytes) { return (bytes + kPage_bytes - 1) / kPage_bytes * kPage_bytes; }

/// From the beginning of a large page on.
void* mapPages(std::size_t bytes) {
  const std::size_t whole = inWholePages(bytes);
  if (whole < bytes || whole + kLargePage_bytes < whole) throw std::bad_alloc();
  const std::size_t mapped = whole + kLargePage_bytes;
  void* const memory = mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  char* const begin = static_cast<char*>(memory);
  const std::size_t before =
      (kLargePage_bytes - reinterpret_cast<std::uintptr_t>(begin) % kLargePage_bytes) % kLargePage_bytes;
  if (before > 0) munmap(begin, before);
  munmap(begin + before + whole, mapped - before - whole);
  // A system that has no large pages to give takes small ones.
  madvise(begin + before, whole, MADV_HUGEPAGE);
  return begin + before;
}

#endif

}  // namespace

void* allocateLarge(std::size_t bytes) {
#ifdef HEXODERM_LARGE_PAGES
  if (bytes >= kMin_bytes) return mapPages(bytes);
#endif
  return ::operator new(bytes, kAlignment);
}

void freeLarge(void* memory, [[maybe_unused]] std::size_t bytes) noexcept {
#ifdef HEXODERM_LARGE_PAGES
  if (bytes >= kMin_bytes) {
    munmap(memory, inWholePages(bytes));
    return;
  }
#endif
  ::operator delete(memory, kAlignment);
}

}  // namespace hexoderm
