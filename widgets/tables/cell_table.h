#pragma once

#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/review_summary.h"
#include "widgets/tables/reconstruction_table.h"
#include "widgets/tables/table_cells.h"
#include "widgets/words/formatting.h"

#include <unordered_map>
#include <utility>
#include <vector>

namespace hexoderm {

/// The columns Cell | Patch | X | Y | Z | Roll | Pitch | Yaw | ± mm | ± ° | Placed by | Worst residual | Offset |
/// Scale; one row per cell, patch by patch, with placements in the frame of the patch's origin.
class CellTableModel : public ReconstructionTable {
  Q_OBJECT

 public:
  explicit CellTableModel(QObject* parent = nullptr) : ReconstructionTable(parent) {
    std::vector<Column> columns;
    const auto add = [&](const QString& name, const QString& unit, int decimals, const QString& explanation,
                         auto value) {
      columns.push_back({.name = name, .unit = unit, .explanation = explanation, .decimals = decimals});
      columns.back().value = [this, value](int row) { return QVariant(value(rows_[static_cast<std::size_t>(row)])); };
    };
    const QString mm = QStringLiteral("mm");
    const QString deg = QStringLiteral("deg");
    add(tr("Cell"), {}, 0, tr("ID of the cell"), [](const Row& row) { return row.summary.cell.value(); });
    columns.back().spoken = [this](int row) { return tr("Cell %1").arg(cellAt(row).value()); };
    add(tr("Patch"), {}, 0, tr("Cells joined by rigid links make a patch; each has a frame of its own"),
        [](const Row& row) { return row.summary.patch.value() + 1; });
    const auto addPlace = [&](const QString& name, int axis) {
      add(name, mm, 2, tr("Position in the patch's frame, which is its origin cell's"),
          [axis](const Row& row) { return toMillimetres(row.summary.T_o_u.t(axis)); });
    };
    addPlace(tr("X mm"), 0);
    addPlace(tr("Y mm"), 1);
    addPlace(tr("Z mm"), 2);
    const auto addAngle = [&](const QString& name, int angle) {
      add(name, deg, 1, tr("Orientation in the patch's frame: roll, pitch and yaw with R = Rz Ry Rx, degrees"),
          [angle](const Row& row) { return toDegrees(row.rpy_rad(angle)); });
    };
    addAngle(tr("Roll °"), 0);
    addAngle(tr("Pitch °"), 1);
    addAngle(tr("Yaw °"), 2);
    add(tr("± mm"), mm, 2, tr("Where the cell is with 95 %, relative to the origin, along the worst direction"),
        [](const Row& row) {
          const auto& stated = row.summary.stated;
          return stated ? QVariant(toMillimetres(stated->position_m)) : QVariant();
        });
    add(tr("± °"), deg, 2, tr("How the cell lies with 95 %, relative to the origin, about the worst axis"),
        [](const Row& row) {
          const auto& stated = row.summary.stated;
          return stated ? rawDegrees(stated->orientation_rad) : QVariant();
        });
    add(tr("Placed by"), {}, 0, tr("Whether the cell's own readings place it, or only its links"), [](const Row& row) {
      if (row.summary.origin) return tr("origin");
      return row.summary.placed_by == PlacedBy::Samples ? tr("readings") : tr("links");
    });
    columns.back().is_text = true;
    add(tr("Worst residual °"), deg, 2, tr("The largest residual of its links: rms over the poses"),
        [](const Row& row) { return rawDegrees(row.summary.worst_residual_rad); });
    add(tr("Offset mg"), QStringLiteral("mg"), 1, tr("Estimated offset of the accelerometer: length of the vector"),
        [](const Row& row) {
          const auto& offset_g = row.summary.offset_g;
          return offset_g ? QVariant(1000 * offset_g->norm()) : QVariant();
        });
    add(tr("Scale %"), QStringLiteral("%"), 2, tr("Estimated error of the accelerometer's scale: worst axis"),
        [](const Row& row) {
          const auto& error = row.summary.worst_scale_error;
          return error ? QVariant(100 * *error) : QVariant();
        });
    setColumns(std::move(columns));
  }

  [[nodiscard]] CellId cellAt(int row) const { return rows_.at(static_cast<std::size_t>(row)).summary.cell; }

  /// -1 if there is none.
  [[nodiscard]] int rowOf(CellId cell) const {
    const auto found = row_of_.find(cell);
    return found == row_of_.end() ? -1 : found->second;
  }

 protected:
  [[nodiscard]] int rows() const override { return static_cast<int>(rows_.size()); }

  [[nodiscard]] QVariant ofRow(int row, int role) const override {
    return role == Qt::ToolTipRole ? cellToolTip(*reconstruction(), cellAt(row)) : QVariant();
  }

  void rebuild() override {
    rows_.clear();
    row_of_.clear();
    if (!reconstruction()) return;
    for (CellSummary& summary : summariseCells(*reconstruction())) {
      row_of_.emplace(summary.cell, static_cast<int>(rows_.size()));
      const Eigen::Vector3d rpy = rpyFromRotation(summary.T_o_u.R);
      rows_.push_back({std::move(summary), rpy});
    }
  }

 private:
  struct Row {
    CellSummary summary;
    Eigen::Vector3d rpy_rad;
  };
  std::vector<Row> rows_;
  std::unordered_map<CellId, int> row_of_;
};

}  // namespace hexoderm
