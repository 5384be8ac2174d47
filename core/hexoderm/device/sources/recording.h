#pragma once

#include "hexoderm/device/skin_source.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hexoderm {

/// Writes the stream of a source into a file, as SkinWire's own frames, and passes everything on to another listener:
/// put it between a source and its listener. Frames are passed on first. If the disk fails, or somebody
/// moves or removes the file, recording ends with error(), and listening goes on. The device's description of itself is
/// among the frames, and losses on the way are gaps in their numbering, so that a replay counts the same losses.
///
/// The file: "SKINREC1", then records of arrival time since the beginning (microseconds, 64 bits), length of the body
/// (32 bits), both little-endian, and the body (major, type, protobuf, CRC-32C). Records are flushed to the file once a
/// second; a recording that was cut off is good up to its last whole record.
class StreamRecorder final : public SkinListener {
 public:
  /// Replaces a file that is there as soon as a skin has described itself. Throws StorageError if it can't be written.
  /// `next` must outlive the recorder.
  StreamRecorder(std::filesystem::path path, SkinListener& next);
  ~StreamRecorder() override;

  void onSkin(const SkinDescription& skin) override;
  void onFrame(const SampleFrame& frame) override;
  void onStatus(const SourceStatus& status) override;
  void onCommandOutcome(const CommandOutcome& outcome) override;
  void onDeviceStatus(const DeviceStatus& status) override;
  void onJoints(const JointReport& joints) override;

  /// Ends the recording. After the source was stopped, or on its thread. Throws StorageError if not all was written.
  void finish();
  /// Why recording ended early; empty if it did not. From any thread.
  [[nodiscard]] Message error() const;

 private:
  void removeWhatIsEmpty() noexcept;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What a recording says of the body that was captured.
struct RecordedBody {
  std::chrono::microseconds arrived{};  ///< since the recording began; never goes back
  std::vector<std::uint8_t> body;       ///< not yet checked
};

/// Reads a recording from its beginning.
class RecordingReader {
 public:
  /// Throws StorageError if the file can't be read, FormatError if it is no recording or one of a newer version.
  explicit RecordingReader(const std::filesystem::path& path);
  /// nullopt at the end, also at the first record that is not whole or claims an impossible length.
  std::optional<RecordedBody> next();
  /// The place and kind of damage if the file ends before its time, for people; empty otherwise.
  [[nodiscard]] const Message& damage() const { return damage_; }

 private:
  /// False, with `damage`, if there are fewer bytes; an end before the first byte is none where that is allowed.
  bool read(std::span<std::uint8_t> bytes, bool may_end);

  std::string path_;
  std::ifstream file_;
  std::uint64_t position_ = 0;
  std::chrono::microseconds last_{};
  Message damage_;
};

/// The speed at which a recording is played.
struct ReplayOptions {
  double speed = 1;       ///< times real time, above 0; infinity: as fast as the listener takes it
  bool stepwise = false;  ///< only by step()
};

/// Plays a recording of a StreamRecorder. It takes no commands; at its end it is Ended.
class ReplaySource : public SkinSource {
 public:
  /// Delivers the next frames, and what lies before them, where replay is stepwise. From any thread; never waits.
  virtual void step(std::uint64_t frames = 1) = 0;
};
/// Throws InvalidArgument for a speed that is none.
std::unique_ptr<ReplaySource> replaySource(std::filesystem::path path, ReplayOptions options = {});

}  // namespace hexoderm
