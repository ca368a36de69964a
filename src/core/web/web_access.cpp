// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/web_access.hpp"

#include <algorithm>
#include <string_view>

#include "lamina/base/loopback.hpp"
#include "lamina/base/sha256.hpp"

namespace lamina {
namespace {

constexpr double kLockOut = 60.0;     // [s] after too many bad tokens
constexpr double kKeyWaits = 300.0;   // [s] an application's request for a token
constexpr std::size_t kMostKeys = 8;  // of these at a time
constexpr std::size_t kMostSessions = 256;
constexpr std::size_t kMostAddresses = 1024;
constexpr std::string_view kBearer = "Bearer ";

std::string shownToken(const HttpHead& head) {
  const std::string authorization = head.header("authorization");
  if (authorization.compare(0, kBearer.size(), kBearer) == 0) return authorization.substr(kBearer.size());
  return head.header("x-api-key");
}

std::string smallLetters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return text;
}

std::string authorityOf(const std::string& origin) {
  const std::size_t scheme = origin.find("://");
  return smallLetters(scheme == std::string::npos ? origin : origin.substr(scheme + 3));
}

WebIdentity identityOf(const WebToken& holder, IdentifiedBy by, bool is_local) {
  return {by, holder.name, holder.role, holder.id, is_local, ""};
}

}  // namespace

WebAccess::WebAccess(WebAccessSettings settings, WebStore& store)
    : settings_(std::move(settings)),
      store_(store),
      loopback_csrf_(randomKey()),
      requests_(settings_.requests),
      bad_tokens_(settings_.bad_tokens) {}

std::optional<WebRefusal> WebAccess::againstOrigin(const HttpHead& head, const HttpTarget& target) const {
  const std::string host = head.header("host");
  const std::string name = hostName(host);
  if (!isLoopbackHost(name) &&
      std::find(settings_.hosts.begin(), settings_.hosts.end(), name) == settings_.hosts.end())
    return WebRefusal{403, "wrong_host", "the request is for host '" + name + "'; expected one of web.hosts"};
  if (target.query.count("apikey") != 0)
    return WebRefusal{403, "key_in_address",
                      "a key in the address ends in logs; expected the header X-Api-Key"};
  const bool is_socket = smallLetters(head.header("upgrade")) == "websocket";
  if (head.method == HttpMethod::Get && !is_socket) return std::nullopt;
  const std::string origin = head.header("origin");
  if (!origin.empty() && authorityOf(origin) != smallLetters(host))
    return WebRefusal{403, "wrong_origin",
                      "the request comes from a page of '" + origin + "'; expected one of '" + host + "'"};
  const std::string site = head.header("sec-fetch-site");
  if (!site.empty() && site != "same-origin" && site != "none")
    return WebRefusal{
        403, "wrong_origin",
        "the request was sent by a page of another site (" + site + "); expected one of '" + host + "'"};
  return std::nullopt;
}

bool WebAccess::isLocal(const HttpHead& head) const {
  // What a proxy on this host passes on does not come from this host.
  const bool is_passed_on =
      head.headers.count("x-forwarded-for") != 0 || head.headers.count("forwarded") != 0;
  return head.peer.is_local && !is_passed_on && isLoopbackHost(hostName(head.header("host")));
}

std::variant<WebIdentity, WebRefusal> WebAccess::identify(const HttpHead& head, const CellTime& now) {
  const bool is_local = isLocal(head);
  const std::string token = shownToken(head);
  if (!token.empty()) {
    if (const auto holder = store_.holderOf(token, now.utc_s))
      return identityOf(*holder, IdentifiedBy::Token, is_local);
    return badToken(head.peer.address, now);
  }
  const std::string cookie = cookieValue(head.header("cookie"), "lamina_session");
  if (!cookie.empty()) {
    if (auto identity = bySession(cookie, now)) {
      identity->is_local = is_local;
      return *identity;
    }
    // Nor is it somebody without a token: a page whose token was withdrawn would go on with all rights.
    if (hasSession(cookie))
      return WebRefusal{401, "token_withdrawn",
                        "the token of this session was withdrawn or has expired; expected another one"};
  }
  WebIdentity identity;
  identity.is_local = is_local;
  if (is_local && settings_.is_loopback_open) {
    identity.by = IdentifiedBy::Loopback;
    identity.name = "this host";
    identity.role = WebRole::Maintenance;
    identity.csrf = loopback_csrf_;
  }
  return identity;
}

