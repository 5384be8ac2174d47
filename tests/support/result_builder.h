#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace hexoderm::test {

/// A link of which only its use is known.
inline LinkEstimate usedLink() {
  LinkEstimate link;
  link.used = true;
  return link;
}

/// A muted link: not used, and without residuals.
inline LinkEstimate mutedLink(FindingCode by = FindingCode::OneSidedLink, LinkEstimate link = {}) {
  link.used = link.in_tree = false;
  link.muted_by = by;
  link.residual_rad = link.sigma_rad = 0;
  link.pose_residual_rad.clear();
  return link;
}

/// How the cells of a hand-made sheet are linked.
struct SheetOptions {
  std::uint32_t origin = 1;
  bool closed = false;  ///< the ends of its rows are joined to a tube (the cells lie flat all the same)
  /// What is known of the link from the cell at (row, column), along its row or along its column.
  std::function<LinkEstimate(std::uint32_t row, std::uint32_t column, bool along_row)> figures =
      [](std::uint32_t, std::uint32_t, bool) { return usedLink(); };
};

/// Builds a result by hand, for tests of what reads results; it comes from no solver and no simulator. Cells, links and
/// directions of gravity belong to the last patch.
///
///     ResultBuilder().patch(1).cells(1, 3).link(1, 1, 2, 4).link(2, 1, 3, 4, mutedLink()).build()
class ResultBuilder {
 public:
  explicit ResultBuilder(CellModel model = builtInCellModel("hex-bma150")) {
    result_.model = std::make_shared<const CellModel>(std::move(model));
  }
  /// Goes on with a result that is there.
  explicit ResultBuilder(Reconstruction result) : result_(std::move(result)) {}

  ResultBuilder& patch(std::uint32_t origin) {
    PatchReconstruction& added = result_.patches.emplace_back();
    added.id = PatchId(static_cast<std::uint32_t>(result_.patches.size() - 1));
    added.origin = CellId(origin);
    return *this;
  }
  /// Cells in ascending order of ID, as in every result.
  ResultBuilder& cell(CellPlacement placement) {
    patch_().cells.push_back(std::move(placement));
    return *this;
  }
  ResultBuilder& cell(std::uint32_t id, const SE3& T_o_u = {}) {
    CellPlacement& added = patch_().cells.emplace_back();
    added.cell = CellId(id);
    added.T_o_u = T_o_u;
    return *this;
  }
  ResultBuilder& cells(std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t id = first; id <= last; ++id) cell(id);
    return *this;
  }
  /// A link between two ports, in either order; `figures` are those from the first end.
  ResultBuilder& link(std::uint32_t a, std::uint32_t port_a, std::uint32_t b, std::uint32_t port_b,
                      LinkEstimate figures = usedLink()) {
    figures.source = {CellId(a), PortNumber(port_a)};
    figures.target = {CellId(b), PortNumber(port_b)};
    if (figures.target < figures.source) {
      std::swap(figures.source, figures.target);
      figures.R_c_n.transposeInPlace();
    }
    patch_().links.push_back(std::move(figures));
    return *this;
  }
  /// Rows of cells along ports 1-4, columns along ports 2-3, IDs from 1 row by row.
  ResultBuilder& sheet(std::uint32_t rows, std::uint32_t columns, const SheetOptions& options = {}) {
    const Eigen::Vector3d right_up = 2 * result_.model->port(PortNumber(1)).vector_m;
    const Eigen::Vector3d right_down = 2 * result_.model->port(PortNumber(2)).vector_m;
    const auto place = [&](std::uint32_t id) -> Eigen::Vector3d {
      return 1.0 * ((id - 1) % columns) * right_up + 1.0 * ((id - 1) / columns) * right_down;
    };
    patch(options.origin);
    for (std::uint32_t row = 0; row < rows; ++row) {
      for (std::uint32_t column = 0; column < columns; ++column) {
        const std::uint32_t id = 1 + row * columns + column;
        cell(id, {Eigen::Matrix3d::Identity(), place(id) - place(options.origin)});
        if (column + 1 < columns) link(id, 1, id + 1, 4, options.figures(row, column, true));
        if (row + 1 < rows) link(id, 2, id + columns, 3, options.figures(row, column, false));
        if (options.closed && column + 1 == columns) {
          link(id, 1, id + 1 - columns, 4, options.figures(row, column, true));
        }
      }
    }
    return *this;
  }
  /// What gravity read in the next pose, a unit vector.
  ResultBuilder& gravity(const Eigen::Vector3d& up_o, double sigma_rad = 0.01) {
    const PoseId pose(static_cast<std::uint32_t>(patch_().gravity.size() + 1));
    patch_().gravity.push_back({pose, up_o, sigma_rad});
    return *this;
  }
  /// So many enabled poses, numbered from 1.
  ResultBuilder& poses(std::size_t count) {
    for (std::size_t k = 1; k <= count; ++k) {
      result_.poses.emplace_back().pose = PoseId(static_cast<std::uint32_t>(k));
    }
    return *this;
  }
  /// Computes the flat drawing of what there is.
  ResultBuilder& laidOut() {
    result_.layout = computeFlatLayout(*result_.model, result_.patches);
    return *this;
  }

  [[nodiscard]] Reconstruction build() const { return result_; }
  [[nodiscard]] std::shared_ptr<Reconstruction> share() const { return std::make_shared<Reconstruction>(result_); }

 private:
  PatchReconstruction& patch_() { return result_.patches.back(); }

  Reconstruction result_;
};

}  // namespace hexoderm::test
