#include "app/window/toolkit/once_per_turn.h"

#include "widgets/controls/heavy_turn.h"

#include <utility>

namespace hexoderm {

OncePerTurn::OncePerTurn(std::function<void()> work, QObject* parent) : QObject(parent), work_(std::move(work)) {}

void OncePerTurn::request() {
  if (std::exchange(requested_, true)) return;
  QMetaObject::invokeMethod(this, &OncePerTurn::finish, Qt::QueuedConnection);
}

void OncePerTurn::finish() {
  if (!std::exchange(requested_, false)) return;
  work_();
  HeavyTurn::note();
  emit done();
}

}  // namespace hexoderm
