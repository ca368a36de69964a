// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "journal/audit_chain.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "lamina/base/sha256.hpp"

namespace lamina {
namespace {

std::string auditDigest(const std::string& before, const AuditRow& row) {
  std::array<char, 40> time{};
  std::snprintf(time.data(), time.size(), "%.6f", row.time_s);
  std::string text = before;
  for (const std::string& field : {std::string(time.data()), row.who, row.from, row.what, row.result})
    text += std::to_string(field.size()) + ':' + field;  // lengths: no two rows read alike
  return sha256Of(text);
}

AuditRow auditIn(const Statement& row) {
  return {row.number(0), row.text(1), row.text(2), row.text(3), row.text(4)};
}

}  // namespace

void addAuditRow(Database& database, const AuditRow& row) {
  Statement last = database.prepare("SELECT digest FROM audit ORDER BY id DESC LIMIT 1");
  const std::string before = last.step() ? last.text(0) : "";
  database.prepare("INSERT INTO audit (time, who, origin, what, result, digest) VALUES (?, ?, ?, ?, ?, ?)")
      .bind(row.time_s)
      .bind(row.who)
      .bind(row.from)
      .bind(row.what)
      .bind(row.result)
      .bind(auditDigest(before, row))
      .run();
}

std::optional<std::int64_t> firstBadAuditRow(const Database& database) {
  Statement rows =
      database.prepare("SELECT time, who, origin, what, result, digest, id FROM audit ORDER BY id");
  std::string before;
  std::int64_t number = 1;
  for (; rows.step(); ++number) {
    if (rows.integer(6) != number || rows.text(5) != auditDigest(before, auditIn(rows))) return number;
    before = rows.text(5);
  }
  // The database remembers how many there were.
  Statement written = database.prepare("SELECT seq FROM sqlite_sequence WHERE name = 'audit'");
  if (written.step() && written.integer(0) >= number) return number;
  return std::nullopt;
}

std::vector<AuditRow> lastAuditRows(const Database& database, std::size_t most) {
  Statement rows =
      database.prepare("SELECT time, who, origin, what, result FROM audit ORDER BY id DESC LIMIT ?");
  rows.bind(static_cast<std::int64_t>(most));
  std::vector<AuditRow> found;
  while (rows.step()) found.push_back(auditIn(rows));
  std::reverse(found.begin(), found.end());
  return found;
}

}  // namespace lamina
