#include "hexoderm/base/units.h"
#include "hexoderm/solve/explain/explainer.h"
#include "hexoderm/solve/faults/sensor_turn.h"
#include "hexoderm/solve/faults/turn_map.h"
#include "hexoderm/solve/metrics/pose_coverage.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace hexoderm {
namespace {

/// How all cells of a patch may differ from the cell model.
struct OtherModel {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  ///< they read R f, or -R f, where the model has f
  std::size_t ports_on = 0;                         ///< their ports have the numbers of those so many further on
  Message text;                                     ///< with what all links fit
};

std::vector<OtherModel> otherModels(std::size_t ports) {
  std::vector<OtherModel> models;
  for (const SensorTurn& turn : possibleSensorTurns()) {
    // A link between two reflected cells is turned as one between two cells that are turned instead.
    models.push_back({turn.R, 0, message("if the accelerometers are {}", turnText(turn))});
  }
  for (std::size_t on = 1; on < ports; ++on) {
    models.push_back({Eigen::Matrix3d::Identity(), on, message("if the ports are numbered {} further on", on)});
  }
  return models;
}

class PatchModels {
 public:
  PatchModels(const SkinLinks& skin, std::size_t patch) : skin_(skin), patch_(patch) {}

  /// Turns of the patch's links if its cells were as another model has them.
  [[nodiscard]] TurnMap mapWith(const OtherModel& model) const {
    const SkinGraph& graph = skin_.graph();
    const std::vector<Port>& ports = skin_.model().ports;
    const auto portOf = [&](const Port& port) -> const Port& {
      return ports[(static_cast<std::size_t>(&port - ports.data()) + model.ports_on) % ports.size()];
    };
    std::vector<DirectedTurn> turns;
    const std::vector<double> headings =
        flatHeadings(skin_, patch_, [&](const Port& port) { return headingOf(portOf(port)); });
    for (const std::size_t cell : graph.patches()[patch_]) {
      for (const std::size_t k : graph.linksAt(cell)) {
        const GraphLink& link = graph.links()[k];
        if (link.muted() || link.source != cell || !skin_.readings().measured(link)) continue;
        const Port& source = portOf(skin_.sourcePort(link));
        const Eigen::Matrix3d R_c_n = model.R.transpose() * skin_.edges()[k].R_c_n * model.R;
        const LinkAngles angles = linkAngles(R_c_n, source, portOf(skin_.targetPort(link)));
        turns.push_back({{angles.twist_rad, angles.bend_rad, angles.yaw_rad},
                         headings[graph.cells()[cell].place] + headingOf(source)});
      }
    }
    return fitTurnMap(turns);
  }

  /// The links contradict the cell model. Among many links that are no skin links, anything may be.
  [[nodiscard]] static bool isContradiction(const TurnMap& map) {
    constexpr double kLimit = 7;  // deviations
    constexpr double kMin = 3 * kDegree;
    constexpr double kMany = 0.3;
    return map.deviate > kLimit && map.unlike_rad > kMin && map.far_off < kMany;
  }

  /// The first other model with which nearly all links are those of a surface.
  [[nodiscard]] std::optional<Message> explanationOf(const TurnMap& map) const {
    constexpr double kStillFarOff = 0.1;
    constexpr double kUsual = 4;  // deviations
    std::optional<Message> best;
    double least = std::min(kUsual, map.far_off > kStillFarOff ? kUsual : map.deviate / 2);
    for (const OtherModel& model : otherModels(skin_.model().ports.size())) {
      const TurnMap with = mapWith(model);
      if (with.far_off > kStillFarOff || with.deviate >= least) continue;
      best = model.text;
      constexpr double kAsGood = 1;
      least = with.deviate - kAsGood;
    }
    return best;
  }

 private:
  const SkinLinks& skin_;
  std::size_t patch_;
};

/// Where gravity lies along one line, nothing tells how links are turned about it.
bool readsOneLine(const SkinLinks& skin) {
  const GravityTable& table = skin.table();
  std::vector<std::size_t> cells(table.cellCount());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  const auto cell = std::ranges::max_element(cells, {}, [&](std::size_t k) { return table.usablePoseCount(k); });
  if (cell == cells.end()) return false;
  std::vector<Eigen::Vector3d> directions;
  for (const std::size_t pose : table.usablePoses(*cell)) {
    directions.push_back(table.at(*cell, pose).mean_g.normalized());
  }
  return lieAlongOneLine(directions);
}

class WholeSkin {
 public:
  [[nodiscard]] std::optional<Explanation> operator()(const Estimate& estimate) {
    if (std::exchange(revision_, estimate.linkRevision()) == estimate.linkRevision()) return std::nullopt;
    const SkinLinks& skin = estimate.skin();
    if (readsOneLine(skin)) return std::nullopt;
    Explanation found;
    for (std::size_t patch = 0; patch < skin.graph().patches().size(); ++patch) {
      constexpr std::size_t kFewest = 4;
      constexpr double kMost = 0.5;
      if (skin.graph().patches()[patch].size() < kFewest) continue;
      const PatchModels models(skin, patch);
      const TurnMap map = models.mapWith({});
      const bool is_contradiction = PatchModels::isContradiction(map);
      if (!is_contradiction && map.far_off < kMost) continue;
      const std::optional<Message> with = models.explanationOf(map);
      if (is_contradiction || with) found.findings.push_back(describe(skin, patch, with));
    }
    found.ends_search = !found.findings.empty();
    return found.empty() ? std::nullopt : std::optional(std::move(found));
  }

 private:
  static Finding describe(const SkinLinks& skin, std::size_t patch, const std::optional<Message>& with) {
    std::vector<CellId> cells;
    for (const std::size_t cell : skin.graph().patches()[patch]) cells.push_back(skin.graph().cells()[cell].id);
    const CellId first = cells.front();
    return makeFinding(FindingCode::ContradictsModel,
                       with ? message("The links of the patch of cell {} are turned as on no surface: the axes of the "
                                      "accelerometers or the numbers of the ports are not as in the cell model {}. All "
                                      "links fit, for example, {}. No other fault was looked for.",
                                      first, skin.model().name, *with)
                            : message("The links of the patch of cell {} are turned as on no surface: the axes of the "
                                      "accelerometers or the numbers of the ports are not as in the cell model {}. No "
                                      "other fault was looked for.",
                                      first, skin.model().name),
                       std::move(cells));
  }

  std::size_t revision_ = 0;  // of the links
};

}  // namespace

Explainer makeWholeSkinExplainer() { return {Estimate::Stage::Links, WholeSkin()}; }

}  // namespace hexoderm
