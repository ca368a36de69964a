// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "journal/database.hpp"
#include "lamina/journal/cell_journal.hpp"

namespace lamina {

/// SQL that makes the table of an audit. Each row has a digest over itself and the digest of the row before.
constexpr const char* kAuditTable = R"sql(
CREATE TABLE audit (id INTEGER PRIMARY KEY AUTOINCREMENT, time REAL NOT NULL, who TEXT NOT NULL, origin TEXT NOT NULL, what TEXT NOT NULL,
  result TEXT NOT NULL, digest TEXT NOT NULL) STRICT;
)sql";

/// Adds a row; to be called within a transaction.
void addAuditRow(Database& database, const AuditRow& row);

/// Number, counted from 1, of the first row whose digest is wrong; nothing if all are right.
std::optional<std::int64_t> firstBadAuditRow(const Database& database);

/// The last rows, at most `most`, oldest first.
std::vector<AuditRow> lastAuditRows(const Database& database, std::size_t most);

}  // namespace lamina
