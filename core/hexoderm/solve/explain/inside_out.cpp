#include "hexoderm/base/units.h"
#include "hexoderm/solve/explain/explainer.h"

#include <cmath>
#include <utility>

namespace hexoderm {
namespace {

/// How many links clearly bend, and to which side.
struct ClearBends {
  std::size_t links = 0;  ///< between two cells that measure
  std::size_t inwards = 0;
  std::size_t outwards = 0;
};

ClearBends clearBendsOf(const SkinLinks& skin) {
  constexpr double kScatter = 2 * kDegree;  // of a flat mould
  constexpr double kClearly = 2.5;          // deviations
  ClearBends bends;
  for (std::size_t k = 0; k < skin.edges().size(); ++k) {
    const GraphLink& link = skin.graph().links()[k];
    if (link.muted() || !skin.readings().measured(link)) continue;
    const EdgeRotation& edge = skin.edges()[k];
    const Eigen::Vector3d about = linkAxes(skin.sourcePort(link)).col(1);
    ++bends.links;
    if (std::abs(edge.angles.bend_rad) < kClearly * std::hypot(kScatter, std::sqrt(about.dot(edge.covariance * about))))
      continue;
    ++(edge.angles.bend_rad < 0 ? bends.inwards : bends.outwards);
  }
  return bends;
}

Finding describeWrongSide(const SkinLinks& skin, const ClearBends& bends, bool is_convex) {
  std::vector<CellId> cells;
  for (const GraphCell& cell : skin.graph().cells()) cells.push_back(cell.id);
  const std::size_t clear = bends.inwards + bends.outwards;
  return makeFinding(
      FindingCode::ContradictsModel,
      is_convex
          ? message("Of {} links that bend clearly, {} bend inwards, and the skin is said to lie on the outside of "
                    "the body: the axes of the accelerometers are not as in the cell model {}, and the result is "
                    "inside out.",
                    clear, bends.inwards, skin.model().name)
          : message("Of {} links that bend clearly, {} bend outwards, and the skin is said to lie in a hollow: the "
                    "axes of the accelerometers are not as in the cell model {}, and the result is inside out.",
                    clear, bends.outwards, skin.model().name),
      std::move(cells));
}

class InsideOutSkin {
 public:
  [[nodiscard]] std::optional<Explanation> operator()(const Estimate& estimate) {
    if (std::exchange(is_judged_, true)) return std::nullopt;
    constexpr std::size_t kFewest = 4;
    constexpr double kNearlyAll = 0.9;
    constexpr double kMany = 0.25;
    const SkinLinks& skin = estimate.skin();
    const ClearBends bends = clearBendsOf(skin);
    const auto clear = static_cast<double>(bends.inwards + bends.outwards);
    if (clear < kFewest || clear < kMany * static_cast<double>(bends.links)) return std::nullopt;
    const bool is_hollow = static_cast<double>(bends.inwards) >= kNearlyAll * clear;
    const bool is_convex = static_cast<double>(bends.outwards) >= kNearlyAll * clear;
    const SkinSide side = skin.snapshot().side;
    Explanation found;
    if (side == SkinSide::Convex ? is_hollow : side == SkinSide::Concave && is_convex) {
      found.findings.push_back(describeWrongSide(skin, bends, side == SkinSide::Convex));
    } else if (side == SkinSide::Unknown && is_hollow) {
      found.findings.push_back(makeFinding(
          FindingCode::InsideOut,
          message(
              "Of {} links that bend clearly, {} bend inwards. If the skin lies in a hollow, the result is right. If "
              "it lies on the outside of the body, the accelerometers are mirrored and the result is inside out: "
              "gravity cannot tell. Say where it lies.",
              bends.inwards + bends.outwards, bends.inwards)));
    }
    return found.empty() ? std::nullopt : std::optional(std::move(found));
  }

 private:
  bool is_judged_ = false;
};

}  // namespace

Explainer makeInsideOutExplainer() { return {Estimate::Stage::Links, InsideOutSkin()}; }

}  // namespace hexoderm
