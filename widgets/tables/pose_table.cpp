#include "widgets/tables/pose_table.h"

#include "widgets/tables/table_cells.h"
#include "widgets/tables/table_roles.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <array>
#include <utility>

namespace hexoderm {
namespace {

enum PoseColumn { kPose, kLabel, kCells, kNoise, kNewBy, kPoseResidual, kPoseColumns };

QString poseText(const Reconstruction& reconstruction, const PoseSummary& pose, int column) {
  switch (column) {
    case kPose:
      return QString::number(pose.pose.value());
    case kLabel:
      return pose.label.empty() ? noValue() : words(pose.label);
    case kCells:
      return QStringLiteral("%1/%2").arg(pose.cells_measured).arg(reconstruction.cellCount());
    case kNoise:
      return pose.noise_g > 0 ? figureInWords(1000 * pose.noise_g, 1) : noValue();
    case kNewBy:
      return pose.new_by_rad ? wholeDegreesInWords(*pose.new_by_rad) : noValue();
    case kPoseResidual:
      return degreesInWords(pose.residual_rad);
    default:
      return {};
  }
}

QVariant poseRaw(const PoseSummary& pose, int column) {
  switch (column) {
    case kPose:
      return pose.pose.value();
    case kLabel:
      return words(pose.label);
    case kCells:
      return static_cast<qulonglong>(pose.cells_measured);
    case kNoise:
      return pose.noise_g > 0 ? QVariant(1000 * pose.noise_g) : QVariant();
    case kNewBy:
      return rawDegrees(pose.new_by_rad);
    case kPoseResidual:
      return rawDegrees(pose.residual_rad);
    default:
      return {};
  }
}

}  // namespace

int PoseTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !reconstruction() ? 0 : static_cast<int>(reconstruction()->poses.size());
}

int PoseTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kPoseColumns; }

QVariant PoseTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const PoseSummary& pose = reconstruction()->poses[static_cast<std::size_t>(index.row())];
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
      return poseText(*reconstruction(), pose, column);
    case kRawRole:
      return poseRaw(pose, column);
    case Qt::DecorationRole:
      return column == kPose ? QVariant(usedMark(pose.enabled)) : QVariant();
    case Qt::TextAlignmentRole:
      return alignment(column >= kCells);
    case Qt::ForegroundRole:
      return pose.enabled ? QVariant() : mutedForeground();
    case Qt::ToolTipRole:
      if (!pose.enabled) return tr("Pose %1 is disabled: it is kept, but not used.").arg(pose.pose.value());
      if (column == kLabel) return words(pose.label);
      if (column == kCells && pose.cells_measured < reconstruction()->cellCount()) {
        return tr("%1 cells gave no reading in this pose.").arg(reconstruction()->cellCount() - pose.cells_measured);
      }
      if (column == kNewBy && !pose.new_by_rad) return tr("There is no earlier pose to compare it with.");
      return headerData(column, Qt::Horizontal, Qt::ToolTipRole);
    case Qt::AccessibleTextRole:
      if (column != kPose) return poseText(*reconstruction(), pose, column);
      return (pose.enabled ? tr("Pose %1, used") : tr("Pose %1, disabled")).arg(pose.pose.value());
    default:
      return {};
  }
}

QVariant PoseTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= kPoseColumns) return {};
  if (role == Qt::TextAlignmentRole) return alignment(section >= kCells);
  if (role == kUnitRole) {
    if (section == kNoise) return QStringLiteral("mg");
    return section > kNoise ? QStringLiteral("deg") : QString();
  }
  const std::array<std::pair<QString, QString>, kPoseColumns> headers = {{
      {tr("Pose"), tr("Number of the pose; a check mark if it is used, a dash if it is disabled")},
      {tr("Label"), tr("What the pose is called")},
      {tr("Cells"), tr("Cells that gave a reading, of all cells")},
      {tr("Noise mg"), tr("Standard deviation of the mean readings, rms over the cells")},
      {tr("New by"), tr("Angle to the nearest direction of gravity seen in an earlier pose")},
      {tr("Residual"), tr("How badly the pose fits the reconstruction: rms over the links")},
  }};
  const auto& [text, explanation] = headers.at(static_cast<std::size_t>(section));
  if (role == Qt::DisplayRole) return text;
  return role == Qt::ToolTipRole ? QVariant(explanation) : QVariant();
}

}  // namespace hexoderm
