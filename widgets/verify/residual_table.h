#pragma once

#include "widgets/controls/selection.h"
#include "widgets/tables/reconstruction_table.h"
#include "widgets/tables/table_cells.h"
#include "widgets/tables/table_roles.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// Links x poses: how badly each link fits each pose. One row a link, as LinkTable has them; the first column is the
/// link's rms over its poses, then one column a pose. Row headers name the links.
class ResidualTable : public LinkRowTable {
  Q_OBJECT

 public:
  using LinkRowTable::LinkRowTable;
  QVariant data(const QModelIndex& index, int role) const override {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    switch (role) {
      case Qt::ToolTipRole:
        return linkToolTip(*reconstruction(), linkAt(index.row()));
      case Qt::AccessibleTextRole: {
        const QString link = longLinkName(linkAt(index.row()));
        const QString residual = degreesInWords(residualAt(index));
        const std::optional<PoseId> pose = poseAt(index.column());
        return pose ? tr("%1, pose %2: %3").arg(link).arg(pose->value()).arg(residual)
                    : tr("%1, all poses: %2").arg(link, residual);
      }
      default:
        return LinkRowTable::data(index, role);
    }
  }

  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    if (orientation == Qt::Horizontal) return LinkRowTable::headerData(section, orientation, role);
    if (section < 0 || section >= rowCount()) return {};
    switch (role) {
      case Qt::DisplayRole:
      case kRawRole:
        return shortLinkName(linkAt(section));
      case kUnitRole:
        return tr("Link");
      case Qt::ToolTipRole:
        return linkToolTip(*reconstruction(), linkAt(section));
      case Qt::TextAlignmentRole:
        return alignment(true);
      default:
        return {};
    }
  }

  /// none for the first column
  [[nodiscard]] std::optional<PoseId> poseAt(int column) const {
    if (column < 1 || column >= columnCount()) return std::nullopt;
    return reconstruction()->poses[static_cast<std::size_t>(column - 1)].pose;
  }

  /// radians
  [[nodiscard]] std::optional<double> residualAt(const QModelIndex& index) const {
    const LinkEstimate& link = linkAt(index.row());
    if (index.column() == 0) return link.knownResidual();
    const auto pose = static_cast<std::size_t>(index.column() - 1);
    return pose < link.pose_residual_rad.size() ? link.pose_residual_rad[pose] : std::nullopt;
  }

 protected:
  void rebuild() override {
    LinkRowTable::rebuild();
    setColumns({});
    if (!reconstruction()) return;
    constexpr int kDecimals = 2;
    const QString deg = QStringLiteral("deg");
    std::vector<Column> columns;
    columns.push_back({tr("All"), deg, tr("Rms over the poses, degrees"), kDecimals});
    for (const PoseSummary& pose : reconstruction()->poses) {
      const auto number = pose.pose.value();
      columns.push_back({tr("Pose %1").arg(number), deg,
                         pose.enabled ? tr("Pose %1 %2, degrees").arg(number).arg(words(pose.label)).simplified()
                                      : tr("Pose %1 is disabled: it is kept, but not used.").arg(number),
                         kDecimals});
    }
    setColumns(std::move(columns));
  }

  [[nodiscard]] QVariant valueAt(const QModelIndex& index) const override { return rawDegrees(residualAt(index)); }
};

}  // namespace hexoderm
