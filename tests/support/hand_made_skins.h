#pragma once

// Skins made by hand, for tests and benchmarks of what shows and writes results: from no solver and no simulator.

#include "hexoderm/base/units.h"
#include "tests/support/result_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm {

/// As views take what they show.
template <class Value>
std::shared_ptr<const Value> shared(Value value) {
  return std::make_shared<const Value>(std::move(value));
}

/// Properties of an X-shaped patch that is bent around a cylinder.
struct DemoOptions {
  double radius_m = 0.0501;     ///< radius of the cylinder (axis along y of the origin cell)
  std::uint32_t arm_cells = 4;  ///< cells in each of the four arms; 4 makes an X17, 0 a single cell
  std::uint32_t first_id = 1;   ///< the origin; the arms are numbered in turns, as the X17's cells are
  std::array<EdgeQuality, 4> arm_quality = {EdgeQuality::Fully, EdgeQuality::Fully, EdgeQuality::Fully,
                                            EdgeQuality::Fully};
};

/// Adds an X-shaped patch: a chain of linkTransforms along each of the four ports.
inline void addDemoPatch(test::ResultBuilder& builder, const CellModel& model, const DemoOptions& options) {
  builder.patch(options.first_id)
      .gravity(Eigen::Vector3d(0.1, 0.9, 0.3).normalized())
      .gravity(Eigen::Vector3d(0.9, -0.2, 0.3).normalized());
  std::vector<CellPlacement> cells(1 + 4 * options.arm_cells);
  cells[0].cell = CellId(options.first_id);
  std::vector<LinkEstimate> links;
  for (std::uint32_t arm = 0; arm < 4; ++arm) {
    const Port& out = model.port(PortNumber(arm + 1));
    const Port& in = model.port(PortNumber(4 - arm));  // opposite: 1-4, 2-3
    const double bend_rad =
        std::copysign(2 * std::atan(std::abs(out.vector_m.x()) / options.radius_m), out.vector_m.x());
    LinkEstimate link = test::usedLink();
    link.R_c_n = expSO3(bend_rad * Eigen::Vector3d::UnitY());
    link.quality = options.arm_quality.at(arm);
    link.singular_values = {1.0, 0.9, 0.1};
    link.weight = 1;
    link.residual_rad = 0.4 * kDegree;
    link.bend_rad = std::abs(bend_rad);
    link.in_tree = true;
    std::size_t source = 0;
    for (std::uint32_t step = 0; step < options.arm_cells; ++step) {
      const std::size_t target = 1 + arm + 4 * step;
      CellPlacement& cell = cells[target];
      cell.cell = CellId(options.first_id + static_cast<std::uint32_t>(target));
      cell.T_o_u = cells[source].T_o_u * linkTransform(link.R_c_n, out, in);
      cell.predecessor = cells[source].cell;
      link.sigma_rad = (1.0 + step) * kDegree;
      builder.link(cells[source].cell.value(), out.number.value(), cell.cell.value(), in.number.value(), link);
      source = target;
    }
  }
  for (CellPlacement& cell : cells) builder.cell(std::move(cell));
}

/// The same skin as the first result of two poses.
inline Reconstruction ofTwoPoses(Reconstruction result) {
  result.revision = 1;
  result.poses = {{PoseId(1), Message::verbatim("standing"), true, result.cellCount(), 0.0014, std::nullopt, 0.007},
                  {PoseId(2), Message::verbatim("on its side"), true, result.cellCount(), 0.0022, 1.5, 0.009}};
  result.assessment = {.level = VerdictLevel::Usable,
                       .reason = Message::verbatim("Made by hand for a test."),
                       .position_95_m = 0.002,
                       .orientation_95_rad = 0.08,
                       .limit = Limit::Directions,
                       .remedy = Remedy::TakePose,
                       .next_action = Message::verbatim("Take a third pose.")};
  return result;
}

/// A skin of X-shaped patches.
inline Reconstruction demoPatches(const std::vector<DemoOptions>& patches) {
  const CellModel model = builtInCellModel("hex-bma150");
  test::ResultBuilder builder(model);
  for (const DemoOptions& options : patches) addDemoPatch(builder, model, options);
  return ofTwoPoses(builder.build());
}

/// The X17 on a cylinder, all links fully defined unless told otherwise.
inline Reconstruction demoReconstruction(const DemoOptions& options = {}) { return demoPatches({options}); }

