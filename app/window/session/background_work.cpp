#include "app/window/session/background_work.h"

#include "widgets/words/words.h"

#include <QMetaObject>
#include <exception>
#include <utility>

namespace hexoderm {

void BackgroundWork::start(const QString& activity, Work work, Continuation finally) {
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

void BackgroundWork::startWriting(const QString& activity, Work work) {
  ++writing_;
  start(activity, std::move(work), [this] { --writing_; });
}

}  // namespace hexoderm
