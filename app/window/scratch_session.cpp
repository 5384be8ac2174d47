#include "app/window/scratch_session.h"

#include "app/window/recovery.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>

namespace hexoderm {

QString newScratchPath(const QString& name) {
  const QDir folder(unsavedFolder());
  folder.mkpath(QStringLiteral("."));
  const QString stem = QStringLiteral("%1-%2-%3")
                           .arg(name, QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")),
                                QString::number(QCoreApplication::applicationPid()));
  QString path = folder.filePath(stem + QStringLiteral(".hexo"));
  for (int k = 2; QFile::exists(path); ++k) path = folder.filePath(QStringLiteral("%1-%2.hexo").arg(stem).arg(k));
  return path;
}

void removeScratchFile(const QString& path) {
  for (const char* suffix : {"", "-wal", "-shm"}) QFile::remove(path + QLatin1String(suffix));
}

}  // namespace hexoderm
