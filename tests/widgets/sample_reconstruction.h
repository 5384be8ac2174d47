#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"
#include "hexoderm/util/units.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

inline LinkEstimate sampleLink(std::uint32_t a, std::uint32_t port_a, std::uint32_t b, std::uint32_t port_b,
                               EdgeQuality quality = EdgeQuality::Fully, bool in_tree = true) {
  LinkEstimate link;
  link.source = {CellId(a), PortNumber(port_a)};
  link.target = {CellId(b), PortNumber(port_b)};
  if (link.target < link.source) std::swap(link.source, link.target);
  link.quality = quality;
  link.used = true;
  link.in_tree = in_tree;
  link.bend_rad = 12.1 * kDegree;
  link.twist_rad = -0.4 * kDegree;
  link.yaw_rad = -0.01 * kDegree;
  link.residual_rad = 0.3 * kDegree;
  link.sigma_rad = 0.7 * kDegree;
  link.pose_residual_rad = {0.3 * kDegree, 0.3 * kDegree};
  return link;
}

inline LinkEstimate mutedLink(std::uint32_t a, std::uint32_t port_a, std::uint32_t b, std::uint32_t port_b) {
  LinkEstimate link = sampleLink(a, port_a, b, port_b, EdgeQuality::Undefined, false);
  link.used = false;
  link.muted_by = FindingCode::OneSidedLink;
  link.residual_rad = link.sigma_rad = 0;
  link.pose_residual_rad.clear();
  return link;
}

inline PatchReconstruction samplePatch(std::uint32_t number, std::vector<std::uint32_t> ids,
                                       std::vector<LinkEstimate> links) {
  PatchReconstruction patch;
  patch.id = PatchId(number);
  patch.origin = CellId(ids.front());
  std::ranges::sort(ids);
  for (const std::uint32_t id : ids) {
    patch.cells.emplace_back();
    patch.cells.back().cell = CellId(id);
  }
  patch.links = std::move(links);
  return patch;
}

inline std::shared_ptr<Reconstruction> sampleReconstruction(std::vector<PatchReconstruction> patches) {
  auto reconstruction = std::make_shared<Reconstruction>();
  reconstruction->model = std::make_shared<CellModel>(builtInCellModel("hex-bma150"));
  reconstruction->patches = std::move(patches);
  reconstruction->layout = computeFlatLayout(*reconstruction->model, reconstruction->patches);
  return reconstruction;
}

/// Two lines of nine cells that cross at cell 1, the origin; the links run along ports 1-4 and 2-3.
inline std::shared_ptr<Reconstruction> sampleX17() {
  std::vector<std::uint32_t> ids = {1};
  std::vector<LinkEstimate> links;
  for (std::uint32_t id = 2; id <= 17; ++id) ids.push_back(id);
  constexpr std::uint32_t kOutward[4] = {1, 4, 2, 3};  // ports towards cells 2, 3, 4 and 5
  for (std::uint32_t id = 2; id <= 17; ++id) {
    const std::uint32_t port = kOutward[(id - 2) % 4];
    links.push_back(sampleLink(id <= 5 ? 1 : id - 4, port, id, 5 - port));
  }
  links[7].quality = EdgeQuality::Partially;  // 5 to 9
  auto reconstruction = sampleReconstruction({samplePatch(0, ids, links)});
  reconstruction->poses = {
      {PoseId(1), Message::verbatim("standing"), true, 17, 0.0014, std::nullopt, 0.4 * kDegree},
      {PoseId(2), Message::verbatim("on its side"), true, 17, 0.0022, 86 * kDegree, 0.5 * kDegree},
      {PoseId(3), Message::verbatim("facing wall"), false, 16, 0.0020, 71 * kDegree, std::nullopt},
      {PoseId(4), {}, true, 17, 0, 64 * kDegree, 0.4 * kDegree},
  };
  return reconstruction;
}

