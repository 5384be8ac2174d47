#include "app/window/report/report_title.h"

#include <QCryptographicHash>
#include <QSettings>

namespace hexoderm {
namespace {

constexpr int kMaxTitles = 200;

const QString kOrder = QStringLiteral("report/order");
const QString kLastRobot = QStringLiteral("report/last_robot");
const QString kLastOperator = QStringLiteral("report/last_operator");

/// Paths have slashes, which would be folders of the settings.
QString keyOf(const QString& session) {
  return QString::fromLatin1(QCryptographicHash::hash(session.toUtf8(), QCryptographicHash::Sha1).toHex());
}

QString groupOf(const QString& key) { return QStringLiteral("report/titles/") + key + QLatin1Char('/'); }

}  // namespace

std::optional<ReportTitle> keptReportTitle(const QString& session) {
  const QSettings settings;
  const QString group = groupOf(keyOf(session));
  if (!settings.contains(group + QStringLiteral("robot"))) return std::nullopt;
  const auto read = [&](const char* name) { return settings.value(group + QLatin1String(name)).toString(); };
  return ReportTitle{read("robot"), read("part"), read("operator"), read("notes")};
}

void keepReportTitle(const QString& session, const ReportTitle& title) {
  QSettings settings;
  const QString key = keyOf(session);
  const QString group = groupOf(key);
  settings.setValue(group + QStringLiteral("robot"), title.robot);
  settings.setValue(group + QStringLiteral("part"), title.part);
  settings.setValue(group + QStringLiteral("operator"), title.made_by);
  settings.setValue(group + QStringLiteral("notes"), title.notes);
  settings.setValue(kLastRobot, title.robot);
  settings.setValue(kLastOperator, title.made_by);
  QStringList order = settings.value(kOrder).toStringList();
  order.removeAll(key);
  order.prepend(key);
  while (order.size() > kMaxTitles) settings.remove(QStringLiteral("report/titles/") + order.takeLast());
  settings.setValue(kOrder, order);
}

ReportTitle proposedReportTitle() {
  const QSettings settings;
  ReportTitle title;
  title.robot = settings.value(kLastRobot).toString();
  title.made_by = settings.value(kLastOperator).toString();
  return title;
}

}  // namespace hexoderm
