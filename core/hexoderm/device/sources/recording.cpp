#include "hexoderm/device/sources/recording.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/system_reason.h"
#include "hexoderm/base/temporary_file.h"
#include "hexoderm/device/skinwire/codec.h"
#include "hexoderm/device/skinwire/description.h"
#include "hexoderm/device/skinwire/little_endian.h"
#include "hexoderm/device/skinwire/sample_messages.h"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <string_view>
#include <system_error>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::string_view kMagic = "SKINREC";
constexpr char kVersion = '1';
constexpr std::size_t kHead = 12;  // arrival time, length
constexpr std::chrono::seconds kFlushEvery(1);

}  // namespace

struct StreamRecorder::Impl {
  using Clock = std::chrono::steady_clock;

  std::filesystem::path path;
  SkinListener& next;
  std::ofstream file;
  FileDescriptor place;  ///< of the same file, which has none that can be asked
  bool is_new = false;   ///< the file was not there before
  bool begun = false;
  Clock::time_point began = Clock::now();
  Clock::time_point flushed = began;
  mutable std::mutex mutex;
  Message failure;  ///< guarded

  SkinDescription skin;
  std::uint32_t stream = 1;
  std::uint32_t topology = 0;
  skinwire::SampleEncoder encoder{0};
  double last_time_s = 0;
  std::uint64_t lost_samples = 0;  ///< on the way from the device, up to now
  std::vector<skinwire::Samples> messages;

  Impl(std::filesystem::path where, SkinListener& listener) : path(std::move(where)), next(listener) {}

  skinwire::JointsEncoder joints;

  void fail(const Message& why) {
    file.close();
    const std::lock_guard lock(mutex);
    if (failure.empty()) failure = located(path.string(), message("the recording ended: {}", why));
  }

  void write(const skinwire::Message& message) {
    const std::vector<std::uint8_t> body = skinwire::encodeBody(message);
    const auto arrived = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - began);
    std::vector<std::uint8_t> head;
    skinwire::appendLittleEndian(static_cast<std::uint64_t>(arrived.count()), head);
    skinwire::appendLittleEndian(static_cast<std::uint32_t>(body.size()), head);
    put(head);
    put(body);
  }

  void put(const std::vector<std::uint8_t>& bytes) {
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

  void writeDescription() {
    write(skinwire::helloOf(skin, 0, stream));
    for (const skinwire::Topology& part : skinwire::topologyParts(skin.neighbors, topology)) write(part);
    joints.nameAgain();
  }

  /// In the place of what was there.
  void begin() {
    if (std::exchange(begun, true)) return;
    std::error_code no_regular_file;
    std::filesystem::resize_file(path, 0, no_regular_file);
    file << kMagic << kVersion << std::flush;
  }

  /// Somebody who has moved or removed the file would look in vain for what comes now.
  void requireInPlace() {
    if (!place.valid() || isAt(path, place.get())) return;
    const std::optional<std::filesystem::path> now = placeOf(place.get());
    fail(now ? message("it was moved to {} while it was written, with what was recorded before", now->string())
             : message("it was removed while it was written, with what was recorded before"));
  }

  /// Recording must not take listening down with it.
  template <class Action>
  void guarded(const Action& action) {
    if (!file.is_open() || !begun) return;
    try {
      action();
      const Clock::time_point now = Clock::now();
      const bool is_to_flush = now - flushed >= kFlushEvery;
      if (is_to_flush) {
        file.flush();
        flushed = now;
      }
      if (!file) {
        fail(systemReason(errno));
      } else if (is_to_flush) {
        requireInPlace();
      }
    } catch (const std::exception& error) {
      fail(messageOf(error));
    }
  }
};

StreamRecorder::StreamRecorder(std::filesystem::path path, SkinListener& next)
    : impl_(std::make_unique<Impl>(std::move(path), next)) {
  requireReplaceable(impl_->path, impl_->path.string());
  impl_->is_new = !std::filesystem::exists(impl_->path);
  const bool replaces = std::filesystem::is_regular_file(impl_->path);
  impl_->file.open(impl_->path, std::ios::binary | std::ios::app);
  if (impl_->file.is_open()) impl_->place = FileDescriptor(::open(impl_->path.c_str(), O_PATH | O_CLOEXEC));
  if (impl_->file.is_open() && !replaces) impl_->begin();
  if (!impl_->file) {
    const int reason = errno;
    removeWhatIsEmpty();
    throw StorageError(impl_->path.string(), message("a recording can't be written there: {}", systemReason(reason)));
  }
}

StreamRecorder::~StreamRecorder() { removeWhatIsEmpty(); }

void StreamRecorder::removeWhatIsEmpty() noexcept {
  if (impl_->skin.model || !impl_->is_new || !isAt(impl_->path, impl_->place.get())) return;
  std::error_code ignored;
  std::filesystem::remove(impl_->path, ignored);
}

