#include "widgets/words.h"

#include "hexoderm/util/units.h"
#include "widgets/palette.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <vector>

namespace hexoderm {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("hexoderm::Words", text); }

/// First line bold, the others plain; escaped, since labels and IDs come from files.
QString asToolTip(const QString& title, const QStringList& lines) {
  QString text = QStringLiteral("<b>%1</b>").arg(title.toHtmlEscaped());
  for (const QString& line : lines) text += QStringLiteral("<br>") + line.toHtmlEscaped();
  return text;
}

/// Names the first few of many, so that a row stays a row.
template <class Id>
QString listOf(const std::vector<Id>& ids, const QString& one, const QString& several) {
  constexpr std::size_t kMost = 6;
  QStringList names;
  for (std::size_t k = 0; k < std::min(ids.size(), kMost); ++k) names << QString::number(ids[k].value());
  QString text = (ids.size() == 1 ? one : several).arg(names.join(QStringLiteral(", ")));
  if (ids.size() > kMost) text += QStringLiteral(" ") + tr("and %1 more").arg(ids.size() - kMost);
  return text;
}

}  // namespace

QString noValue() { return QStringLiteral("–"); }

QString figureInWords(double value, int decimals) {
  // "-0.0" would be a sign without a meaning.
  const double half_of_last = 0.5 * std::pow(10.0, -decimals);
  QString text = QLocale().toString(std::abs(value) < half_of_last ? 0.0 : value, 'f', decimals);
  text.replace(QLatin1Char('-'), QStringLiteral("−"));
  return text;
}

QString degreesInWords(std::optional<double> angle_rad) {
  return angle_rad ? figureInWords(toDegrees(*angle_rad), 1) + QStringLiteral("°") : noValue();
}

QString wholeDegreesInWords(double angle_rad) {
  return QLocale().toString(toDegrees(angle_rad), 'f', 0) + QStringLiteral("°");
}

QString shortLinkName(const LinkEstimate& link) {
  return QStringLiteral("%1:%2 – %3:%4")
      .arg(link.source.cell.value())
      .arg(link.source.port.value())
      .arg(link.target.cell.value())
      .arg(link.target.port.value());
}

QString longLinkName(const LinkEstimate& link) {
  return tr("Link %1 · port %2 — %3 · port %4")
      .arg(link.source.cell.value())
      .arg(link.source.port.value())
      .arg(link.target.cell.value())
      .arg(link.target.port.value());
}

QString mutedBecause(const LinkEstimate& link) {
  if (link.used) return {};
  if (!link.muted_by) return tr("It is not used.");
  const auto table = findingTable();
  const auto entry = std::ranges::find(table, *link.muted_by, &FindingDescription::code);
  if (entry == table.end()) return tr("It is not used.");
  return QString::fromUtf8(entry->meaning.data(), static_cast<int>(entry->meaning.size()));
}

bool hasFigures(const LinkEstimate& link) {
  return link.used || knownResidual(link).has_value() || knownSigma(link).has_value();
}

std::optional<double> knownResidual(const LinkEstimate& link) {
  const bool measured =
      std::ranges::any_of(link.pose_residual_rad, [](const auto& angle) { return angle.has_value(); });
  return measured || link.residual_rad > 0 ? std::optional(link.residual_rad) : std::nullopt;
}

std::optional<double> knownSigma(const LinkEstimate& link) {
  return link.sigma_rad > 0 ? std::optional(link.sigma_rad) : std::nullopt;
}

QString severityWord(Severity severity) {
  switch (severity) {
    case Severity::Info:
      return tr("Note");
    case Severity::Warning:
      return tr("Warning");
    case Severity::Error:
      return tr("Error");
  }
  return {};
}

QString placeInWords(const Finding& finding) {
  QStringList places;
  if (!finding.cells.empty()) places << listOf(finding.cells, tr("cell %1"), tr("cells %1"));
  if (!finding.poses.empty()) places << listOf(finding.poses, tr("pose %1"), tr("poses %1"));
  return places.isEmpty() ? noValue() : places.join(QStringLiteral("; "));
}

QString findingToolTip(const Finding& finding) {
  const auto table = findingTable();
  const auto entry = std::ranges::find(table, finding.code, &FindingDescription::code);
  QStringList lines;
  if (entry != table.end()) {
    lines << QString::fromUtf8(entry->meaning.data(), static_cast<int>(entry->meaning.size()));
    lines << QString::fromUtf8(entry->name.data(), static_cast<int>(entry->name.size()));
  }
  return asToolTip(QString::fromStdString(finding.text), lines);
}

QString linkToolTip(const LinkEstimate& link) {
  QStringList lines;
  if (!link.used) lines << tr("Muted: %1").arg(mutedBecause(link));
  if (hasFigures(link)) {
    lines << (link.in_tree ? tr("%1, on the shortest-path tree") : QStringLiteral("%1")).arg(qualityWord(link.quality));
    lines << tr("Bend %1, twist %2, yaw %3")
                 .arg(degreesInWords(link.bend_rad), degreesInWords(link.twist_rad), degreesInWords(link.yaw_rad));
    lines << tr("Residual %1, predicted %2").arg(degreesInWords(knownResidual(link)), degreesInWords(knownSigma(link)));
  }
  return asToolTip(longLinkName(link), lines);
}

QString cellToolTip(const Reconstruction& reconstruction, CellId cell) {
  const auto [patch, placement] = reconstruction.find(cell);
  if (placement == nullptr) return {};
  QStringList lines;
  lines << (patch->origin == cell ? tr("Origin of patch %1") : tr("Patch %1")).arg(patch->id.value() + 1);
  if (!placement->body_part.empty()) lines << tr("On %1").arg(QString::fromStdString(placement->body_part));
  if (patch->origin != cell) {
    const Eigen::Vector3d& t_o_u = placement->T_o_u.t;
    const QLocale locale;
    lines << tr("At %1, %2, %3 mm from the origin")
                 .arg(locale.toString(toMillimetres(t_o_u.x()), 'f', 1),
                      locale.toString(toMillimetres(t_o_u.y()), 'f', 1),
                      locale.toString(toMillimetres(t_o_u.z()), 'f', 1));
    if (placement->path.size() == 2) lines << tr("Next to the origin");
    if (placement->path.size() > 2) lines << tr("%1 links from the origin").arg(placement->path.size() - 1);
  }
  if (placement->placed_by == PlacedBy::Links) lines << tr("Placed through its links: its own readings are not used");
  for (const Finding& finding : reconstruction.findings) {
    constexpr std::size_t kMostCells = 4;  // one that names half of the skin is not about this cell
    if (finding.severity == Severity::Info || finding.cells.size() > kMostCells) continue;
    if (std::ranges::find(finding.cells, cell) != finding.cells.end()) lines << QString::fromStdString(finding.text);
  }
  return asToolTip(tr("Cell %1").arg(cell.value()), lines);
}

}  // namespace hexoderm
