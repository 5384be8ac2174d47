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

 protected:
  void rebuild() override {
    LinkRowTable::rebuild();
    setColumns({});
    if (!reconstruction()) return;
    std::vector<Column> columns;
    // `spoken`: with a place for the link and one for the residual.
    const auto add = [&](const QString& name, const QString& explanation, const QString& spoken, auto residual) {
      columns.push_back({.name = name, .unit = QStringLiteral("deg"), .explanation = explanation, .decimals = 2});
      columns.back().value = [this, residual](int row) { return rawDegrees(residual(linkAt(row))); };
      columns.back().spoken = [this, residual, spoken](int row) {
        return spoken.arg(longLinkName(linkAt(row)), degreesText(residual(linkAt(row))));
      };
    };
    add(tr("All"), tr("Rms over the poses, degrees"), tr("%1, all poses: %2"),
        [](const LinkEstimate& link) { return link.knownResidual(); });
    for (const PoseSummary& pose : reconstruction()->poses) {
      const auto number = pose.pose.value();
      const std::size_t place = columns.size() - 1;
      add(tr("Pose %1").arg(number),
          pose.enabled ? tr("Pose %1 %2, degrees").arg(number).arg(words(pose.label)).simplified()
                       : tr("Pose %1 is disabled: it is kept, but not used.").arg(number),
          tr("%1, pose %2: %3").arg(QStringLiteral("%1"), QString::number(number), QStringLiteral("%2")),
          [place](const LinkEstimate& link) {
            return place < link.pose_residual_rad.size() ? link.pose_residual_rad[place] : std::nullopt;
          });
    }
    setColumns(std::move(columns));
  }

  [[nodiscard]] QVariant ofRow(int row, int role) const override {
    return role == Qt::ToolTipRole ? linkToolTip(*reconstruction(), linkAt(row)) : QVariant();
  }
};

}  // namespace hexoderm
