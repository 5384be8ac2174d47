#pragma once

#include "hexoderm/base/finding.h"

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <vector>

namespace hexoderm {

/// A change of one reading: what a motion of the part added to it.
struct ReadingCorrection {
  std::size_t cell = 0;                               ///< of the graph
  std::size_t pose = 0;                               ///< of the snapshot
  Eigen::Vector3d added_g = Eigen::Vector3d::Zero();  ///< to be subtracted from the mean, cell frame
  double variance_g2 = 0;                             ///< of that, per axis; to be added to the mean's
};

/// Why a skin and its model disagree: what must not be used for both to agree, and a finding for each fault. Cells and
/// links are indices of the graph, poses of the snapshot.
struct Explanation {
  std::vector<Finding> findings;                          ///< of what is excluded
  std::vector<Finding> remarks;                           ///< of what is only suspected, and stays; each is said once
  std::map<FindingCode, std::vector<std::size_t>> links;  ///< that are no skin links, by the reason
  std::vector<std::size_t> cells;                         ///< whose readings are not those of a cell in its place
  std::vector<std::size_t> poses;                         ///< in which the part moved
  std::vector<ReadingCorrection> corrections;
  /// Without the cells all others stay about where they are, so that the joint estimate can go on from there. Else
  /// origin, paths and placements are found anew, as they would be had the cells never measured.
  bool keeps_placements = false;
  bool ends_search = false;  ///< the model is another one, so that nothing else can be said to be wrong

  /// It changes what the estimate is made of.
  [[nodiscard]] bool excludes() const {
    return !links.empty() || !cells.empty() || !poses.empty() || !corrections.empty();
  }
  [[nodiscard]] bool empty() const { return !excludes() && findings.empty() && remarks.empty(); }
};

}  // namespace hexoderm
