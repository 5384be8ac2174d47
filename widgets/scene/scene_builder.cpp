#include "widgets/scene/scene_builder.h"

#include <utility>

namespace hexoderm {

SceneBuilder::SceneBuilder(std::function<void(Content)> deliver) : deliver_(std::move(deliver)) {}

void SceneBuilder::submit(std::shared_ptr<const Reconstruction> reconstruction) {
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

void SceneBuilder::cancel() {
  worker_.cancel();
  const std::lock_guard lock(mutex_);
  settled_ = submitted_;
  result_.reset();
}

bool SceneBuilder::isBusy() const {
  const std::lock_guard lock(mutex_);
  return settled_ < submitted_ || result_;
}

void SceneBuilder::finish() {
  worker_.waitUntilIdle();
  deliverResult();
}

void SceneBuilder::deliverResult() {
  std::optional<Content> result;
  {
    const std::lock_guard lock(mutex_);
    result = std::exchange(result_, std::nullopt);
  }
  if (result) deliver_(std::move(*result));
}

}  // namespace hexoderm
