#include "hexoderm/solve/sensor_statistics.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"
#include "hexoderm/skin/breadth_first.h"
#include "hexoderm/skin/skin_graph_boost.h"
#include "hexoderm/solve/solve.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace hexoderm {
namespace {

/// Cells that hang together, the largest patch's first.
std::unordered_set<CellId> chooseCells(const SkinGraph& graph) {
  std::vector<const std::vector<std::size_t>*> patches;
  for (const std::vector<std::size_t>& patch : graph.patches()) patches.push_back(&patch);
  std::ranges::stable_sort(patches, std::ranges::greater(), [](const auto* patch) { return patch->size(); });
  std::unordered_set<CellId> ids;
  BreadthFirst search(graph);
  for (const std::vector<std::size_t>* patch : patches) {
    std::vector<std::size_t> cells = search.searchFrom(patch->front());
    cells.resize(std::min(cells.size(), kMaxCellsForSensors - ids.size()));
    for (const std::size_t cell : cells) ids.insert(graph.cells()[cell].id);
  }
  return ids;
}

std::shared_ptr<const PoseCapture> partOf(const PoseCapture& pose, const std::unordered_set<CellId>& cells) {
  auto part = std::make_shared<PoseCapture>(pose);
  std::erase_if(part->samples, [&](const GravitySample& sample) { return !cells.contains(sample.cell); });
  return part;
}

/// A skin of at most kMaxCellsForSensors cells.
SessionSnapshot partOf(const SessionSnapshot& session) {
  SessionSnapshot part = session;
  const SkinGraph graph(*session.model, *session.neighbors);
  if (graph.cells().size() <= kMaxCellsForSensors) return part;
  const std::unordered_set<CellId> cells = chooseCells(graph);
  NeighborList neighbors = *session.neighbors;
  std::erase_if(neighbors, [&](const CellReport& cell) { return !cells.contains(cell.id); });
  for (CellReport& cell : neighbors) {
    std::erase_if(cell.neighbors, [&](const NeighborReport& report) { return !cells.contains(report.cell); });
  }
  part.neighbors = std::make_shared<const NeighborList>(std::move(neighbors));
  for (SessionPose& pose : part.poses) pose.capture = partOf(*pose.capture, cells);
  return part;
}

/// A sensor that is said to have no errors at all would never show any.
Accelerometer withLeastSigmas(Accelerometer accelerometer) {
  constexpr double kMinOffset_g = 1e-4;
  constexpr double kMinGain = 1e-4;
  accelerometer.offset_sigma_g = accelerometer.offset_sigma_g.cwiseMax(kMinOffset_g);
  accelerometer.scale_sigma = std::max(accelerometer.scale_sigma, kMinGain);
  accelerometer.cross_axis_sigma = std::max(accelerometer.cross_axis_sigma, kMinGain);
  return accelerometer;
}

bool isSettled(const Accelerometer& before, const Accelerometer& after) {
  constexpr double kSettled = 0.01;
  const auto same = [](double a, double b) { return std::abs(a - b) <= kSettled * a; };
  return same(before.ofUnknownLot().largestOffsetSigma_g(), after.ofUnknownLot().largestOffsetSigma_g()) &&
         same(before.scale_sigma, after.scale_sigma) && same(before.scale_shared_sigma, after.scale_shared_sigma) &&
         same(before.cross_axis_sigma, after.cross_axis_sigma);
}

void requireOneModel(std::span<const std::shared_ptr<const SessionSnapshot>> sessions) {
  if (sessions.empty()) throw InvalidArgument(message("there is no session to estimate sensors from"));
  const CellModel& first = *sessions.front()->model;
  for (const auto& session : sessions) {
    if (cellModelToJson(*session->model) == cellModelToJson(first)) continue;
    throw InvalidArgument(
        message("the sessions must have one cell model, and those of session {} and session 1 ({} and {}) differ",
                &session - sessions.data() + 1, excerptOf(session->model->name), excerptOf(first.name)));
  }
}

class Estimation {
 public:
  explicit Estimation(std::span<const std::shared_ptr<const SessionSnapshot>> sessions)
      : model_(*sessions.front()->model) {
    for (const auto& session : sessions) sessions_.push_back(partOf(*session));
    for (std::size_t a = 0; a < sessions.size(); ++a) {
      result_.cells += sessions[a]->neighbors->size();
      for (std::size_t b = a + 1; b < sessions.size(); ++b) {
        if (*sessions[a]->neighbors == *sessions[b]->neighbors) result_.same_cells.emplace_back(a, b);
      }
    }
  }

  std::optional<SensorStatistics> run(const std::stop_token& stop) {
    constexpr int kMaxRounds = 10;
    Accelerometer prior = withLeastSigmas(model_.accelerometer);
    // What a lot has in common must not pass for broken sensors before it is known.
    prior.offset_shared_sigma_g = std::max(prior.offset_shared_sigma_g, 0.05);
    prior.scale_shared_sigma = std::max(prior.scale_shared_sigma, 0.1);
    while (!result_.settled && result_.rounds < kMaxRounds) {
      const std::optional<std::vector<SensorEvidence>> evidence = collect(prior, stop);
      if (!evidence) return std::nullopt;
      result_.sigmas = estimateSensorSigmas(*evidence, model_.accelerometer);
      const Accelerometer next = withLeastSigmas(result_.sigmas.inModel(model_.accelerometer));
      result_.settled = isSettled(prior, next);
      prior = next;
      ++result_.rounds;
    }
    result_.model = model_;
    result_.model.accelerometer = result_.sigmas.inModel(model_.accelerometer);
    return result_;
  }

 private:
  /// Of all patches; null if it was stopped.
  std::optional<std::vector<SensorEvidence>> collect(const Accelerometer& prior, const std::stop_token& stop) {
    const auto model = std::make_shared<CellModel>(model_);
    model->accelerometer = prior;
    result_.cells_used = result_.readings = 0;
    std::vector<SensorEvidence> evidence;
    for (SessionSnapshot& session : sessions_) {
      session.model = model;
      const SolverOptions options;
      const std::unique_ptr<const Estimate> solved = solveSkin(session, options, nullptr, stop);
      if (solved == nullptr) return std::nullopt;
      for (const PatchSolver& patch : solved->patches()) {
        if (patch.cells().size() < 2) continue;
        evidence.push_back(patch.joint()->sensorEvidence());
        count(patch);
      }
    }
    return evidence;
  }

  void count(const PatchSolver& patch) {
    for (const std::size_t cell : patch.cells()) {
      const std::size_t readings = patch.joint()->readingsOf(cell).size();
      if (readings < 2) continue;
      ++result_.cells_used;
      result_.readings += readings;
    }
  }

  CellModel model_;
  std::vector<SessionSnapshot> sessions_;
  SensorStatistics result_;
};

}  // namespace

bool SensorStatistics::knowsAnything() const {
  const auto knows = [](const SigmaEstimate& estimate) { return estimate.knowledge != SigmaKnowledge::Unknown; };
  return knows(sigmas.offset_g) || knows(sigmas.scale) || knows(sigmas.cross_axis);
}

std::optional<SensorStatistics> estimateSensorStatistics(
    std::span<const std::shared_ptr<const SessionSnapshot>> sessions, const std::stop_token& stop) {
  requireOneModel(sessions);
  return Estimation(sessions).run(stop);
}

}  // namespace hexoderm