/// A flat sheet, every port towards a neighbour linked.
inline Reconstruction sheetReconstruction(std::uint32_t columns, std::uint32_t rows) {
  test::SheetOptions options;
  options.figures = [](std::uint32_t, std::uint32_t, bool) {
    LinkEstimate link = test::usedLink();
    link.quality = EdgeQuality::Fully;
    return link;
  };
  return ofTwoPoses(test::ResultBuilder().sheet(rows, columns, options).gravity(Eigen::Vector3d::UnitZ()).build());
}

/// A sheet laid directly around nine tenths of a cylinder, cells in staggered columns along its axis, every port
/// towards a neighbour linked: what large skins look like. Links don't fit exactly.
inline Reconstruction cylinderSheet(std::uint32_t columns, std::uint32_t rows) {
  CellModel model = builtInCellModel("hex-bma150");
  model.interface_id = CellId(1U << 30);
  const Eigen::Vector3d step = 2 * model.port(PortNumber(1)).vector_m;  // to the right and up
  const double radius_m = step.x() * columns / (0.9 * 2 * kPi);
  const auto idOf = [rows](std::uint32_t column, std::uint32_t row) { return 1 + column * rows + row; };
  test::ResultBuilder builder(model);
  builder.patch(idOf(columns / 2, rows / 2)).gravity(Eigen::Vector3d::UnitY());
  for (std::uint32_t column = 0; column < columns; ++column) {
    const double angle = step.x() * (column - columns / 2.0) / radius_m;
    const Eigen::Matrix3d R = expSO3(angle * Eigen::Vector3d::UnitY());
    for (std::uint32_t row = 0; row < rows; ++row) {
      CellPlacement cell;
      cell.cell = CellId(idOf(column, row));
      const double along_m = step.y() * (2.0 * (row - rows / 2.0) + column % 2);
      cell.T_o_u = {R, R * Eigen::Vector3d(0, 0, radius_m) + Eigen::Vector3d(0, along_m, -radius_m)};
      const double sigma_m = 0.0001 + 0.002 * std::abs(angle) / kPi;
      const double sigma_rad = 0.002 + 0.02 * row / rows;
      cell.cov_t_r = Matrix6d::Zero();
      cell.cov_t_r->diagonal() << Eigen::Vector3d::Constant(sigma_m * sigma_m),
          Eigen::Vector3d::Constant(sigma_rad * sigma_rad);
      builder.cell(std::move(cell));
      if (column + 1 == columns) continue;
      LinkEstimate figures = test::usedLink();
      figures.quality = static_cast<EdgeQuality>((column / 8 + row / 6) % 4);
      figures.residual_rad = 0.3 * kDegree;
      figures.sigma_rad = (0.5 + 0.1 * (column % 40)) * kDegree;
      const std::uint32_t up = row + column % 2;  // in the next column
      if (up < rows) builder.link(idOf(column, row), 1, idOf(column + 1, up), 4, figures);
      if (up > 0) builder.link(idOf(column, row), 2, idOf(column + 1, up - 1), 3, figures);
    }
  }
  Reconstruction result = builder.build();
  result.revision = 1;
  return result;
}

/// A link that was measured and solved, with figures of its own for each quantity.
inline LinkEstimate solvedLink(EdgeQuality quality = EdgeQuality::Fully, bool in_tree = true) {
  LinkEstimate link = test::usedLink();
  link.quality = quality;
  link.in_tree = in_tree;
  link.bend_rad = 12.1 * kDegree;
  link.twist_rad = -0.4 * kDegree;
  link.yaw_rad = -0.01 * kDegree;
  link.residual_rad = 0.3 * kDegree;
  link.sigma_rad = 0.7 * kDegree;
  link.pose_residual_rad = {0.3 * kDegree, 0.3 * kDegree};
  return link;
}

