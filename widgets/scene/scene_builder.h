#pragma once

#include "hexoderm/util/latest_worker.h"
#include "widgets/scene/scene_content.h"

#include <QObject>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
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
    std::uint64_t number = 0;
    {
      const std::lock_guard lock(mutex_);
      number = ++submitted_;
    }
    worker_.submit([this, number, reconstruction = std::move(reconstruction)](const std::stop_token& stop) {
      Content content = makeSceneContent(reconstruction);
      {
        const std::lock_guard lock(mutex_);
        if (stop.stop_requested()) return;
        result_ = std::move(content);
        settled_ = number;
      }
      QMetaObject::invokeMethod(
          &receiver_, [this] { deliverResult(); }, Qt::QueuedConnection);
    });
  }

  /// Forgets what is waiting, and what is being made.
  void cancel() {
    worker_.cancel();
    const std::lock_guard lock(mutex_);
    settled_ = submitted_;
    result_.reset();
  }

  /// Something was submitted and has not been delivered yet.
  [[nodiscard]] bool isBusy() const {
    const std::lock_guard lock(mutex_);
    return settled_ < submitted_ || result_;
  }

  /// Waits for what was submitted and delivers it now: for pictures, which must show what the tables beside them do.
  void finish() {
    worker_.waitUntilIdle();
    deliverResult();
  }

 private:
  void deliverResult() {
    std::optional<Content> result;
    {
      const std::lock_guard lock(mutex_);
      result = std::exchange(result_, std::nullopt);
    }
    if (result) deliver_(std::move(*result));
  }

  std::function<void(Content)> deliver_;
  QObject receiver_;  ///< receiver of the posted deliveries, which go with it
  mutable std::mutex mutex_;
  std::uint64_t submitted_ = 0;  ///< how many so far
  std::uint64_t settled_ = 0;    ///< number of these that are made or cancelled; those before a made one count too
  std::optional<Content> result_;
  LatestWorker worker_;  // last: it has ended before anything that it uses is destroyed
};

}  // namespace hexoderm
