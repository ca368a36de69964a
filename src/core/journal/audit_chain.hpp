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

/// The table of an audit: each row holds the digest of the row before and of itself.
constexpr const char* kAuditTable = R"sql(
CREATE TABLE audit (id INTEGER PRIMARY KEY AUTOINCREMENT, time REAL NOT NULL, who TEXT NOT NULL, origin TEXT NOT NULL, what TEXT NOT NULL,
  result TEXT NOT NULL, digest TEXT NOT NULL) STRICT;
)sql";

/// Adds a row. Call it within a transaction.
void addAuditRow(Database& database, const AuditRow& row);

/// The first row whose digest is not its own, counted from 1; nothing if the chain is whole.
std::optional<std::int64_t> firstBadAuditRow(const Database& database);

/// The last rows, oldest first.
std::vector<AuditRow> lastAuditRows(const Database& database, std::size_t most);

}  // namespace lamina
