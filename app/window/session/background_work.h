#pragma once

#include "app/window/files/job_queue.h"

#include <QObject>
#include <QStringList>
#include <functional>

namespace hexoderm {

/// Work that the window does not wait for, done on one thread in the order in which it was started.
class BackgroundWork : public QObject {
  Q_OBJECT

 public:
  using Continuation = std::function<void()>;
  using Work = std::function<Continuation()>;

  /// Runs `work` on the thread, then `finally` and the continuation that `work` returned on the thread of this object.
  /// An exception from `work` becomes failed().
  void start(const QString& activity, Work work, Continuation finally = {});
  /// The same for a file: isWriting() until it is there.
  void startWriting(const QString& activity, Work work);

  /// The job that runs, in words; empty if none does.
  [[nodiscard]] QString activity() const { return activities_.isEmpty() ? QString() : activities_.front(); }
  [[nodiscard]] bool isWriting() const { return writing_ > 0; }
  /// The thread, for jobs without words.
  [[nodiscard]] JobQueue& jobs() { return jobs_; }

 signals:
  void changed();
  void failed(const QString& message);

 private:
  QStringList activities_;
  int writing_ = 0;
  JobQueue jobs_;  // last: its thread has ended before what it reports to goes
};

}  // namespace hexoderm
