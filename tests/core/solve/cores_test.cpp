// What is solved does not depend on how many cores it is solved with.

#include "hexoderm/base/parallel.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/solvers.h"
#include "tests/support/testing.h"

#include <cstddef>
#include <thread>

namespace hexoderm {
namespace {

class SolvedWithCores : public testing::TestWithParam<Solver> {
 protected:
  ~SolvedWithCores() override { setCores(before_); }

  [[nodiscard]] std::string calibration() const {
    Reconstruction result = *reconstruct(*session_.snapshot(), test::by(GetParam()));
    result.solve_seconds = 0;
    return calibrationToJson(result);
  }

  /// Large enough for all that is shared out, and with faults that are looked for.
  static Session session() {
    SimulatedSkinOptions options = test::skinOptions("sheet:42x42", "cylinder:r=0.3", 4);
    options.faults = {{SkinFault::Yawed, CellId(100)}, {SkinFault::Dead, CellId(700)}};
    return test::simulatedSession(options, 3);
  }

  Session session_ = session();

 private:
  std::size_t before_ = cores();
};

TEST_P(SolvedWithCores, IsTheSameToTheLastDigitAlsoWhereSeveralShareThem) {
  setCores(1);
  const std::string expected = calibration();
  for (const auto& [count, at_a_time] : {std::pair(5U, 1U), std::pair(3U, 2U)}) {
    setCores(count);
    std::vector<std::string> found(at_a_time);
    {
      std::vector<std::jthread> threads;
      for (std::string& each : found) threads.emplace_back([&] { each = calibration(); });
    }
    for (const std::string& each : found) EXPECT_TRUE(each == expected) << count << " cores";
  }
}

INSTANTIATE_TEST_SUITE_P(Both, SolvedWithCores, testing::Values(Solver::Tree, Solver::Global), test::solverOfTest);

}  // namespace
}  // namespace hexoderm
