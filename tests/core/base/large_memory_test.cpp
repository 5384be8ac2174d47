#include "hexoderm/base/large_memory.h"

#include "tests/support/testing.h"

#include <unistd.h>

#include <fstream>
#include <new>
#include <numeric>

namespace hexoderm {
namespace {

constexpr std::size_t kMB = std::size_t{1} << 20;

TEST(LargeMemory, EveryByteOfAnySizeCanBeUsed) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, 4 * kMB - 1, 4 * kMB, 4 * kMB + 1, 7 * kMB}) {
    LargeVector<unsigned char> bytes(size);
    std::iota(bytes.begin(), bytes.end(), static_cast<unsigned char>(3));
    for (std::size_t k = 0; k < size; ++k) ASSERT_EQ(bytes[k], static_cast<unsigned char>(k + 3)) << size;
  }
}

TEST(LargeMemory, BeginsWhereVectorsOfNumbersMayBegin) {
  for (const std::size_t size : {std::size_t{8}, kMB, 5 * kMB}) {
    const LargeVector<double> numbers(size / sizeof(double));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(numbers.data()) % 64, 0U);
  }
}

TEST(LargeMemory, ElementsAreSetWhereAValueIsGiven) {
  LargeVector<double> numbers(kMB, 2.5);
  EXPECT_EQ(std::accumulate(numbers.begin(), numbers.end(), 0.0), 2.5 * kMB);
  numbers.assign(3, 1.5);
  EXPECT_EQ(numbers, LargeVector<double>({1.5, 1.5, 1.5}));
}

TEST(LargeMemory, KeepsElementsWhereItGrows) {
  LargeVector<std::size_t> numbers;
  for (std::size_t k = 0; k < kMB; ++k) numbers.push_back(k);  // from little memory to large
  for (std::size_t k = 0; k < kMB; ++k) ASSERT_EQ(numbers[k], k);
  const LargeVector<std::size_t> copy = numbers;
  LargeVector<std::size_t> taken = std::move(numbers);
  EXPECT_EQ(taken, copy);
}

TEST(LargeMemory, MoreThanThereIsCanNotBeHad) {
  constexpr std::size_t kMax = std::numeric_limits<std::size_t>::max();
  EXPECT_THROW(static_cast<void>(LargeAllocator<double>().allocate(kMax / 4)), std::bad_alloc);
#ifndef __SANITIZE_ADDRESS__  // which ends the process
  EXPECT_THROW(static_cast<void>(allocateLarge(kMax - 5)), std::bad_alloc);
  EXPECT_THROW(static_cast<void>(allocateLarge(kMax / 2)), std::bad_alloc);
#endif
}

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
double mapped_MB() {
  std::ifstream file("/proc/self/statm");
  double pages = 0;
  file >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / kMB;
}

TEST(LargeMemory, GoesBackToTheSystemAtOnce) {
  const double before = mapped_MB();
  {
    const LargeVector<double> numbers(64 * kMB / sizeof(double));
    EXPECT_GT(mapped_MB(), before + 60);
  }
  EXPECT_LT(mapped_MB(), before + 4);
}
#endif

}  // namespace
}  // namespace hexoderm
