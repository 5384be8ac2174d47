#include "tests/benchmarks/reproduce/trials.h"

#include "hexoderm/base/text.h"
#include "hexoderm/solve/reconstructor.h"

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

/// The same measurements with another prior for the size of offsets.
Session withPrior(const Session& session, double prior_mg) {
  CellModel model = session.model();
  model.accelerometer.offset_sigma_g.setConstant(prior_mg / 1000);
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

std::string inWords(Band band) { return formatFixed(band.low, 1) + " to " + formatFixed(band.high, 1); }

/// `prior_mg`: the solver's prior for the offsets' sigma.
FigureRow runRow(const Trials& trials, const SkinCase& skin, double prior_mg, Band band) {
  const Tally tally =
      trials.run("uncertainty of " + skin.patch, skinsOf(skin, trials), [&](Tally& found, std::size_t seed) {
        SimulatedSkin simulated = makeSkin(skin, seed);
        const Session session = measure(simulated, skin);
        noteNees(found, *reconstruct(*withPrior(session, prior_mg).snapshot()), *session.truth());
      });
  const double position = tally.mean("position").value_or(0);
  const double orientation = tally.mean("orientation").value_or(0);
  const bool is_reached = band.contains(position) && band.contains(orientation);
  return {
      ofText("skin", "skin", skin.surface.empty() ? skin.patch : skin.patch + " on " + skin.surface),
      ofText("law", "link_law", std::string(linkLawName(skin.law))),
      {"offsets", formatFixed(skin.offset_sigma_mg, 0) + " mg", "offset_sigma_mg", skin.offset_sigma_mg},
      {"cell model", formatFixed(prior_mg, 0) + " mg", "prior_sigma_mg", prior_mg},
      ofCount("poses", "poses", skin.poses),
      ofText("nees", "", formatFixed(position, 2) + " / " + formatFixed(orientation, 2) + (is_reached ? "" : " NO")),
      ofCount("", "skins", tally.of("position").size()),
      ofNumber("", "nees_position", position),
      ofNumber("", "nees_orientation", orientation),
      {"", "", "bar", {band.low, band.high}},
      {"", "", "reached", is_reached}};
}

std::vector<FigureRow> withBars(std::vector<FigureRow> table) {
  FigureRow bars = {ofText("skin", "", "bar"), ofText("law", "", ""), ofText("offsets", "", "")};
  for (const std::size_t poses : kPoses) {
    bars.push_back(ofText(std::to_string(poses) + " poses", "", inWords(poses < 3 ? kTwoPoses : kMorePoses)));
  }
  table.push_back(std::move(bars));
  return table;
}

void print(const std::vector<FigureRow>& rows, const std::vector<FigureRow>& wrong_prior, std::size_t seeds) {
  std::cout << "Stated uncertainty on simulated skins, global solver, fit: mean over " << seeds << " skins of the\n"
            << "normalised estimation error squared, position / orientation. 1 is honest, less is too cautious, more\n"
            << "claims too much. NO marks what is outside its bar.";
  const std::string of_torus = rows.back()[6].text;
  if (of_torus != std::to_string(seeds)) std::cout << " Of the torus " << of_torus << " skins.";
  std::cout << "\n\n";
  printTable(withBars(besideEachOther(rows, 3, "nees")));
  std::cout << "\nThe offsets' sigma in the cell model is wrong (bar " << inWords(kWrongPrior) << "):\n";
  printTable(wrong_prior);
}

}  // namespace

Json checkUncertainty(const Trials& trials, bool prints) {
  const std::vector<std::pair<std::string, std::string>> patches = {
      {"x17", "cylinder:r=0.0501"}, {"ring8", ""}, {"ring8:closed", ""}, {"sheet:10x10", "torus:R=0.2,r=0.1"}};
  std::vector<FigureRow> rows;
  std::vector<FigureRow> wrong_prior;
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
  return {{"rows", toJson(rows)}, {"wrong_prior", toJson(wrong_prior)}};
}

}  // namespace hexoderm::cli
