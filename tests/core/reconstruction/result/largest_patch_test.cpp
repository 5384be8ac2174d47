#include "hexoderm/reconstruction/result/reconstruction.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

Reconstruction patchesOf(const std::vector<std::size_t>& sizes) {
  Reconstruction result;
  for (const std::size_t size : sizes) result.patches.emplace_back().cells.resize(size);
  return result;
}

TEST(LargestPatch, IsTheOneWithTheMostCellsOfEqualOnesTheFirst) {
  const Reconstruction result = patchesOf({1, 3, 2, 3});
  EXPECT_EQ(largestPatch(result), &result.patches[1]);
}

TEST(LargestPatch, IsNullWithoutCells) {
  EXPECT_EQ(largestPatch(Reconstruction()), nullptr);
  EXPECT_EQ(largestPatch(patchesOf({0, 0})), nullptr);
}

}  // namespace
}  // namespace hexoderm
