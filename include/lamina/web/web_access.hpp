// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lamina/cell/production_cell.hpp"
#include "lamina/web/http_message.hpp"
#include "lamina/web/rate_limit.hpp"
#include "lamina/web/web_store.hpp"

namespace lamina {

/// Settings of access: which clients are admitted, and at which rate.
struct WebAccessSettings {
  bool is_loopback_open = true;         ///< clients on this host need no token and have the role maintenance
  std::vector<std::string> hosts;       ///< names allowed in `Host`, besides those of the loopback interface
  double session_s = 12.0 * 3600.0;     ///< life of a session
  Rate requests = {20.0, 40.0};         ///< greatest rate for one token
  Rate bad_tokens = {1.0 / 60.0, 5.0};  ///< greatest rate of unknown tokens from one address
};

/// How a client was identified.
enum class IdentifiedBy : std::uint8_t { Nothing, Loopback, Session, Token };

/// Identity of a client.
struct WebIdentity {
  IdentifiedBy by = IdentifiedBy::Nothing;
  std::string name;             ///< "anna"; "this host" on the open loopback interface
  std::optional<WebRole> role;  ///< nothing if the client is not identified
  std::int64_t token = 0;       ///< number of the token; 0 for none
  bool is_local = false;        ///< from the loopback interface, and not through a proxy that declares itself
  std::string csrf;             ///< value that requests without a token must state in `X-CSRF-Token`
};

/// Reason why a client is not admitted.
struct WebRefusal {
  int status = 403;
  std::string code;     ///< "wrong_host"
  std::string message;  ///< what is wrong, and what was expected
};

struct WebSession {
  std::string cookie;
  std::string csrf;
};

/// Request of an application for a token, like OctoPrint's application keys.
struct KeyRequest {
  std::int64_t id = 0;
  std::string application;
  std::string from;  ///< address of the application
};

/// Identifies clients and decides whether they are admitted. Times are passed in; may be called from several
/// threads.
class WebAccess {
 public:
  WebAccess(WebAccessSettings settings, WebStore& store);

  /// Refuses requests that another site made a browser send, or that use an unknown host name; also refuses
  /// keys in addresses, because addresses end up in logs.
  std::optional<WebRefusal> againstOrigin(const HttpHead& head, const HttpTarget& target) const;

  /// Identifies a client by `X-Api-Key`, `Authorization: Bearer`, the cookie of a session, or the loopback
  /// interface. A client with none of these, or with a cookie that is not valid, is not refused, but has no
  /// role.
  /// @return a refusal if the presented token is unknown: 401, or 429 if there were too many unknown tokens
  std::variant<WebIdentity, WebRefusal> identify(const HttpHead& head, const CellTime& now);

  /// Refuses a request that changes something and that another site may have caused: a client that is
  /// identified without a token also needs the CSRF token.
  std::optional<WebRefusal> againstForgery(const HttpHead& head, const WebIdentity& identity) const;

  /// Counts a request.
  /// @return false if there were too many
  bool takeRequest(const WebIdentity& identity, const CellTime& now);

  /// Opens a session for the holder of a token.
  /// @return a refusal as `identify` if the token is not known
  std::variant<WebSession, WebRefusal> openSession(const std::string& token, const HttpPeer& peer,
                                                   const CellTime& now);
  void closeSession(const std::string& cookie);

  /// Records that an application asks for a token. It can be decided on for five minutes.
  /// @return the secret by which the application asks for the decision; empty if eight requests wait already
  std::string requestKey(const std::string& application, const std::string& from, const CellTime& now);
  /// The requests that wait for a decision.
  std::vector<KeyRequest> keyRequests(const CellTime& now) const;
  /// Decides on a request.
  /// @param key  the token for the application; nothing to deny it
  /// @return false if no such request waits
  bool decide(std::int64_t id, const std::optional<std::string>& key, const CellTime& now);
  /// Decision on a request of an application. `is_known` is false if there is no such request (any more);
  /// `key` is nothing while the request waits, and empty if it was denied.
  struct KeyDecision {
    bool is_known = false;
    std::optional<std::string> key;
  };
  /// The decision on the request with that secret; once it was made, it is returned only once.
  KeyDecision keyDecision(const std::string& secret, const CellTime& now);

  /// Number of times since the last call that an address was locked out for unknown tokens; they raise alarm
  /// 9001.
  int takeLockOuts();

 private:
  struct Session {
    std::int64_t token = 0;
    std::string csrf;
    double until_s = 0.0;
  };
  struct Waiting {
    KeyRequest request;
    std::string secret;
    std::optional<std::string> key;  ///< empty: denied
    double until_s = 0.0;
  };
  bool isLocal(const HttpHead& head) const;
  WebRefusal badToken(const std::string& address, const CellTime& now);
  std::optional<WebIdentity> bySession(const std::string& cookie, const CellTime& now);
  bool hasSession(const std::string& cookie) const;
  void forgetOldKeys(const CellTime& now);

  WebAccessSettings settings_;
  WebStore& store_;
  std::string loopback_csrf_;
  mutable std::mutex mutex_;
  std::map<std::string, Session> sessions_;  ///< by the digest of the cookie
  RateLimit requests_;
  RateLimit bad_tokens_;
  std::map<std::string, double> locked_until_s_;  ///< by address
  int lock_outs_ = 0;
  std::vector<Waiting> waiting_;
  std::int64_t last_request_ = 0;
};

}  // namespace lamina
