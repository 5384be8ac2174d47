#pragma once

// The tables of a *.hexo, and how older ones become newer ones.

#include "hexoderm/base/kept_files.h"
#include "hexoderm/session/sqlite_database.h"

#include <span>

namespace hexoderm {

/// `migrations[v]` is the SQL that makes version v + 1 of version v; version 0 is an empty database. Released
/// migrations are never changed; new ones are appended.
using Migrations = std::span<const char* const>;
Migrations storeMigrations();

/// The store's version. Throws FormatError if it is not a session store, or of a newer version than `migrations` make:
/// both numbers are named.
std::size_t requireStoreVersion(Database& database, Migrations migrations);
/// Brings the database to the newest version, each step in a transaction of its own: one that fails leaves the version
/// before it. Also makes a store of an empty database.
void migrate(Database& database, Migrations migrations);
/// Throws FormatError unless tables, indexes and triggers are exactly those that the migrations up to `version` make: a
/// file may come from anywhere, and a view in the place of a table can do what it likes.
void requireSchema(Database& database, Migrations migrations, std::size_t version);

}  // namespace hexoderm
