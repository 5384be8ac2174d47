#include "app/window/session/live_source.h"

#include "hexoderm/device/sources/open_source.h"
#include "widgets/words/words.h"

#include <QMetaObject>
#include <mutex>
#include <utility>

namespace hexoderm {

/// Lives on the source's thread; posts to the LiveSource, which lives longer.
class LiveSource::Feed final : public SkinListener,
                               public PoseRecorderListener,
                               public std::enable_shared_from_this<Feed> {
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

LiveSource::LiveSource(QObject* parent) : QObject(parent) {}

LiveSource::~LiveSource() { feed_.reset(); }

void LiveSource::start(const LiveOptions& options) {
  stop();
  feed_ = std::make_shared<Feed>(*this, options.recorder);
  feed_->recorder().setNextPoseId(options.next_pose);
  feed_->recorder().setEarlierPoses(options.earlier_poses);
  address_ = options.address;
  automatic_ = options.recorder.automatic;
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

void LiveSource::stop() {
  if (!feed_) return;
  jobs_.add([feed = std::move(feed_)] { feed->stop(); });
  feed_.reset();
  skin_.reset();
  hold_ = {};
  preview_ = {};
  status_ = {};
  emit statusChanged();
}

void LiveSource::setAutomatic(bool automatic) {
  automatic_ = automatic;
  if (feed_) feed_->recorder().setAutomatic(automatic);
}

void LiveSource::captureNow() {
  if (feed_) feed_->recorder().captureNow();
}

void LiveSource::setEarlierPoses(std::vector<std::shared_ptr<const PoseCapture>> poses) {
  if (feed_) feed_->recorder().setEarlierPoses(std::move(poses));
}

std::uint32_t LiveSource::send(const SkinCommand& command) { return feed_ ? feed_->send(command) : 0; }

}  // namespace hexoderm
