#pragma once

#include "widgets/scene/scene_content.h"

#include <QObject>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace hexoderm {

/// Makes the content of large skins on a thread of its own. One slot, the newest wins: what was not begun when a newer
/// reconstruction comes is never made.
class SceneBuilder {
 public:
  using Content = std::shared_ptr<const SceneContent>;

  /// `deliver` is called with each result, on the thread that made the builder (which needs an event loop), and never
  /// after the destructor, which waits for the content being made.
  explicit SceneBuilder(std::function<void(Content)> deliver);
  ~SceneBuilder();
  SceneBuilder(const SceneBuilder&) = delete;
  SceneBuilder& operator=(const SceneBuilder&) = delete;

  void submit(std::shared_ptr<const Reconstruction> reconstruction);
  /// Forgets what is waiting, and what is being made.
  void cancel();
  /// Something was submitted and has not been delivered yet.
  [[nodiscard]] bool isBusy() const;
  /// Waits for what was submitted and delivers it now: for pictures, which must show what the tables beside them do.
  void finish();

 private:
  void run(const std::stop_token& stop);
  void deliverResult();

  std::function<void(Content)> deliver_;
  QObject receiver_;  ///< receiver of the posted deliveries, which go with it
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::shared_ptr<const Reconstruction> waiting_;
  bool running_ = false;
  bool cancelled_ = false;  ///< the running work is not wanted any more
  std::optional<Content> result_;
  std::jthread thread_;  // last: joined before what it uses goes
};

}  // namespace hexoderm
