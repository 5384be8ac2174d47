#include "app/cli/command.h"

#include "hexoderm/mounting/parts/parts.h"
#include "hexoderm/solve/reconstructor.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace hexoderm::cli {
namespace {

// --- as text

/// "1.2e-05", "0.43": a probability that may be tiny.
std::string probability(double value) {
  return value >= 0.001   ? formatFixed(value, 3)
         : value >= 1e-99 ? "1e" + formatFixed(std::floor(std::log10(value)), 0)
                          : "0";
}

/// "2.0 deg", the worst way.
std::string sigmaOf(const Eigen::Matrix3d& covariance) { return degrees(rotationSigma(covariance), 1); }

std::string direction(const HingeAxis& axis) { return "(" + inWords(axis.u, 3, ", ") + ")"; }

std::size_t cellsOf(const Reconstruction& r, PatchId patch) { return r.patches[patch.value()].cells.size(); }

void printParts(const Reconstruction& r, const PartsResult& result) {
  for (std::size_t k = 0; k < result.parts.size(); ++k) {
    const Part& part = result.parts[k];
    std::cout << "Part " << k + 1 << ", in the frame of cell " << part.patches.front().origin << ":\n";
    for (const PatchOfPart& patch : part.patches) {
      std::cout << "  patch " << patch.patch << ", origin cell " << patch.origin << ", "
                << counted(cellsOf(r, patch.patch), "cell");
      if (&patch != &part.patches.front()) {
        std::cout << ": turned by roll, pitch, yaw " << rollPitchYaw(patch.R_part_o, 1) << ", +- "
                  << sigmaOf(patch.covariance);
      }
      std::cout << '\n';
    }
  }
}

void printPairs(const PartsResult& result) {
  if (result.pairs.empty()) return;
  std::cout
      << "Pairs of patches (misfit: chi-squared / degrees of freedom; p: its probability in one part; odds: of one "
         "part against a joint that was moved; shows: turns that would have shown about any axis):\n";
  for (const PatchPair& pair : result.pairs) {
    std::cout << "  " << pair.a << " and " << pair.b << ": " << movementName(pair.movement) << "; " << pair.poses
              << " poses, misfit " << formatFixed(pair.chi_squared, 1) << " / " << pair.freedom << ", p "
              << probability(pair.probability) << ", odds 10^" << formatFixed(pair.log10_odds, 1) << ", shows "
              << degrees(pair.noticeable_rad, 1) << '\n';
  }
}

void printHinge(const PartsResult& result, const PartRelation& relation) {
  const Hinge& hinge = *relation.hinge;
  if (hinge.knowledge != HingeKnowledge::Found) return;
  const auto frame = [&](std::size_t part) { return result.parts[part].patches.front().origin; };
  std::cout << "    axis " << direction(hinge.a) << " +- " << degrees(hinge.a.sigma_rad, 1) << " in the frame of cell "
            << frame(relation.a) << ", " << direction(hinge.b) << " +- " << degrees(hinge.b.sigma_rad, 1)
            << " in that of cell " << frame(relation.b) << '\n';
  std::cout << "    turned, against pose " << *hinge.reference << ", by";
  const char* separator = " ";
  for (const HingeAngle& angle : hinge.angles) {
    if (angle.pose == *hinge.reference) continue;
    std::cout << separator << "pose " << angle.pose << ": "
              << (angle.angle_rad ? formatFixed(toDegrees(*angle.angle_rad), 1) + " +- " +
                                        formatFixed(toDegrees(angle.sigma_rad), 1)
                                  : std::string("not shown"));
    separator = ", ";
  }
  std::cout << " deg\n";
}

void printRelations(const PartsResult& result) {
  for (const PartRelation& relation : result.relations) {
    std::cout << "Parts " << relation.a + 1 << " and " << relation.b + 1 << ": " << forTerminal(relation.why.english())
              << '\n';
    if (relation.hinge) printHinge(result, relation);
    if (!relation.what_would_tell.empty()) {
      std::cout << "    Next: " << forTerminal(relation.what_would_tell.english()) << '\n';
    }
  }
}

// --- as JSON

Json toJson(const Reconstruction& r, const Part& part) {
  const auto patch_json = [&](const PatchOfPart& patch) -> Json {
    return {{"id", patch.patch.value()},
            {"origin", patch.origin.value()},
            {"cells", cellsOf(r, patch.patch)},
            {"q_part_o_wxyz", quaternionOf(patch.R_part_o)},
            {"covariance_rad2", rowsOf(patch.covariance)},
            {"sigma_deg", toDegrees(rotationSigma(patch.covariance))}};
  };
  const auto gravity_json = [](const GravityDirection& gravity) -> Json {
    return {
        {"pose", gravity.pose.value()}, {"up_part", listOf(gravity.g_o)}, {"sigma_deg", toDegrees(gravity.sigma_rad)}};
  };
  return {{"frame_of_cell", part.patches.front().origin.value()},
          {"chi_squared", part.chi_squared},
          {"freedom", part.freedom},
          {"patches", arrayOf(part.patches, patch_json)},
          {"gravity", arrayOf(part.gravity, gravity_json)}};
}

Json toJson(const PatchPair& pair) {
  return {{"a", pair.a.value()},
          {"b", pair.b.value()},
          {"movement", movementName(pair.movement)},
          {"poses", pair.poses},
          {"q_a_b_wxyz", quaternionOf(pair.R_a_b)},
          {"covariance_rad2", rowsOf(pair.covariance)},
          {"chi_squared", pair.chi_squared},
          {"freedom", pair.freedom},
          {"probability", pair.probability},
          {"log10_odds", pair.log10_odds},
          {"noticeable_deg", toDegrees(pair.noticeable_rad)}};
}

Json toJson(const HingeAxis& axis) {
  return {
      {"u", listOf(axis.u)}, {"covariance_rad2", rowsOf(axis.covariance)}, {"sigma_deg", toDegrees(axis.sigma_rad)}};
}

Json toJson(const Hinge& hinge) {
  Json json = {{"knowledge", hingeKnowledgeName(hinge.knowledge)},
               {"chi_squared", hinge.chi_squared},
               {"freedom", hinge.freedom},
               {"probability", hinge.probability}};
  if (!hinge.reference) return json;
  json["axis_a"] = toJson(hinge.a);
  json["axis_b"] = toJson(hinge.b);
  json["q_a_b_wxyz"] = quaternionOf(hinge.R_a_b);
  json["reference_pose"] = hinge.reference->value();
  json["angles"] = arrayOf(hinge.angles, [](const HingeAngle& angle) -> Json {
    return {{"pose", angle.pose.value()},
            {"angle_deg", orNull(angle.angle_rad, toDegrees)},
            {"sigma_deg", toDegrees(angle.sigma_rad)}};
  });
  return json;
}

Json toJson(const PartRelation& relation) {
  return {{"a", relation.a},
          {"b", relation.b},
          {"movement", movementName(relation.movement)},
          {"probability", relation.probability},
          {"log10_odds", relation.log10_odds},
          {"noticeable_deg", toDegrees(relation.noticeable_rad)},
          {"why", relation.why.english()},
          {"what_would_tell", relation.what_would_tell.english()},
          {"hinge", orNull(relation.hinge, [](const Hinge& hinge) { return toJson(hinge); })}};
}

Json toJson(const Reconstruction& r, const PartsResult& result) {
  return {{"summary", result.summary.english()},
          {"parts", arrayOf(result.parts, [&](const Part& part) { return toJson(r, part); })},
          {"pairs", arrayOf(result.pairs, [](const PatchPair& pair) { return toJson(pair); })},
          {"relations", arrayOf(result.relations, [](const PartRelation& relation) { return toJson(relation); })},
          {"not_compared", numbersOf(result.not_compared)}};
}

bool tellsAll(const PartsResult& result) {
  return !result.parts.empty() && std::ranges::none_of(result.relations, [](const PartRelation& relation) {
    return relation.movement == Movement::CantTell;
  });
}

int run(const std::string& input, const Common& common) {
  common.progress("Solving ...");
  const auto r = reconstruct(*openSession(input).snapshot());
  common.endProgress();
  const PartsResult result = findParts(*r);
  if (common.json) {
    printJson(toJson(*r, result));
  } else {
    std::cout << forTerminal(result.summary.english()) << '\n';
    for (const PatchId patch : result.not_compared) {
      std::cout << "Not compared: patch " << patch << ", origin cell " << r->patches[patch.value()].origin << '\n';
    }
    printParts(*r, result);
    printPairs(result);
    printRelations(result);
  }
  return tellsAll(result) ? kDone : kNotGoodEnough;
}

}  // namespace

void addParts(CLI::App& app, Common& common) {
  auto [command, input] = addCommand<std::string>(
      app, common, "parts",
      "Tell which patches move together, how they are turned against each other, and where hinges are",
      "From gravity alone: where patches and hinges lie, it doesn't say. A joint that stood still in all poses can't "
      "be\n"
      "seen. Hinges take five poses.\n"
      "Exit code 1: of some parts the poses can't tell whether they move together.\n"
      "Example:\n  hexoderm-cli parts robot.session.json --json",
      run);
  addInput(command, "session", input, "Session (*.hexo or *.session.json)")->required();
}

}  // namespace hexoderm::cli