void StreamRecorder::onSkin(const SkinDescription& skin) {
  impl_->next.onSkin(skin);
  if (impl_->file.is_open()) impl_->begin();
  impl_->guarded([&] {
    const bool new_model = !impl_->skin.model || impl_->skin.model != skin.model;
    impl_->skin = skin;
    ++impl_->topology;
    if (new_model) {
      // Its LSB may be another; the numbers start over, and so does the stream.
      impl_->encoder = skinwire::SampleEncoder(skin.model->accelerometer.lsb_g);
      ++impl_->stream;
    }
    impl_->writeDescription();
  });
}

void StreamRecorder::onFrame(const SampleFrame& frame) {
  impl_->next.onFrame(frame);
  impl_->guarded([&] {
    if (frame.time_s < impl_->last_time_s) {
      ++impl_->stream;  // the device's clock began anew
      impl_->writeDescription();
    }
    impl_->last_time_s = frame.time_s;
    impl_->messages.clear();
    impl_->encoder.encode(frame, impl_->messages);
    for (skinwire::Samples& message : impl_->messages) {
      // The encoder numbers what came; the file tells of what did not.
      if (message.sequence) *message.sequence += impl_->lost_samples;
      impl_->write(std::move(message));
    }
  });
}

void StreamRecorder::onStatus(const SourceStatus& status) {
  impl_->next.onStatus(status);
  // Less of them, where one came late after all: what is written can't be taken back.
  impl_->lost_samples = std::max(impl_->lost_samples, status.lost_samples);
}

void StreamRecorder::onDeviceStatus(const DeviceStatus& status) {
  impl_->next.onDeviceStatus(status);
  impl_->guarded([&] {
    impl_->write(skinwire::Status{status.text, status.exploring, status.samples_sent, status.samples_dropped});
  });
}

void StreamRecorder::onJoints(const JointReport& joints) {
  impl_->next.onJoints(joints);
  if (joints.angles.positions.empty()) return;
  impl_->guarded([&] { impl_->write(impl_->joints.encode(joints)); });
}

void StreamRecorder::onCommandOutcome(const CommandOutcome& outcome) { impl_->next.onCommandOutcome(outcome); }

void StreamRecorder::finish() {
  if (impl_->file.is_open()) {
    impl_->file.close();
    if (impl_->file) {
      impl_->requireInPlace();
    } else {
      impl_->fail(systemReason(errno));
    }
  }
  if (const Message why = error(); !why.empty()) throw StorageError(why);
}

Message StreamRecorder::error() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->failure;
}

bool RecordingReader::read(std::span<std::uint8_t> bytes, bool may_end) {
  file_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  const auto count = static_cast<std::size_t>(file_.gcount());
  if (count == bytes.size()) return true;
  if (count > 0 || !may_end) damage_ = located(path_, message("is cut off; all before byte {} was played", position_));
  return false;
}

RecordingReader::RecordingReader(const std::filesystem::path& path) : path_(path.string()) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw StorageError(path_, message("is a folder, expected a recording"));
  }
  file_.open(path, std::ios::binary);
  if (!file_) throw StorageError(path_, message("can't be read: {}", systemReason(errno)));
  std::array<std::uint8_t, kMagic.size() + 1> magic{};
  const bool whole = read(magic, false);
  const char version = static_cast<char>(magic.back());
  if (!whole || !std::equal(kMagic.begin(), kMagic.end(), magic.begin()) || version < kVersion || version > '9') {
    throw FormatError(path_, message("is no recording of a skin, expected it to begin with \"SKINREC1\""));
  }
  if (version > kVersion) {
    throw FormatError(path_, message("this recording has version {}, this program reads version {}",
                                     std::string(1, version), std::string(1, kVersion)));
  }
  position_ = magic.size();
}

std::optional<RecordedBody> RecordingReader::next() {
  if (!damage_.empty()) return std::nullopt;
  std::array<std::uint8_t, kHead> head{};
  if (!read(head, true)) return std::nullopt;
  const auto arrived_us = skinwire::littleEndian<std::uint64_t>(head);
  const auto length = skinwire::littleEndian(skinwire::ByteView(head).subspan(8));
  if (length > skinwire::kMaxBody || arrived_us > skinwire::kMaxTime_us) {
    damage_ = located(
        path_, message("byte {}: a record says that it has {} bytes, at most {} were expected; the rest can't be read",
                       position_, length, skinwire::kMaxBody));
    return std::nullopt;
  }
  RecordedBody record;
  record.body.resize(length);
  if (!read(record.body, false)) return std::nullopt;
  position_ += kHead + length;
  last_ = std::max(last_, std::chrono::microseconds(arrived_us));
  record.arrived = last_;
  return record;
}

}  // namespace hexoderm
