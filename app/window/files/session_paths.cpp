#include "app/window/files/session_paths.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace hexoderm {
namespace {

QString stamp() { return QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")); }

}  // namespace

std::filesystem::path toPath(const QString& path) { return {path.toStdU16String()}; }

bool isSameFile(const QString& a, const QString& b) {
  const QFileInfo file(a);
  const QFileInfo other(b);
  return file.absoluteFilePath() == other.absoluteFilePath() || (file.exists() && other.exists() && file == other);
}

QString freePath(const QDir& folder, const QString& name) {
  QString path = folder.filePath(name + QStringLiteral(".hexo"));
  for (int k = 2; QFileInfo::exists(path); ++k) path = folder.filePath(QStringLiteral("%1-%2.hexo").arg(name).arg(k));
  return path;
}

QString unsavedFolder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath(QStringLiteral("unsaved"));
}

bool isInUnsavedFolder(const QString& path) {
  return QFileInfo(path).absolutePath() == QFileInfo(unsavedFolder()).absoluteFilePath();
}

QString newScratchPath(const QString& name) {
  const QDir folder(unsavedFolder());
  folder.mkpath(QStringLiteral("."));
  return freePath(folder, QStringLiteral("%1-%2-%3").arg(name, stamp()).arg(QCoreApplication::applicationPid()));
}

QString newSessionPath(const QString& folder) { return freePath(QDir(folder), QStringLiteral("skin-") + stamp()); }

}  // namespace hexoderm
