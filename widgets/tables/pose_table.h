#pragma once

#include "widgets/tables/reconstruction_table.h"
#include "widgets/tables/table_cells.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

namespace hexoderm {

/// The columns Pose | Label | Cells | Noise mg | New by | Residual; row k is Reconstruction::poses[k]. Disabled poses
/// are greyed and carry a dash instead of a tick.
class PoseTable : public ReconstructionTable {
  Q_OBJECT

 public:
  /// Columns that can be done without, by their places.
  static constexpr int kCellsColumn = 2;
  static constexpr int kNoiseColumn = 3;
  static constexpr int kNewByColumn = 4;

  explicit PoseTable(QObject* parent = nullptr) : ReconstructionTable(parent) {
    const auto of = [this](auto value) {
      return [this, value](int row) { return value(reconstruction()->poses[static_cast<std::size_t>(row)]); };
    };
    const QString deg = QStringLiteral("deg");
    setColumns({{.name = tr("Pose"),
                 .explanation = tr("Number of the pose; a check mark if it is used, a dash if it is disabled"),
                 .is_text = true,
                 .value = of([](const PoseSummary& pose) { return pose.pose.value(); }),
                 .decoration = of([](const PoseSummary& pose) { return usedMark(pose.enabled); }),
                 .spoken = of([](const PoseSummary& pose) {
                   return (pose.enabled ? tr("Pose %1, used") : tr("Pose %1, disabled")).arg(pose.pose.value());
                 })},
                {.name = tr("Label"),
                 .explanation = tr("What the pose is called"),
                 .is_text = true,
                 .value = of([](const PoseSummary& pose) { return words(pose.label); }),
                 .text = of([](const PoseSummary& pose) { return pose.label.empty() ? noValue() : words(pose.label); }),
                 .tool_tip = of([](const PoseSummary& pose) { return words(pose.label); })},
                {.name = tr("Cells"),
                 .explanation = tr("Cells that gave a reading, of all cells"),
                 .value = of([](const PoseSummary& pose) { return static_cast<qulonglong>(pose.cells_measured); }),
                 .text = of([this](const PoseSummary& pose) {
                   return QStringLiteral("%1/%2").arg(pose.cells_measured).arg(reconstruction()->cellCount());
                 }),
                 .tool_tip = of([this](const PoseSummary& pose) {
                   const std::size_t cells = reconstruction()->cellCount();
                   return pose.cells_measured < cells
                              ? tr("%1 cells gave no reading in this pose.").arg(cells - pose.cells_measured)
                              : QString();
                 })},
                {.name = tr("Noise mg"),
                 .unit = QStringLiteral("mg"),
                 .explanation = tr("Standard deviation of the mean readings, rms over the cells"),
                 .decimals = 1,
                 .value = of([](const PoseSummary& pose) {
                   return pose.noise_g > 0 ? QVariant(1000 * pose.noise_g) : QVariant();
                 })},
                {.name = tr("New by"),
                 .unit = deg,
                 .explanation = tr("Angle to the nearest direction of gravity seen in an earlier pose"),
                 .sign = QStringLiteral("°"),
                 .value = of([](const PoseSummary& pose) { return rawDegrees(pose.new_by_rad); }),
                 .tool_tip = of([](const PoseSummary& pose) {
                   return pose.new_by_rad ? QString() : tr("There is no earlier pose to compare it with.");
                 })},
                {.name = tr("Residual"),
                 .unit = deg,
                 .explanation = tr("How badly the pose fits the reconstruction: rms over the links"),
                 .decimals = 1,
                 .sign = QStringLiteral("°"),
                 .value = of([](const PoseSummary& pose) { return rawDegrees(pose.residual_rad); })}});
  }

  QVariant data(const QModelIndex& index, int role) const override {
    const QVariant data = ReconstructionTable::data(index, role);
    const bool is_unexplained = role == Qt::ToolTipRole && data.toString().isEmpty();
    return is_unexplained ? headerData(index.column(), Qt::Horizontal, role) : data;
  }

 protected:
  [[nodiscard]] int rows() const override {
    return reconstruction() ? static_cast<int>(reconstruction()->poses.size()) : 0;
  }

  [[nodiscard]] QVariant ofRow(int row, int role) const override {
    const PoseSummary& pose = reconstruction()->poses[static_cast<std::size_t>(row)];
    if (pose.enabled) return {};
    if (role == Qt::ToolTipRole) return tr("Pose %1 is disabled: it is kept, but not used.").arg(pose.pose.value());
    return role == Qt::ForegroundRole ? excludedForeground() : QVariant();
  }
};

}  // namespace hexoderm
