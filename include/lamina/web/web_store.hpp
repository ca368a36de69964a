// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lamina/journal/cell_journal.hpp"
#include "lamina/web/web_roles.hpp"

namespace lamina {

/// Somebody who may use the page or the interface. The token itself is known to its holder alone.
struct WebToken {
  std::int64_t id = 0;
  std::string name;
  WebRole role = WebRole::Viewer;
  double created_s = 0.0;           ///< since 1970, UTC, as all times here
  std::optional<double> expires_s;  ///< nothing: never
  std::optional<double> last_used_s;
};

/// A token that is being made.
struct NewToken {
  std::string name;
  WebRole role = WebRole::Viewer;
  std::optional<double> expires_s;
};

/// An answer that is given again to a repeated request.
struct KeptAnswer {
  int status = 0;
  std::string body;
};

/// A request that was begun under a key.
struct KeptRequest {
  std::string request;               ///< its digest
  std::optional<KeptAnswer> answer;  ///< nothing if none was kept yet
};

/// 32 random bytes as 64 hexadecimal digits.
/// @throws FileError if the system has none
std::string randomKey();

/// Tokens, audit and kept answers of the page: a database file (SQLite) beside the journal. Several threads
/// and processes may use it at a time. Reading never waits for writing.
class WebStore {
 public:
  /// Opens the file, and makes it if it is missing, readable by its owner alone.
  /// @throws FileError if it cannot be read or written, or a newer version has written it
  explicit WebStore(const std::string& path);
  ~WebStore();
  WebStore(const WebStore&) = delete;
  WebStore& operator=(const WebStore&) = delete;

  /// Makes a token.
  /// @return the token, which is shown once and kept nowhere: only its SHA-256 is
  /// @throws InvalidInput if the name is empty, longer than 64 bytes, holds control characters, or is taken
  std::string add(const NewToken& token, double now_s);
  std::vector<WebToken> tokens() const;
  /// The holder of a token; nothing if there is none, or it has expired.
  std::optional<WebToken> holderOf(const std::string& token, double now_s) const;
  /// The same by number: for sessions that outlive their token.
  std::optional<WebToken> holder(std::int64_t id, double now_s) const;
  /// @return false if there is no such token
  bool remove(std::int64_t id);
  void noteUse(std::int64_t id, double now_s);

  /// Adds a row to the audit, whose rows are chained by their digests.
  void add(const AuditRow& row);
  std::vector<AuditRow> audit(std::size_t most) const;  ///< the last, oldest first
  std::optional<std::int64_t> firstBadAudit() const;

  /// Begins a request under a key, which is remembered for a day. Of several at a time, one begins.
  /// @param request  its digest
  /// @return the request that was begun under that key before; nothing if this one is
  std::optional<KeptRequest> begin(const std::string& key, const std::string& request, double now_s);
  /// Keeps the answer to the request that was begun under a key.
  void keep(const std::string& key, const KeptAnswer& answer);
  /// Nothing came of that request: it may be begun again.
  void forget(const std::string& key);

 private:
  struct Connections;
  std::unique_ptr<Connections> connections_;
};

}  // namespace lamina
