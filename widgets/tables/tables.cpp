#include "widgets/tables/tables.h"

#include "hexoderm/util/units.h"
#include "widgets/style/palette.h"
#include "widgets/tables/table_actions.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QApplication>
#include <QBrush>
#include <QIcon>
#include <QPainter>
#include <QPixmap>
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace hexoderm {
namespace {

constexpr int kMark = 16;  ///< side of the marks before words, in device-independent pixels

/// The theme in use; models belong to no widget, so they ask the application.
Theme currentTheme() {
  const QPalette palette = QApplication::palette();
  return palette.color(QPalette::Base).lightness() < 128 ? Theme::Dark : Theme::Light;
}

const Colors& colors() { return Colors::of(currentTheme()); }

/// A mark drawn at twice its size, so that it is sharp on fine screens, too.
template <class Draw>
QIcon drawMark(Draw&& draw) {
  constexpr int kFine = 2;
  QPixmap mark(kFine * kMark, kFine * kMark);
  mark.setDevicePixelRatio(kFine);
  mark.fill(Qt::transparent);
  QPainter painter(&mark);
  painter.setRenderHint(QPainter::Antialiasing);
  draw(painter);
  painter.end();
  QIcon icon(mark);
  icon.addPixmap(mark, QIcon::Selected);  // or the style tints it, and colours here have a meaning
  return icon;
}

QIcon checkMark(bool enabled) {
  return drawMark([enabled](QPainter& painter) {
    painter.setPen(QPen(enabled ? colors().good : colors().text_muted, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (enabled) {
      painter.drawPolyline(QPolygonF({QPointF(3.5, 8.5), QPointF(6.5, 11.5), QPointF(12.5, 4.5)}));
    } else {
      painter.drawLine(QPointF(4, 8), QPointF(12, 8));
    }
  });
}

/// A piece of the line that the link has in the graph.
QIcon strokeMark(EdgeQuality quality) {
  return drawMark([quality](QPainter& painter) {
    drawStroke(painter, linkStroke(quality, currentTheme()), QLineF(0.5, 8, kMark - 0.5, 8), 2.8);
  });
}

/// Shape and colour together: a cross, a triangle, a ring.
QIcon severityMark(Severity severity) {
  return drawMark([severity](QPainter& painter) {
    switch (severity) {
      case Severity::Error:
        painter.setPen(QPen(colors().bad, 2.4, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(QPointF(4, 4), QPointF(12, 12));
        painter.drawLine(QPointF(4, 12), QPointF(12, 4));
        return;
      case Severity::Warning:
        painter.setPen(Qt::NoPen);
        painter.setBrush(colors().caution);
        painter.drawPolygon(QPolygonF({QPointF(8, 2.5), QPointF(14, 13), QPointF(2, 13)}));
        return;
      case Severity::Info:
        painter.setPen(QPen(colors().text_muted, 1.6));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(QPointF(8, 8), 4.2, 4.2);
        return;
    }
  });
}

QVariant alignment(bool figure) {
  return QVariant::fromValue(static_cast<int>((figure ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
}

QVariant rawDegrees(std::optional<double> angle_rad) {
  return angle_rad ? QVariant(toDegrees(*angle_rad)) : QVariant();
}

}  // namespace

void ReconstructionTable::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  beginResetModel();
  reconstruction_ = std::move(reconstruction);
  rebuild();
  endResetModel();
}

// --- poses ---

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
      return column == kPose ? QVariant(checkMark(pose.enabled)) : QVariant();
    case Qt::TextAlignmentRole:
      return alignment(column >= kCells);
    case Qt::ForegroundRole:
      return pose.enabled ? QVariant() : QVariant(QBrush(colors().text_muted));
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

// --- links ---

namespace {

enum LinkColumn { kLink, kQuality, kResidual, kPredicted, kBend, kTwist, kYaw, kState, kLinkColumns };

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
      case kYaw:
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
      case kYaw:
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
      return alignment(column >= kResidual && column <= kYaw);
    case Qt::ForegroundRole:
      return link.used ? QVariant() : QVariant(QBrush(colors().text_muted));
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
  if (role == Qt::TextAlignmentRole) return alignment(section >= kResidual && section <= kYaw);
  if (role == kUnitRole) return section >= kResidual && section <= kYaw ? QStringLiteral("deg") : QString();
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

// --- findings ---

namespace {

enum FindingColumn { kSeverity, kWhat, kWhere, kFindingColumns };

}  // namespace

void FindingTable::rebuild() {
  rows_.clear();
  if (!reconstruction()) return;
  const std::vector<Finding>& findings = reconstruction()->findings;
  rows_.resize(findings.size());
  std::iota(rows_.begin(), rows_.end(), std::size_t{0});
  std::ranges::stable_sort(rows_, std::ranges::greater(), [&](std::size_t row) { return findings[row].severity; });
}

int FindingTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int FindingTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kFindingColumns; }

const Finding& FindingTable::findingAt(int row) const {
  return reconstruction()->findings[rows_.at(static_cast<std::size_t>(row))];
}

QVariant FindingTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const Finding& finding = findingAt(index.row());
  switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      if (index.column() == kSeverity) return severityWord(finding.severity);
      return index.column() == kWhat ? words(finding.message) : placeInWords(finding);
    case Qt::DecorationRole:
      return index.column() == kSeverity ? QVariant(severityMark(finding.severity)) : QVariant();
    case Qt::TextAlignmentRole:
      return alignment(false);
    case Qt::ToolTipRole:
      return findingToolTip(finding);
    default:
      return {};
  }
}

QVariant FindingTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= kFindingColumns) return {};
  if (role == Qt::TextAlignmentRole) return alignment(false);
  const std::array<QString, kFindingColumns> headers = {tr("Severity"), tr("What"), tr("Where")};
  return role == Qt::DisplayRole ? QVariant(headers.at(static_cast<std::size_t>(section))) : QVariant();
}

}  // namespace hexoderm
