#include "hexoderm/session/store_schema.h"

#include "hexoderm/session/store_version.h"

#include <array>
#include <string>
#include <vector>

namespace hexoderm {
namespace {

// The layout is documented in README.md beside this file.
constexpr const char* kVersion1 = R"(
CREATE TABLE journal (
  entry INTEGER PRIMARY KEY CHECK (entry >= 1),
  at_ms INTEGER NOT NULL,
  kind TEXT NOT NULL,
  detail TEXT NOT NULL,
  samples BLOB,
  digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;
CREATE TABLE raw_samples (
  entry INTEGER PRIMARY KEY REFERENCES journal (entry),
  frames BLOB NOT NULL
) STRICT;
CREATE TRIGGER journal_keeps_what_it_has BEFORE UPDATE ON journal
  BEGIN SELECT RAISE(ABORT, 'the journal of a Hexoderm session is append-only'); END;
CREATE TRIGGER journal_loses_nothing BEFORE DELETE ON journal
  BEGIN SELECT RAISE(ABORT, 'the journal of a Hexoderm session is append-only'); END;
CREATE TRIGGER raw_samples_keep_what_they_have BEFORE UPDATE ON raw_samples
  BEGIN SELECT RAISE(ABORT, 'the raw samples of a Hexoderm session are append-only'); END;
CREATE TRIGGER raw_samples_lose_nothing BEFORE DELETE ON raw_samples
  BEGIN SELECT RAISE(ABORT, 'the raw samples of a Hexoderm session are append-only'); END;
)";

// The tables are the same: only entries of the kinds "mute" and "unmute" are new, and a program that does not know them
// must not take links for good that were set aside.
constexpr const char* kVersion2 = "";

// Likewise entries of the kind "joints".
constexpr const char* kVersion3 = "";

// And of the kinds "robot" and "placement".
constexpr const char* kVersion4 = "";

// And of the kind "surface".
constexpr const char* kVersion5 = "";

constexpr std::array kMigrations = {kVersion1, kVersion2, kVersion3, kVersion4, kVersion5};
static_assert(kMigrations.size() == kStoreVersion);

/// Reading a schema of a few entries takes a few hundred; a database can be made so that it takes for ever.
constexpr int kMaxWorkOnSchema = 1'000'000;

std::vector<std::string> schemaOf(Database& database) {
  database.limitWork(kMaxWorkOnSchema);
  std::vector<std::string> schema;
  Statement statement(database,
                      "SELECT type || ' ' || name || ': ' || ifnull(sql, '') FROM sqlite_schema "
                      "WHERE name NOT LIKE 'sqlite\\_%' ESCAPE '\\' ORDER BY type, name");
  while (statement.step()) schema.emplace_back(statement.text(0));
  database.limitWork(0);
  return schema;
}

}  // namespace

Migrations storeMigrations() { return kMigrations; }

std::size_t requireStoreVersion(Database& database, Migrations migrations) {
  if (database.number("PRAGMA application_id") != kStoreApplicationId) {
    database.failFormat(message(
        "is an SQLite database, but not a Hexoderm session (*.hexo): expected application_id {}", kStoreApplicationId));
  }
  const std::int64_t version = database.number("PRAGMA user_version");
  if (version < 1 || static_cast<std::size_t>(version) > migrations.size()) {
    database.failFormat(message("user_version: this file has version {}, this program reads up to version {}", version,
                                migrations.size()));
  }
  return static_cast<std::size_t>(version);
}

void migrate(Database& database, Migrations migrations) {
  auto version = static_cast<std::size_t>(database.number("PRAGMA user_version"));
  for (; version < migrations.size(); ++version) {
    Transaction transaction(database);
    database.run(migrations[version]);
    database.run(("PRAGMA application_id=" + std::to_string(kStoreApplicationId)).c_str());
    database.run(("PRAGMA user_version=" + std::to_string(version + 1)).c_str());
    transaction.commit();
  }
}

void requireSchema(Database& database, Migrations migrations, std::size_t version) {
  Database expected(database.name());
  migrate(expected, migrations.first(version));
  if (schemaOf(database) != schemaOf(expected)) {
    database.failFormat(message(
        "the file is damaged or changed: expected the tables of a Hexoderm session of version {} and nothing else",
        version));
  }
}

}  // namespace hexoderm
