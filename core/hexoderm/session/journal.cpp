#include "hexoderm/session/journal.h"

#include <openssl/evp.h>
#include "hexoderm/base/error.h"
#include "hexoderm/base/sha256.h"
#include "hexoderm/session/session_parts_json.h"
#include "hexoderm/skin/cell_model_json.h"

#include <algorithm>

namespace hexoderm {
namespace {

/// More than anybody takes, and few enough that a file of insertions and removals is read in a moment.
constexpr std::size_t kMaxPoses = 100'000;

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

template <class Json, class Source>
void storedSourceFields(Json& json, Source& source) {
  json.object(requiredMessage("text", source.text), requiredField("file", source.file),
              requiredField("sha256", source.sha256));
}

std::int64_t captureOf(const JsonReader& json) { return json.at("capture").unsignedInteger(1); }
std::size_t placeIn(const JsonReader& json) { return json.at("place").unsignedInteger(); }

void requireCapture(const SessionPose& pose) {
  if (!pose.capture) throw InvalidArgument(message("a pose must hold a capture"));
}

/// As the file keeps them.
bool haveSameReadings(const PoseCapture& a, const PoseCapture& b) {
  return a.taken_at_ms == b.taken_at_ms && encodeSamples(a.samples) == encodeSamples(b.samples);
}

/// Makes the entry a capture.
void sayCapture(const SessionPose& pose, std::size_t place, const std::string& raw_sha256, JournalEntry& entry) {
  requireCapture(pose);
  const PoseCapture& capture = *pose.capture;
  entry.kind = "capture";
  try {
    entry.samples = encodeSamples(capture.samples);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(message("pose {}", capture.id), error.message());
  }
  const std::size_t cells = capture.samples.size();
  entry.detail = jsonText([&](JsonWriter& json) {
    poseFields(json, "pose", capture, pose, requiredField("place", place), requiredField("cells", cells),
               optionalField("raw_sha256", raw_sha256));
  });
}

/// The detail of an entry that is about one capture, and more fields.
template <class... Fields>
std::string ofCapture(std::int64_t capture, const Fields&... fields) {
  return jsonText([&](JsonWriter& json) { json.object(requiredField("capture", capture), fields...); });
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

std::int64_t JournalState::captureAt(std::size_t index) const {
  if (index >= captures_.size()) throw InvalidArgument(message("there is no pose at place {}", index));
  return captures_[index];
}

std::size_t JournalState::placeOf(std::int64_t capture) const {
  const auto found = std::ranges::find(captures_, capture);
  if (found == captures_.end()) throw InvalidArgument(message("entry {} is no pose of the session", capture));
  return static_cast<std::size_t>(found - captures_.begin());
}

const JournalState::RemovedPose* JournalState::lastRemoved(const PoseCapture& capture) const {
  const auto found = std::find_if(removed_.rbegin(), removed_.rend(), [&](const RemovedPose& removed) {
    return removed.pose.capture->id == capture.id && haveSameReadings(*removed.pose.capture, capture);
  });
  return found == removed_.rend() ? nullptr : &*found;
}

const JournalState::RemovedPose& JournalState::removedBy(std::int64_t capture) const {
  const auto found = std::ranges::find(removed_, capture, &RemovedPose::capture);
  if (found == removed_.end()) throw InvalidArgument(message("a pose can be restored that was removed"));
  return *found;
}

std::string JournalState::rawSha256(std::int64_t capture) const {
  const auto found = raw_sha256_.find(capture);
  return found == raw_sha256_.end() ? std::string() : found->second;
}

void JournalState::read(const JournalEntry& entry, const std::string& file) {
  const std::string where = file + ": journal entry " + std::to_string(entry.entry);
  if (entry.entry != last_entry_ + 1) {
    throw FormatError(where, message("the file is damaged: expected entry {}", last_entry_ + 1));
  }
  if (entry.digest != entry.expectedDigest(digest_)) {
    throw FormatError(where, message("the file is damaged: what it holds does not match its digest"));
  }
  if (entry.samples.has_value() != (entry.kind == "capture")) {
    throw FormatError(where, message("expected samples in captures and nowhere else"));
  }
  if (!hasSkin() && entry.kind != "skin") {
    throw FormatError(where, message("expected the skin first, found \"{}\"", entry.kind));
  }
  try {
    apply(entry, where);
  } catch (const InvalidArgument& error) {
    throw FormatError(where, error.message());
  }
  last_entry_ = entry.entry;
  edited_at_ms_ = entry.at_ms;
  digest_ = entry.digest;
}

void JournalState::apply(const JournalEntry& entry, const std::string& where) {
  const JsonDocument document = parseJson(entry.detail, where, kMaxSkinValues);
  const JsonReader json(document);
  if (!json.isObject()) json.fail(message("an object"));
  if (const std::optional<SessionEdit> edit = editIn(entry, json, where)) {
    const bool is_restored = std::holds_alternative<RestorePose>(*edit);
    apply(*edit, is_restored ? captureOf(json) : entry.entry);
    if (entry.kind != "capture") return;
    if (const auto raw = json.find("raw_sha256")) raw_sha256_[entry.entry] = raw->string();
  } else if (entry.kind == "source") {
    SourceDescription source;
    storedSourceFields(json, source);
    session_->setSource(std::move(source));
  } else if (entry.kind == "truth") {
    session_->setTruth(readTruth(json));
  } else if (entry.kind == "options") {
    options_ = entry.detail;
  } else {
    throw FormatError(where, message("kind: expected capture, remove, restore, disable, enable, joints, mute, "
                                     "unmute, robot, placement, skin, source, truth or options, found \"{}\"",
                                     entry.kind.substr(0, 40)));
  }
}

std::optional<SessionEdit> JournalState::editIn(const JournalEntry& entry, const JsonReader& json,
                                                const std::string& where) const {
  const std::string& kind = entry.kind;
  if (kind == "skin") {
    return SetSkin{std::make_shared<const CellModel>(readCellModel(json.at("cell_model"))),
                   readNeighbors(json.at("cells"))};
  }
  if (kind == "capture") {
    return AddPose{readPose(json, "pose", [&] { return decodeSamples(*entry.samples, where); }), placeIn(json)};
  }
  if (kind == "remove") return RemovePose{placeOf(captureOf(json))};
  if (kind == "restore") return RestorePose{removedBy(captureOf(json)).pose, placeIn(json)};
  if (kind == "disable" || kind == "enable") {
    const auto why = json.find("why");
    return SetPoseDisabled{placeOf(captureOf(json)), kind == "disable", why ? why->string() : std::string()};
  }
  if (kind == "joints") {
    SetJointAngles joints{placeOf(captureOf(json))};
    json.object(requiredField("joint_angles", joints.angles.positions, AsJointAngles()));
    return joints;
  }
  if (kind == "robot") return SetRobot{readRobot(json)};
  if (kind == "placement") return SetPatchPlacement{readPlacement(json)};
  if (kind == "surface") return SetSkinSide{readSkinSide(json)};
  if (kind == "mute" || kind == "unmute") {
    MutedLink link = readMutedLink(json);
    return SetLinkMuted{link.source, link.target, kind == "mute", std::move(link.why)};
  }
  return std::nullopt;
}

void JournalState::apply(const SessionEdit& edit, std::int64_t capture) {
  if (const auto* skin = std::get_if<SetSkin>(&edit); skin != nullptr && !session_) {
    session_.emplace(*skin->model, skin->neighbors);
    return;
  }
  const auto at = [this](std::size_t place) { return captures_.begin() + static_cast<std::ptrdiff_t>(place); };
  if (const auto* add = std::get_if<AddPose>(&edit)) {
    if (captures_.size() + removed_.size() >= kMaxPoses) {
      throw InvalidArgument(message("a session holds at most {} poses", kMaxPoses));
    }
    hexoderm::apply(edit, *session_);
    captures_.insert(at(add->index.value_or(captures_.size())), capture);
  } else if (const auto* remove = std::get_if<RemovePose>(&edit)) {
    RemovedPose removed{captureAt(remove->index), session_->poses().at(remove->index)};
    hexoderm::apply(edit, *session_);
    captures_.erase(at(remove->index));
    removed_.push_back(std::move(removed));
  } else if (const auto* restore = std::get_if<RestorePose>(&edit)) {
    hexoderm::apply(edit, *session_);
    captures_.insert(at(restore->index), capture);
    std::erase_if(removed_, [&](const RemovedPose& removed) { return removed.capture == capture; });
  } else {
    hexoderm::apply(edit, *session_);
  }
}

JournalEntry JournalState::entryFor(const StoreOperation& operation, std::int64_t at_ms,
                                    const std::string& raw_sha256) const {
  JournalEntry entry;
  entry.entry = last_entry_ + 1;
  entry.at_ms = at_ms;
  if (const auto* edit = std::get_if<SessionEdit>(&operation)) {
    sayEdit(*edit, raw_sha256, entry);
  } else if (const auto* set = std::get_if<SetSource>(&operation)) {
    entry.kind = "source";
    entry.detail = jsonText([&](JsonWriter& json) { storedSourceFields(json, set->source); });
  } else if (const auto* truth = std::get_if<SetTruth>(&operation)) {
    entry.kind = "truth";
    entry.detail = jsonText([&](JsonWriter& json) { writeTruth(truth->truth, json); });
  } else if (const auto* options = std::get_if<SetOptions>(&operation)) {
    entry.kind = "options";
    entry.detail = options->json.empty() ? "{}\n" : options->json;
  }
  entry.digest = entry.expectedDigest(digest_);
  return entry;
}

void JournalState::sayEdit(const SessionEdit& edit, const std::string& raw_sha256, JournalEntry& entry) const {
  if (const auto* add = std::get_if<AddPose>(&edit)) {
    sayCapture(add->pose, add->index.value_or(captures_.size()), raw_sha256, entry);
  } else if (const auto* remove = std::get_if<RemovePose>(&edit)) {
    entry.kind = "remove";
    entry.detail = ofCapture(captureAt(remove->index));
  } else if (const auto* restore = std::get_if<RestorePose>(&edit)) {
    requireCapture(restore->pose);
    if (const RemovedPose* removed = lastRemoved(*restore->pose.capture)) {
      entry.kind = "restore";
      entry.detail = ofCapture(removed->capture, requiredField("place", restore->index));
    } else {
      sayCapture(restore->pose, restore->index, {}, entry);
    }
  } else if (const auto* disable = std::get_if<SetPoseDisabled>(&edit)) {
    entry.kind = disable->disabled ? "disable" : "enable";
    const std::string why = disable->disabled ? disable->why : std::string();
    entry.detail = ofCapture(captureAt(disable->index), optionalField("why", why));
  } else if (const auto* joints = std::get_if<SetJointAngles>(&edit)) {
    entry.kind = "joints";
    joints->angles.validate();
    entry.detail =
        ofCapture(captureAt(joints->index), requiredField("joint_angles", joints->angles.positions, AsJointAngles()));
  } else if (const auto* mute = std::get_if<SetLinkMuted>(&edit)) {
    entry.kind = mute->muted ? "mute" : "unmute";
    const MutedLink link{std::min(mute->a, mute->b), std::max(mute->a, mute->b), mute->muted ? mute->why : ""};
    entry.detail = jsonText([&](JsonWriter& json) { writeMutedLink(link, json); });
  } else if (const auto* set = std::get_if<SetRobot>(&edit)) {
    entry.kind = "robot";
    if (set->robot) set->robot->validate();
    entry.detail = jsonText([&](JsonWriter& json) { writeRobot(set->robot, json); });
  } else if (const auto* placed = std::get_if<SetPatchPlacement>(&edit)) {
    entry.kind = "placement";
    placed->placement.validate();
    entry.detail = jsonText([&](JsonWriter& json) { writePlacement(placed->placement, json); });
  } else if (const auto* surface = std::get_if<SetSkinSide>(&edit)) {
    entry.kind = "surface";
    entry.detail = jsonText([&](JsonWriter& json) {
      json.beginObject();
      writeSkinSide(surface->side, json);
      json.endObject();
    });
  } else if (const auto* skin = std::get_if<SetSkin>(&edit)) {
    if (!skin->model) throw InvalidArgument(message("a skin must have a cell model"));
    entry.kind = "skin";
    entry.detail = jsonText([&](JsonWriter& json) {
      json.beginObject();
      json.key("cell_model");
      writeCellModel(*skin->model, json);
      json.key("cells");
      writeNeighbors(skin->neighbors, json);
      json.endObject();
    });
  }
}

Session JournalState::session(const std::string& file) const {
  if (!session_) throw InvalidArgument(message("a session needs a skin first"));
  Session session = *session_;
  session.setSource({session.source().text, file, hexDigits(digest_)});
  return session;
}

}  // namespace hexoderm
