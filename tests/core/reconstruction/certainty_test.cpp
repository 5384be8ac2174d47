#include "hexoderm/reconstruction/certainty.h"
#include "hexoderm/util/units.h"
#include "support/matchers.h"

namespace hexoderm {
namespace {

TEST(Certainty95, IsAlongTheWorstDirectionAndHalfATurnAtMost) {
  CellPlacement cell;
  cell.cov_t_r = Matrix6d::Zero();
  cell.cov_t_r->diagonal() << 1e-6, 4e-6, 1e-6, 1e-4, 1e-4, 9e-4;
  const auto known = certainty95(cell);
  ASSERT_TRUE(known);
  EXPECT_NEAR(known->position_m, 1.96 * 0.002, 1e-6);
  EXPECT_NEAR(known->orientation_rad, 1.96 * 0.03, 1e-6);
  cell.cov_t_r->diagonal().tail<3>().setConstant(100);
  EXPECT_DOUBLE_EQ(certainty95(cell)->orientation_rad, kPi);
}

TEST(Certainty95, IsAbsentWhereNoneIsStated) { EXPECT_FALSE(certainty95(CellPlacement())); }

}  // namespace
}  // namespace hexoderm
