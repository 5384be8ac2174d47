#pragma once

// Private to session/: entries of the journal, written from operations and read back into what they amount to.

#include "hexoderm/session/sample_blobs.h"
#include "hexoderm/session/session_store.h"

#include <array>
#include <map>
#include <utility>

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

/// The state of a session after the entries so far.
class JournalState {
 public:
  struct StoredPose {
    std::int64_t entry = 0;  ///< entry of its capture
    SessionPose pose;
  };

  /// Applies an entry that was read. Throws FormatError beginning with `file` and the entry: not the next one, digest
  /// wrong, content that is no entry, or makes no sense after those before.
  void read(const JournalEntry& entry, const std::string& file);
  /// The next entry, that says an operation; read() applies it. Throws InvalidArgument if it makes no sense now.
  [[nodiscard]] JournalEntry entryFor(const StoreOperation& operation, std::int64_t at_ms,
                                      const std::string& raw_sha256) const;

  /// Throws InvalidArgument if there is no skin yet.
  [[nodiscard]] Session session(const std::string& file) const;
  [[nodiscard]] const StoredPose& poseAt(std::size_t index) const;  ///< throws InvalidArgument
  /// SHA-256 of the raw samples of a capture, hexadecimal; empty if it has none.
  [[nodiscard]] std::string rawSha256(std::int64_t capture) const;
  [[nodiscard]] std::int64_t lastEntry() const { return last_entry_; }
  [[nodiscard]] std::int64_t editedAtMs() const { return edited_at_ms_; }
  [[nodiscard]] const std::string& options() const { return options_; }
  [[nodiscard]] bool hasSkin() const { return model_ != nullptr; }
  /// The step of the skin's accelerometers; 0 without a skin.
  [[nodiscard]] double lsb_g() const { return model_ ? model_->accelerometer.lsb_g : 0; }

 private:
  void insert(StoredPose pose, std::size_t place);
  StoredPose take(std::size_t index);
  void restore(std::int64_t capture, std::size_t place);
  [[nodiscard]] std::size_t placeOf(std::int64_t capture) const;
  /// Null if none of this ID was removed.
  [[nodiscard]] const StoredPose* lastRemoved(PoseId id) const;
  void apply(const JournalEntry& entry, const std::string& where);

  std::shared_ptr<const CellModel> model_;
  std::shared_ptr<const NeighborList> neighbors_;  ///< shared, because states are copied for every transaction
  SourceDescription source_;
  std::shared_ptr<const GroundTruth> truth_;
  std::string options_ = "{}";
  std::vector<StoredPose> poses_;
  std::vector<StoredPose> removed_;                                 ///< the last removed last
  std::map<std::pair<LinkEnd, LinkEnd>, std::string> muted_links_;  ///< and why
  std::map<std::int64_t, std::string> raw_sha256_;
  std::int64_t last_entry_ = 0;
  std::int64_t edited_at_ms_ = 0;
  Digest digest_{};
};

}  // namespace hexoderm
