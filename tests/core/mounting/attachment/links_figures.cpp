// The figures of robot/links in its README: links_figures [SEEDS [LEVER_M]]. No test, because it takes minutes.

#include "tests/core/mounting/attachment/simulated_links.h"

#include <cstdlib>
#include <iostream>

int main(int argc, char** argv) {
  using namespace hexoderm;
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 100;
  const double lever_m = argc > 2 ? std::atof(argv[2]) : LinksOptions().lever_m;
  struct Case {
    const char* name;
    std::size_t poses;
    bool motors;
    double zero_sigma_deg;
  };
  for (const Case& c : {Case{"still, 4 poses", 4, false, 0.5}, Case{"still, 8 poses", 8, false, 0.5},
                        Case{"motors, 4 poses", 4, true, 0.5}, Case{"motors, 8 poses", 8, true, 0.5},
                        Case{"still, 8 poses, zeros of 2 degrees", 8, false, 2},
                        Case{"motors, 8 poses, zeros of 2 degrees", 8, true, 2}}) {
    SimulatedLinksOptions options;
    options.poses = c.poses;
    options.motors = c.motors;
    options.zero_sigma_rad = c.zero_sigma_deg * kDegree;
    options.find.lever_m = lever_m;
    std::cout << c.name << ": " << inWords(tallySimulatedLinks(options, seeds)) << std::endl;
  }
}
