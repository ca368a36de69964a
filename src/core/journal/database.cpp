// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "journal/database.hpp"

#include <filesystem>

namespace lamina {
namespace {

constexpr int kBusyTimeout = 2000;  // [ms]

std::string pathOf(sqlite3* database) {
  const char* path = sqlite3_db_filename(database, "main");
  return path == nullptr ? "database" : path;
}

[[noreturn]] void fail(sqlite3* database) {
  const std::string message = pathOf(database) + ": " + sqlite3_errmsg(database);
  const int code = sqlite3_errcode(database);
  if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB) throw DamagedDatabase(message);
  throw FileError(message);
}

}  // namespace

Statement::Statement(sqlite3* database, const std::string& sql) : database_(database) {
  sqlite3_stmt* statement = nullptr;
  const int result =
      sqlite3_prepare_v2(database, sql.c_str(), static_cast<int>(sql.size()) + 1, &statement, nullptr);
  statement_.reset(statement);
  check(result);
}

void Statement::check(int result) const {
  if (result != SQLITE_OK && result != SQLITE_ROW && result != SQLITE_DONE) fail(database_);
}

Statement& Statement::bind(std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), ++bound_, value));
  return *this;
}

Statement& Statement::bind(double value) {
  check(sqlite3_bind_double(statement_.get(), ++bound_, value));
  return *this;
}

Statement& Statement::bind(const std::string& text) {
  check(sqlite3_bind_text(statement_.get(), ++bound_, text.data(), static_cast<int>(text.size()),
                          SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind(const std::optional<std::int64_t>& value) {
  if (value) return bind(*value);
  check(sqlite3_bind_null(statement_.get(), ++bound_));
  return *this;
}

Statement& Statement::bind(const std::optional<double>& value) {
  if (value) return bind(*value);
  check(sqlite3_bind_null(statement_.get(), ++bound_));
  return *this;
}

Statement& Statement::bind(const std::optional<std::string>& value) {
  if (value) return bind(*value);
  return bind(std::optional<double>());
}

bool Statement::step() {
  const int result = sqlite3_step(statement_.get());
  check(result);
  return result == SQLITE_ROW;
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

double Statement::number(int column) const { return sqlite3_column_double(statement_.get(), column); }

std::string Statement::text(int column) const {
  const unsigned char* text = sqlite3_column_text(statement_.get(), column);
  if (text == nullptr) return "";
  return {reinterpret_cast<const char*>(text),
          static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

std::optional<double> Statement::optionalNumber(int column) const {
  if (isNull(column)) return std::nullopt;
  return number(column);
}

bool Statement::isNull(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

Database::Database(const std::string& path) : Database(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE) {}

Database Database::toRead(const std::string& path) { return {path, SQLITE_OPEN_READONLY}; }

Database::Database(const std::string& path, int flags) {
  sqlite3* database = nullptr;
  const int result = sqlite3_open_v2(path.c_str(), &database, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  database_.reset(database);
  if (result != SQLITE_OK)
    throw FileError(path + ": " + (database == nullptr ? "no memory" : sqlite3_errmsg(database)));
  sqlite3_busy_timeout(database, kBusyTimeout);
}

void Database::run(const std::string& sql) {
  if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    fail(database_.get());
}

void Database::copyTo(const std::string& path) const {
  const Database copy(path);
  sqlite3_backup* backup = sqlite3_backup_init(copy.database_.get(), "main", database_.get(), "main");
  if (backup == nullptr) fail(copy.database_.get());
  sqlite3_backup_step(backup, -1);
  if (sqlite3_backup_finish(backup) != SQLITE_OK) fail(copy.database_.get());
}

bool isWhole(const Database& database) {
  Statement check = database.prepare("PRAGMA quick_check");
  return check.step() && check.text(0) == "ok";
}

std::string moveAside(const std::string& path) {
  namespace fs = std::filesystem;
  std::string aside;
  for (int number = 1; aside.empty() || fs::exists(aside); ++number)
    aside = path + ".damaged" + std::to_string(number);
  std::error_code error;
  fs::rename(path, aside, error);
  if (error) throw FileError(path + ": is damaged and cannot be moved aside: " + error.message());
  for (const char* suffix : {"-wal", "-shm"}) fs::rename(path + suffix, aside + suffix, error);
  return aside;
}

Transaction::Transaction(Database& database) : database_(database), is_open_(!database.isInTransaction()) {
  if (is_open_) database_.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (!is_open_) return;
  try {
    database_.run("ROLLBACK");
  } catch (const Error&) {
    // SQLite has rolled back by itself: what failed has reported its reason.
  }
}

void Transaction::commit() {
  if (!is_open_) return;
  database_.run("COMMIT");
  is_open_ = false;
}

}  // namespace lamina
