#pragma once

// Entries of the journal, written from operations and read back into the session that they make.

#include "hexoderm/base/json_reader.h"
#include "hexoderm/session/sample_blobs.h"
#include "hexoderm/session/session_store.h"

#include <array>
#include <map>

namespace hexoderm {

using Digest = std::array<std::uint8_t, 32>;

/// One row of the table "journal".
struct JournalEntry {
  std::int64_t entry = 0;  ///< 1, 2, 3 ... without gaps
  std::int64_t at_ms = 0;
  std::string kind;
  std::string detail;            ///< a JSON object
  std::optional<Bytes> samples;  ///< of captures
  Digest digest{};               ///< of the entry before and of this one

  [[nodiscard]] Digest expectedDigest(const Digest& previous) const;
};

/// The session that the entries so far make, and what a file knows of it besides. A value: every transaction works on a
/// copy, which shares captures, skin and truth.
class JournalState {
 public:
  /// Applies an entry that was read. Throws FormatError beginning with `file` and the entry: not the next one, digest
  /// wrong, content that is no entry, or makes no sense after those before.
  void read(const JournalEntry& entry, const std::string& file);
  /// The next entry, that says an operation; read() applies it. Throws InvalidArgument if it makes no sense now.
  [[nodiscard]] JournalEntry entryFor(const StoreOperation& operation, std::int64_t at_ms,
                                      const std::string& raw_sha256) const;

  /// Throws InvalidArgument if there is no skin yet.
  [[nodiscard]] Session session(const std::string& file) const;
  /// The entry of the capture of the pose at `index`. Throws InvalidArgument if there is no such pose.
  [[nodiscard]] std::int64_t captureAt(std::size_t index) const;
  /// SHA-256 of the raw samples of a capture, hexadecimal; empty if it has none.
  [[nodiscard]] std::string rawSha256(std::int64_t capture) const;
  [[nodiscard]] std::int64_t lastEntry() const { return last_entry_; }
  [[nodiscard]] std::int64_t editedAtMs() const { return edited_at_ms_; }
  [[nodiscard]] const std::string& options() const { return options_; }
  [[nodiscard]] bool hasSkin() const { return session_.has_value(); }
  /// The step of the skin's accelerometers; 0 without a skin.
  [[nodiscard]] double lsb_g() const { return session_ ? session_->model().accelerometer.lsb_g : 0; }

 private:
  struct RemovedPose {
    std::int64_t capture = 0;  ///< its entry
    SessionPose pose;
  };

  [[nodiscard]] std::size_t placeOf(std::int64_t capture) const;
  /// The last removed pose with this ID and these readings, since a pose that was recaptured has the ID of the one
  /// before. Null if there is none.
  [[nodiscard]] const RemovedPose* lastRemoved(const PoseCapture& capture) const;
  [[nodiscard]] const RemovedPose& removedBy(std::int64_t capture) const;
  /// Gives the entry its kind, its detail and, if it is a capture, its samples.
  void sayEdit(const SessionEdit& edit, const std::string& raw_sha256, JournalEntry& entry) const;
  void apply(const JournalEntry& entry, const std::string& where);
  /// Nothing for the kinds that are no edits.
  [[nodiscard]] std::optional<SessionEdit> editIn(const JournalEntry& entry, const JsonReader& json,
                                                  const std::string& where) const;
  /// Keeps captures_ and removed_ in step with the session. `capture`: the entry of the capture that is added or
  /// restored.
  void apply(const SessionEdit& edit, std::int64_t capture);

  std::optional<Session> session_;      ///< none before the first skin
  std::vector<std::int64_t> captures_;  ///< entries of the captures of the session's poses
  std::vector<RemovedPose> removed_;    ///< the last removed last
  std::string options_ = "{}";
  std::map<std::int64_t, std::string> raw_sha256_;
  std::int64_t last_entry_ = 0;
  std::int64_t edited_at_ms_ = 0;
  Digest digest_{};
};

}  // namespace hexoderm
