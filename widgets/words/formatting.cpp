#include "widgets/words/formatting.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/review_summary.h"
#include "hexoderm/solve/result/reconstruction.h"
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
  constexpr std::size_t kMax = 6;
  QStringList names;
  for (std::size_t k = 0; k < std::min(ids.size(), kMax); ++k) names << QString::number(ids[k].value());
  QString text = (ids.size() == 1 ? one : several).arg(names.join(QStringLiteral(", ")));
  if (ids.size() > kMax) text += QStringLiteral(" ") + Words::tr("and %1 more").arg(ids.size() - kMax);
  return text;
}

/// "12.3; −4.0; 0.2": a comma is a decimal point in some languages.
QString threeNumbers(const Eigen::Vector3d& vector, int decimals) {
  QStringList numbers;
  for (const double value : vector) numbers << figureText(value, decimals);
  return numbers.join(QStringLiteral("; "));
}

/// "1 → 2 → 6 → 10", its middle left out if it is long.
QString pathText(const std::vector<CellId>& path) {
  constexpr std::size_t kMaxAtEachEnd = 4;
  QStringList cells;
  for (std::size_t k = 0; k < path.size(); ++k) {
    if (path.size() > 2 * kMaxAtEachEnd + 1 && k == kMaxAtEachEnd) {
      cells << QStringLiteral("…");
      k = path.size() - kMaxAtEachEnd;
    }
    cells << QString::number(path[k].value());
  }
  const std::size_t links = path.size() - 1;
  const QString count = links == 1 ? Words::tr("1 link") : Words::tr("%1 links").arg(links);
  return Words::tr("Path from the origin: %1 (%2)").arg(cells.join(QStringLiteral(" → ")), count);
}

