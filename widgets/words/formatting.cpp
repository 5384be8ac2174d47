#include "widgets/words/formatting.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/result/uncertainty.h"
#include "widgets/style/of_enum.h"
#include "widgets/style/palette.h"
#include "widgets/words/cell_words.h"
#include "widgets/words/words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::Words)
};

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
  if (ids.size() > kMost) text += QStringLiteral(" ") + Words::tr("and %1 more").arg(ids.size() - kMost);
  return text;
}

/// "12.3; −4.0; 0.2": a comma is a decimal point in some languages.
QString threeNumbers(const Eigen::Vector3d& vector, int decimals) {
  QStringList numbers;
  for (const double value : vector) numbers << figureInWords(value, decimals);
  return numbers.join(QStringLiteral("; "));
}

/// "1 → 2 → 6 → 10", its middle left out if it is long.
QString pathInWords(const std::vector<CellId>& path) {
  constexpr std::size_t kMostAtEachEnd = 4;
  QStringList cells;
  for (std::size_t k = 0; k < path.size(); ++k) {
    if (path.size() > 2 * kMostAtEachEnd + 1 && k == kMostAtEachEnd) {
      cells << QStringLiteral("…");
      k = path.size() - kMostAtEachEnd;
    }
    cells << QString::number(path[k].value());
  }
  const std::size_t links = path.size() - 1;
  const QString count = links == 1 ? Words::tr("1 link") : Words::tr("%1 links").arg(links);
  return Words::tr("Path from the origin: %1 (%2)").arg(cells.join(QStringLiteral(" → ")), count);
}

/// "Residual in pose 1: 0.3°, 2: 0.4°"; of many poses the worst. Empty if there are none.
QString poseResiduals(const Reconstruction& reconstruction, const LinkEstimate& link) {
  constexpr std::size_t kMost = 6;
  std::vector<std::pair<double, PoseId>> known;
  for (std::size_t k = 0; k < std::min(link.pose_residual_rad.size(), reconstruction.poses.size()); ++k) {
    if (link.pose_residual_rad[k]) known.emplace_back(*link.pose_residual_rad[k], reconstruction.poses[k].pose);
  }
  if (known.empty()) return {};
  const bool too_many = known.size() > kMost;
  if (too_many) {
    std::ranges::sort(known, [](const auto& a, const auto& b) { return a.first > b.first; });
    known.resize(kMost);
  }
  QStringList poses;
  for (const auto& [angle_rad, pose] : known) {
    poses << QStringLiteral("%1: %2").arg(pose.value()).arg(degreesInWords(angle_rad));
  }
  return (too_many ? Words::tr("Residual in the worst poses %1") : Words::tr("Residual in pose %1"))
      .arg(poses.join(QStringLiteral(", ")));
}

}  // namespace

QString noValue() { return QStringLiteral("–"); }

QString unbroken(QString text) {
  static const QRegularExpression kUnit(QStringLiteral("(\\d) (?=(?:%|mm|mg|g|ms|s)(?!\\w))"));
  return text.replace(kUnit, QStringLiteral("\\1\u00a0"));
}

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

QString wholeDegreesInWords(double angle_rad) { return figureInWords(toDegrees(angle_rad), 0) + QStringLiteral("°"); }

QString millimetresInWords(double length_m, int decimals) {
  return Words::tr("%1 mm").arg(figureInWords(toMillimetres(length_m), decimals));
}

QString posesInWords(std::size_t count) {
  if (count == 0) return Words::tr("no poses");
  return count == 1 ? Words::tr("1 pose") : Words::tr("%1 poses").arg(count);
}

QString shortLinkName(LinkEnd a, LinkEnd b) {
  return QStringLiteral("%1:%2 – %3:%4")
      .arg(a.cell.value())
      .arg(a.port.value())
      .arg(b.cell.value())
      .arg(b.port.value());
}

QString longLinkName(const LinkEstimate& link) {
  return Words::tr("Link %1 · port %2 — %3 · port %4")
      .arg(link.source.cell.value())
      .arg(link.source.port.value())
      .arg(link.target.cell.value())
      .arg(link.target.port.value());
}

QString mutedBecause(const LinkEstimate& link) {
  if (link.used) return {};
  return link.muted_by ? words(descriptionOf(*link.muted_by).meaning) : Words::tr("It is not used.");
}

QString severityWord(Severity severity) {
  return ofEnum(severity, {Words::tr("Note"), Words::tr("Warning"), Words::tr("Error")});
}

QString placeInWords(const Finding& finding) {
  QStringList places;
  if (!finding.cells.empty()) places << listOf(finding.cells, Words::tr("cell %1"), Words::tr("cells %1"));
  if (!finding.poses.empty()) places << listOf(finding.poses, Words::tr("pose %1"), Words::tr("poses %1"));
  return places.isEmpty() ? noValue() : places.join(QStringLiteral("; "));
}

QString findingToolTip(const Finding& finding) {
  const FindingDescription& kind = descriptionOf(finding.code);
  return asToolTip(words(finding.message), {words(kind.meaning), QString::fromStdString(std::string(kind.name))});
}

