#include "hexoderm/solve/reconstructor.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

std::shared_ptr<const Reconstruction> solvedWith(WholeSkinFault fault, const char* patch, const char* surface,
                                                 std::uint64_t seed) {
  SimulatedSkinOptions options = test::skinOptions(patch, surface, seed);
  options.whole_skin_faults = {fault};
  return reconstruct(*test::simulatedSession(options, 4).snapshot());
}

TEST(WholeSkin, OtherAxesOrPortsAreTheOnlyFinding) {
  for (const WholeSkinFault fault : {WholeSkinFault::AxesSwapped, WholeSkinFault::AxesPermuted,
                                     WholeSkinFault::PortsRotated, WholeSkinFault::PortOffset}) {
    for (const auto& [patch, surface] : {std::pair("x17", ""), std::pair("sheet:5x5", "cylinder:r=0.08"),
                                         std::pair("sheet:10x10", "cylinder:r=0.1")}) {
      for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const auto result = solvedWith(fault, patch, surface, seed);
        EXPECT_THAT(result->findings, ElementsAre(Field(&Finding::code, FindingCode::ContradictsModel)))
            << "fault " << static_cast<int>(fault) << ", " << patch << ", seed " << seed;
      }
    }
  }
}

TEST(WholeSkin, SaysWithWhichAxesOrPortsAllLinksFit) {
  const auto textOf = [](WholeSkinFault fault) {
    const auto result = solvedWith(fault, "x17", "", 1);
    return result->findings.empty() ? std::string() : result->findings[0].message.english();
  };
  EXPECT_THAT(textOf(WholeSkinFault::AxesSwapped), HasSubstr("x and y exchanged"));
  EXPECT_THAT(textOf(WholeSkinFault::PortOffset), HasSubstr("if the ports are numbered 1 further on"));
}

}  // namespace
}  // namespace hexoderm
