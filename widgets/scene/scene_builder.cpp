#include "widgets/scene/scene_builder.h"

#include <utility>

namespace hexoderm {

SceneBuilder::SceneBuilder(std::function<void(Content)> deliver)
    : deliver_(std::move(deliver)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

SceneBuilder::~SceneBuilder() {
  thread_.request_stop();
  thread_.join();
}

void SceneBuilder::submit(std::shared_ptr<const Reconstruction> reconstruction) {
  {
    const std::lock_guard lock(mutex_);
    waiting_ = std::move(reconstruction);
  }
  changed_.notify_all();
}

void SceneBuilder::cancel() {
  const std::lock_guard lock(mutex_);
  waiting_.reset();
  result_.reset();
  cancelled_ = running_;
}

bool SceneBuilder::isBusy() const {
  const std::lock_guard lock(mutex_);
  return waiting_ || (running_ && !cancelled_) || result_;
}

void SceneBuilder::finish() {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !waiting_ && !running_; });
  }
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

void SceneBuilder::run(const std::stop_token& stop) {
  for (;;) {
    std::shared_ptr<const Reconstruction> reconstruction;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, stop, [this] { return waiting_ != nullptr; });
      if (stop.stop_requested()) return;
      reconstruction = std::exchange(waiting_, nullptr);
      running_ = true;
      cancelled_ = false;
    }
    Content content = makeSceneContent(std::move(reconstruction));
    {
      const std::lock_guard lock(mutex_);
      running_ = false;
      if (!cancelled_) result_ = std::move(content);
    }
    changed_.notify_all();
    QMetaObject::invokeMethod(
        &receiver_, [this] { deliverResult(); }, Qt::QueuedConnection);
  }
}

}  // namespace hexoderm
