#pragma once

#include "hexoderm/base/thread_priority.h"

#include <QCoreApplication>
#include <QMetaObject>
#include <QPointer>
#include <QThreadPool>
#include <atomic>
#include <functional>
#include <utility>

namespace hexoderm {

/// Runs jobs one after another on a thread of its own: files and the simulated skin never make the window wait. Jobs
/// must not throw. The destructor finishes the running job and the essential ones, drops the others and joins.
class JobQueue {
 public:
  using Job = std::function<void()>;

  /// `is_urgent`: its jobs do not give way to computations.
  explicit JobQueue(bool is_urgent = false) {
    pool_.setMaxThreadCount(1);
    pool_.setExpiryTimeout(-1);
    if (!is_urgent) pool_.start(giveWayToOtherThreads);
  }
  ~JobQueue() { is_ending_ = true; }
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  void add(Job job) {
    addEssential([this, job = std::move(job)] {
      if (!is_ending_) job();
    });
  }
  void addEssential(Job job) { pool_.start(std::move(job)); }
  /// What `work` returns is called with the object on the application's thread, if the object is still there.
  template <class Object, class Work>
  void addFor(Object* object, Work work) {
    add([self = QPointer<Object>(object), work = std::move(work)] {
      QMetaObject::invokeMethod(
          QCoreApplication::instance(),
          [self, then = work()] {
            if (self) then(*self);
          },
          Qt::QueuedConnection);
    });
  }

 private:
  std::atomic<bool> is_ending_ = false;
  QThreadPool pool_;  // last: its thread has ended before what it uses goes
};

}  // namespace hexoderm
