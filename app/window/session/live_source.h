#pragma once

#include "app/window/files/job_queue.h"
#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/device/skin_source.h"

#include <QObject>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

/// What a source is started with.
struct LiveOptions {
  QString address;  ///< as openSkinSource() takes it
  PoseId next_pose{1};
  std::vector<std::shared_ptr<const PoseCapture>> earlier_poses;  ///< those that a capture can repeat
  PoseRecorderOptions recorder;
};

/// A skin that is connected: a source and the recorder of its poses, which run on the source's thread, as signals on
/// the thread of this object. Of states that follow each other faster than they are looked at, the newest is signalled.
/// Nothing here waits: opening, connecting and the end of a source happen elsewhere.
class LiveSource : public QObject {
  Q_OBJECT

 public:
  explicit LiveSource(QObject* parent = nullptr);
  ~LiveSource() override;

  /// Stops what runs, and starts. What goes wrong follows as failed() or as a state.
  void start(const LiveOptions& options);
  /// Nothing of the source is signalled afterwards.
  void stop();

  /// From start() on until stop() or failed().
  [[nodiscard]] bool isRunning() const { return feed_ != nullptr; }
  [[nodiscard]] QString address() const { return address_; }
  [[nodiscard]] const SourceStatus& status() const { return status_; }
  [[nodiscard]] const HoldStatus& hold() const { return hold_; }
  /// What the cells read of late; empty before the first readings.
  [[nodiscard]] const SkinPreview& preview() const { return preview_; }
  /// What the device said of itself; nothing as long as it did not.
  [[nodiscard]] const std::optional<SkinDescription>& skin() const { return skin_; }
  [[nodiscard]] bool isAutomatic() const { return automatic_; }

  void setAutomatic(bool automatic);
  void captureNow();
  void setEarlierPoses(std::vector<std::shared_ptr<const PoseCapture>> poses);
  /// 0 if nothing runs.
  std::uint32_t send(const SkinCommand& command);

 signals:
  void skinDescribed(const hexoderm::SkinDescription& skin);
  void poseCaptured(const hexoderm::CapturedPose& captured);
  /// At most once per turn of the event loop.
  void holdChanged();
  void previewChanged();
  void statusChanged();
  void commandAnswered(const hexoderm::CommandOutcome& outcome);
  /// The source could not be opened, and is not running any more.
  void failed(const QString& message);

 private:
  class Feed;

  std::shared_ptr<Feed> feed_;  ///< of the source that runs; late words of others are dropped
  QString address_;
  SourceStatus status_;
  HoldStatus hold_;
  SkinPreview preview_;
  std::optional<SkinDescription> skin_;
  bool automatic_ = true;

  JobQueue jobs_;  // last: it has ended before anything it reports to goes
};

}  // namespace hexoderm
