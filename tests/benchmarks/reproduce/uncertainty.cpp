#include "tests/benchmarks/reproduce/experiments.h"

#include "hexoderm/base/text.h"
#include "hexoderm/solve/reconstructor.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <iostream>

namespace hexoderm::cli {
namespace {

constexpr std::array<std::size_t, 3> kPoses = {2, 3, 6};

struct Band {
  double low = 0;
  double high = 0;
  [[nodiscard]] bool contains(double value) const { return value >= low && value <= high; }
};

constexpr Band kTwoPoses = {0.3, 5};
constexpr Band kMorePoses = {0.7, 1.5};
constexpr Band kWrongPrior = {0.3, 4};

/// Normalised estimation error squared, per degree of freedom; 1 is honest, less is too cautious.
struct Nees {
  double position = 0;
  double orientation = 0;
};

struct UncertaintyRow {
  SkinCase skin;
  double prior_mg = 0;  ///< the solver's prior for the offsets' sigma
  std::size_t skins = 0;
  Nees nees;
  Band band;
  [[nodiscard]] bool reached() const { return band.contains(nees.position) && band.contains(nees.orientation); }
};

/// The truth is moved so that the origin cells coincide, no best fit; mean over the other cells of e^T C^-1 e / 3.
std::optional<Nees> neesOf(const Reconstruction& result, const GroundTruth& truth) {
  const PatchReconstruction& patch = *largestPatch(result);
  const SE3 T_o_b = truePlacement(truth, patch.origin).inverse();
  Nees sum;
  double count = 0;
  for (const CellPlacement& cell : patch.cells) {
    if (cell.cell == patch.origin || !cell.cov_t_r) continue;
    const SE3 T_o_u = T_o_b * truePlacement(truth, cell.cell);
    const Eigen::Vector3d e_t = T_o_u.t - cell.T_o_u.t;
    const Eigen::Vector3d e_r = logSO3(cell.T_o_u.R.transpose() * T_o_u.R);
    const Eigen::Matrix3d C_t = cell.cov_t_r->topLeftCorner<3, 3>();
    const Eigen::Matrix3d C_r = cell.cov_t_r->bottomRightCorner<3, 3>();
    sum.position += e_t.dot(C_t.ldlt().solve(e_t)) / 3;
    sum.orientation += e_r.dot(C_r.ldlt().solve(e_r)) / 3;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return Nees{sum.position / count, sum.orientation / count};
}

/// The same measurements with another prior for the size of offsets.
Session withPrior(const Session& session, double prior_mg) {
  CellModel model = session.model();
  model.accelerometer.offset_sigma_g = prior_mg / 1000;
  Session other(std::move(model), session.neighbors());
  for (const SessionPose& pose : session.poses()) other.addPose(pose);
  return other;
}

/// Settling 100 cells on a torus takes the simulator long.
std::size_t skinsOf(const SkinCase& skin_case, const Trials& trials) {
  if (!skin_case.surface.starts_with("torus")) return trials.seeds();
  constexpr std::size_t kMaxSkins = 60;
  return std::clamp<std::size_t>(trials.seeds() * 3 / 10, 1, kMaxSkins);
}

UncertaintyRow runRow(const Trials& trials, const SkinCase& skin_case, double prior_mg, Band band) {
  const auto results =
      trials.run("uncertainty of " + skin_case.patch, skinsOf(skin_case, trials), [&](std::size_t seed) {
        SimulatedSkin skin = makeSkin(skin_case, seed);
        const Session session = measure(skin, skin_case);
        return neesOf(*reconstruct(*withPrior(session, prior_mg).snapshot(), globalSolver()), *session.truth());
      });
  UncertaintyRow row{skin_case, prior_mg, 0, {}, band};
  std::vector<double> position;
  std::vector<double> orientation;
  for (const auto& nees : results) {
    if (!nees) continue;
    position.push_back(nees->position);
    orientation.push_back(nees->orientation);
  }
  row.skins = position.size();
  row.nees = {mean(position), mean(orientation)};
  return row;
}

std::string nameOf(const SkinCase& skin_case) {
  return skin_case.surface.empty() ? skin_case.patch : skin_case.patch + " on " + skin_case.surface;
}

std::string inWords(const UncertaintyRow& row) {
  return formatFixed(row.nees.position, 2) + " / " + formatFixed(row.nees.orientation, 2) +
         (row.reached() ? "" : " NO");
}

std::string inWords(Band band) { return formatFixed(band.low, 1) + " to " + formatFixed(band.high, 1); }

/// Rows come in groups of kPoses.size(): one skin measured in that many ways.
void print(const std::vector<UncertaintyRow>& rows, const std::vector<UncertaintyRow>& wrong_prior, std::size_t seeds) {
  std::cout << "Stated uncertainty on simulated skins, global solver, fit: mean over " << seeds << " skins of the\n"
            << "normalised estimation error squared, position / orientation. 1 is honest, less is too cautious, more\n"
            << "claims too much. NO marks what is outside its bar.";
  if (rows.back().skins != seeds) std::cout << " Of the torus " << rows.back().skins << " skins.";
  std::cout << "\n\n";
  const auto skinOf = [](const UncertaintyRow& row) -> FigureRow {
    return {ofText("skin", "", nameOf(row.skin)), ofText("law", "", std::string(linkLawName(row.skin.law))),
            ofText("offsets", "", formatFixed(row.skin.offset_sigma_mg, 0) + " mg")};
  };
  const auto titleOf = [](std::size_t poses) { return std::to_string(poses) + " poses"; };
  std::vector<FigureRow> table;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k % kPoses.size() == 0) table.push_back(skinOf(rows[k]));
    table.back().push_back(ofText(titleOf(rows[k].skin.poses), "", inWords(rows[k])));
  }
  FigureRow bars = {ofText("skin", "", "bar"), ofText("law", "", ""), ofText("offsets", "", "")};
  for (const std::size_t poses : kPoses) {
    bars.push_back(ofText(titleOf(poses), "", inWords(poses < 3 ? kTwoPoses : kMorePoses)));
  }
  table.push_back(std::move(bars));
  printTable(table);
  std::cout << "\nThe offsets' sigma in the cell model is wrong (bar " << inWords(kWrongPrior) << "):\n";
  std::vector<FigureRow> wrong;
  for (const UncertaintyRow& row : wrong_prior) {
    wrong.push_back(skinOf(row));
    wrong.back().push_back(ofText("cell model", "", formatFixed(row.prior_mg, 0) + " mg"));
    wrong.back().push_back(ofCount("poses", "", row.skin.poses));
    wrong.back().push_back(ofText("nees", "", inWords(row)));
  }
  printTable(wrong);
}

Json toJson(const UncertaintyRow& row) {
  return {{"skin", nameOf(row.skin)},
          {"link_law", linkLawName(row.skin.law)},
          {"poses", row.skin.poses},
          {"offset_sigma_mg", row.skin.offset_sigma_mg},
          {"prior_sigma_mg", row.prior_mg},
          {"skins", row.skins},
          {"nees_position", row.nees.position},
          {"nees_orientation", row.nees.orientation},
          {"bar", {row.band.low, row.band.high}},
          {"reached", row.reached()}};
}

}  // namespace

