#pragma once

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QString>
#include <filesystem>

namespace hexoderm {

inline QString timeStamp() { return QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")); }

// Folders of sessions, and names for new ones. Sessions that nobody has saved yet are kept in files of their own all
// the same, so that a killed program loses nothing; each is removed when its session was saved elsewhere or given up
// knowingly.

inline std::filesystem::path toPath(const QString& path) { return {path.toStdU16String()}; }

/// Unlike Qt's comparison, which takes any two files that are not there for the same.
inline bool isSameFile(const QString& a, const QString& b) {
  const QFileInfo file(a);
  const QFileInfo other(b);
  return file.absoluteFilePath() == other.absoluteFilePath() || (file.exists() && other.exists() && file == other);
}

/// "NAME.hexo" in the folder, or "NAME-2.hexo", ...: the first that is not taken.
inline QString freePath(const QDir& folder, const QString& name) {
  QString path = folder.filePath(name + QStringLiteral(".hexo"));
  for (int k = 2; QFileInfo::exists(path); ++k) path = folder.filePath(QStringLiteral("%1-%2.hexo").arg(name).arg(k));
  return path;
}

/// The folder of sessions that were not saved anywhere: AppDataLocation/unsaved.
inline QString unsavedFolder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath(QStringLiteral("unsaved"));
}
inline bool isInUnsavedFolder(const QString& path) {
  return QFileInfo(path).absolutePath() == QFileInfo(unsavedFolder()).absoluteFilePath();
}
/// A new name in unsavedFolder(), for example ".../unsaved/demo-20260102-150405-4711.hexo". The folder is made if it
/// can be.
inline QString newScratchPath(const QString& name) {
  const QDir folder(unsavedFolder());
  folder.mkpath(QStringLiteral("."));
  return freePath(folder, QStringLiteral("%1-%2-%3").arg(name, timeStamp()).arg(QCoreApplication::applicationPid()));
}
/// A new name for a session that is about to be captured: "skin-20261121-173335.hexo" in `folder`.
inline QString newSessionPath(const QString& folder) {
  return freePath(QDir(folder), QStringLiteral("skin-") + timeStamp());
}

}  // namespace hexoderm
