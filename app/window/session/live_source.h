#pragma once

#include "app/window/files/job_queue.h"
#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/device/skin_source.h"
#include "hexoderm/device/sources/open_source.h"
#include "widgets/words/words.h"

#include <QMetaObject>
#include <QObject>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
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
  explicit LiveSource(QObject* parent = nullptr) : QObject(parent) {}
  ~LiveSource() override { feed_.reset(); }

  /// Stops the running source, and starts another. Failures follow as failed() or as a state.
  void start(const LiveOptions& options) {
    stop();
    feed_ = std::make_shared<Feed>(*this, options.recorder);
    feed_->recorder().setNextPoseId(options.next_pose);
    feed_->recorder().setEarlierPoses(options.earlier_poses);
    address_ = options.address;
    status_.state = SourceState::Connecting;
    status_.message = message("Connecting to {}", address_.toStdString());
    jobs_.add([feed = feed_, address = address_.toStdString()] {
      try {
        feed->open(address);
      } catch (const std::exception& error) {
        feed->post([message = words(error)](LiveSource& live) {
          live.stop();
          emit live.failed(message);
        });
      }
    });
    emit statusChanged();
  }

  /// Nothing of the source is signalled afterwards.
  void stop() {
    if (!feed_) return;
    jobs_.add([feed = std::move(feed_)] { feed->stop(); });
    feed_.reset();
    skin_.reset();
    hold_ = {};
    preview_ = {};
    status_ = {};
    emit statusChanged();
  }

  /// From start() on until stop() or failed().
  [[nodiscard]] bool isRunning() const { return feed_ != nullptr; }
  [[nodiscard]] QString address() const { return address_; }
  [[nodiscard]] const SourceStatus& status() const { return status_; }
  [[nodiscard]] const HoldStatus& hold() const { return hold_; }
  /// The latest readings of the cells; empty before the first ones.
  [[nodiscard]] const SkinPreview& preview() const { return preview_; }
  /// The device's description of itself; none before it has arrived.
  [[nodiscard]] const std::optional<SkinDescription>& skin() const { return skin_; }

  void setAutomatic(bool automatic) {
    if (feed_) feed_->recorder().setAutomatic(automatic);
  }

  void captureNow() {
    if (feed_) feed_->recorder().captureNow();
  }

  void setEarlierPoses(std::vector<std::shared_ptr<const PoseCapture>> poses) {
    if (feed_) feed_->recorder().setEarlierPoses(std::move(poses));
  }

  /// 0 if nothing runs.
  std::uint32_t send(const SkinCommand& command) { return feed_ ? feed_->send(command) : 0; }

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
  /// Lives on the source's thread; posts to the LiveSource, which lives longer.
  class Feed final : public SkinListener, public PoseRecorderListener, public std::enable_shared_from_this<Feed> {
   public:
    Feed(LiveSource& live, PoseRecorderOptions options) : live_(live), recorder_(*this, std::move(options)) {}
    ~Feed() override { stop(); }
    Feed(const Feed&) = delete;
    Feed& operator=(const Feed&) = delete;

    /// May take as long as it takes to build a simulated skin or to read the beginning of a file. Throws as
    /// openSkinSource() and SkinSource::start().
    void open(const std::string& address) {
      std::unique_ptr<SkinSource> source = openSkinSource(address);
      source->start(*this);
      const std::lock_guard lock(mutex_);
      source_ = std::move(source);
    }
    /// Joins the source's thread.
    void stop() {
      std::unique_ptr<SkinSource> source;
      {
        const std::lock_guard lock(mutex_);
        source = std::move(source_);
      }
      if (source) source->stop();
    }
    std::uint32_t send(const SkinCommand& command) {
      const std::lock_guard lock(mutex_);
      return source_ ? source_->send(command) : 0;
    }
    PoseRecorder& recorder() { return recorder_; }

    /// Runs `then` on the GUI thread if this source is still the one that counts.
    template <class Then>
    void post(Then then) {
      QMetaObject::invokeMethod(
          &live_,
          [self = weak_from_this(), &live = live_, then = std::move(then)] {
            const std::shared_ptr<Feed> feed = self.lock();
            if (feed && live.feed_ == feed) then(live);
          },
          Qt::QueuedConnection);
    }

    void onSkin(const SkinDescription& skin) override {
      recorder_.setSkin(skin);
      post([skin](LiveSource& live) {
        live.skin_ = skin;
        emit live.skinDescribed(skin);
      });
    }
    void onFrame(const SampleFrame& frame) override { recorder_.addFrame(frame); }
    void onJoints(const JointReport& joints) override { recorder_.addJoints(joints); }
    void onStatus(const SourceStatus& status) override {
      if (!keepNewest(status_, status)) return;
      post([this](LiveSource& live) {
        live.status_ = takeNewest(status_);
        emit live.statusChanged();
      });
    }
    void onCommandOutcome(const CommandOutcome& outcome) override {
      post([outcome](LiveSource& live) { emit live.commandAnswered(outcome); });
    }
    void onPoseCaptured(CapturedPose captured) override {
      post([captured = std::move(captured)](LiveSource& live) { emit live.poseCaptured(captured); });
    }
    void onHold(const HoldStatus& status) override {
      if (!keepNewest(hold_, status)) return;
      post([this](LiveSource& live) {
        live.hold_ = takeNewest(hold_);
        emit live.holdChanged();
      });
    }
    void onPreview(SkinPreview preview) override {
      if (!keepNewest(preview_, std::move(preview))) return;
      post([this](LiveSource& live) {
        live.preview_ = takeNewest(preview_);
        emit live.previewChanged();
      });
    }

   private:
    /// True if nobody is on the way to take it yet.
    template <class State>
    bool keepNewest(std::optional<State>& kept, State state) {
      const std::lock_guard lock(mutex_);
      const bool is_first = !kept;
      kept = std::move(state);
      return is_first;
    }
    template <class State>
    State takeNewest(std::optional<State>& kept) {
      const std::lock_guard lock(mutex_);
      return std::move(*std::exchange(kept, std::nullopt));
    }

    LiveSource& live_;
    std::mutex mutex_;
    std::optional<SourceStatus> status_;
    std::optional<HoldStatus> hold_;
    std::optional<SkinPreview> preview_;
    PoseRecorder recorder_;
    std::unique_ptr<SkinSource> source_;  // last: it calls this object until it has stopped
  };

  std::shared_ptr<Feed> feed_;  ///< feed of the running source; late words of others are dropped
  QString address_;
  SourceStatus status_;
  HoldStatus hold_;
  SkinPreview preview_;
  std::optional<SkinDescription> skin_;

  JobQueue jobs_;  // last: it has ended before anything it reports to goes
};

}  // namespace hexoderm