/// Rows along ports 1-4, columns along ports 2-3; `closed` joins the ends of the rows to a tube.
inline std::shared_ptr<Reconstruction> sampleSheet(std::uint32_t rows, std::uint32_t columns, bool closed = false) {
  std::vector<std::uint32_t> ids = {rows / 2 * columns + columns / 2 + 1};
  std::vector<LinkEstimate> links;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t id = 1 + row * columns + column;
      if (id != ids.front()) ids.push_back(id);
      const auto quality = static_cast<EdgeQuality>((row / 3 + column / 4) % 4);
      if (column + 1 < columns) links.push_back(sampleLink(id, 1, id + 1, 4, quality, row == rows / 2));
      if (row + 1 < rows) links.push_back(sampleLink(id, 2, id + columns, 3, quality, true));
      if (closed && column == 0) links.push_back(sampleLink(id + columns - 1, 1, id, 4, quality, false));
    }
  }
  return sampleReconstruction({samplePatch(0, ids, links)});
}

/// A sheet whose residuals differ by link and pose.
inline std::shared_ptr<Reconstruction> sheetWithPoses(std::uint32_t rows, std::uint32_t columns, std::uint32_t poses) {
  auto reconstruction = sampleSheet(rows, columns);
  for (std::uint32_t k = 1; k <= poses; ++k) {
    reconstruction->poses.push_back({PoseId(k), {}, k % 7 != 3, rows * columns, 0.001, 60 * kDegree, 0.5 * kDegree});
  }
  double phase = 0;
  for (LinkEstimate& link : reconstruction->patches[0].links) {
    phase += 0.37;
    link.pose_residual_rad.clear();
    double sum = 0;
    for (std::uint32_t k = 0; k < poses; ++k) {
      const double degrees = 0.6 + 0.5 * std::sin(phase + k) + (std::fmod(phase, 40) < 0.37 ? 1.9 : 0);
      const bool measured = reconstruction->poses[k].enabled;
      link.pose_residual_rad.push_back(measured ? std::optional(degrees * kDegree) : std::nullopt);
      sum += measured ? degrees * degrees : 0;
    }
    link.residual_rad = std::sqrt(sum / poses) * kDegree;
  }
  return reconstruction;
}

/// Two patches with a muted link between them and one inside of the first.
inline std::shared_ptr<Reconstruction> sampleTwoPatches() {
  const std::vector<LinkEstimate> first = {sampleLink(1, 1, 2, 4, EdgeQuality::Over), sampleLink(2, 2, 3, 3),
                                           sampleLink(1, 2, 4, 3, EdgeQuality::Undefined), mutedLink(3, 4, 4, 1),
                                           mutedLink(3, 1, 21, 4)};
  const std::vector<LinkEstimate> second = {sampleLink(21, 1, 22, 4, EdgeQuality::Partially),
                                            sampleLink(21, 2, 23, 3, EdgeQuality::Fully)};
  auto reconstruction =
      sampleReconstruction({samplePatch(0, {1, 2, 3, 4}, first), samplePatch(1, {21, 22, 23}, second)});
  reconstruction->patches[1].cells[1].placed_by = PlacedBy::Links;
  reconstruction->findings = {
      makeFinding(FindingCode::InterfaceLink,
                  Message::verbatim("A computer interface (ID 16383) is connected at cell 1 port 4."), {CellId(1)}),
      makeFinding(FindingCode::OneSidedLink, Message::verbatim("Only cell 3 reports the link 3 port 1 - 21 port 4."),
                  {CellId(3), CellId(21)}),
      makeFinding(FindingCode::DeadSensor, Message::verbatim("Cell 22 reads nothing like gravity."), {CellId(22)}, {},
                  {PoseId(1)}),
      makeFinding(FindingCode::NoPoses, Message::verbatim("No pose has been captured yet.")),
  };
  return reconstruction;
}

}  // namespace hexoderm
