// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/web_store.hpp"

#include <openssl/rand.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <mutex>

#include "journal/audit_chain.hpp"
#include "journal/database.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/hex_text.hpp"
#include "lamina/base/sha256.hpp"

namespace lamina {
namespace {

constexpr int kVersion = 2;
constexpr std::int64_t kNoStatusYet = 0;  // of a request that was begun
constexpr double kKept = 86400.0;         // [s]
constexpr std::size_t kLongestName = 64;
constexpr mode_t kForOthers = 077;

constexpr const char* kTables = R"sql(
CREATE TABLE token (id INTEGER PRIMARY KEY AUTOINCREMENT, sha256 TEXT NOT NULL UNIQUE, name TEXT NOT NULL UNIQUE, role TEXT NOT NULL,
  created REAL NOT NULL, expires REAL, last_used REAL) STRICT;
CREATE TABLE answer (key TEXT PRIMARY KEY, time REAL NOT NULL, status INTEGER NOT NULL, body TEXT NOT NULL) STRICT;
)sql";
/// Answers of version 1 do not say to what.
constexpr const char* kRequestOfAnswers =
    "DELETE FROM answer; ALTER TABLE answer ADD COLUMN request TEXT NOT NULL DEFAULT ''";
constexpr const char* kTokenColumns = "SELECT id, name, role, created, expires, last_used FROM token ";

/// Opens the file; one that is new is its owner's alone.
Database openForOwner(const std::string& path) {
  const mode_t before = ::umask(kForOthers);
  try {
    Database database(path);
    database.run("PRAGMA journal_mode = WAL");
    database.run("PRAGMA synchronous = FULL");
    ::umask(before);
    return database;
  } catch (...) {
    ::umask(before);
    throw;
  }
}

void bringForward(Database& database, const std::string& path) {
  Transaction transaction(database);
  Statement row = database.prepare("PRAGMA user_version");
  const auto version = row.step() ? row.integer(0) : 0;
  if (version > kVersion)
    throw FileError(path + ": written by a newer version of Lamina (" + std::to_string(version) +
                    "); expected at most " + std::to_string(kVersion));
  if (version == kVersion) return;
  if (version == 0) {
    database.run(kTables);
    database.run(kAuditTable);
  }
  database.run(kRequestOfAnswers);
  database.run("PRAGMA user_version = " + std::to_string(kVersion));
  transaction.commit();
}

WebToken tokenIn(const Statement& row) {
  return {row.integer(0), row.text(1),           webRole(row.text(2)),
          row.number(3),  row.optionalNumber(4), row.optionalNumber(5)};
}

void requireName(const std::string& name) {
  const bool is_plain = std::none_of(name.begin(), name.end(), [](char character) {
    return static_cast<unsigned char>(character) < 0x20 || character == 0x7f;
  });
  if (name.empty() || name.size() > kLongestName || !is_plain)
    throw InvalidInput("the name of a token has " + std::to_string(name.size()) + " bytes" +
                       (is_plain ? "" : ", with control characters") + "; expected 1 to " +
                       std::to_string(kLongestName) + " without control characters");
}

}  // namespace

std::string randomKey() {
  std::array<unsigned char, 32> bytes{};
  if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1)
    throw FileError("no random bytes can be had from the system");
  return hexText(bytes.data(), bytes.size());
}

std::string moveDamagedStoreAside(const std::string& path) {
  std::error_code unreadable;
  if (!std::filesystem::exists(path, unreadable)) return "";
  try {
    if (isWhole(openForOwner(path))) return "";
  } catch (const DamagedDatabase&) {
    // It is no database at all.
  }
  return moveAside(path);
}

/// Connections for one thread at a time each. The audit is read, all of it, by one of its own: whoever asks
/// for anything is looked up by `reading`, and waits for none of that.
struct WebStore::Connections {
  explicit Connections(const std::string& path)
      : writing(openForOwner(path)), reading(openForOwner(path)), checking(openForOwner(path)) {}
  std::mutex writer;
  Database writing;
  mutable std::mutex reader;
  Database reading;
  mutable std::mutex checker;
  Database checking;
};

WebStore::WebStore(const std::string& path) : connections_(std::make_unique<Connections>(path)) {
  bringForward(connections_->writing, path);
}

WebStore::~WebStore() = default;

