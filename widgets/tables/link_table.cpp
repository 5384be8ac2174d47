#include "widgets/tables/link_table.h"

#include "widgets/style/palette.h"
#include "widgets/tables/table_cells.h"
#include "widgets/tables/table_roles.h"
#include "widgets/words/formatting.h"

#include <array>

namespace hexoderm {
namespace {

enum LinkColumn { kLink, kQuality, kResidual, kPredicted, kBend, kTwist, kLinkYaw, kState, kLinkColumns };

}  // namespace

void LinkTable::rebuild() {
  rows_.clear();
  if (!reconstruction()) return;
  for (std::size_t patch = 0; patch < reconstruction()->patches.size(); ++patch) {
    for (std::size_t link = 0; link < reconstruction()->patches[patch].links.size(); ++link) {
      rows_.emplace_back(patch, link);
    }
  }
}

int LinkTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int LinkTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kLinkColumns; }

const LinkEstimate& LinkTable::linkAt(int row) const {
  const auto& [patch, link] = rows_.at(static_cast<std::size_t>(row));
  return reconstruction()->patches[patch].links[link];
}

int LinkTable::rowOf(LinkEnd source, LinkEnd target) const {
  if (target < source) std::swap(source, target);
  for (int row = 0; row < static_cast<int>(rows_.size()); ++row) {
    const LinkEstimate& link = linkAt(row);
    if (link.source == source && link.target == target) return row;
  }
  return -1;
}

QVariant LinkTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const LinkEstimate& link = linkAt(index.row());
  const int column = index.column();
  const bool known = link.hasFigures();
  const auto text = [&]() -> QString {
    switch (column) {
      case kLink:
        return shortLinkName(link);
      case kQuality:
        return known ? qualityWord(link.quality) : noValue();
      case kResidual:
        return degreesInWords(link.knownResidual());
      case kPredicted:
        return degreesInWords(link.knownSigma());
      case kBend:
        return known ? degreesInWords(link.bend_rad) : noValue();
      case kTwist:
        return known ? degreesInWords(link.twist_rad) : noValue();
      case kLinkYaw:
        return known ? degreesInWords(link.yaw_rad) : noValue();
      case kState:
        if (link.muted_by == FindingCode::LinkSetAside) return tr("set aside");
        if (!link.used) return tr("muted");
        return link.in_tree ? tr("used, in tree") : tr("used");
      default:
        return {};
    }
  };
  const auto raw = [&]() -> QVariant {
    switch (column) {
      case kResidual:
        return rawDegrees(link.knownResidual());
      case kPredicted:
        return rawDegrees(link.knownSigma());
      case kBend:
        return known ? rawDegrees(link.bend_rad) : QVariant();
      case kTwist:
        return known ? rawDegrees(link.twist_rad) : QVariant();
      case kLinkYaw:
        return known ? rawDegrees(link.yaw_rad) : QVariant();
      case kQuality:
        return known ? QVariant(text()) : QVariant();
      default:
        return text();
    }
  };
  switch (role) {
    case Qt::DisplayRole:
      return text();
    case kRawRole:
      return raw();
    case Qt::DecorationRole:
      return column == kQuality && known ? QVariant(strokeMark(link.quality)) : QVariant();
    case Qt::TextAlignmentRole:
      return alignment(column >= kResidual && column <= kLinkYaw);
    case Qt::ForegroundRole:
      return link.used ? QVariant() : mutedForeground();
    case Qt::ToolTipRole:
      return linkToolTip(*reconstruction(), link);
    case Qt::AccessibleTextRole:
      return column == kLink ? longLinkName(link) : text();
    default:
      return {};
  }
}

QVariant LinkTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= kLinkColumns) return {};
  if (role == Qt::TextAlignmentRole) return alignment(section >= kResidual && section <= kLinkYaw);
  if (role == kUnitRole) return section >= kResidual && section <= kLinkYaw ? QStringLiteral("deg") : QString();
  const std::array<std::pair<QString, QString>, kLinkColumns> headers = {{
      {tr("Link"), tr("Cell and port of both ends")},
      {tr("Quality"), tr("How well the poses determine the link's rotation")},
      {tr("Residual"), tr("How badly the readings of the two cells fit together, the estimated errors of their sensors "
                          "taken away: rms over the poses")},
      {tr("Predicted"), tr("Expected standard deviation of the link's rotation about its worst axis")},
      {tr("Bend"), tr("Angle by which the surface folds at the link")},
      {tr("Twist"), tr("Angle by which the cells are turned about the line that joins them")},
      {tr("Yaw"), tr("Angle by which the cells are turned within the surface")},
      {tr("State"), tr("Whether the link is used, and whether it lies on the shortest-path tree")},
  }};
  const auto& [text, explanation] = headers.at(static_cast<std::size_t>(section));
  if (role == Qt::DisplayRole) return text;
  return role == Qt::ToolTipRole ? QVariant(explanation) : QVariant();
}

}  // namespace hexoderm
