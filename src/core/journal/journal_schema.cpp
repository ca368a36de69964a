// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "journal/journal_schema.hpp"

#include <array>
#include <cstddef>

#include "journal/audit_chain.hpp"

namespace lamina {
namespace {

// Times are seconds since 1970, UTC. What a later version adds is added by statements of its own: files are
// brought forward, never back.
constexpr const char* kFirstTables = R"sql(
CREATE TABLE artefact (id INTEGER PRIMARY KEY, sha256 TEXT NOT NULL UNIQUE, bytes INTEGER NOT NULL, kind TEXT NOT NULL,
  name TEXT NOT NULL, created REAL NOT NULL) STRICT;
CREATE TABLE job (id INTEGER PRIMARY KEY AUTOINCREMENT, digest TEXT NOT NULL, name TEXT NOT NULL, part TEXT NOT NULL,
  machine TEXT NOT NULL, state INTEGER NOT NULL, position INTEGER NOT NULL, created REAL NOT NULL, created_by TEXT NOT NULL,
  released_by TEXT NOT NULL DEFAULT '', is_removed INTEGER NOT NULL DEFAULT 0) STRICT;
CREATE TABLE job_artefact (job INTEGER NOT NULL REFERENCES job, artefact INTEGER NOT NULL REFERENCES artefact,
  kind TEXT NOT NULL, name TEXT NOT NULL, PRIMARY KEY (job, kind, name)) STRICT;
CREATE TABLE execution (id INTEGER PRIMARY KEY AUTOINCREMENT, job INTEGER NOT NULL REFERENCES job, attempt INTEGER NOT NULL,
  started REAL NOT NULL, ended REAL, outcome INTEGER, reason TEXT NOT NULL DEFAULT '', operator TEXT NOT NULL) STRICT;
CREATE UNIQUE INDEX one_open_execution ON execution (ended IS NULL) WHERE ended IS NULL;
CREATE TABLE progress (execution INTEGER PRIMARY KEY REFERENCES execution, sent_through INTEGER NOT NULL,
  taken_through INTEGER NOT NULL, layer INTEGER NOT NULL, path_mm REAL NOT NULL, laid_mm3 REAL NOT NULL,
  updated REAL NOT NULL) STRICT;
CREATE TABLE transition (id INTEGER PRIMARY KEY, time REAL NOT NULL, mode INTEGER NOT NULL, from_state INTEGER NOT NULL,
  to_state INTEGER NOT NULL, command INTEGER NOT NULL, source TEXT NOT NULL, reason TEXT NOT NULL) STRICT;
CREATE TABLE alarm (id INTEGER PRIMARY KEY, execution INTEGER REFERENCES execution, time REAL NOT NULL, alarm INTEGER NOT NULL,
  value REAL NOT NULL, category TEXT NOT NULL, message TEXT NOT NULL) STRICT;
CREATE INDEX alarm_by_execution ON alarm (execution, time);
CREATE TABLE counter (name TEXT PRIMARY KEY, value REAL NOT NULL) STRICT;
)sql";

constexpr const char* kTraceability = R"sql(
ALTER TABLE job ADD COLUMN layers INTEGER NOT NULL DEFAULT 0;
ALTER TABLE transition ADD COLUMN execution INTEGER REFERENCES execution;
CREATE INDEX transition_by_execution ON transition (execution, time);
ALTER TABLE alarm ADD COLUMN acknowledged REAL;
ALTER TABLE alarm ADD COLUMN acknowledged_by TEXT NOT NULL DEFAULT '';
ALTER TABLE alarm ADD COLUMN gone REAL;
CREATE INDEX alarm_unacknowledged ON alarm (alarm) WHERE acknowledged IS NULL;
CREATE INDEX alarm_present ON alarm (alarm) WHERE gone IS NULL;
CREATE TABLE gap (id INTEGER PRIMARY KEY, execution INTEGER NOT NULL REFERENCES execution, began REAL NOT NULL, ended REAL,
  line INTEGER NOT NULL, reason TEXT NOT NULL) STRICT;
CREATE INDEX gap_by_execution ON gap (execution, began);
CREATE TABLE layer (execution INTEGER NOT NULL REFERENCES execution, layer INTEGER NOT NULL, began REAL, ended REAL,
  expected_mm REAL, mean_mm REAL, rms_mm REAL, flatness_mm REAL, worst_mm REAL, coverage REAL, gain REAL, nozzle_c REAL,
  bed_c REAL, correction TEXT, PRIMARY KEY (execution, layer)) STRICT;
CREATE TABLE setpoint (id INTEGER PRIMARY KEY, execution INTEGER NOT NULL REFERENCES execution, time REAL NOT NULL,
  key TEXT NOT NULL, value REAL NOT NULL, source TEXT NOT NULL) STRICT;
CREATE INDEX setpoint_by_execution ON setpoint (execution, time);
CREATE TABLE part (execution INTEGER PRIMARY KEY REFERENCES execution, serial TEXT NOT NULL UNIQUE, verdict TEXT NOT NULL,
  verdict_by TEXT NOT NULL, removed REAL, removed_by TEXT NOT NULL DEFAULT '', record TEXT NOT NULL) STRICT;
)sql";

/// What each version adds to the one before; the first has an audit, too.
constexpr std::array<const char*, 2> kVersions = {kFirstTables, kTraceability};
constexpr int kVersion = static_cast<int>(kVersions.size());

int versionOf(const Database& database) {
  Statement version = database.prepare("PRAGMA user_version");
  return version.step() ? static_cast<int>(version.integer(0)) : 0;
}

void requireNoLater(int version, const std::string& path) {
  if (version > kVersion)
    throw FileError(path + ": written by a newer version of Lamina (" + std::to_string(version) +
                    "); expected at most " + std::to_string(kVersion));
}

}  // namespace

void bringUpToDate(Database& database, const std::string& path) {
  const int version = versionOf(database);
  requireNoLater(version, path);
  if (version == kVersion) return;
  Transaction transaction(database);
  for (int next = version; next < kVersion; ++next)
    database.run(kVersions.at(static_cast<std::size_t>(next)));
  if (version == 0) database.run(kAuditTable);
  database.run("PRAGMA user_version = " + std::to_string(kVersion));
  transaction.commit();
}

void requireUpToDate(const Database& database, const std::string& path) {
  const int version = versionOf(database);
  requireNoLater(version, path);
  if (version < kVersion)
    throw FileError(path + ": of version " + std::to_string(version) + "; expected " +
                    std::to_string(kVersion) + ", to which cell_controller brings it when it starts");
}

}  // namespace lamina