/// "Residual in pose 1: 0.3°, 2: 0.4°"; of many poses the worst. Empty if there are none.
QString poseResiduals(const Reconstruction& reconstruction, const LinkEstimate& link) {
  constexpr std::size_t kMax = 6;
  std::vector<std::pair<double, PoseId>> known;
  for (std::size_t k = 0; k < std::min(link.pose_residual_rad.size(), reconstruction.poses.size()); ++k) {
    if (link.pose_residual_rad[k]) known.emplace_back(*link.pose_residual_rad[k], reconstruction.poses[k].pose);
  }
  if (known.empty()) return {};
  const bool too_many = known.size() > kMax;
  if (too_many) {
    std::ranges::sort(known, [](const auto& a, const auto& b) { return a.first > b.first; });
    known.resize(kMax);
  }
  QStringList poses;
  for (const auto& [angle_rad, pose] : known) {
    poses << QStringLiteral("%1: %2").arg(pose.value()).arg(degreesText(angle_rad));
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

QString figureText(double value, int decimals) {
  // "-0.0" would be a sign without a meaning.
  const double half_of_last = 0.5 * std::pow(10.0, -decimals);
  QString text = QLocale().toString(std::abs(value) < half_of_last ? 0.0 : value, 'f', decimals);
  text.replace(QLatin1Char('-'), QStringLiteral("−"));
  return text;
}

QString lotWords(const LotEstimate& lot) {
  QString text = words(lotText(lot));
  text.replace(QStringLiteral("+-"), QStringLiteral("±"));
  return text.replace(QLatin1Char('-'), QStringLiteral("−"));
}

QString degreesText(std::optional<double> angle_rad) {
  return angle_rad ? figureText(toDegrees(*angle_rad), 1) + QStringLiteral("°") : noValue();
}

QString wholeDegreesText(double angle_rad) { return figureText(toDegrees(angle_rad), 0) + QStringLiteral("°"); }

QString millimetresText(double length_m, int decimals) {
  return Words::tr("%1 mm").arg(figureText(toMillimetres(length_m), decimals));
}

QString posesText(std::size_t count) {
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

QString excludedBecause(const LinkEstimate& link) {
  if (link.used) return {};
  return link.muted_by ? words(descriptionOf(*link.muted_by).meaning) : Words::tr("It is not used.");
}

QString severityWord(Severity severity) {
  return ofEnum(severity, {Words::tr("Note"), Words::tr("Warning"), Words::tr("Error")});
}

QString placeText(const Finding& finding) {
  QStringList places;
  if (!finding.cells.empty()) places << listOf(finding.cells, Words::tr("cell %1"), Words::tr("cells %1"));
  if (!finding.poses.empty()) places << listOf(finding.poses, Words::tr("pose %1"), Words::tr("poses %1"));
  return places.isEmpty() ? noValue() : places.join(QStringLiteral("; "));
}

QString findingToolTip(const Finding& finding) {
  const FindingDescription& kind = descriptionOf(finding.code);
  return asToolTip(words(finding.message), {words(kind.meaning), QString::fromStdString(std::string(kind.name))});
}

QString excludedBecause(const Reconstruction& reconstruction, const LinkEstimate& link) {
  if (!link.used && link.muted_by) {
    const auto isAboutIt = [&](const Finding& finding) {
      if (finding.code != *link.muted_by) return false;
      const std::size_t ends = std::min(finding.cells.size(), finding.ports.size());
      for (std::size_t k = 0; k + 1 < ends; k += 2) {
        if (LinkEnd{finding.cells[k], finding.ports[k]} == link.source &&
            LinkEnd{finding.cells[k + 1], finding.ports[k + 1]} == link.target) {
          return true;
        }
      }
      return false;
    };
    const auto found = std::ranges::find_if(reconstruction.findings, isAboutIt);
    if (found != reconstruction.findings.end()) return words(found->message);
  }
  return excludedBecause(link);
}

QString linkToolTip(const Reconstruction& reconstruction, const LinkEstimate& link) {
  QStringList lines;
  if (link.used) {
    lines << (link.in_tree ? Words::tr("Used, on the shortest paths to the origin") : Words::tr("Used"));
  } else {
    lines << Words::tr("Muted: %1").arg(excludedBecause(reconstruction, link));
  }
  if (!link.hasMetrics()) return asToolTip(longLinkName(link), lines);
  const Eigen::Vector3d& values = link.singular_values;
  lines << Words::tr("%1, singular values %2, %3, %4; weight %5")
               .arg(qualityWord(link.quality), figureText(values[0], 2), figureText(values[1], 2),
                    figureText(values[2], 2), QLocale().toString(link.weight, 'g', 3));
  lines << Words::tr("Bend %1, twist %2, yaw %3")
               .arg(degreesText(link.bend_rad), degreesText(link.twist_rad), degreesText(link.yaw_rad));
  lines << Words::tr("Residual %1, predicted deviation %2")
               .arg(degreesText(link.knownResidual()), degreesText(link.knownSigma()));
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
                 .arg(degreesText(rpy_rad.x()), degreesText(rpy_rad.y()), degreesText(rpy_rad.z()));
    if (const auto known = uncertaintyOf(*placement)) {
      lines << Words::tr("Known to ±%1, ±%2 (95 %)")
                   .arg(millimetresText(known->position_m, 1), degreesText(known->orientation_rad));
    } else {
      lines << Words::tr("How well it is known is not stated");
    }
    if (const auto path = patch->pathTo(cell); path.size() > 1) lines << pathText(path);
  }
  if (const auto shape = shapeUncertaintyOf(*placement)) {
    lines << Words::tr("In the shape known to ±%1, ±%2 (95 %)")
                 .arg(millimetresText(shape->position_m, 1), degreesText(shape->orientation_rad));
  }
  if (const WorstLinkMetrics worst = worstOf(links); worst.quality) {
    lines << Words::tr("Worst link: %1, residual %2, predicted deviation %3")
                 .arg(qualityWord(*worst.quality), degreesText(worst.residual_rad), degreesText(worst.sigma_rad));
  }
  if (placement->accel_offset_g) {
    lines << Words::tr("Accelerometer offset %1 mg").arg(threeNumbers(1e3 * *placement->accel_offset_g, 0));
  }
  if (placement->accel_scale) {
    lines << Words::tr("Accelerometer scale %1").arg(threeNumbers(*placement->accel_scale, 3));
    if (patch->lot) lines << Words::tr("Shared by its lot: %1").arg(lotWords(*patch->lot));
  }
  for (const Finding& finding : reconstruction.findings) {
    constexpr std::size_t kMaxCells = 4;  // one that names half of the skin is not about this cell
    if (finding.severity == Severity::Info || finding.cells.size() > kMaxCells) continue;
    if (std::ranges::find(finding.cells, cell) != finding.cells.end()) lines << words(finding.message);
  }
  return asToolTip(Words::tr("Cell %1").arg(cell.value()), lines);
}

}  // namespace hexoderm
