#pragma once

#include "widgets/style/palette.h"
#include "widgets/tables/reconstruction_table.h"
#include "widgets/tables/table_cells.h"
#include "widgets/words/formatting.h"

namespace hexoderm {

/// The columns Link | Quality | Residual | Predicted | Bend | Twist | Yaw | State; one row per link, excluded links
/// included.
class LinkTable : public LinkRowTable {
  Q_OBJECT

 public:
  /// Columns that can be done without, by their places.
  static constexpr int kTwistColumn = 5;
  static constexpr int kYawColumn = 6;

  explicit LinkTable(QObject* parent = nullptr) : LinkRowTable(parent) {
    const auto text = [this](const QString& name, const QString& explanation, auto value) {
      return Column{.name = name, .explanation = explanation, .is_text = true, .value = [this, value](int row) {
                      return value(linkAt(row));
                    }};
    };
    const auto angle = [this](const QString& name, const QString& explanation, auto value_rad) {
      return Column{.name = name,
                    .unit = QStringLiteral("deg"),
                    .explanation = explanation,
                    .decimals = 1,
                    .sign = QStringLiteral("°"),
                    .value = [this, value_rad](int row) { return rawDegrees(value_rad(linkAt(row))); }};
    };
    const auto ofMetrics = [](double LinkEstimate::*angle_rad) {
      return [angle_rad](const LinkEstimate& link) {
        return link.hasMetrics() ? std::optional(link.*angle_rad) : std::nullopt;
      };
    };
    Column name = text(tr("Link"), tr("Cell and port of both ends"),
                       [](const LinkEstimate& link) { return shortLinkName(link); });
    name.spoken = [this](int row) { return longLinkName(linkAt(row)); };
    Column quality = text(
        tr("Quality"), tr("How well the poses determine the link's rotation"),
        [](const LinkEstimate& link) { return link.hasMetrics() ? QVariant(qualityWord(link.quality)) : QVariant(); });
    quality.decoration = [this](int row) {
      const LinkEstimate& link = linkAt(row);
      return link.hasMetrics() ? QVariant(strokeMark(link.quality)) : QVariant();
    };
    setColumns(
        {name, quality,
         angle(tr("Residual"),
               tr("How badly the readings of the two cells fit together, the estimated errors of their sensors "
                  "taken away: rms over the poses"),
               [](const LinkEstimate& link) { return link.knownResidual(); }),
         angle(tr("Predicted"), tr("Expected standard deviation of the link's rotation about its worst axis"),
               [](const LinkEstimate& link) { return link.knownSigma(); }),
         angle(tr("Bend"), tr("Angle by which the surface folds at the link"), ofMetrics(&LinkEstimate::bend_rad)),
         angle(tr("Twist"), tr("Angle by which the cells are turned about the line that joins them"),
               ofMetrics(&LinkEstimate::twist_rad)),
         angle(tr("Yaw"), tr("Angle by which the cells are turned within the surface"),
               ofMetrics(&LinkEstimate::yaw_rad)),
         text(tr("State"), tr("Whether the link is used, and whether it lies on the shortest-path tree"),
              [](const LinkEstimate& link) {
                if (link.muted_by == FindingCode::LinkSetAside) return tr("set aside");
                if (!link.used) return tr("muted");
                return link.in_tree ? tr("used, in tree") : tr("used");
              })});
  }

 protected:
  [[nodiscard]] QVariant ofRow(int row, int role) const override {
    const LinkEstimate& link = linkAt(row);
    if (role == Qt::ToolTipRole) return linkToolTip(*reconstruction(), link);
    return role == Qt::ForegroundRole && !link.used ? excludedForeground() : QVariant();
  }
};

}  // namespace hexoderm
