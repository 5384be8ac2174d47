#pragma once

#include <QString>

namespace hexoderm {

// Sessions that nobody has saved yet are kept in files of their own all the same, so that a killed program loses
// nothing: in unsavedFolder() (recovery.h), each removed when its session was saved elsewhere or given up knowingly.

/// A new name in unsavedFolder(), for example ".../unsaved/demo-20260102-150405-4711.hexo". The folder is made if it
/// can be.
QString newScratchPath(const QString& name);
/// With what SQLite keeps beside it. Nothing happens where there is none.
void removeScratchFile(const QString& path);

}  // namespace hexoderm
