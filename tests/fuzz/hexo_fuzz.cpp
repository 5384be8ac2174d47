// Any bytes as a *.hexo: a sound session, which is the same again in a new file, or an Error; the file and its folder
// stay as they were. The first byte of an input says what the rest is:
//   'R'  the file itself
//   'P'  changes to a good file: 16 bits of place, 8 of value each
//   else a journal in a good file, its digests in order. Each entry: a byte with its kind (low 4 bits) and flags (high
//        4), a text as detail, and where flags say so a blob of samples and one of raw samples. Texts and blobs have a
//        length of 16 bits in front. "$RAW" in a detail becomes the digest of the raw samples.

#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/sha256.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/session_store.h"

#include "hexoderm/session/journal.h"
#include "hexoderm/session/store_schema.h"
#include "tests/fuzz/fuzz_checks.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/scratch_file.h"

#include <cmath>
#include <optional>

namespace {

using namespace hexoderm;
using fuzz::ByteView;
using fuzz::FuzzInput;

enum Flag : unsigned { kHasSamples = 0x10, kHasRaw = 0x20, kIsMisnumbered = 0x40, kHasOddDigest = 0x80 };
constexpr std::size_t kMaxEntries = 200;

const fuzz::ScratchFile& scratch() {
  static const fuzz::ScratchFile file("fuzz.hexo");
  return file;
}

/// A file with a session, or only with its tables.
std::string makeGoodFile(bool with_session) {
  const fuzz::ScratchFile file("good.hexo");
  if (with_session) {
    NeighborList cells = {{CellId(1), "arm", {{PortNumber(2), CellId(2), PortNumber(3)}}},
                          {CellId(2), "arm", {{PortNumber(3), CellId(1), std::nullopt}}}};
    Session session(builtInCellModel("hex-bma150"), std::move(cells), {Message::verbatim("two cells"), "", ""});
    for (const std::uint32_t id : {1U, 2U}) {
      PoseCapture pose;
      pose.id = PoseId(id);
      pose.samples = {{CellId(1), {0, 0, 1}}, {CellId(2), {0, 1, 0}}};
      session.addPose({std::make_shared<const PoseCapture>(std::move(pose))});
    }
    writeSessionStore(session, file.path());
  } else {
    file.write({});
    Database database(file.path().string(), "good.hexo", Database::Mode::Create);
    database.run("PRAGMA journal_mode=MEMORY; PRAGMA synchronous=OFF");
    migrate(database, storeMigrations());
  }
  return readFile(file.path());
}

void changeGoodFile(FuzzInput& input) {
  static const std::string good = makeGoodFile(true);
  std::string changed = good;
  while (!input.atEnd()) {
    const std::size_t place = input.shortNumber();
    changed[place % changed.size()] = static_cast<char>(input.byte());
  }
  scratch().write(changed);
}

std::string kindOf(unsigned number) {
  static constexpr std::array kKinds = {"skin",   "capture", "source", "truth",  "remove", "restore",  "disable",
                                        "enable", "options", "mute",   "unmute", "joints", "surprise", ""};
  return kKinds[number % kKinds.size()];
}

/// The entry, and its raw samples where it has some.
std::pair<JournalEntry, std::optional<Bytes>> readEntry(FuzzInput& input) {
  const unsigned head = input.byte();
  JournalEntry entry;
  entry.kind = kindOf(head & 0x0FU);
  entry.detail = fuzz::asText(input.piece());
  if ((head & kHasSamples) != 0) {
    const ByteView samples = input.piece();
    entry.samples.emplace(samples.begin(), samples.end());
  }
  std::optional<Bytes> raw;
  if ((head & kHasRaw) != 0) {
    const ByteView frames = input.piece();
    raw.emplace(frames.begin(), frames.end());
    const std::size_t place = entry.detail.find("$RAW");
    if (place != std::string::npos) entry.detail.replace(place, 4, sha256Hex(fuzz::asText(frames)));
  }
  if ((head & kIsMisnumbered) != 0) entry.entry = input.byte();
  if ((head & kHasOddDigest) != 0) entry.digest.fill(input.byte());
  return {std::move(entry), std::move(raw)};
}

/// Rows that the tables themselves refuse (a number twice, for one) are left out.
void writeJournal(FuzzInput& input) {
  static const std::string good = makeGoodFile(false);
  scratch().write(good);
  Database database(scratch().path().string(), "fuzz.hexo", Database::Mode::ReadWrite);
  database.run("PRAGMA journal_mode=MEMORY; PRAGMA synchronous=OFF");
  Digest previous{};
  std::int64_t number = 0;
  const Transaction transaction(database);
  for (std::size_t count = 0; count < kMaxEntries && !input.atEnd(); ++count) {
    auto [entry, raw] = readEntry(input);
    if (entry.entry == 0) entry.entry = ++number;
    entry.at_ms = entry.entry;
    if (entry.digest == Digest{}) entry.digest = entry.expectedDigest(previous);
    previous = entry.digest;
    try {
      Statement row(
          database,
          "INSERT INTO journal (entry, at_ms, kind, detail, samples, digest) VALUES (?1, ?2, ?3, ?4, ?5, ?6)");
      row.bind(1, entry.entry).bind(2, entry.at_ms).bindText(3, entry.kind).bindText(4, entry.detail);
      if (entry.samples) row.bindBlob(5, *entry.samples);
      row.bindBlob(6, entry.digest);
      row.step();
      if (!raw) continue;
      Statement raw_row(database, "INSERT INTO raw_samples (entry, frames) VALUES (?1, ?2)");
      raw_row.bind(1, entry.entry).bindBlob(2, *raw);
      raw_row.step();
    } catch (const Error&) {
      continue;
    }
  }
  database.run("COMMIT");
}

void requireFinite(const std::vector<SampleFrame>& frames) {
  for (const SampleFrame& frame : frames) {
    fuzz::require(std::isfinite(frame.time_s), "finite times");
    for (const CellSample& sample : frame.samples) fuzz::require(sample.acceleration_g.allFinite(), "finite samples");
    for (const CellMean& mean : frame.means) {
      fuzz::require(mean.mean_g.allFinite() && mean.variance_g2.allFinite(), "finite raw means");
    }
    for (const CellTemperature& cell : frame.temperatures) {
      fuzz::require(std::isfinite(cell.temperature_c), "finite raw temperatures");
    }
  }
}

void requireSameAgain(const Session& session) {
  const fuzz::ScratchFile first("first.hexo");
  writeSessionStore(session, first.path());
  fuzz::require(sessionToJson(readSessionStore(first.path())) == sessionToJson(session), "the same session again");
}

void readStore() {
  std::optional<SessionStore> store;
  fuzz::takeOrComplain([&] { store.emplace(SessionStore::openReadOnly(scratch().path())); });
  if (!store) return;
  const Session session = store->readSession();
  fuzz::requireSound(session);
  fuzz::require(store->history().size() == store->revision(), "a line for every entry");
  for (std::size_t k = 0; k < session.poses().size(); ++k) {
    try {
      requireFinite(store->readRawSamples(k));
    } catch (const FormatError&) {
      continue;
    }
  }
  store.reset();
  requireSameAgain(session);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput input({data, size});
  switch (input.byte()) {
    case 'R':
      scratch().write(fuzz::asText(input.rest()));
      break;
    case 'P':
      changeGoodFile(input);
      break;
    default:
      writeJournal(input);
  }
  const std::string before = readFile(scratch().path());
  readStore();
  // As they come from a pipe.
  fuzz::takeOrComplain([&] { fuzz::requireSound(parseSessionStore(before, "fuzz.hexo")); });
  fuzz::require(readFile(scratch().path()) == before, "a file that is only read to stay as it was");
  fuzz::require(scratch().isAlone(), "nothing left beside a file that is only read");
  return 0;
}
