#pragma once

#include "hexoderm/solve/global/rigidity.h"
#include "hexoderm/solve/tree/skin_links.h"

#include <set>
#include <span>
#include <vector>

namespace hexoderm {

/// Compares neighbouring cells and finds the links that no skin link can be (by their angles, or because their cells
/// moved against each other between poses) and the cells whose readings fit none of their neighbours'. One bad cell
/// makes good links look bad, so a cell that agrees with nearly none of its neighbours is named instead of its links.
class SuspectSearch {
 public:
  explicit SuspectSearch(const SkinLinks& skin);

  /// Judges these links anew: their readings or rotations are other ones now.
  void update(std::span<const std::size_t> links);

  /// The pose without which nearly all links are rigid, where with it most are not: the part moved while it was
  /// sampled.
  [[nodiscard]] std::optional<std::size_t> worstPose() const;

  /// The cell, none of `but`, that contradicts its neighbours most, if there is one: its readings should not be used.
  /// Ask again after that, with new readings and edges.
  [[nodiscard]] std::optional<std::size_t> worstCell(std::span<const std::size_t> but = {}) const;
  /// The cell's readings contradict a neighbour's so clearly that two poses suffice to say so.
  [[nodiscard]] bool isClearlyWrong(std::size_t cell) const;

  /// By how many deviations the cells of a link moved against each other between poses; 0 where it was not tested.
  [[nodiscard]] double misfitOf(std::size_t link) const { return verdicts_[link].misfit; }

  struct BadLink {
    std::size_t link = 0;
    std::vector<Finding> findings;  ///< at least one
  };
  /// `spared`: cells whose links are left as they are.
  [[nodiscard]] std::vector<BadLink> badLinks(std::span<const std::size_t> spared = {}) const;

 private:
  struct Verdict {
    bool tested = false;
    std::vector<Finding> implausible;
    double misfit = 0;  ///< standard deviations
    bool rigid = true;
    [[nodiscard]] bool bad() const { return !implausible.empty() || !rigid; }
  };
  [[nodiscard]] Verdict judge(std::size_t link) const;
  /// Counts a link's verdict, or takes it out again (`by` -1).
  void count(std::size_t link, int by);
  /// Nearly all links of the cell are bad.
  [[nodiscard]] bool isAtOdds(std::size_t cell) const;
  /// Errors of both cells of a link together, seen from the source.
  [[nodiscard]] AccelerometerPrior pairPriorOf(std::size_t link) const;
  /// Calls use(reading of the source, what it would read if it turned with the target) for all poses of both.
  template <class Use>
  void forReadings(std::size_t link, const Use& use) const;

  const SkinLinks& skin_;
  std::vector<Verdict> verdicts_;  ///< per link
  int tested_links_ = 0;
  int moving_links_ = 0;
  std::vector<int> tested_;        ///< links of every cell
  std::vector<int> bad_;           ///< the same
  std::set<std::size_t> at_odds_;  ///< cells; few, so that asking for the worst does not go through all
};

/// By so many times the limit must a cell with too few poses be beyond it to be called wrong.
inline constexpr double kClearly = 2;

/// Two poses fix a cell's attitude by the priors of its sensor, and what contradicts them may be chance: a cell with no
/// more, and not clearly wrong, is called suspicious and stays.
bool hasTooFewPoses(const SkinLinks& skin, std::size_t cell);
Finding describeSuspiciousSensor(const SkinLinks& skin, std::size_t cell);

/// A cell that turned against the others; its readings before and after belong to two attitudes.
Finding describeMovedCell(const SkinLinks& skin, std::size_t cell, std::size_t first_pose_after, double angle_rad);

/// Why a cell's readings are not used, in words: a gain that is wrong in all poses, or else readings that fit nothing.
Finding describeBadSensor(const SkinLinks& skin, std::size_t cell, bool is_leaf);

}  // namespace hexoderm
