#pragma once

#include "hexoderm/sim/simulated_session.h"

#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace hexoderm::test {

/// A simulated session such as the window or a file may hold: skins, faults, links set aside, poses disabled and
/// readings lost, drawn at random from a seed.
class RandomSession {
 public:
  explicit RandomSession(std::uint64_t seed) : random_(seed) {}

  [[nodiscard]] Session draw() {
    SimulatedSkinOptions options;
    options.patch = std::vector<std::string>{"x17", "x17", "ring8", "ring8:closed", "sheet:3x4", "sheet:2x6"}[pick(6)];
    if (options.patch == "x17" && pick(2) == 0) options.surface = "plane";
    options.seed = random_();
    options.hand_held = pick(3) > 0;
    const std::size_t cells = options.patch == "x17" ? 17 : options.patch.starts_with("ring") ? 8 : 12;
    for (std::size_t k = pick(4) == 0 ? 1 + pick(3) : 0; k > 0; --k) {
      options.faults.push_back({static_cast<SkinFault>(pick(8)), CellId(static_cast<std::uint32_t>(1 + pick(cells)))});
    }
    SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
    Session session = simulateSession(skin, pick(8), 10 + pick(200));
    muteLinks(session, skin.neighbors());
    for (std::size_t pose = 0; pose < session.poses().size(); ++pose) {
      if (pick(8) == 0) session.setPoseDisabled(pose, true);
      if (pick(4) == 0) loseReadings(session, pose);
    }
    return session;
  }

 private:
  std::size_t pick(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }

  /// None, some or all of them.
  void muteLinks(Session& session, const NeighborList& neighbors) {
    const std::size_t one_in = std::vector<std::size_t>{0, 0, 0, 8, 3, 1}[pick(6)];
    if (one_in == 0) return;
    for (const CellReport& cell : neighbors) {
      for (const NeighborReport& link : cell.neighbors) {
        if (link.cell.value() <= cell.id.value() || !link.cell_port || pick(one_in) != 0) continue;
        session.setLinkMuted({cell.id, link.port}, {link.cell, *link.cell_port}, true);
      }
    }
  }

  void loseReadings(Session& session, std::size_t index) {
    SessionPose pose = session.poses()[index];
    PoseCapture capture = *pose.capture;
    std::erase_if(capture.samples, [this](const GravitySample&) { return pick(4) == 0; });
    pose.capture = std::make_shared<const PoseCapture>(std::move(capture));
    session.removePose(index);
    session.addPose(pose, index);
  }

  std::mt19937_64 random_;
};

}  // namespace hexoderm::test
