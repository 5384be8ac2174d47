#pragma once

#include "hexoderm/base/latest_worker.h"
#include "widgets/scene/scene_content.h"

#include <QCoreApplication>
#include <QObject>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace hexoderm {

/// Makes the content of large skins on a thread of its own. The newest reconstruction wins: one whose content was not
/// begun when a newer one comes is dropped.
class SceneBuilder {
 public:
  using Content = std::shared_ptr<const SceneContent>;

  /// `deliver` is called with each result, on the thread that made the builder (which needs an event loop), and never
  /// after the destructor, which waits for the content being made.
  explicit SceneBuilder(std::function<void(Content)> deliver) : deliver_(std::move(deliver)) {}
  SceneBuilder(const SceneBuilder&) = delete;
  SceneBuilder& operator=(const SceneBuilder&) = delete;

  void submit(std::shared_ptr<const Reconstruction> reconstruction) {
    newest_ = reconstruction;
    worker_.submit(
        [this, reconstruction = std::move(reconstruction), generation = generation_](const std::stop_token& stop) {
          Content content = makeSceneContent(reconstruction);
          if (stop.stop_requested()) return;
          QMetaObject::invokeMethod(
              &receiver_, [this, content = std::move(content), generation] { take(content, generation); },
              Qt::QueuedConnection);
        });
  }

  /// Forgets what is waiting, and what is being made.
  void cancel() {
    ++generation_;
    worker_.cancel();
    QCoreApplication::removePostedEvents(&receiver_, QEvent::MetaCall);
    newest_.reset();
  }

  /// Something was submitted and has not been delivered yet.
  [[nodiscard]] bool isBusy() const { return newest_ != nullptr; }
  /// Waits for what was submitted and delivers it now: for pictures, which must show what the tables beside them do.
  void finish() {
    worker_.waitUntilIdle();
    QCoreApplication::sendPostedEvents(&receiver_, QEvent::MetaCall);
  }

 private:
  void take(const Content& content, std::size_t generation) {
    if (generation != generation_) return;
    if (content->reconstruction == newest_) newest_.reset();
    deliver_(content);
  }

  std::function<void(Content)> deliver_;
  std::size_t generation_ = 0;                    ///< content of an earlier one was cancelled
  QObject receiver_;                              ///< receiver of the posted deliveries, which go with it
  std::shared_ptr<const Reconstruction> newest_;  ///< until it is delivered
  LatestWorker worker_;                           // last: it has ended before anything that it uses is destroyed
};

}  // namespace hexoderm