QString mutedBecause(const Reconstruction& reconstruction, const LinkEstimate& link) {
  if (!link.used && link.muted_by) {
    const auto isAboutIt = [&](const Finding& finding) {
      return finding.code == *link.muted_by && finding.cells.size() >= 2 && finding.ports.size() >= 2 &&
             LinkEnd{finding.cells[0], finding.ports[0]} == link.source &&
             LinkEnd{finding.cells[1], finding.ports[1]} == link.target;
    };
    const auto found = std::ranges::find_if(reconstruction.findings, isAboutIt);
    if (found != reconstruction.findings.end()) return words(found->message);
  }
  return mutedBecause(link);
}

QString linkToolTip(const Reconstruction& reconstruction, const LinkEstimate& link) {
  QStringList lines;
  if (link.used) {
    lines << (link.in_tree ? Words::tr("Used, on the shortest paths to the origin") : Words::tr("Used"));
  } else {
    lines << Words::tr("Muted: %1").arg(mutedBecause(reconstruction, link));
  }
  if (!link.hasFigures()) return asToolTip(longLinkName(link), lines);
  const Eigen::Vector3d& values = link.singular_values;
  lines << Words::tr("%1, singular values %2, %3, %4; weight %5")
               .arg(qualityWord(link.quality), figureInWords(values[0], 2), figureInWords(values[1], 2),
                    figureInWords(values[2], 2), QLocale().toString(link.weight, 'g', 3));
  lines << Words::tr("Bend %1, twist %2, yaw %3")
               .arg(degreesInWords(link.bend_rad), degreesInWords(link.twist_rad), degreesInWords(link.yaw_rad));
  lines << Words::tr("Residual %1, predicted deviation %2")
               .arg(degreesInWords(link.knownResidual()), degreesInWords(link.knownSigma()));
  if (link.centred) lines << Words::tr("Centred: the mean of each cell's readings was subtracted");
  if (link.supported) lines << Words::tr("Support axes were added: the poses alone do not fix it");
  const QString poses = poseResiduals(reconstruction, link);
  if (!poses.isEmpty()) lines << poses;
  return asToolTip(longLinkName(link), lines);
}

QString cellToolTip(const Reconstruction& reconstruction, CellId cell) {
  return cellToolTip(reconstruction, cell, linksOf(reconstruction, cell));
}

QString cellToolTip(const Reconstruction& reconstruction, CellId cell, LinksOfCell links) {
  const auto [patch, placement] = reconstruction.find(cell);
  if (placement == nullptr) return {};
  QStringList lines;
  lines << (patch->origin == cell ? Words::tr("Origin of patch %1") : Words::tr("Patch %1")).arg(patch->id.value() + 1);
  if (!placement->body_part.empty()) lines << Words::tr("On %1").arg(QString::fromStdString(placement->body_part));
  lines << (placement->placed_by == PlacedBy::Links
                ? Words::tr("Placed through its links: its own readings are not used")
                : Words::tr("Placed by its own readings"));
  if (patch->origin != cell) {
    const Eigen::Vector3d& t_o_u = placement->T_o_u.t;
    const Eigen::Vector3d rpy_rad = rpyFromRotation(placement->T_o_u.R);
    lines << Words::tr("At %1 mm from the origin").arg(threeNumbers(1e3 * t_o_u, 1));
    lines << Words::tr("Roll %1, pitch %2, yaw %3")
                 .arg(degreesInWords(rpy_rad.x()), degreesInWords(rpy_rad.y()), degreesInWords(rpy_rad.z()));
    if (const auto known = uncertaintyOf(*placement)) {
      lines << Words::tr("Known to ±%1, ±%2 (95 %)")
                   .arg(millimetresInWords(known->position_m, 1), degreesInWords(known->orientation_rad));
    } else {
      lines << Words::tr("How well it is known is not stated");
    }
    if (const auto path = patch->pathTo(cell); path.size() > 1) lines << pathInWords(path);
  }
  if (const auto shape = shapeUncertaintyOf(*placement)) {
    lines << Words::tr("In the shape known to ±%1, ±%2 (95 %)")
                 .arg(millimetresInWords(shape->position_m, 1), degreesInWords(shape->orientation_rad));
  }
  if (const WorstLinkFigures worst = worstOf(links); worst.quality) {
    lines << Words::tr("Worst link: %1, residual %2, predicted deviation %3")
                 .arg(qualityWord(*worst.quality), degreesInWords(worst.residual_rad), degreesInWords(worst.sigma_rad));
  }
  if (placement->accel_offset_g) {
    lines << Words::tr("Accelerometer offset %1 mg").arg(threeNumbers(1e3 * *placement->accel_offset_g, 0));
  }
  if (placement->accel_scale)
    lines << Words::tr("Accelerometer scale %1").arg(threeNumbers(*placement->accel_scale, 3));
  for (const Finding& finding : reconstruction.findings) {
    constexpr std::size_t kMostCells = 4;  // one that names half of the skin is not about this cell
    if (finding.severity == Severity::Info || finding.cells.size() > kMostCells) continue;
    if (std::ranges::find(finding.cells, cell) != finding.cells.end()) lines << words(finding.message);
  }
  return asToolTip(Words::tr("Cell %1").arg(cell.value()), lines);
}

}  // namespace hexoderm
