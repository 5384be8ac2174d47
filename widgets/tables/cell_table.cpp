#include "widgets/tables/cell_table.h"

#include "hexoderm/util/units.h"
#include "widgets/tables/table_cells.h"
#include "widgets/tables/table_roles.h"
#include "widgets/words/formatting.h"

#include <array>
#include <cmath>
#include <utility>

namespace hexoderm {
namespace {

enum CellColumn {
  kCell,
  kPatch,
  kX,
  kY,
  kZ,
  kRoll,
  kPitch,
  kYaw,
  kPosition95,
  kOrientation95,
  kPlacedBy,
  kWorstResidual,
  kOffset,
  kScale,
  kCellColumns
};

bool isText(int column) { return column == kPlacedBy; }

int decimalsOf(int column) {
  switch (column) {
    case kX:
    case kY:
    case kZ:
    case kPosition95:
    case kOrientation95:
    case kWorstResidual:
    case kScale:
      return 2;
    default:
      return 1;
  }
}

}  // namespace

void CellTable::rebuild() {
  rows_.clear();
  row_of_.clear();
  if (!reconstruction()) return;
  for (CellSummary& summary : summariseCells(*reconstruction())) {
    row_of_.emplace(summary.cell, static_cast<int>(rows_.size()));
    const Eigen::Vector3d rpy = rpyFromRotation(summary.T_o_u.R);
    rows_.push_back({std::move(summary), rpy});
  }
}

int CellTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int CellTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kCellColumns; }

CellId CellTable::cellAt(int row) const { return rows_.at(static_cast<std::size_t>(row)).summary.cell; }

int CellTable::rowOf(CellId cell) const {
  const auto found = row_of_.find(cell);
  return found == row_of_.end() ? -1 : found->second;
}

QVariant CellTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const CellSummary& cell = row.summary;
  const int column = index.column();
  const auto raw = [&]() -> QVariant {
    switch (column) {
      case kCell:
        return cell.cell.value();
      case kPatch:
        return cell.patch.value() + 1;
      case kX:
      case kY:
      case kZ:
        return toMillimetres(cell.T_o_u.t(column - kX));
      case kRoll:
      case kPitch:
      case kYaw:
        return toDegrees(row.rpy_rad(column - kRoll));
      case kPosition95:
        return cell.stated ? QVariant(toMillimetres(cell.stated->position_m)) : QVariant();
      case kOrientation95:
        return cell.stated ? rawDegrees(cell.stated->orientation_rad) : QVariant();
      case kPlacedBy:
        if (cell.origin) return tr("origin");
        return cell.placed_by == PlacedBy::Samples ? tr("readings") : tr("links");
      case kWorstResidual:
        return rawDegrees(cell.worst_residual_rad);
      case kOffset:
        return cell.offset_g ? QVariant(1000 * cell.offset_g->norm()) : QVariant();
      case kScale:
        return cell.worst_scale_error ? QVariant(100 * *cell.worst_scale_error) : QVariant();
      default:
        return {};
    }
  };
  const auto text = [&]() -> QString {
    const QVariant value = raw();
    if (!value.isValid()) return noValue();
    if (column == kCell || column == kPatch || isText(column)) return value.toString();
    return figureInWords(value.toDouble(), decimalsOf(column));
  };
  switch (role) {
    case Qt::DisplayRole:
      return text();
    case kRawRole:
      return raw();
    case Qt::TextAlignmentRole:
      return alignment(!isText(column));
    case Qt::ToolTipRole:
      return cellToolTip(*reconstruction(), cell.cell);
    case Qt::AccessibleTextRole:
      return column == kCell ? tr("Cell %1").arg(cell.cell.value()) : text();
    default:
      return {};
  }
}

QVariant CellTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= kCellColumns) return {};
  if (role == Qt::TextAlignmentRole) return alignment(!isText(section));
  struct Header {
    QString text;
    QString unit;
    QString explanation;
  };
  const QString mm = QStringLiteral("mm");
  const QString deg = QStringLiteral("deg");
  const QString rpy = tr("Orientation in the patch's frame: roll, pitch and yaw with R = Rz Ry Rx, degrees");
  const QString place = tr("Position in the patch's frame, which is its origin cell's");
  const std::array<Header, kCellColumns> headers = {{
      {tr("Cell"), {}, tr("ID of the cell")},
      {tr("Patch"), {}, tr("Cells joined by rigid links make a patch; each has a frame of its own")},
      {tr("X mm"), mm, place},
      {tr("Y mm"), mm, place},
      {tr("Z mm"), mm, place},
      {tr("Roll °"), deg, rpy},
      {tr("Pitch °"), deg, rpy},
      {tr("Yaw °"), deg, rpy},
      {tr("± mm"), mm, tr("Where the cell is with 95 %, relative to the origin, along the worst direction")},
      {tr("± °"), deg, tr("How the cell lies with 95 %, relative to the origin, about the worst axis")},
      {tr("Placed by"), {}, tr("Whether the cell's own readings place it, or only its links")},
      {tr("Worst residual °"), deg, tr("The largest residual of its links: rms over the poses")},
      {tr("Offset mg"), QStringLiteral("mg"), tr("Estimated offset of the accelerometer: length of the vector")},
      {tr("Scale %"), QStringLiteral("%"), tr("Estimated error of the accelerometer's scale: worst axis")},
  }};
  const Header& header = headers.at(static_cast<std::size_t>(section));
  if (role == Qt::DisplayRole) return header.text;
  if (role == kUnitRole) return header.unit;
  return role == Qt::ToolTipRole ? QVariant(header.explanation) : QVariant();
}

}  // namespace hexoderm
