#pragma once

#include "app/window/files/job_queue.h"
#include "widgets/words/words.h"

#include <QMetaObject>
#include <QObject>
#include <QStringList>
#include <exception>
#include <functional>
#include <utility>

namespace hexoderm {

/// Work that the window does not wait for, done on one thread in the order in which it was started.
class BackgroundWork : public QObject {
  Q_OBJECT

 public:
  using Continuation = std::function<void()>;
  using Work = std::function<Continuation()>;

  /// Runs `work` on the thread, then `finally` and the continuation that `work` returned on the thread of this object.
  /// An exception from `work` becomes failed().
  void start(const QString& activity, Work work, Continuation finally = {}) {
    activities_.push_back(activity);
    emit changed();
    jobs_.add([this, work = std::move(work), finally = std::move(finally)] {
      Continuation then;
      try {
        then = work();
      } catch (const std::exception& error) {
        then = [this, message = words(error)] { emit failed(message); };
      }
      QMetaObject::invokeMethod(
          this,
          [this, then = std::move(then), finally] {
            activities_.pop_front();
            if (finally) finally();
            then();
            emit changed();
          },
          Qt::QueuedConnection);
    });
  }

  /// The same for a file: isWriting() until it is there.
  void startWriting(const QString& activity, Work work) {
    ++writing_;
    start(activity, std::move(work), [this] { --writing_; });
  }

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
