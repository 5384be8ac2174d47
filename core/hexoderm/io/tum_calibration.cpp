#include "hexoderm/io/tum_xml.h"
#include "hexoderm/skin/skin_graph.h"
#include "hexoderm/solve/faults/link_plausibility.h"

#include <algorithm>
#include <unordered_map>

namespace hexoderm {
namespace {

NeighborList neighborList(const TumSkinConfig& config) {
  NeighborList neighbors;
  for (const TumSkinConfig::Cell& cell : config.cells) neighbors.push_back(cell.report);
  return neighbors;
}

SourceDescription sourceDescription(const TumSkinConfig& config, const std::string& file, bool with_placements) {
  const std::string name = std::filesystem::path(file).filename().string();
  return {with_placements ? message("Placements of the TUM skin configuration {}", name)
                          : message("Topology of the TUM skin configuration {}", name),
          name, config.sha256};
}

/// The placements of a configuration as a calibration.
class Importer {
 public:
  Importer(const TumSkinConfig& config, const CellModel& model) : model_(model), graph_(model, neighborList(config)) {
    for (const TumSkinConfig::Cell& cell : config.cells) cells_.emplace(cell.report.id, &cell);
    findings_ = graph_.findings();
    muteLinksBetweenFrames();
  }

  std::vector<PatchReconstruction> patches() {
    std::vector<PatchReconstruction> patches;
    for (const std::vector<std::size_t>& members : graph_.patches()) patches.push_back(patchOf(members));
    for (const GraphLink& link : graph_.links()) {
      patches[graph_.cells()[link.source].patch.value()].links.push_back(estimateOf(link));
    }
    return patches;
  }

  [[nodiscard]] std::vector<Finding> takeFindings() { return std::move(findings_); }

 private:
  [[nodiscard]] const TumSkinConfig::Cell& cellAt(std::size_t index) const {
    return *cells_.at(graph_.cells()[index].id);
  }
  [[nodiscard]] bool shareFrame(const GraphLink& link) const {
    return cellAt(link.source).root == cellAt(link.target).root;
  }

  /// The file does not tell the relative placement of two cells that are placed in frames of different root cells.
  void muteLinksBetweenFrames() {
    std::vector<std::size_t> between;
    for (std::size_t k = 0; k < graph_.links().size(); ++k) {
      const GraphLink& link = graph_.links()[k];
      if (link.muted() || shareFrame(link)) continue;
      between.push_back(k);
      const LinkEnd source = graph_.sourceEnd(link);
      const LinkEnd target = graph_.targetEnd(link);
      findings_.push_back(
          makeFinding(FindingCode::BodyPartBoundary,
                      message("The {} joins cells that the file places in different frames (root cells {} and {}); the "
                              "patch ends there.",
                              linkText(source, target), cellAt(link.source).root, cellAt(link.target).root),
                      {source.cell, target.cell}, {source.port, target.port}));
    }
    if (!between.empty()) graph_.mute(between, FindingCode::BodyPartBoundary);
  }

  PatchReconstruction patchOf(const std::vector<std::size_t>& members) const {
    PatchReconstruction patch;
    patch.id = graph_.cells()[members.front()].patch;
    const CellId root = cellAt(members.front()).root;
    const auto found = std::ranges::find_if(members, [&](std::size_t k) { return graph_.cells()[k].id == root; });
    const TumSkinConfig::Cell& origin = cellAt(found != members.end() ? *found : members.front());
    patch.origin = origin.report.id;
    const SE3 T_o_root = origin.T_root_u.inverse();
    for (const std::size_t k : members) {
      CellPlacement placement;
      placement.cell = graph_.cells()[k].id;
      placement.body_part = graph_.cells()[k].body_part;
      if (placement.cell != patch.origin) placement.T_o_u = T_o_root * cellAt(k).T_root_u;
      for (const CellSensor& sensor : model_.sensors) {
        placement.sensors.push_back({sensor.name, sensor.type, placement.T_o_u * sensor.T_u_s});
      }
      patch.cells.push_back(std::move(placement));
    }
    return patch;
  }

  LinkEstimate estimateOf(const GraphLink& link) {
    LinkEstimate estimate;
    estimate.source = graph_.sourceEnd(link);
    estimate.target = graph_.targetEnd(link);
    estimate.muted_by = link.muted_by;
    estimate.used = !link.muted();
    const Port& source = model_.port(link.source_port);
    const Port& target = model_.port(link.target_port);
    if (!shareFrame(link)) {
      estimate.R_c_n = nominalAlignment(source, target);
      return estimate;
    }
    estimate.R_c_n = cellAt(link.source).T_root_u.R.transpose() * cellAt(link.target).T_root_u.R;
    const LinkAngles angles = linkAngles(estimate.R_c_n, source, target);
    estimate.bend_rad = angles.bend_rad;
    estimate.twist_rad = angles.twist_rad;
    estimate.yaw_rad = angles.yaw_rad;
    if (estimate.used) {
      std::ranges::move(judgeLinkAngles(angles, estimate.source, estimate.target, model_, SolverOptions{}, {}),
                        std::back_inserter(findings_));
    }
    return estimate;
  }

  const CellModel& model_;
  SkinGraph graph_;
  std::unordered_map<CellId, const TumSkinConfig::Cell*> cells_;
  std::vector<Finding> findings_;
};

}  // namespace

Session sessionFromTum(const TumSkinConfig& config, const CellModel& model, const std::string& file) {
  return {model, neighborList(config), sourceDescription(config, file, false)};
}

std::shared_ptr<const Reconstruction> calibrationFromTum(const TumSkinConfig& config, const CellModel& model,
                                                         const std::string& file) {
  Reconstruction result;
  result.solver = "imported";
  result.source = sourceDescription(config, file, true);
  result.model = std::make_shared<const CellModel>(model);
  Importer importer(config, *result.model);
  result.patches = importer.patches();
  result.findings = importer.takeFindings();
  result.assessment.level = VerdictLevel::Usable;
  result.assessment.reason = message("Imported placements; nothing was measured here.");
  result.assessment.next_action = message("Check the findings, then export, or take poses of this skin to measure it.");
  result.layout = computeFlatLayout(*result.model, result.patches);
  return std::make_shared<const Reconstruction>(std::move(result));
}

}  // namespace hexoderm
