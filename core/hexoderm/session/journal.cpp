#include "hexoderm/session/journal.h"

#include "hexoderm/graph/cell_model_json.h"
#include "hexoderm/session/session_parts_json.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/hex.h"
#include "hexoderm/util/sha256.h"

#include <algorithm>

namespace hexoderm {
namespace {

using Json = nlohmann::ordered_json;

/// More than anybody takes, and few enough that a file of insertions and removals is read in a moment.
constexpr std::size_t kMostPoses = 100'000;

/// Eight bytes, little-endian.
void addNumber(std::uint64_t value, Sha256& sha) {
  std::array<std::uint8_t, 8> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(value >> (8 * i));
  sha.add(bytes.data(), bytes.size());
}

/// With its length in front, so that no two entries look alike.
void addPart(const void* data, std::size_t size, Sha256& sha) {
  addNumber(size, sha);
  sha.add(data, size);
}

std::int64_t captureOf(const JsonReader& json) { return json.at("capture").unsignedInteger(1); }
std::size_t placeIn(const JsonReader& json) { return json.at("place").unsignedInteger(); }

void requireCapture(const SessionPose& pose) {
  if (!pose.capture) throw InvalidArgument("a pose must hold a capture");
}

/// Makes the entry a capture; its detail is returned.
Json sayCapture(const SessionPose& pose, std::size_t place, JournalEntry& entry) {
  const PoseCapture& capture = *pose.capture;
  entry.kind = "capture";
  entry.samples = encodeSamples(capture.samples);
  Json detail = {{"pose", capture.id.value()}, {"place", place}, {"cells", capture.samples.size()}};
  if (!capture.label.empty()) detail["label"] = capture.label;
  if (capture.taken_at_ms) detail["taken_at_ms"] = *capture.taken_at_ms;
  if (pose.disabled) detail["disabled"] = true;
  if (!pose.why_disabled.empty()) detail["why_disabled"] = pose.why_disabled;
  return detail;
}

}  // namespace

Digest JournalEntry::expectedDigest(const Digest& previous) const {
  Sha256 sha;
  sha.add(previous.data(), previous.size());
  addNumber(static_cast<std::uint64_t>(entry), sha);
  addNumber(static_cast<std::uint64_t>(at_ms), sha);
  addPart(kind.data(), kind.size(), sha);
  addPart(detail.data(), detail.size(), sha);
  if (samples) addPart(samples->data(), samples->size(), sha);
  return sha.finish();
}

void JournalState::insert(StoredPose pose, std::size_t place) {
  if (place > poses_.size()) throw InvalidArgument("there is no place " + std::to_string(place) + " among the poses");
  if (poses_.size() + removed_.size() >= kMostPoses) {
    throw InvalidArgument("a session holds at most " + std::to_string(kMostPoses) + " poses");
  }
  poses_.insert(poses_.begin() + static_cast<std::ptrdiff_t>(place), std::move(pose));
}

JournalState::StoredPose JournalState::take(std::size_t index) {
  StoredPose pose = poseAt(index);
  poses_.erase(poses_.begin() + static_cast<std::ptrdiff_t>(index));
  return pose;
}

void JournalState::restore(std::int64_t capture, std::size_t place) {
  const auto found = std::ranges::find(removed_, capture, &StoredPose::entry);
  if (found == removed_.end()) throw InvalidArgument("a pose can be restored that was removed");
  StoredPose pose = std::move(*found);
  removed_.erase(found);
  insert(std::move(pose), place);
}

const JournalState::StoredPose& JournalState::poseAt(std::size_t index) const {
  if (index >= poses_.size()) throw InvalidArgument("there is no pose at place " + std::to_string(index));
  return poses_[index];
}

std::size_t JournalState::placeOf(std::int64_t capture) const {
  const auto found = std::ranges::find(poses_, capture, &StoredPose::entry);
  if (found == poses_.end()) throw InvalidArgument("entry " + std::to_string(capture) + " is no pose of the session");
  return static_cast<std::size_t>(found - poses_.begin());
}

const JournalState::StoredPose* JournalState::lastRemoved(PoseId id) const {
  const auto found = std::find_if(removed_.rbegin(), removed_.rend(),
                                  [&](const StoredPose& pose) { return pose.pose.capture->id == id; });
  return found == removed_.rend() ? nullptr : &*found;
}

std::string JournalState::rawSha256(std::int64_t capture) const {
  const auto found = raw_sha256_.find(capture);
  return found == raw_sha256_.end() ? std::string() : found->second;
}

void JournalState::read(const JournalEntry& entry, const std::string& file) {
  const std::string where = file + ": journal entry " + std::to_string(entry.entry);
  if (entry.entry != last_entry_ + 1) {
    throw FormatError(where + ": the file is damaged: expected entry " + std::to_string(last_entry_ + 1));
  }
  if (entry.digest != entry.expectedDigest(digest_)) {
    throw FormatError(where + ": the file is damaged: what it holds does not match its digest");
  }
  if (entry.samples.has_value() != (entry.kind == "capture")) {
    throw FormatError(where + ": expected samples in captures and nowhere else");
  }
  try {
    apply(entry, where);
  } catch (const InvalidArgument& error) {
    throw FormatError(where + ": " + error.what());
  }
  if (!hasSkin()) throw FormatError(where + ": expected the skin first, found \"" + entry.kind + "\"");
  last_entry_ = entry.entry;
  edited_at_ms_ = entry.at_ms;
  digest_ = entry.digest;
}

void JournalState::apply(const JournalEntry& entry, const std::string& where) {
  const nlohmann::json document = parseJson(entry.detail, where);
  const JsonReader json(document, where);
  if (!json.isObject()) json.fail("an object");
  const std::string& kind = entry.kind;
  if (kind == "skin") {
    model_ = std::make_shared<const CellModel>(readCellModel(json.at("cell_model")));
    neighbors_ = std::make_shared<const NeighborList>(readNeighbors(json.at("cells")));
  } else if (kind == "source") {
    source_ = {json.at("text").string(), json.at("file").string(), json.at("sha256").string()};
  } else if (kind == "truth") {
    truth_ = std::make_shared<const GroundTruth>(readTruth(json));
  } else if (kind == "options") {
    options_ = entry.detail;
  } else if (kind == "capture") {
    PoseCapture capture;
    // One below the largest number, so that there is always an ID for the next pose.
    capture.id = PoseId(json.at("pose").unsignedInteger(0, UINT32_MAX - 1));
    if (const auto label = json.find("label")) capture.label = label->string();
    if (const auto taken = json.find("taken_at_ms")) capture.taken_at_ms = taken->integer();
    capture.samples = decodeSamples(*entry.samples, where);
    const auto disabled = json.find("disabled");
    const auto why = json.find("why_disabled");
    insert({entry.entry,
            {std::make_shared<const PoseCapture>(std::move(capture)), disabled && disabled->boolean(),
             why ? why->string() : std::string()}},
           placeIn(json));
    if (const auto raw = json.find("raw_sha256")) raw_sha256_[entry.entry] = raw->string();
  } else if (kind == "remove") {
    removed_.push_back(take(placeOf(captureOf(json))));
  } else if (kind == "restore") {
    restore(captureOf(json), placeIn(json));
  } else if (kind == "disable" || kind == "enable") {
    SessionPose& pose = poses_[placeOf(captureOf(json))].pose;
    const auto why = json.find("why");
    pose.disabled = kind == "disable";
    pose.why_disabled = why && pose.disabled ? why->string() : std::string();
  } else if (kind == "mute" || kind == "unmute") {
    MutedLink link = readMutedLink(json);
    const std::pair ends(link.source, link.target);
    if (kind == "unmute") {
      muted_links_.erase(ends);
    } else {
      muted_links_[ends] = std::move(link.why);
    }
  } else {
    throw FormatError(where +
                      ": kind: expected capture, remove, restore, disable, enable, mute, unmute, skin, source, truth "
                      "or options, found \"" +
                      kind.substr(0, 40) + "\"");
  }
}

JournalEntry JournalState::entryFor(const StoreOperation& operation, std::int64_t at_ms,
                                    const std::string& raw_sha256) const {
  JournalEntry entry;
  entry.entry = last_entry_ + 1;
  entry.at_ms = at_ms;
  Json detail = Json::object();
  if (const auto* add = std::get_if<AddPose>(&operation)) {
    requireCapture(add->pose);
    detail = sayCapture(add->pose, add->index.value_or(poses_.size()), entry);
    if (!raw_sha256.empty()) detail["raw_sha256"] = raw_sha256;
  } else if (const auto* remove = std::get_if<RemovePose>(&operation)) {
    entry.kind = "remove";
    detail["capture"] = poseAt(remove->index).entry;
  } else if (const auto* restored = std::get_if<RestorePose>(&operation)) {
    requireCapture(restored->pose);
    if (const StoredPose* removed = lastRemoved(restored->pose.capture->id)) {
      entry.kind = "restore";
      detail["capture"] = removed->entry;
      detail["place"] = restored->index;
    } else {
      detail = sayCapture(restored->pose, restored->index, entry);
    }
  } else if (const auto* disable = std::get_if<SetPoseDisabled>(&operation)) {
    entry.kind = disable->disabled ? "disable" : "enable";
    detail["capture"] = poseAt(disable->index).entry;
    if (disable->disabled && !disable->why.empty()) detail["why"] = disable->why;
  } else if (const auto* mute = std::get_if<SetLinkMuted>(&operation)) {
    entry.kind = mute->muted ? "mute" : "unmute";
    detail = mutedLinkJson(
        {std::min(mute->a, mute->b), std::max(mute->a, mute->b), mute->muted ? mute->why : std::string()});
  } else if (const auto* source = std::get_if<SetSource>(&operation)) {
    entry.kind = "source";
    detail = {{"text", source->source.text}, {"file", source->source.file}, {"sha256", source->source.sha256}};
  } else if (const auto* truth = std::get_if<SetTruth>(&operation)) {
    entry.kind = "truth";
    detail = truthJson(truth->truth);
  } else if (const auto* skin = std::get_if<SetSkin>(&operation)) {
    if (!skin->model) throw InvalidArgument("a skin must have a cell model");
    entry.kind = "skin";
    detail["cell_model"] = cellModelJson(*skin->model);
    detail["cells"] = neighborsJson(skin->neighbors);
  } else if (const auto* options = std::get_if<SetOptions>(&operation)) {
    entry.kind = "options";
    entry.detail = options->json;
  }
  if (entry.detail.empty()) entry.detail = dumpReadable(detail);
  entry.digest = entry.expectedDigest(digest_);
  return entry;
}

Session JournalState::session(const std::string& file) const {
  if (!hasSkin()) throw InvalidArgument("a session needs a skin first");
  Session session(*model_, *neighbors_, {source_.text, file, hexDigits(digest_)});
  if (truth_) session.setTruth(*truth_);
  // Their numbers are not used again.
  for (const StoredPose& pose : removed_) {
    session.addPose(pose.pose);
    session.removePose(0);
  }
  for (const StoredPose& pose : poses_) session.addPose(pose.pose);
  for (const auto& [ends, why] : muted_links_) session.setLinkMuted(ends.first, ends.second, true, why);
  return session;
}

}  // namespace hexoderm
