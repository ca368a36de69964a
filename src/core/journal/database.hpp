// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {

/// Thrown if a file is no database, or a damaged one.
class DamagedDatabase : public FileError {
 public:
  using FileError::FileError;
};

/// A prepared statement of SQLite. Parameters are bound in their order; rows are read after `step`.
class Statement {
 public:
  /// @throws FileError if the statement is not SQL, or a table is missing
  Statement(sqlite3* database, const std::string& sql);

  Statement& bind(std::int64_t value);
  Statement& bind(double value);
  Statement& bind(const std::string& text);
  Statement& bind(const std::optional<std::int64_t>& value);
  Statement& bind(const std::optional<double>& value);
  Statement& bind(const std::optional<std::string>& value);

  /// Runs the statement up to its next row.
  /// @return true if there is a row to read
  /// @throws FileError with SQLite's reason: locked for too long, disk full, damaged
  bool step();

  /// Runs a statement that has no rows.
  void run() { step(); }

  std::int64_t integer(int column) const;
  double number(int column) const;
  /// The number in a column; nothing if the column is null.
  std::optional<double> optionalNumber(int column) const;
  std::string text(int column) const;
  bool isNull(int column) const;

 private:
  struct Finalise {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  void check(int result) const;

  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalise> statement_;
  int bound_ = 0;
};

/// A database file, to be used by one thread.
class Database {
 public:
  /// Opens the file, and makes it if it is missing.
  /// @throws FileError with path and reason
  explicit Database(const std::string& path);

  /// Opens an existing file read-only.
  static Database toRead(const std::string& path);

  /// Runs statements without parameters or rows.
  void run(const std::string& sql);
  Statement prepare(const std::string& sql) const { return {database_.get(), sql}; }
  std::int64_t lastId() const { return sqlite3_last_insert_rowid(database_.get()); }
  bool isInTransaction() const { return sqlite3_get_autocommit(database_.get()) == 0; }
  std::int64_t changes() const { return sqlite3_changes(database_.get()); }
  /// Copies the whole database into another file, by SQLite's backup interface.
  void copyTo(const std::string& path) const;

 private:
  Database(const std::string& path, int flags);
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
  };
  std::unique_ptr<sqlite3, Close> database_;
};

/// Whether SQLite's quick check finds nothing wrong.
bool isWhole(const Database& database);

/// Moves a damaged database and the files that belong to it to a free name.
/// @return the name
/// @throws FileError if it cannot be moved
std::string moveAside(const std::string& path);

/// A transaction: its statements take effect together when committed, and are otherwise rolled back. A
/// transaction within another one takes effect when the outer one does.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool is_open_;  ///< whether this object began the transaction, and has not committed it
};

}  // namespace lamina