std::string WebStore::add(const NewToken& token, double now_s) {
  requireName(token.name);
  std::string key = randomKey();
  const std::lock_guard<std::mutex> lock(connections_->writer);
  Database& database = connections_->writing;
  Transaction transaction(database);
  Statement taken = database.prepare("SELECT id FROM token WHERE name = ?");
  if (taken.bind(token.name).step())
    throw InvalidInput("there is a token named '" + token.name + "' already; remove it first");
  database.prepare("INSERT INTO token (sha256, name, role, created, expires) VALUES (?, ?, ?, ?, ?)")
      .bind(sha256Of(key))
      .bind(token.name)
      .bind(std::string(toString(token.role)))
      .bind(now_s)
      .bind(token.expires_s)
      .run();
  transaction.commit();
  return key;
}

std::vector<WebToken> WebStore::tokens() const {
  const std::lock_guard<std::mutex> lock(connections_->reader);
  Statement rows = connections_->reading.prepare(std::string(kTokenColumns) + "ORDER BY name");
  std::vector<WebToken> tokens;
  while (rows.step()) tokens.push_back(tokenIn(rows));
  return tokens;
}

std::optional<WebToken> WebStore::holderOf(const std::string& token, double now_s) const {
  const std::string digest = sha256Of(token);
  const std::lock_guard<std::mutex> lock(connections_->reader);
  Statement row = connections_->reading.prepare(std::string(kTokenColumns) +
                                                "WHERE sha256 = ? AND (expires IS NULL OR expires > ?)");
  if (!row.bind(digest).bind(now_s).step()) return std::nullopt;
  return tokenIn(row);
}

std::optional<WebToken> WebStore::holder(std::int64_t id, double now_s) const {
  const std::lock_guard<std::mutex> lock(connections_->reader);
  Statement row = connections_->reading.prepare(std::string(kTokenColumns) +
                                                "WHERE id = ? AND (expires IS NULL OR expires > ?)");
  if (!row.bind(id).bind(now_s).step()) return std::nullopt;
  return tokenIn(row);
}

bool WebStore::remove(std::int64_t id) {
  const std::lock_guard<std::mutex> lock(connections_->writer);
  connections_->writing.prepare("DELETE FROM token WHERE id = ?").bind(id).run();
  return connections_->writing.changes() > 0;
}

void WebStore::noteUse(std::int64_t id, double now_s) {
  const std::lock_guard<std::mutex> lock(connections_->writer);
  connections_->writing.prepare("UPDATE token SET last_used = ? WHERE id = ?").bind(now_s).bind(id).run();
}

void WebStore::add(const AuditRow& row) {
  const std::lock_guard<std::mutex> lock(connections_->writer);
  Transaction transaction(connections_->writing);
  addAuditRow(connections_->writing, row);
  transaction.commit();
}

std::vector<AuditRow> WebStore::audit(std::size_t most) const {
  const std::lock_guard<std::mutex> lock(connections_->checker);
  return lastAuditRows(connections_->checking, most);
}

std::optional<std::int64_t> WebStore::firstBadAudit() const {
  const std::lock_guard<std::mutex> lock(connections_->checker);
  return firstBadAuditRow(connections_->checking);
}

std::optional<KeptRequest> WebStore::begin(const std::string& key, const std::string& request, double now_s) {
  const std::lock_guard<std::mutex> lock(connections_->writer);
  Transaction transaction(connections_->writing);
  connections_->writing.prepare("DELETE FROM answer WHERE time < ?").bind(now_s - kKept).run();
  {
    Statement row = connections_->writing.prepare("SELECT request, status, body FROM answer WHERE key = ?");
    if (row.bind(key).step()) {
      KeptRequest known{row.text(0), std::nullopt};
      if (row.integer(1) != kNoStatusYet)
        known.answer = KeptAnswer{static_cast<int>(row.integer(1)), row.text(2)};
      return known;
    }
  }
  connections_->writing
      .prepare("INSERT INTO answer (key, time, status, body, request) VALUES (?, ?, ?, '', ?)")
      .bind(key)
      .bind(now_s)
      .bind(kNoStatusYet)
      .bind(request)
      .run();
  transaction.commit();
  return std::nullopt;
}

void WebStore::keep(const std::string& key, const KeptAnswer& answer) {
  const std::lock_guard<std::mutex> lock(connections_->writer);
  connections_->writing.prepare("UPDATE answer SET status = ?, body = ? WHERE key = ?")
      .bind(std::int64_t{answer.status})
      .bind(answer.body)
      .bind(key)
      .run();
}

void WebStore::forget(const std::string& key) {
  const std::lock_guard<std::mutex> lock(connections_->writer);
  connections_->writing.prepare("DELETE FROM answer WHERE key = ?").bind(key).run();
}

}  // namespace lamina
