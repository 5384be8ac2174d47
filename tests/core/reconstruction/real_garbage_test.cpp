// What is wrong with sessions of a real robot's leg is named, and what is real in them is not (README of the reference
// data).

#include "hexoderm/io/session_json.h"
#include "hexoderm/reconstruction/evaluation/evaluation.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/util/units.h"
#include "tests/support/matchers.h"
#include "tests/support/paths.h"
#include "tests/support/solvers.h"

#include <algorithm>

namespace hexoderm {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;

class RealGarbage : public ::testing::TestWithParam<Solver> {
 protected:
  [[nodiscard]] static std::shared_ptr<const Reconstruction> solve(const std::string& name) {
    const std::string path = std::string(HEXODERM_REFERENCE_DATA) + "/real/icub_leg/" + name + ".session.json";
    return reconstruct(*readSessionJson(path).snapshot(), test::by(GetParam()));
  }
  /// Of links and cells; poses are told apart as they are.
  [[nodiscard]] static std::vector<Finding> accusations(const Reconstruction& result) {
    std::vector<Finding> found;
    std::ranges::copy_if(result.findings, std::back_inserter(found), [](const Finding& finding) {
      return finding.severity != Severity::Info && !finding.cells.empty();
    });
    return found;
  }
};

INSTANTIATE_TEST_SUITE_P(Solvers, RealGarbage, ::testing::Values(Solver::Global, Solver::Tree), test::solverOfTest);

TEST_P(RealGarbage, ABoardTurnedBy180DegreesIsNamed) {
  const auto result = solve("turned_180_not_seen");
  const std::vector<Finding> found = accusations(*result);
  ASSERT_FALSE(found.empty());
  for (const Finding& finding : found) EXPECT_THAT(finding.cells, Contains(CellId(38)));
}

TEST_P(RealGarbage, ALinkAroundTheThighIsNoSkinLink) {
  const auto result = solve("link_around_the_thigh");
  const std::vector<Finding> found = accusations(*result);
  ASSERT_FALSE(found.empty());
  for (const Finding& finding : found) {
    EXPECT_THAT(finding.cells, ::testing::UnorderedElementsAre(CellId(41), CellId(44)));
  }
}

/// Real links twist by up to 50 degrees, far more than the simulator's.
TEST_P(RealGarbage, SoundBoardsAreNotAccused) {
  for (const std::string name : {"three_holds", "three_holds_cut_into_five", "one_long_and_twelve_short_windows"}) {
    EXPECT_THAT(accusations(*solve(name)), IsEmpty()) << name;
  }
}

/// Orientations of the tree, on the average over the cells and against the joint estimate from the same readings, by
/// default and as in the paper: support axes pull links towards straight that two directions of gravity show well.
TEST(RealTree, IsNotWorseByDefaultThanThePapersMethod) {
  for (const std::string name : {"three_holds", "three_holds_cut_into_five", "link_around_the_thigh"}) {
    const Session session =
        readSessionJson(std::string(HEXODERM_REFERENCE_DATA) + "/real/icub_leg/" + name + ".session.json");
    const auto joint = reconstruct(*session.snapshot());
    const SolverOptions tree = test::by(Solver::Tree);
    SolverOptions paper = tree;
    paper.centring = Centring::Off;
    paper.support_axes = SupportAxes::Off;
    const auto offOf = [&](const SolverOptions& options) {
      const auto result = reconstruct(*session.snapshot(), options);
      double sum = 0;
      for (const CellPlacement& cell : largestPatch(*joint)->cells) {
        const CellId origin = largestPatch(*joint)->origin;
        const Eigen::Matrix3d R =
            result->find(origin).cell->T_o_u.R.transpose() * result->find(cell.cell).cell->T_o_u.R;
        const double off = rotationAngle(R.transpose() * joint->find(origin).cell->T_o_u.R.transpose() * cell.T_o_u.R);
        sum += off * off;
      }
      return std::sqrt(sum / static_cast<double>(largestPatch(*joint)->cells.size()));
    };
    EXPECT_LE(offOf(tree), offOf(paper) + 1e-9) << name;
  }
}

}  // namespace
}  // namespace hexoderm
