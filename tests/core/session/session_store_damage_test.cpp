// Files that are no session, not any more, not yet, or made to do harm: an error that names the file, never anything
// else.

#include "hexoderm/session/session_store.h"

#include "hexoderm/session/journal.h"
#include "hexoderm/session/sqlite_database.h"
#include "hexoderm/session/store_file.h"
#include "tests/core/session/store_test.h"

#include <cstring>

namespace hexoderm::store_test {
namespace {

class DamagedStore : public StoreTest {
 protected:
  DamagedStore() { writeSessionStore(sessionWithEverything(), path_); }

  void execute(const std::string& sql) const {
    Database(path_.string(), "test", Database::Mode::ReadWrite).run(sql.c_str());
  }
  /// The complaints of a reader and of a writer.
  [[nodiscard]] std::string complaint() const {
    const std::string reader = messageOf<FormatError>([&] { readSessionStore(path_); });
    const std::string writer = messageOf<FormatError>([&] { SessionStore::open(path_); });
    EXPECT_EQ(reader, writer);
    EXPECT_THAT(reader, StartsWith(path_.string() + ": "));
    return reader;
  }
  /// The complaint about a copy with an entry appended whose digest is right.
  [[nodiscard]] std::string complaintAbout(const std::string& kind, const std::string& detail,
                                           std::optional<Bytes> samples = std::nullopt) const {
    {
      Database database(path_.string(), "test", Database::Mode::ReadWrite);
      Statement last(database, "SELECT entry, digest FROM journal ORDER BY entry DESC LIMIT 1");
      last.step();
      Digest digest{};
      std::ranges::copy(last.blob(1), digest.begin());
      JournalEntry entry{last.integer(0) + 1, 0, kind, detail, std::move(samples), {}};
      entry.digest = entry.expectedDigest(digest);
      Statement row(database, "INSERT INTO journal VALUES (?1, 0, ?2, ?3, ?4, ?5)");
      row.bind(1, entry.entry).bindText(2, kind).bindText(3, detail).bindBlob(5, entry.digest);
      if (entry.samples) row.bindBlob(4, *entry.samples);
      row.step();
    }
    const std::string text = complaint();
    fs::remove(path_);
    writeSessionStore(sessionWithEverything(), path_);
    return text;
  }
};

TEST_F(DamagedStore, NewerVersionsAreRefusedNamingBoth) {
  execute("PRAGMA user_version=6");
  EXPECT_THAT(complaint(), saysAll("user_version", "version 6", "up to version 5"));
  execute("PRAGMA user_version=-1");
  EXPECT_THAT(complaint(), saysAll("version -1", "version 5"));
}

TEST_F(DamagedStore, FilesOfOlderVersionsAreReadAndBroughtToTheNewestByAWriter) {
  Session session = sessionWithEverything();
  session.setRobot(std::nullopt);
  for (const PatchPlacement& placement : std::vector(session.placements())) {
    PatchPlacement nothing;
    nothing.origin = placement.origin;
    session.setPlacement(nothing);
  }
  const auto version = [this] {
    return Database(path_.string(), "test", Database::Mode::ReadWrite).number("PRAGMA user_version");
  };
  for (const int older : {3, 2, 1}) {
    if (older == 2) {
      for (std::size_t k = 0; k < session.poses().size(); ++k) session.setJointAngles(k, {});
    }
    if (older == 1) {
      for (const MutedLink& link : std::vector(session.mutedLinks())) {
        session.setLinkMuted(link.source, link.target, false);
      }
    }
    fs::remove(path_);
    writeSessionStore(session, path_);
    execute("PRAGMA user_version=" + std::to_string(older));  // the tables are the same
    expectSameSession(readSessionStore(path_), session);
    EXPECT_EQ(version(), older) << "a reader changes nothing";
    expectSameSession(SessionStore::open(path_).readSession(), session);
    EXPECT_EQ(version(), 5) << "so that a program that does not know what is new refuses it";
  }
}

TEST_F(DamagedStore, OtherDatabasesAreNoSessions) {
  execute("PRAGMA application_id=0");
  EXPECT_THAT(complaint(), saysAll("SQLite database", "not a Hexoderm session", "application_id"));
}

TEST_F(DamagedStore, OtherFilesAreNoSessions) {
  std::ofstream(path_) << "{\"format\": \"hexoderm-session\"}" << std::string(1000, ' ');
  EXPECT_THAT(complaint(), saysAll("not a Hexoderm session", "expected an SQLite database"));
  EXPECT_FALSE(isSessionStore(path_));
  std::ofstream(path_) << "";
  EXPECT_THAT(complaint(), saysAll("empty", "expected a Hexoderm session"));
}

TEST_F(DamagedStore, TruncatedFilesAreRefused) {
  const std::string whole = readFile(path_);
  for (std::size_t size = 1; size < whole.size(); size += size < 200 ? 1 : 499) {
    std::ofstream(path_, std::ios::binary) << whole.substr(0, size);
    EXPECT_THAT(messageOf<FormatError>([&] { readSessionStore(path_); }), StartsWith(path_.string()))
        << "cut after " << size << " bytes";
  }
}

TEST_F(DamagedStore, AnyChangedByteGivesAnErrorOrTheSameSession) {
  const std::string whole = readFile(path_);
  const std::string digest = readSessionStore(path_).source().sha256;
  std::size_t refused = 0;
  std::size_t read = 0;
  for (std::size_t at = 0; at < whole.size(); at += at < 110 ? 1 : 61) {
    for (const char change : {'\x01', '\xff'}) {
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ change);
      std::ofstream(path_, std::ios::binary) << changed;
      try {
        const Session session = readSessionStore(path_);
        EXPECT_EQ(session.source().sha256, digest) << "byte " << at;
        expectSameSession(session, sessionWithEverything());
        ++read;
      } catch (const Error& error) {
        EXPECT_THAT(error.what(), StartsWith(path_.string())) << "byte " << at;
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 200U);
  EXPECT_GT(read, 50U) << "free space in pages means nothing";
}

TEST_F(DamagedStore, AWriterRefusesDamageThatReadersDoNotSee) {
  std::string changed = readFile(path_);
  const std::string entry = "raw_samples_keep";  // in the schema; its page is read by everybody
  ASSERT_NE(changed.find(entry), std::string::npos);
  // A free list that is not there.
  const std::uint8_t free_pages[] = {0, 0, 0, 2, 0, 0, 0, 3};
  std::memcpy(changed.data() + 32, free_pages, sizeof(free_pages));
  std::ofstream(path_, std::ios::binary) << changed;
  EXPECT_NO_THROW(readSessionStore(path_));
  EXPECT_THAT(messageOf<FormatError>([&] { SessionStore::open(path_); }), saysAll("arm.hexo", "damaged"));
}

TEST_F(DamagedStore, TablesAreNothingElse) {
  const std::string whole = readFile(path_);
  for (const char* sql : {
           "CREATE TABLE more (x)",
           "CREATE VIEW more AS SELECT 1",
           "CREATE INDEX more ON journal (at_ms)",
           "CREATE TRIGGER more AFTER INSERT ON journal BEGIN INSERT INTO raw_samples VALUES (new.entry, x''); END",
           "DROP TRIGGER journal_loses_nothing",
           "DROP TABLE raw_samples",
           "ALTER TABLE journal ADD COLUMN more TEXT",
           "DROP TABLE journal; CREATE VIEW journal AS WITH RECURSIVE n (entry) AS (SELECT 1 UNION ALL SELECT entry + "
           "1 "
           "FROM n) SELECT entry, 0 AS at_ms, '' AS kind, '' AS detail, x'' AS samples, x'' AS digest FROM n",
       }) {
    execute(sql);
    EXPECT_THAT(complaint(), saysAll("expected the tables of a Hexoderm session of version 5")) << sql;
    std::ofstream(path_, std::ios::binary) << whole;
  }
}

TEST_F(DamagedStore, TheJournalIsAppendOnlyForEverybody) {
  for (const char* sql : {"DELETE FROM journal", "UPDATE journal SET at_ms = 0"}) {
    EXPECT_THAT(messageOf<FormatError>([&] { execute(sql); }), saysAll("append-only"));
  }
}

TEST_F(DamagedStore, GapsAndLiesInTheJournalAreSeen) {
  const std::string whole = readFile(path_);
  const std::string drop = "DROP TRIGGER journal_loses_nothing; DROP TRIGGER journal_keeps_what_it_has; ";
  const std::vector<std::array<std::string, 3>> damages = {
      {"DELETE FROM journal", "journal is empty", "expected a skin"},
      {"DELETE FROM journal WHERE entry = 4", "journal entry 5", "expected entry 4"},
      {"DELETE FROM journal WHERE entry = 1", "journal entry 2", "expected entry 1"},
      {"UPDATE journal SET kind = 'options' WHERE entry = 3", "journal entry 3", "does not match its digest"},
      {"UPDATE journal SET at_ms = at_ms + 1 WHERE entry = 5", "journal entry 5", "does not match its digest"},
      {"UPDATE journal SET samples = x'' WHERE entry = 5", "journal entry 5", "does not match its digest"},
      {"UPDATE journal SET samples = NULL WHERE entry = 5", "journal entry 5", "does not match its digest"},
      {"UPDATE journal SET digest = zeroblob(32) WHERE entry = 2", "journal entry 2", "does not match its digest"},
  };
  for (const auto& [sql, where, what] : damages) {
    {
      // The triggers are made again, so that only the content is wrong.
      Database database(path_.string(), "test", Database::Mode::ReadWrite);
      Statement statement(
          database, "SELECT group_concat(sql, ';') FROM sqlite_schema WHERE type = 'trigger' AND tbl_name = 'journal'");
      statement.step();
      const std::string triggers(statement.text(0));
      static_cast<void>(statement.step());
      database.run((drop + sql + ";" + triggers).c_str());
    }
    EXPECT_THAT(complaint(), saysAll(where, what)) << sql;
    std::ofstream(path_, std::ios::binary) << whole;
  }
}

TEST_F(DamagedStore, EntriesThatMakeNoSenseAreNamed) {
  const std::string where = "journal entry 12: ";
  EXPECT_THAT(complaintAbout("dance", "{}"), saysAll(where, "kind: expected capture", "found \"dance\""));
  EXPECT_THAT(complaintAbout("remove", "{"), saysAll(where, "the file ends in the middle"));
  EXPECT_THAT(complaintAbout("remove", "[]"), saysAll(where, "expected an object"));
  EXPECT_THAT(complaintAbout("remove", "{}"), saysAll(where, "capture: is missing"));
  EXPECT_THAT(complaintAbout("remove", R"({"capture": 3})"), saysAll(where, "entry 3 is no pose"));
  EXPECT_THAT(complaintAbout("remove", R"({"capture": -1})"), saysAll(where, "capture: expected a whole number"));
  EXPECT_THAT(complaintAbout("remove", R"({"capture": 4})", Bytes{}), saysAll(where, "samples in captures"));
  EXPECT_THAT(complaintAbout("restore", R"({"capture": 4, "place": 0})"), saysAll(where, "that was removed"));
  EXPECT_THAT(complaintAbout("disable", R"({"capture": 99})"), saysAll(where, "entry 99 is no pose"));
  EXPECT_THAT(complaintAbout("disable", R"({"capture": 4, "why": 3})"), saysAll(where, "why: expected a text"));
  EXPECT_THAT(complaintAbout("mute", R"({"source": 1})"), saysAll(where, "source_port: is missing"));
  EXPECT_THAT(complaintAbout("unmute", R"({"source": 1, "source_port": 2, "target": 1, "target_port": 2})"),
              saysAll(where, "target_port: expected another port"));
  EXPECT_THAT(complaintAbout("source", R"({"text": 1})"), saysAll(where, "text: expected a text"));
  EXPECT_THAT(complaintAbout("truth", R"({"cells": [{"id": 1, "R": [1], "t_m": [0, 0, 0]}]})"),
              saysAll(where, "cells[0].R"));
  EXPECT_THAT(complaintAbout("skin", R"({"cell_model": {"name": "x"}, "cells": []})"),
              saysAll(where, "cell_model.side_m: is missing"));
  EXPECT_THAT(complaintAbout("options", "\xff"), saysAll(where));
  EXPECT_THAT(complaintAbout("capture", R"({"pose": 9, "place": 3})"), saysAll(where, "samples in captures"));
  EXPECT_THAT(complaintAbout("capture", R"({"pose": 9, "place": 4})", Bytes{}), saysAll(where, "no place 4"));
  EXPECT_THAT(complaintAbout("capture", R"({"pose": 4294967295, "place": 3})", Bytes{}), saysAll(where, "pose:"));
}

TEST_F(DamagedStore, SamplesThatMakeNoSenseAreNamed) {
  GravitySample sample{CellId(5), {0, 0, 1}, Eigen::Matrix3d::Identity(), 100, 20.0};
  const Bytes good = encodeSamples({&sample, 1});
  ASSERT_EQ(good.size(), 96U) << "as documented";
  const auto with = [&](std::size_t at, auto value) {
    Bytes bytes = good;
    std::memcpy(bytes.data() + at, &value, sizeof(value));
    return complaintAbout("capture", R"({"pose": 9, "place": 3})", bytes);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(with(8, std::uint32_t{2}), saysAll("entry 12: samples: cell 5", "flags"));
  EXPECT_THAT(with(12, std::uint32_t{1}), saysAll("entry 12: samples: cell 5", "flags"));
  EXPECT_THAT(with(16, nan), saysAll("entry 12: samples: cell 5: the mean must be finite"));
  EXPECT_THAT(with(40, -1e-9), saysAll("cell 5: variances must be at least 0"));
  EXPECT_THAT(with(80, std::numeric_limits<double>::infinity()), saysAll("cell 5: the covariance must be finite"));
  EXPECT_THAT(with(88, nan), saysAll("cell 5: the temperature must be finite"));
  Bytes cut = good;
  cut.pop_back();
  EXPECT_THAT(complaintAbout("capture", R"({"pose": 9, "place": 3})", cut), saysAll("expected 96 bytes", "95"));
}

TEST_F(DamagedStore, RawSamplesAreCheckedWhenTheyAreRead) {
  fs::remove(path_);
  {
    SessionStore store = SessionStore::create(path_, emptySession());
    AddPose add{{std::make_shared<const PoseCapture>(PoseCapture{PoseId(1), {}, {}})}};
    add.raw = std::make_shared<std::vector<SampleFrame>>(1, SampleFrame{0.5, {{CellId(1), {0.1, 0.2, 0.3}}}});
    appendTo(store, add);
  }
  std::string changed = readFile(path_);
  const double number = 0.2;
  const std::string needle(reinterpret_cast<const char*>(&number), sizeof(number));
  const std::size_t at = changed.rfind(needle);
  ASSERT_NE(at, std::string::npos);
  changed[at] = static_cast<char>(changed[at] ^ 1);
  std::ofstream(path_, std::ios::binary) << changed;
  const SessionStore store = SessionStore::openReadOnly(path_);
  EXPECT_EQ(store.readSession().poses().size(), 1U);
  EXPECT_THAT(messageOf<FormatError>([&] { static_cast<void>(store.readRawSamples(0)); }),
              saysAll("arm.hexo: raw samples of journal entry 3", "do not match their digest"));
}

constexpr std::array kTwoVersions = {"CREATE TABLE a (x TEXT) STRICT",
                                     "ALTER TABLE a ADD COLUMN y TEXT; UPDATE a SET y = x || '!'"};
constexpr std::array kBadStep = {kTwoVersions[0], "ALTER TABLE a ADD COLUMN y TEXT; INSERT INTO nowhere VALUES (1)"};

class Migrating : public StoreTest {
 protected:
  Migrating() {
    folder_.put("arm.hexo", "");
    Database database(path_.string(), "old", Database::Mode::Create);
    migrate(database, Migrations(kTwoVersions).first(1));
    database.run("INSERT INTO a VALUES ('kept')");
  }
};

TEST_F(Migrating, AWriterBringsAnOlderFileToTheNewestVersion) {
  {
    StoreFile file = openStoreForWriting(path_, kTwoVersions);
    EXPECT_EQ(file.database.number("PRAGMA user_version"), 2);
    EXPECT_EQ(file.database.text("SELECT y FROM a"), "kept!");
    EXPECT_EQ(file.database.text("PRAGMA journal_mode"), "wal");
    EXPECT_EQ(file.database.number("PRAGMA synchronous"), 2) << "FULL";
    EXPECT_EQ(file.database.number("PRAGMA foreign_keys"), 1);
  }
  EXPECT_EQ(openStoreForWriting(path_, kTwoVersions).database.text("SELECT y FROM a"), "kept!");
}

TEST_F(Migrating, AReaderReadsAnOlderFileAndLeavesItAsItIs) {
  const std::string before = readFile(path_);
  StoreFile file = openStoreForReading(path_, kTwoVersions);
  EXPECT_EQ(file.database.text("SELECT y FROM a"), "kept!");
  EXPECT_EQ(readFile(path_), before);
  EXPECT_EQ(folder_.entryCount(), 1U);
}

TEST_F(Migrating, AStepThatFailsLeavesTheVersionBeforeIt) {
  EXPECT_THAT(messageOf<FormatError>([&] { openStoreForWriting(path_, kBadStep); }), saysAll("arm.hexo", "nowhere"));
  StoreFile file = openStoreForReading(path_, Migrations(kTwoVersions).first(1));
  EXPECT_EQ(file.database.number("PRAGMA user_version"), 1);
  EXPECT_EQ(file.database.text("SELECT x FROM a"), "kept");
}

TEST_F(Migrating, ADatabaseWithoutAVersionIsRefused) {
  Database(path_.string(), "test", Database::Mode::ReadWrite).run("PRAGMA user_version=0");
  EXPECT_THAT(messageOf<FormatError>([&] { openStoreForWriting(path_, kTwoVersions); }), saysAll("version 0"));
}

}  // namespace
}  // namespace hexoderm::store_test
