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

/// The holder of a token, who may use the page or the interface. The token itself is not stored.
struct WebToken {
  std::int64_t id = 0;
  std::string name;
  WebRole role = WebRole::Viewer;
  double created_s = 0.0;           ///< since 1970, UTC, as all times here
  std::optional<double> expires_s;  ///< nothing if it never expires
  std::optional<double> last_used_s;
};

/// A token to be made.
struct NewToken {
  std::string name;
  WebRole role = WebRole::Viewer;
  std::optional<double> expires_s;
};

/// An answer that is repeated if its request is repeated.
struct KeptAnswer {
  int status = 0;
  std::string body;
};

/// A request that was begun under an idempotency key.
struct KeptRequest {
  std::string request;               ///< digest of the request
  std::optional<KeptAnswer> answer;  ///< nothing if none has been kept
};

/// A random key: 32 bytes as 64 hexadecimal digits.
/// @throws FileError if the system provides no random bytes
std::string randomKey();

/// Moves a damaged store aside to make room for a new one. Nothing is deleted.
/// @return the new name; empty if the store is whole, or missing
/// @throws FileError if it can neither be read nor moved
std::string moveDamagedStoreAside(const std::string& path);

/// Store of the page's tokens, audit and kept answers: a database file (SQLite) beside the journal. It may be
/// used by several threads and processes at a time. Reading never waits for writing.
class WebStore {
 public:
  /// Opens the file, and makes it if it is missing, readable by its owner alone.
  /// @throws FileError if it cannot be read or written, or a newer version has written it
  explicit WebStore(const std::string& path);
  ~WebStore();
  WebStore(const WebStore&) = delete;
  WebStore& operator=(const WebStore&) = delete;

  /// Makes a token.
  /// @return the token, which has to be shown to its holder now: only its SHA-256 is stored
  /// @throws InvalidInput if the name is empty, longer than 64 bytes, holds control characters, or is taken
  std::string add(const NewToken& token, double now_s);
  std::vector<WebToken> tokens() const;
  /// The holder of a token; nothing if the token is unknown or has expired.
  std::optional<WebToken> holderOf(const std::string& token, double now_s) const;
  /// The holder of the token with that number, for sessions; nothing if it was removed or has expired.
  std::optional<WebToken> holder(std::int64_t id, double now_s) const;
  /// Removes a token.
  /// @return false if there is no such token
  bool remove(std::int64_t id);
  /// Sets the time at which a token was last used.
  void noteUse(std::int64_t id, double now_s);

  /// Adds a row to the audit. Each row holds a digest that covers the row before.
  void add(const AuditRow& row);
  /// The last rows of the audit, at most `most`.
  std::vector<AuditRow> audit(std::size_t most) const;  ///< oldest first
  /// The first row of the audit whose digest is wrong, counted from 1; nothing if the chain is intact.
  std::optional<std::int64_t> firstBadAudit() const;

  /// Begins a request under an idempotency key, which is remembered for a day. If the same key is used
  /// concurrently, only one request is begun.
  /// @param request  digest of the request
  /// @return the request that was begun under that key before; nothing if this one was begun now
  std::optional<KeptRequest> begin(const std::string& key, const std::string& request, double now_s);
  /// Keeps the answer to the request that was begun under a key.
  void keep(const std::string& key, const KeptAnswer& answer);
  /// Forgets the request that was begun under a key, as it had no effect: it may be begun again.
  void forget(const std::string& key);

 private:
  struct Connections;
  std::unique_ptr<Connections> connections_;
};

}  // namespace lamina
