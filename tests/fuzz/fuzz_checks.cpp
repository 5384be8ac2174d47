#include "tests/fuzz/fuzz_checks.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/text.h"
#include "hexoderm/skin/skin_graph.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace hexoderm::fuzz {

void require(bool condition, std::string_view what) {
  if (condition) return;
  std::cerr << "fuzz: expected " << what << std::endl;
  std::abort();
}

void requireSound(const Session& session) {
  session.model().validate();
  for (const SessionPose& pose : session.poses()) {
    require(pose.capture != nullptr, "a capture in every pose");
    for (const GravitySample& sample : pose.capture->samples) {
      require(sample.mean_g.allFinite(), "finite means");
      require(sample.cov_g2.allFinite(), "finite covariances");
      require(isCovariance(sample.cov_g2), "covariances");
      require(!sample.temperature_c || std::isfinite(*sample.temperature_c), "finite temperatures");
    }
  }
  require(session.nextPoseId().value() > 0 || session.poses().empty(), "an ID for the next pose");
  if (session.truth()) {
    for (const TrueCellPlacement& cell : session.truth()->cells) {
      require(cell.T_b_u.t.allFinite(), "finite positions");
      require((cell.T_b_u.R * cell.T_b_u.R.transpose()).isIdentity(1e-5), "rotations");
    }
  }
  const SkinGraph graph(session.model(), session.neighbors());
  std::size_t cells = 0;
  for (const auto& patch : graph.patches()) cells += patch.size();
  require(cells == graph.cells().size(), "each cell in one patch");
}

void requireSayable(const Error& error) {
  constexpr std::size_t kLongest = 2000;
  const std::string_view what = error.what();
  require(what.size() <= kLongest, "complaints of at most 2000 bytes");
  require(what.find(".hexoderm-") == std::string_view::npos, "complaints that name no temporary file");
  const std::string line = forTerminal(what);
  require(std::ranges::none_of(line, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '\x7f'; }),
          "a line without control characters");
}

}  // namespace hexoderm::fuzz
