// Memory of large sessions, and that there is a result at all: skins that have fallen apart into thousands of patches,
// and thousands of poses.

#include "hexoderm/base/parallel.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/matchers.h"
#include "tests/support/neighbor_lists.h"
#include "tests/support/peak_memory.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/slow_build.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

/// A session of cells that report no neighbours, each of which reads every pose exactly. From no simulator.
Session unlinkedCells(std::uint32_t count, std::size_t poses) {
  Session session(test::modelOfMany(), test::listOfCells(count));
  for (std::size_t pose = 0; pose < poses; ++pose) {
    auto capture = std::make_shared<PoseCapture>();
    capture->id = session.nextPoseId();
    const Eigen::Vector3d up_u = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(pose % 3));
    for (std::uint32_t id = 1; id <= count; ++id) {
      capture->samples.push_back({CellId(id), up_u, Eigen::Matrix3d::Zero(), 100});
    }
    session.addPose({capture, false});
  }
  return session;
}

// A sanitizer keeps the memory that is freed.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

double memoryToSolve_MB(const Session& session) {
  const auto snapshot = session.snapshot();
  const double before = test::peakMemory_MB([] {});
  return test::peakMemory_MB([&] { static_cast<void>(reconstruct(*snapshot)); }) - before;
}

/// Twice as much of something takes twice the memory, or four times as much, if it grows with the square.
constexpr double kLinear = 2.6;
constexpr double kSquare = 4.4;

TEST(Size, MemoryGrowsLinearlyWithThePatches) {
  const double half = memoryToSolve_MB(unlinkedCells(2000, 3));
  const double whole = memoryToSolve_MB(unlinkedCells(4000, 3));
  EXPECT_LT(whole, kLinear * half) << half << " MB and " << whole << " MB";
}

TEST(Size, MemoryGrowsWithTheSquareOfThePosesAtMost) {
  const double half = memoryToSolve_MB(test::simulatedSession({}, 500, 2));
  const double whole = memoryToSolve_MB(test::simulatedSession({}, 1000, 2));
  EXPECT_LT(whole, kSquare * half) << half << " MB and " << whole << " MB";
  EXPECT_LT(whole, 450) << "MB";
}

TEST(Size, TheGlobalSolverTakesLittleMemoryForACell) {
  const std::size_t before = cores();
  setCores(1);
  // The lot's four columns are 1.2 MB of it, in the equations and once more in their factor.
  EXPECT_LT(memoryToSolve_MB(test::simulatedSession(test::robotOptions("sheet:80x80", "cylinder:r=0.56"), 3, 10)),
            94.4);
  setCores(before);
}

#endif

TEST(Size, EveryOneOfTwentyThousandUnlinkedCellsIsItsOwnPatch) {
  constexpr std::uint32_t kCells = test::kSlowBuild ? 2'000 : 20'000;
  const auto result = reconstruct(*unlinkedCells(kCells, 3).snapshot());
  EXPECT_EQ(result->patches.size(), kCells);
  EXPECT_EQ(result->layout.cells.size(), kCells);
  EXPECT_THAT(*result, IsFinite());
}

}  // namespace
}  // namespace hexoderm
