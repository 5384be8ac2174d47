#pragma once

#include "widgets/controls/heavy_turn.h"

#include <QObject>
#include <functional>
#include <utility>

namespace hexoderm {

/// Does a piece of work in the next turn of the event loop, once, however often it was requested before that.
class CoalescedRefresh : public QObject {
  Q_OBJECT

 public:
  explicit CoalescedRefresh(std::function<void()> work, QObject* parent = nullptr)
      : QObject(parent), work_(std::move(work)) {}

  /// Does the work at once if it was requested, for pictures that can't wait for the next turn.
  void finish() {
    if (!std::exchange(requested_, false)) return;
    work_();
    HeavyTurn::note();
    emit done();
  }

 public slots:
  void request() {
    if (std::exchange(requested_, true)) return;
    QMetaObject::invokeMethod(this, &CoalescedRefresh::finish, Qt::QueuedConnection);
  }

 signals:
  /// The work was done.
  void done();

 private:
  std::function<void()> work_;
  bool requested_ = false;
};

}  // namespace hexoderm
