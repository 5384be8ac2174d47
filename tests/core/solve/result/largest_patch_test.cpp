#include "hexoderm/solve/result/reconstruction.h"

#include "tests/support/result_builder.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

Reconstruction patchesOf(const std::vector<std::uint32_t>& sizes) {
  test::ResultBuilder builder;
  for (const std::uint32_t size : sizes) builder.patch(1).cells(1, size);
  return builder.build();
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
