#pragma once

#include <QObject>
#include <QString>
#include <QVBoxLayout>
#include <QWidget>
#include <cstdint>
#include <vector>

namespace hexoderm {

class JobQueue;

/// A session that was worked on and never saved, left over by a program that was killed or a machine that was switched
/// off.
struct UnsavedSession {
  QString path;
  std::int64_t edited_at_ms = 0;  ///< milliseconds since 1970, UTC; of a file that can't be read, the file's
  std::size_t poses = 0;
  std::size_t cells = 0;
  QString source;   ///< "Simulated x17 on ..."
  QString problem;  ///< why it can't be read; empty if it can
};

/// The sessions `*.hexo` in a folder that no living process has open, the newest first; those without poses are not
/// worth a question and left out. Changes nothing. Reads every file: not on the GUI thread.
std::vector<UnsavedSession> findUnsavedSessions(const QString& folder);

/// Moves the file, with what SQLite keeps beside it, to `discarded/` in its folder; returns where it is now. Throws
/// StorageError. restoreDiscarded() takes it back.
QString discardUnsaved(const QString& path);
QString restoreDiscarded(const QString& discarded_path);
/// Removes for good what was discarded more than a week ago.
void removeOldDiscarded(const QString& folder);

/// "A session of today, 14:32 with 3 poses of 17 cells was not saved."
QString describeUnsaved(const UnsavedSession& session);

/// The sessions that were not saved, as they were found at the start, and what the operator made of them since. Works
/// on files elsewhere than on the GUI thread.
class UnsavedSessions : public QObject {
  Q_OBJECT

 public:
  /// `jobs` must outlive this object.
  UnsavedSessions(JobQueue& jobs, QString folder, QObject* parent = nullptr);

  /// Looks what there is; changed() and found() follow.
  void search();
  /// All sessions, including those that were discarded since.
  [[nodiscard]] const std::vector<UnsavedSession>& all() const { return sessions_; }
  [[nodiscard]] static bool isDiscarded(const UnsavedSession& session);

  /// recoverWanted() asks for it to be opened; until it is, it stays in the list.
  void recover(const QString& path);
  /// It goes from the list, if it is there.
  void noteOpened(const QString& path);
  /// Puts it away for a week; takeBack() until then.
  void discard(const QString& path);
  void takeBack(const QString& path);

 signals:
  void found(int count);
  void changed();
  void recoverWanted(const QString& path);
  void failed(const QString& message);

 private:
  /// Changes where the session's file is, on the thread of the jobs.
  void move(const QString& path, QString (*how)(const QString&));

  JobQueue& jobs_;
  QString folder_;
  std::vector<UnsavedSession> sessions_;
};

/// Says which sessions were not saved, each with "Recover" and "Discard", which can be undone. Hidden as long as there
/// are none.
class RecoveryList : public QWidget {
  Q_OBJECT

 public:
  /// `sessions` must outlive the list.
  explicit RecoveryList(UnsavedSessions& sessions, QWidget* parent = nullptr);

 private:
  void rebuild();
  [[nodiscard]] QWidget* makeRow(const UnsavedSession& session);

  UnsavedSessions& sessions_;
  QVBoxLayout* layout_ = new QVBoxLayout(this);
};

}  // namespace hexoderm
