#pragma once

#include <QString>
#include <filesystem>

class QDir;

namespace hexoderm {

// Folders of sessions, and names for new ones. Sessions that nobody has saved yet are kept in files of their own all
// the same, so that a killed program loses nothing; each is removed when its session was saved elsewhere or given up
// knowingly.

std::filesystem::path toPath(const QString& path);

/// Unlike Qt's comparison, which takes any two files that are not there for the same.
bool isSameFile(const QString& a, const QString& b);

/// "NAME.hexo" in the folder, or "NAME-2.hexo", ...: the first that is not taken.
QString freePath(const QDir& folder, const QString& name);

/// The folder of sessions that were not saved anywhere: AppDataLocation/unsaved.
QString unsavedFolder();
bool isInUnsavedFolder(const QString& path);
/// A new name in unsavedFolder(), for example ".../unsaved/demo-20260102-150405-4711.hexo". The folder is made if it
/// can be.
QString newScratchPath(const QString& name);
/// A new name for a session that is about to be captured: "skin-20261121-173335.hexo" in `folder`.
QString newSessionPath(const QString& folder);

}  // namespace hexoderm
