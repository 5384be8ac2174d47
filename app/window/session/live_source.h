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

/// The start parameters of a source.
struct LiveOptions {
  QString address;  ///< in the form that openSkinSource() takes
  PoseId next_pose{1};
  std::vector<std::shared_ptr<const PoseCapture>> earlier_poses;  ///< those that a capture can repeat
  PoseRecorderOptions recorder;
};

/// A connected skin: a source and the recorder of its poses, which run on the source's thread, as signals on the thread
/// of this object. If states follow each other faster than they are looked at, the newest is signalled. Nothing here
/// waits: opening, connecting and the end of a source happen elsewhere.
class LiveSource : public QObject {
  Q_OBJECT

 public:
  explicit LiveSource(QObject* parent = nullptr);
  ~LiveSource() override;

  /// Stops the running source, and starts another. Failures follow as failed() or as a state.
  void start(const LiveOptions& options);
  /// Nothing of the source is signalled afterwards.
  void stop();

  /// From start() on until stop() or failed().
  [[nodiscard]] bool isRunning() const { return feed_ != nullptr; }
  [[nodiscard]] QString address() const { return address_; }
  [[nodiscard]] const SourceStatus& status() const { return status_; }
  [[nodiscard]] const HoldStatus& hold() const { return hold_; }
  /// The latest readings of the cells; empty before the first ones.
  [[nodiscard]] const SkinPreview& preview() const { return preview_; }
  /// The device's description of itself; none before it has arrived.
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

  std::shared_ptr<Feed> feed_;  ///< feed of the running source; late words of others are dropped
  QString address_;
  SourceStatus status_;
  HoldStatus hold_;
  SkinPreview preview_;
  std::optional<SkinDescription> skin_;
  bool automatic_ = true;

  JobQueue jobs_;  // last: it has ended before anything it reports to goes
};

}  // namespace hexoderm