/// Two lines of nine cells that cross at cell 1, the origin; the links run along ports 1-4 and 2-3. Where its cells are
/// in space is not known.
inline std::shared_ptr<Reconstruction> sampleX17() {
  test::ResultBuilder builder;
  builder.patch(1).cells(1, 17);
  constexpr std::uint32_t kOutward[4] = {1, 4, 2, 3};  // ports towards cells 2, 3, 4 and 5
  for (std::uint32_t id = 2; id <= 17; ++id) {
    const std::uint32_t port = kOutward[(id - 2) % 4];
    const auto quality = id == 9 ? EdgeQuality::Partially : EdgeQuality::Fully;
    builder.link(id <= 5 ? 1 : id - 4, port, id, 5 - port, solvedLink(quality));
  }
  auto result = builder.laidOut().share();
  result->poses = {
      {PoseId(1), Message::verbatim("standing"), true, 17, 0.0014, std::nullopt, 0.4 * kDegree},
      {PoseId(2), Message::verbatim("on its side"), true, 17, 0.0022, 86 * kDegree, 0.5 * kDegree},
      {PoseId(3), Message::verbatim("facing wall"), false, 16, 0.0020, 71 * kDegree, std::nullopt},
      {PoseId(4), {}, true, 17, 0, 64 * kDegree, 0.4 * kDegree},
  };
  return result;
}

/// A sheet with regions of each quality and its origin in the middle.
inline std::shared_ptr<Reconstruction> sampleSheet(std::uint32_t rows, std::uint32_t columns) {
  test::SheetOptions options;
  options.origin = rows / 2 * columns + columns / 2 + 1;
  options.figures = [rows](std::uint32_t row, std::uint32_t column, bool along_row) {
    return solvedLink(static_cast<EdgeQuality>((row / 3 + column / 4) % 4), !along_row || row == rows / 2);
  };
  return test::ResultBuilder().sheet(rows, columns, options).laidOut().share();
}

/// A sheet whose residuals differ by link and pose.
inline std::shared_ptr<Reconstruction> sheetWithPoses(std::uint32_t rows, std::uint32_t columns, std::uint32_t poses) {
  auto result = sampleSheet(rows, columns);
  for (std::uint32_t k = 1; k <= poses; ++k) {
    result->poses.push_back({PoseId(k), {}, k % 7 != 3, rows * columns, 0.001, 60 * kDegree, 0.5 * kDegree});
  }
  double phase = 0;
  for (LinkEstimate& link : result->patches[0].links) {
    phase += 0.37;
    link.pose_residual_rad.clear();
    double sum = 0;
    for (std::uint32_t k = 0; k < poses; ++k) {
      const double degrees = 0.6 + 0.5 * std::sin(phase + k) + (std::fmod(phase, 40) < 0.37 ? 1.9 : 0);
      const bool measured = result->poses[k].enabled;
      link.pose_residual_rad.push_back(measured ? std::optional(degrees * kDegree) : std::nullopt);
      sum += measured ? degrees * degrees : 0;
    }
    link.residual_rad = std::sqrt(sum / poses) * kDegree;
  }
  return result;
}

/// Two patches with a muted link between them and one inside of the first.
inline std::shared_ptr<Reconstruction> sampleTwoPatches() {
  const LinkEstimate muted = test::mutedLink(FindingCode::OneSidedLink, solvedLink(EdgeQuality::Undefined));
  auto result = test::ResultBuilder()
                    .patch(1)
                    .cells(1, 4)
                    .link(1, 1, 2, 4, solvedLink(EdgeQuality::Over))
                    .link(2, 2, 3, 3, solvedLink())
                    .link(1, 2, 4, 3, solvedLink(EdgeQuality::Undefined))
                    .link(3, 4, 4, 1, muted)
                    .link(3, 1, 21, 4, muted)
                    .patch(21)
                    .cells(21, 23)
                    .link(21, 1, 22, 4, solvedLink(EdgeQuality::Partially))
                    .link(21, 2, 23, 3, solvedLink())
                    .laidOut()
                    .share();
  result->patches[1].cells[1].placed_by = PlacedBy::Links;
  result->findings = {
      makeFinding(FindingCode::InterfaceLink,
                  Message::verbatim("A computer interface (ID 16383) is connected at cell 1 port 4."), {CellId(1)}),
      makeFinding(FindingCode::OneSidedLink, Message::verbatim("Only cell 3 reports the link 3 port 1 - 21 port 4."),
                  {CellId(3), CellId(21)}),
      makeFinding(FindingCode::DeadSensor, Message::verbatim("Cell 22 reads nothing like gravity."), {CellId(22)}, {},
                  {PoseId(1)}),
      makeFinding(FindingCode::NoPoses, Message::verbatim("No pose has been captured yet.")),
  };
  return result;
}

/// Text that every format has to escape: quote, comma, apostrophe, ampersand, angle brackets, backslash, umlaut.
inline constexpr const char* kAwkwardText = "left \"arm\", Bernd's <R&D> \\ größer";

