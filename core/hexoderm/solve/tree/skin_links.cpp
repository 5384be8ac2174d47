#include "hexoderm/solve/tree/skin_links.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/units.h"
#include "hexoderm/skin/shortest_paths.h"
#include "hexoderm/solve/tree/edge_batches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hexoderm {
namespace {

SkinGraph makeGraph(const SessionSnapshot& snapshot, std::vector<Finding>& findings) {
  SkinGraph graph(*snapshot.model, *snapshot.neighbors);
  findings.insert(findings.end(), graph.findings().begin(), graph.findings().end());
  return graph;
}

double weightOf(const EdgeRotation& edge, LinkWeights weights) {
  if (weights == LinkWeights::Paper) return paperWeight(edge.quality);
  // In degrees, so that it reads like the figures beside it; never so small that a path of many links costs nothing.
  constexpr double kMin = 0.1;
  return std::max(kMin, toDegrees(std::hypot(std::min(kPi, edge.deviation_rad), edge.residual_rad)));
}

}  // namespace

SkinLinks::SkinLinks(const SessionSnapshot& snapshot, const SolverOptions& options, std::vector<Finding>& findings)
    : snapshot_(snapshot),
      options_(options),
      model_(*snapshot.model),
      graph_(makeGraph(snapshot, findings)),
      table_(snapshot, graph_, findings),
      readings_(model_, graph_, table_) {}

PoseId SkinLinks::poseId(std::size_t pose) const { return snapshot_.poses[pose].capture->id; }

void SkinLinks::dropCell(std::size_t cell) {
  for (std::size_t pose = 0; pose < table_.poseCount(); ++pose) table_.at(cell, pose).usable = false;
}

void SkinLinks::dropPose(std::size_t pose) {
  for (std::size_t cell = 0; cell < table_.cellCount(); ++cell) table_.at(cell, pose).usable = false;
}

void SkinLinks::correct(std::size_t cell, std::size_t pose, const Eigen::Vector3d& added_g, double variance_g2) {
  GravityTable::Entry& entry = table_.at(cell, pose);
  entry.mean_g -= added_g;
  entry.variance_g2 += variance_g2;
}

void SkinLinks::estimateEdges() {
  readings_ = SkinReadings(model_, graph_, table_);
  edges_.assign(graph_.links().size(), {});
  pose_residuals_.assign(edges_.size() * table_.poseCount(), std::nullopt);
  std::vector<std::size_t> all(edges_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  estimate(all);
}

std::vector<std::size_t> SkinLinks::estimateEdgesAround(std::size_t cell) {
  std::vector<std::size_t> links;
  for (const std::size_t changed : readings_.update(model_, graph_, cell)) {
    const auto& at = graph_.linksAt(changed);
    links.insert(links.end(), at.begin(), at.end());
  }
  std::ranges::sort(links);
  links.erase(std::unique(links.begin(), links.end()), links.end());
  estimate(links);
  return links;
}

void SkinLinks::estimate(std::span<const std::size_t> links) {
  for (const std::size_t link : estimateUsualEdges(*this, links, edges_, pose_residuals_)) estimateCarefully(link);
}

void SkinLinks::estimateCarefully(std::size_t index) {
  const GraphLink& link = graph_.links()[index];
  const EdgeReadings readings = readings_.readingsOf(link);
  EdgeRotation edge = estimateEdgeRotation(model_, sourcePort(link), targetPort(link), readings, options_);
  const auto residuals = std::span(pose_residuals_).subspan(index * table_.poseCount(), table_.poseCount());
  std::ranges::fill(residuals, std::nullopt);
  if (readings_.measured(link)) {
    std::size_t k = 0;
    for (const std::size_t pose : readings_.posesOf(link)) residuals[pose] = edge.pose_residual_rad[k++];
  } else if (readings.n_g.cols() > 0) {
    markAsGuessed(edge, link);
  }
  edge.pose_residual_rad = {};
  edges_[index] = std::move(edge);
}

/// One end does not measure: the rotation is interpolated, and nothing but the elastomer prior speaks for it.
void SkinLinks::markAsGuessed(EdgeRotation& edge, const GraphLink& link) const {
  edge.quality = EdgeQuality::Undefined;
  edge.singular_values.setZero();
  edge.residual_rad = 0;
  edge.expected_residual_rad = 0;
  edge.prior_part.setZero();  // it is the blind cell that may lie otherwise, not what comes after it
  edge.covariance = elastomerPrior(sourcePort(link));
  edge.deviation_rad = largestDeviation(edge.covariance);
}

/// How far a link may bend, twist and yaw, as a covariance in the frame of the cell that the port belongs to.
Eigen::Matrix3d SkinLinks::elastomerPrior(const Port& port) const {
  const Eigen::Matrix3d axes = linkAxes(port);
  const Eigen::Vector3d prior(model_.twist_sigma_rad, model_.bend_sigma_rad, model_.yaw_sigma_rad);
  return axes * prior.cwiseAbs2().asDiagonal() * axes.transpose();
}

Eigen::Matrix3d SkinLinks::attitudeCovariance(std::size_t cell, std::size_t link_index) const {
  if (readings_.interpolated(cell) && link_index != kNoIndex) {
    const GraphLink& link = graph_.links()[link_index];
    const auto sides = std::ranges::count_if(graph_.linksAt(cell), [&](std::size_t k) {
      return !graph_.links()[k].muted() && readings_.measured(graph_.links()[k].other(cell));
    });
    // Half way between two neighbours, half of each link's bend is what may be wrong.
    return elastomerPrior(link.source == cell ? sourcePort(link) : targetPort(link)) / (sides >= 2 ? 2 : 1);
  }
  const EdgeRotation* edge = link_index == kNoIndex ? nullptr : &edges_[link_index];
  const std::vector<std::size_t> poses = table_.usablePoses(cell);
  Eigen::Matrix3Xd g(3, static_cast<Eigen::Index>(poses.size()));
  std::vector<double> variance;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    g.col(static_cast<Eigen::Index>(k)) = table_.at(cell, poses[k]).mean_g;
    variance.push_back(table_.at(cell, poses[k]).variance_g2);
  }
  const bool centred = edge != nullptr && edge->centred && poses.size() >= 3;
  const bool supported = edge == nullptr || edge->supported || poses.size() < 2;
  return cellAttitudeCovariance(model_.accelerometer, g, variance, centred, supported);
}

std::vector<double> linkWeights(const SkinLinks& skin) {
  std::vector<double> weights;
  for (const EdgeRotation& edge : skin.edges()) weights.push_back(weightOf(edge, skin.options().weights));
  return weights;
}

}  // namespace hexoderm
