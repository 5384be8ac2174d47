#pragma once

// What findLinks() claims, beside the truth, counted over seeds.

#include "hexoderm/base/median.h"
#include "hexoderm/base/units.h"
#include "hexoderm/mounting/attachment/links.h"
#include "tests/core/mounting/parts/gravity_draw.h"
#include "tests/support/testing.h"

namespace hexoderm {

struct LinksTruth {
  struct OnLink {
    std::string link;
    Eigen::Matrix3d R_l_u;
  };
  std::map<CellId, OnLink> cells;
  JointAngles zeros;
  Eigen::Vector3d up_w = Eigen::Vector3d::UnitZ();
};

struct LinksTally {
  int patches = 0;
  int alone = 0;       ///< on the right link, or on links that turn with it, and no other candidate
  int equivalent = 0;  ///< the right link is in the only candidate, with others that can't be told from it
  int among = 0;       ///< the right link is in one of several candidates
  int wrong = 0;       ///< candidates without the right link
  int none = 0;        ///< no candidate
  std::map<std::string, std::vector<double>> nees_on;  ///< turn_nees by link
  std::vector<double> turn_nees;                       ///< of the turns on the right links, each by 3
  std::vector<double> errors_rad;
  std::vector<double> stated_rad;
  std::vector<double> zero_nees;  ///< of the zeros that are shown
  std::vector<double> zero_errors_rad;
  std::vector<double> all_zero_nees;  ///< of all zeros
  std::vector<double> tilt_nees;      ///< by 2
  std::vector<double> chi_per_freedom;

  void add(const LinksResult& result, const LinksTruth& truth) {
    for (const PatchLinks& patch : result.patches) addPatch(patch, truth.cells.at(patch.origin));
    if (!result.robot) return;
    for (const JointZero& zero : result.robot->zeros) {
      const double error = zero.zero_rad - truth.zeros.positions.at(zero.joint);
      all_zero_nees.push_back(std::pow(error / zero.sigma_rad, 2));
      if (!zero.shown) continue;
      zero_nees.push_back(all_zero_nees.back());
      zero_errors_rad.push_back(std::abs(error));
    }
    tilt_nees.push_back(neesOfAxis(result.robot->up_w, result.robot->up_covariance, truth.up_w));
    chi_per_freedom.push_back(result.robot->chi_squared / std::max(1, result.robot->freedom));
  }

 private:
  void addPatch(const PatchLinks& found, const LinksTruth::OnLink& truth) {
    ++patches;
    const PatchTurn* right = nullptr;
    for (const LinkCandidate& candidate : found.candidates) {
      for (const PatchTurn& turn : candidate.links) right = turn.link == truth.link ? &turn : right;
    }
    if (right == nullptr) {
      ++(found.candidates.empty() ? none : wrong);
      return;
    }
    ++(found.placed ? alone : found.candidates.size() == 1 ? equivalent : among);
    const Eigen::Vector3d e = logSO3(right->R_l_o.transpose() * truth.R_l_u);
    turn_nees.push_back(e.dot(right->covariance.llt().solve(e)) / 3);
    nees_on[truth.link].push_back(turn_nees.back());
    errors_rad.push_back(e.norm());
    stated_rad.push_back(std::sqrt(right->covariance.trace()));
  }
};

/// 1 sigma of meanOf().
inline double meanSigmaOf(const std::vector<double>& values) {
  if (values.size() < 2) return 0;
  double squares = 0;
  for (const double value : values) squares += std::pow(value - meanOf(values), 2);
  const auto count = static_cast<double>(values.size());
  return std::sqrt(squares / (count - 1) / count);
}

inline std::string inWords(const LinksTally& tally) {
  std::string by_link;
  for (const auto& [link, nees] : tally.nees_on) by_link += ", " + link + " " + std::to_string(meanOf(nees));

  const auto mean = [](const std::vector<double>& values) {
    return std::to_string(meanOf(values)) + " +- " + std::to_string(1.96 * meanSigmaOf(values)) + " of " +
           std::to_string(values.size());
  };
  return "patches " + std::to_string(tally.patches) + ": alone " + std::to_string(tally.alone) + ", equivalent " +
         std::to_string(tally.equivalent) + ", among several " + std::to_string(tally.among) + ", wrong " +
         std::to_string(tally.wrong) + ", none " + std::to_string(tally.none) + "; turn error, median " +
         std::to_string(toDegrees(median(tally.errors_rad))) + " deg, stated " +
         std::to_string(toDegrees(median(tally.stated_rad))) + ", NEES " + mean(tally.turn_nees) + by_link +
         "; zeros NEES " + mean(tally.zero_nees) + ", error, median " +
         std::to_string(toDegrees(median(tally.zero_errors_rad))) + " deg, all zeros NEES " +
         mean(tally.all_zero_nees) + "; tilt NEES " + mean(tally.tilt_nees) + "; chi-squared per freedom " +
         mean(tally.chi_per_freedom);
}

}  // namespace hexoderm