nlohmann::ordered_json checkUncertainty(const Trials& trials, bool prints) {
  const std::vector<std::pair<std::string, std::string>> patches = {
      {"x17", "cylinder:r=0.0501"}, {"ring8", ""}, {"ring8:closed", ""}, {"sheet:10x10", "torus:R=0.2,r=0.1"}};
  std::vector<UncertaintyRow> rows;
  std::vector<UncertaintyRow> wrong_prior;
  for (const auto& [patch, surface] : patches) {
    for (const LinkLaw law : {LinkLaw::Bend, LinkLaw::Surface}) {
      for (const double offset : {20.0, 60.0}) {
        for (const std::size_t poses : kPoses) {
          const SkinCase skin = {
              .patch = patch, .surface = surface, .law = law, .poses = poses, .offset_sigma_mg = offset};
          rows.push_back(runRow(trials, skin, offset, poses < 3 ? kTwoPoses : kMorePoses));
        }
      }
    }
  }
  for (const LinkLaw law : {LinkLaw::Bend, LinkLaw::Surface}) {
    for (const double factor : {0.5, 2.0}) {
      const SkinCase skin = {.patch = "x17", .surface = "cylinder:r=0.0501", .law = law, .poses = 3};
      wrong_prior.push_back(runRow(trials, skin, factor * skin.offset_sigma_mg, kWrongPrior));
    }
  }
  if (prints) print(rows, wrong_prior, trials.seeds());
  const auto row_json = [](const UncertaintyRow& row) { return toJson(row); };
  return {{"rows", arrayOf(rows, row_json)}, {"wrong_prior", arrayOf(wrong_prior, row_json)}};
}

}  // namespace hexoderm::cli
