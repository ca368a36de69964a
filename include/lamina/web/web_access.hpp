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

/// Who is let in, and how often.
struct WebAccessSettings {
  bool is_loopback_open = true;    ///< whoever comes from this host has the role maintenance without a token
  std::vector<std::string> hosts;  ///< names in `Host` besides those of the loopback interface
  double session_s = 12.0 * 3600.0;
  Rate requests = {20.0, 40.0};         ///< of one token
  Rate bad_tokens = {1.0 / 60.0, 5.0};  ///< of one address
};

/// How somebody is known.
enum class IdentifiedBy : std::uint8_t { Nothing, Loopback, Session, Token };

/// Who asks.
struct WebIdentity {
  IdentifiedBy by = IdentifiedBy::Nothing;
  std::string name;  ///< "anna"; "this host" on the open loopback interface
  std::optional<WebRole> role;
  std::int64_t token = 0;  ///< 0 for none
  bool is_local = false;   ///< from the loopback interface, and not through a proxy that says so
  std::string csrf;        ///< that requests by cookie have to show in `X-CSRF-Token`
};

/// Why somebody is not let in.
struct WebRefusal {
  int status = 403;
  std::string code;     ///< "wrong_host"
  std::string message;  ///< what, and what was expected
};

struct WebSession {
  std::string cookie;
  std::string csrf;
};

/// An application that asks for a token, as OctoPrint's application keys do.
struct KeyRequest {
  std::int64_t id = 0;
  std::string application;
  std::string from;  ///< address
};

/// Decides who asks. Times are given; several threads may ask at a time.
class WebAccess {
 public:
  WebAccess(WebAccessSettings settings, WebStore& store);

  /// Refuses requests that a browser was made to send from another page or under another host name. Also
  /// refuses keys in addresses, because addresses end up in logs.
  std::optional<WebRefusal> againstOrigin(const HttpHead& head, const HttpTarget& target) const;

  /// Who asks, by `X-Api-Key`, `Authorization: Bearer`, the cookie of a session, or where from.
  /// @return a refusal if what was shown is not known: 401, or 429 after five of them in a minute
  std::variant<WebIdentity, WebRefusal> identify(const HttpHead& head, const CellTime& now);

  /// Whether a request that changes something was really sent by the page or by a program: an identity that a
  /// browser shows unasked needs its CSRF token as well.
  std::optional<WebRefusal> againstForgery(const HttpHead& head, const WebIdentity& identity) const;

  /// Counts a request. @return false if there were too many
  bool takeRequest(const WebIdentity& identity, const CellTime& now);

  /// Opens a session for the holder of a token.
  std::variant<WebSession, WebRefusal> openSession(const std::string& token, const HttpPeer& peer,
                                                   const CellTime& now);
  void closeSession(const std::string& cookie);

  /// An application asks for a token. @return the secret to ask by; empty if too many wait
  std::string requestKey(const std::string& application, const std::string& from, const CellTime& now);
  std::vector<KeyRequest> keyRequests(const CellTime& now) const;
  /// @return false if no such request waits
  bool decide(std::int64_t id, const std::optional<std::string>& key, const CellTime& now);
  /// What became of a request: nothing while it waits or was never made; an empty key if it was denied.
  struct KeyDecision {
    bool is_known = false;
    std::optional<std::string> key;
  };
  KeyDecision keyDecision(const std::string& secret, const CellTime& now);

  /// Number of lock-outs for guessed tokens since the last call; they raise 9001.
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
