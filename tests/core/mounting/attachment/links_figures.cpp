// The figures of core/hexoderm/mounting/attachment/README.md: links_figures [SEEDS [LEVER_M]]. No test, because it
// takes minutes.

#include "tests/core/mounting/attachment/simulated_links.h"

#include <cstdlib>
#include <iostream>

int main(int argc, char** argv) {
  using namespace hexoderm;
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 100;
  const double lever_m = argc > 2 ? std::atof(argv[2]) : LinksOptions().lever_m;
  std::pair<const char*, SimulatedLinksOptions> cases[] = {
      {"still, 4 poses", {.poses = 4}},
      {"still, 8 poses", {.poses = 8}},
      {"motors, 4 poses", {.poses = 4, .motors = true}},
      {"motors, 8 poses", {.poses = 8, .motors = true}},
      {"still, 8 poses, zeros of 2 degrees", {.poses = 8, .zero_sigma_rad = 2 * kDegree}},
      {"motors, 8 poses, zeros of 2 degrees", {.poses = 8, .motors = true, .zero_sigma_rad = 2 * kDegree}}};
  for (auto& [name, options] : cases) {
    options.find.lever_m = lever_m;
    std::cout << name << ": " << inWords(tallySimulatedLinks(options, seeds)) << std::endl;
  }
}