WebRefusal WebAccess::badToken(const std::string& address, const CellTime& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto locked = locked_until_s_.find(address);
  const bool is_locked = locked != locked_until_s_.end() && now.steady_s < locked->second;
  if (!is_locked && bad_tokens_.take(address, now.steady_s))
    return {401, "unknown_token", "the token is not known, or has expired"};
  if (!is_locked) {
    ++lock_outs_;
    if (locked_until_s_.size() >= kMostAddresses) locked_until_s_.clear();
    locked_until_s_[address] = now.steady_s + kLockOut;
  }
  return {429, "too_many_bad_tokens", "too many unknown tokens from " + address + "; wait a minute"};
}

std::optional<WebIdentity> WebAccess::bySession(const std::string& cookie, const CellTime& now) {
  const std::string digest = sha256Of(cookie);
  Session session;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = sessions_.find(digest);
    if (found == sessions_.end()) return std::nullopt;
    session = found->second;
    if (now.steady_s >= session.until_s) {
      sessions_.erase(found);
      return std::nullopt;
    }
  }
  const auto holder = store_.holder(session.token, now.utc_s);
  if (!holder) return std::nullopt;
  WebIdentity identity = identityOf(*holder, IdentifiedBy::Session, false);
  identity.csrf = session.csrf;
  return identity;
}

bool WebAccess::hasSession(const std::string& cookie) const {
  const std::string digest = sha256Of(cookie);
  const std::lock_guard<std::mutex> lock(mutex_);
  return sessions_.count(digest) != 0;
}

std::optional<WebRefusal> WebAccess::againstForgery(const HttpHead& head, const WebIdentity& identity) const {
  if (identity.by != IdentifiedBy::Session && identity.by != IdentifiedBy::Loopback) return std::nullopt;
  if (head.header("x-csrf-token") == identity.csrf) return std::nullopt;
  return WebRefusal{
      403, "no_csrf_token",
      "the header X-CSRF-Token is missing or another one; expected that of GET /api/v1/session"};
}

bool WebAccess::takeRequest(const WebIdentity& identity, const CellTime& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return requests_.take(std::to_string(identity.token) + identity.name, now.steady_s);
}

std::variant<WebSession, WebRefusal> WebAccess::openSession(const std::string& token, const HttpPeer& peer,
                                                            const CellTime& now) {
  const auto holder = store_.holderOf(token, now.utc_s);
  if (!holder) return badToken(peer.address, now);
  WebSession session{randomKey(), randomKey()};
  const std::string digest = sha256Of(session.cookie);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (sessions_.size() >= kMostSessions)
    sessions_.erase(std::min_element(
        sessions_.begin(), sessions_.end(),
        [](const auto& one, const auto& other) { return one.second.until_s < other.second.until_s; }));
  sessions_[digest] = {holder->id, session.csrf, now.steady_s + settings_.session_s};
  return session;
}

void WebAccess::closeSession(const std::string& cookie) {
  const std::string digest = sha256Of(cookie);
  const std::lock_guard<std::mutex> lock(mutex_);
  sessions_.erase(digest);
}

void WebAccess::forgetOldKeys(const CellTime& now) {
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(),
                                [&](const Waiting& waiting) { return now.steady_s >= waiting.until_s; }),
                 waiting_.end());
}

std::string WebAccess::requestKey(const std::string& application, const std::string& from,
                                  const CellTime& now) {
  std::string secret = randomKey();
  const std::lock_guard<std::mutex> lock(mutex_);
  forgetOldKeys(now);
  if (waiting_.size() >= kMostKeys) return "";
  waiting_.push_back(
      {{++last_request_, application.substr(0, 60), from}, secret, std::nullopt, now.steady_s + kKeyWaits});
  return secret;
}

std::vector<KeyRequest> WebAccess::keyRequests(const CellTime& now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<KeyRequest> requests;
  for (const Waiting& waiting : waiting_)
    if (!waiting.key && now.steady_s < waiting.until_s) requests.push_back(waiting.request);
  return requests;
}

bool WebAccess::decide(std::int64_t id, const std::optional<std::string>& key, const CellTime& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (Waiting& waiting : waiting_)
    if (waiting.request.id == id && !waiting.key && now.steady_s < waiting.until_s) {
      waiting.key = key.value_or("");
      return true;
    }
  return false;
}

WebAccess::KeyDecision WebAccess::keyDecision(const std::string& secret, const CellTime& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  forgetOldKeys(now);
  for (auto waiting = waiting_.begin(); waiting != waiting_.end(); ++waiting) {
    if (waiting->secret != secret) continue;
    KeyDecision decision{true, waiting->key};
    if (decision.key) waiting_.erase(waiting);  // a key is given once
    return decision;
  }
  return {};
}

int WebAccess::takeLockOuts() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(lock_outs_, 0);
}

}  // namespace lamina