/// A small result with something of everything: patch 0 with cells 3, 7 (origin) and 12, patch 1 with cell 20 alone;
/// links 3:2-7:3 (fully), 7:2-12:3 (over), 7:1-12:4 (muted, one-sided) and 7:4-20:1 (muted, between the patches); poses
/// 1 (awkward label), 2 (link 3-7 has no residual in it) and 4 (disabled). Every cell but 20 has a sensor off its
/// centre; cell 12 has an awkward body part and no covariance, and is pitched by 90 degrees (gimbal lock).
inline Reconstruction makeTestReconstruction() {
  const SE3 T_o_3{expSO3({0.2, -0.3, 0.1}), {-0.024, 0.0013, -0.0031}};
  const SE3 T_o_12{rotationFromRpy({0.4, 1.5707963267948966, 0}), {0.0123456789012345, 0.007, -0.012}};
  LinkEstimate fully = test::usedLink();
  fully.R_c_n = T_o_3.R.transpose();
  fully.quality = EdgeQuality::Fully;
  fully.singular_values = {1.5, 0.5000000000000001, 0};
  fully.weight = 1;
  fully.residual_rad = 0.01;
  fully.sigma_rad = 0.02;
  fully.bend_rad = -0.3;
  fully.twist_rad = 0.1;
  fully.yaw_rad = 1.0 / 3;
  fully.in_tree = true;
  fully.pose_residual_rad = {0.011, std::nullopt, 0.5};
  LinkEstimate over = fully;
  over.quality = EdgeQuality::Over;
  over.pose_residual_rad = {0.0, 0.02, std::nullopt};
  Reconstruction result = test::ResultBuilder()
                              .patch(7)
                              .cell(3, T_o_3)
                              .cell(7)
                              .cell(12, T_o_12)
                              .gravity(Eigen::Vector3d::UnitZ())
                              .gravity({0.6, 0, 0.8}, 0.02)
                              .link(3, 2, 7, 3, fully)
                              .link(7, 1, 12, 4, test::mutedLink())
                              .link(7, 2, 12, 3, over)
                              .link(7, 4, 20, 1, test::mutedLink(FindingCode::BodyPartBoundary))
                              .patch(20)
                              .cell(20)
                              .build();
  result.solver = "tree";
  result.source.text = Message::verbatim("made by hand");
  result.source.file = "hand \"made\".session.json";

  for (PatchReconstruction& patch : result.patches) {
    for (CellPlacement& cell : patch.cells) {
      if (cell.cell != patch.origin) cell.predecessor = patch.origin;
      cell.cov_t_r = Matrix6d::Zero();
    }
  }
  std::vector<CellPlacement>& cells = result.patches[0].cells;
  cells[0].cov_t_r = 1e-6 * Matrix6d::Identity();
  cells[2].cov_t_r.reset();
  cells[2].placed_by = PlacedBy::Links;
  cells[2].body_part = kAwkwardText;
  const auto addSensor = [](CellPlacement& placement, const std::string& name, const std::string& type) {
    const SE3 T_u_s{expSO3({0.1, -0.2, 0.3}), {0.004, -0.002, -0.001}};
    placement.sensors.push_back({name, type, placement.T_o_u * T_u_s});
  };
  addSensor(cells[0], "accelerometer", "accelerometer");
  addSensor(cells[1], "force \"1\"/größe", "force, normal");
  addSensor(cells[1], "force '1' größe", "force");
  addSensor(cells[2], "", "");

  result.poses.resize(3);
  result.poses[0] = {PoseId(1), Message::verbatim("standing, \"arm\"\nhanging"), true, 4, 0.001, std::nullopt, 0.011};
  result.poses[1] = {PoseId(2), {}, true, 3, 0.0015, 0.6435011087932844, 0.02};
  result.poses[2] = {PoseId(4), Message::verbatim(" größer"), false, 4, 0.002, std::nullopt, std::nullopt};
  result.layout.cells = {{CellId(3), {-0.024, 0.001}, 0.1},
                         {CellId(7), {0, 0}, 0},
                         {CellId(12), {0.024, -0.001}, 0},
                         {CellId(20), {0.0931, 0}, 0}};
  result.assessment.level = VerdictLevel::Usable;
  return result;
}

}  // namespace hexoderm
