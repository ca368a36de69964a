// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/operator_site.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <optional>
#include <set>

#include "lamina/base/error.hpp"
#include "lamina/base/sha256.hpp"
#include "lamina/web/multipart_reader.hpp"
#include "lamina/web/rate_limit.hpp"
#include "web/site_routes.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLongestKey = 100;  // of Idempotency-Key
constexpr int kMayBeDone = 504;           // the cell may still do what it has not answered
// Whoever is refused, from one address or from many, neither fills the disk nor has others wait for it.
constexpr Rate kAuditedRefusals = {1.0, 60.0};  // of one address
constexpr Rate kAllAuditedRefusals = {2.0, 200.0};
constexpr double kUseNoted = 600.0;  // [s]

/// The parts of a pattern: "/a/{b}" gives "a" and "{b}".
std::vector<std::string> partsOf(const std::string& pattern) {
  return parsedTarget(pattern).value_or(HttpTarget{}).segments;
}

/// The text of a state with the time at which it was written, by which a page tells when it was pressed. That
/// time alone makes no state a new one.
std::string withClock(const std::string& state, const CellTime& now) {
  return state.substr(0, state.size() - 1) + R"(,"clock_s":)" + nlohmann::json(now.steady_s).dump() + '}';
}

bool isPlace(const std::string& part) { return part.front() == '{'; }

/// The values of a pattern's places; nothing if the path is another one.
std::optional<std::vector<std::string>> valuesIn(const std::vector<std::string>& pattern,
                                                 const std::vector<std::string>& path) {
  if (pattern.size() != path.size()) return std::nullopt;
  std::vector<std::string> values;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (isPlace(pattern[i]))
      values.push_back(path[i]);
    else if (pattern[i] != path[i])
      return std::nullopt;
  }
  return values;
}

const char* wordOf(HttpMethod method) {
  switch (method) {
    case HttpMethod::Get:
      return "GET";
    case HttpMethod::Post:
      return "POST";
    case HttpMethod::Delete:
      return "DELETE";
    case HttpMethod::Other:
      break;
  }
  return "?";
}

/// What a request asks for, in full: its method, target, body or upload.
std::string digestOf(const WebRequest& request) {
  std::string text = std::string(wordOf(request.head.method)) + ' ' + request.head.target + '\n' +
                     sha256Of(request.body) + '\n' + request.upload.sha256 + '\n' + request.upload.name;
  for (const auto& [name, value] : request.upload.fields)
    text += '\n' + std::to_string(name.size()) + ':' + name + std::to_string(value.size()) + ':' + value;
  return sha256Of(text);
}

/// `Content-Length`; 0 without one, nothing if it is no number.
std::optional<std::uint64_t> bodyLength(const HttpHead& head) {
  constexpr std::size_t kMostDigits = 15;
  const std::string text = head.header("content-length");
  if (text.size() > kMostDigits || text.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  return text.empty() ? 0 : std::stoull(text);
}

std::vector<SiteRoute> allRoutes() {
  std::vector<SiteRoute> routes = pageRoutes();
  for (const auto& more : {cellRoutes(), partRoutes(), octoprintRoutes()})
    routes.insert(routes.end(), more.begin(), more.end());
  return routes;
}

/// Orders that stop the unit: neither rates nor repeated keys stand before them.
bool isUrgent(const RouteRow& row) { return row.right == WebRight::Hold; }

/// Answers that hold a token or open a session are shown once, and kept by nobody.
bool isShownOnce(const RouteRow& row) {
  return row.right == WebRight::None || row.pattern == "/api/v1/tokens";
}

int statusOf(const Failure& failure) {
  switch (failure.code) {
    case ErrorCode::FileError:
    case ErrorCode::Internal:
      return 500;
    default:
      return 400;
  }
}

}  // namespace

struct OperatorSite::Inside {
  Inside(SiteSettings settings, CellDesk& desk, WebStore& store, std::vector<PageFile> files)
      : parts(std::move(settings), desk, store, std::move(files)),
        room(parts.settings.upload_folder, parts.settings.free_bytes),
        refusals(kAuditedRefusals),
        all_refusals(kAllAuditedRefusals) {
    for (const SiteRoute& route : routes) patterns.push_back(partsOf(route.row.pattern));
  }

  WebResponse refuse(const HttpHead& head, const WebRefusal& refusal, const WebIdentity& who,
                     const CellTime& now);
  std::optional<WebRefusal> againstRight(const RouteRow& row, const WebIdentity& who) const;
  std::optional<WebRefusal> against(const HttpHead& head, const RouteRow& row, const WebIdentity& who,
                                    const CellTime& now);
  std::optional<WebRefusal> againstBody(const HttpHead& head, const RouteRow& row) const;
  WebResponse call(const Admitted& admitted, const WebRequest& request, const CellTime& now);
  WebResponse answerAgain(const KeptRequest& known, const std::string& request, bool is_under_way) const;
  WebResponse callOnce(const std::string& key, const Admitted& admitted, const WebRequest& request,
                       const CellTime& now);
  bool isRefusalWritten(const std::string& address, const CellTime& now);
  void audit(const AuditRow& row);
  void tellGuesses(const std::string& address);
  void noteUse(const WebIdentity& who, const CellTime& now);

  SiteParts parts;
  std::vector<SiteRoute> routes = allRoutes();
  std::vector<std::vector<std::string>> patterns;
  UploadRoom room;
  std::mutex mutex;  // of all that follows
  RateLimit refusals;
  RateLimit all_refusals;
  std::map<std::int64_t, double> used_s;
  StateBell bell;
  std::array<Live, 2> lives;          // for those who see the state only, and for all others
  std::array<std::string, 2> states;  // of `lives`, without the time at which they were written
  Frame frame;
  std::mutex keys_mutex;  // of the keys: taken while the disk is written to
  std::set<std::string> keys_under_way;
};

OperatorSite::OperatorSite(SiteSettings settings, CellDesk& desk, WebStore& store,
                           std::vector<PageFile> files)
    : inside_(std::make_unique<Inside>(std::move(settings), desk, store, std::move(files))) {}

OperatorSite::~OperatorSite() = default;

std::vector<RouteRow> OperatorSite::routes() {
  std::vector<RouteRow> rows;
  for (const SiteRoute& route : allRoutes()) rows.push_back(route.row);
  return rows;
}

const SiteSettings& OperatorSite::settings() const { return inside_->parts.settings; }

bool OperatorSite::Inside::isRefusalWritten(const std::string& address, const CellTime& now) {
  const std::lock_guard<std::mutex> lock(mutex);
  return refusals.take(address, now.steady_s) && all_refusals.take("", now.steady_s);
}

void OperatorSite::Inside::audit(const AuditRow& row) {
  try {
    parts.store.add(row);
  } catch (const Error& error) {
    // What was done is done; that it is not in the audit is reported as loudly as a broken one.
    parts.desk.report(9003, 0.0, std::string("the audit cannot be written: ") + error.what());
  }
}

void OperatorSite::Inside::noteUse(const WebIdentity& who, const CellTime& now) {
  if (who.token == 0) return;
  {
    const std::lock_guard<std::mutex> lock(mutex);
    double& used = used_s[who.token];
    if (used != 0.0 && now.utc_s - used < kUseNoted) return;
    used = now.utc_s;
  }
  try {
    parts.store.noteUse(who.token, now.utc_s);
  } catch (const Error&) {
    // A disk that cannot be written is reported by the audit.
  }
}

WebResponse OperatorSite::Inside::refuse(const HttpHead& head, const WebRefusal& refusal,
                                         const WebIdentity& who, const CellTime& now) {
  const bool is_written = isRefusalWritten(head.peer.address, now);
  const std::string path = head.target.substr(0, head.target.find('?')).substr(0, 120);
  if (is_written)
    audit({now.utc_s, who.name.empty() ? "nobody" : who.name, head.peer.address,
           std::string(wordOf(head.method)) + ' ' + path,
           "refused " + std::to_string(refusal.status) + ": " + refusal.message});
  tellGuesses(head.peer.address);
  WebResponse response = errorAnswer(refusal.status, refusal.code, refusal.message);
  if (refusal.status == 401) response.headers.emplace_back("WWW-Authenticate", "Bearer");
  if (refusal.status == 429) response.headers.emplace_back("Retry-After", "60");
  return response;
}

void OperatorSite::Inside::tellGuesses(const std::string& address) {
  const int lock_outs = parts.access.takeLockOuts();
  if (lock_outs > 0)
    parts.desk.report(9001, lock_outs, "more than five unknown tokens in a minute from " + address);
}

std::optional<WebRefusal> OperatorSite::Inside::againstRight(const RouteRow& row,
                                                             const WebIdentity& who) const {
  if (row.right == WebRight::None) return std::nullopt;
  if (!who.role)
    return WebRefusal{401, "no_token", "nobody is logged in; expected a token in X-Api-Key or a session"};
  if (mayDo(*who.role, row.right)) return std::nullopt;
  if (row.right == WebRight::Hold && *who.role == WebRole::Viewer && who.is_local) return std::nullopt;
  return WebRefusal{
      403, "wrong_role",
      std::string("the role ") + toString(*who.role) + " has not the right to " + toString(row.right)};
}

std::optional<WebRefusal> OperatorSite::Inside::againstBody(const HttpHead& head, const RouteRow& row) const {
  const std::string text = head.header("content-length");
  if (!bodyLength(head)) return WebRefusal{400, "bad_length", "Content-Length is no whole number of bytes"};
  const std::uint64_t length = *bodyLength(head);
  if (row.body != RouteBody::Upload) {
    if (length > kMostSmallBody)
      return WebRefusal{413, "too_large", "the body has " + text + " bytes; expected at most 65536"};
    return std::nullopt;
  }
  if (!multipartBoundary(head.header("content-type")))
    return WebRefusal{415, "no_form", "an upload is a form of type multipart/form-data"};
  if (head.headers.count("transfer-encoding") != 0)
    return WebRefusal{
        411, "no_length",
        "the upload is sent in chunks; expected Content-Length, so that room can be kept for it"};
  const std::uint64_t most = parts.settings.most_upload_bytes + kMostSmallBody;
  if (length > most)
    return WebRefusal{413, "too_large",
                      "the upload has " + text + " bytes; expected a file of at most " +
                          std::to_string(parts.settings.most_upload_bytes) + " (web.largest_upload_mb)"};
  return std::nullopt;
}

std::optional<WebRefusal> OperatorSite::Inside::against(const HttpHead& head, const RouteRow& row,
                                                        const WebIdentity& who, const CellTime& now) {
  if (auto refusal = againstRight(row, who)) return refusal;
  // Slicers on this host have neither token nor page; what a browser sends names its origin.
  const bool is_from_program = who.by == IdentifiedBy::Loopback && head.header("origin").empty() &&
                               head.header("sec-fetch-site").empty();
  const bool is_for_slicers = row.pattern.compare(0, 8, "/api/v1/") != 0;
  if (head.method != HttpMethod::Get && row.right != WebRight::None && !(is_from_program && is_for_slicers))
    if (auto refusal = parts.access.againstForgery(head, who)) return refusal;
  if (!isUrgent(row)) {
    WebIdentity counted = who;
    if (!who.role) counted.name = head.peer.address;
    if (!parts.access.takeRequest(counted, now))
      return WebRefusal{429, "too_many_requests", "more requests than the rate that one token has"};
  }
  return againstBody(head, row);
}

std::variant<OperatorSite::Admitted, WebResponse> OperatorSite::admit(const HttpHead& head,
                                                                      const CellTime& now) {
  Inside& inside = *inside_;
  const auto refuse = [&](const WebRefusal& refusal, const WebIdentity& who = {}) {
    return inside.refuse(head, refusal, who, now);
  };
  const auto target = parsedTarget(head.target);
  if (!target) return refuse({400, "bad_target", "the address is no plain path"});
  if (const auto refusal = inside.parts.access.againstOrigin(head, *target)) return refuse(*refusal);
  bool is_path_known = false;
  for (std::size_t i = 0; i < inside.routes.size(); ++i) {
    const RouteRow& row = inside.routes[i].row;
    auto values = valuesIn(inside.patterns[i], target->segments);
    is_path_known = is_path_known || values;
    if (!values || row.method != head.method) continue;
    Admitted admitted{i, row.body, {}, std::move(*values), *target};
    auto identified = inside.parts.access.identify(head, now);
    if (const auto* refusal = std::get_if<WebRefusal>(&identified)) {
      // Files of the page and the state of the session are for everybody, whatever token they show.
      if (row.right != WebRight::None) return refuse(*refusal);
    } else {
      admitted.who = std::get<WebIdentity>(identified);
    }
    if (const auto refusal = inside.against(head, row, admitted.who, now))
      return refuse(*refusal, admitted.who);
    if (row.body == RouteBody::Upload) {
      admitted.place = inside.room.reserve(bodyLength(head).value_or(0));
      if (!admitted.place)
        return refuse({507, "disk_full",
                       "the disk would have less than 1 GiB left after this upload, its copy and those that "
                       "are under way"},
                      admitted.who);
    }
    return admitted;
  }
  if (is_path_known) return refuse({405, "wrong_method", "the address does not take this method"});
  return refuse({404, "not_found", "there is nothing at this address"});
}

WebResponse OperatorSite::Inside::call(const Admitted& admitted, const WebRequest& request,
                                       const CellTime& now) {
  SiteCall call{parts, request, admitted, now};
  try {
    return routes.at(admitted.route).handler(call);
  } catch (...) {
    const Failure failure = currentFailure();
    return errorAnswer(statusOf(failure), toString(failure.code), failure.message);
  }
}

/// The answer to a request whose key was shown before.
WebResponse OperatorSite::Inside::answerAgain(const KeptRequest& known, const std::string& request,
                                              bool is_under_way) const {
  if (known.request != request)
    return errorAnswer(409, "other_request",
                       "this Idempotency-Key was shown with another request; expected a key of its own");
  if (known.answer) {
    WebResponse response;
    response.status = known.answer->status;
    response.body = known.answer->body;
    response.note = "repeated";
    return response;
  }
  if (is_under_way)
    return errorAnswer(409, "under_way", "a request of the same Idempotency-Key is under way");
  return errorAnswer(
      409, "not_known",
      "the request of this Idempotency-Key was cut off, and may have been done; expected a look "
      "at the state, and another key");
}

/// Runs a request once for its key. The key is on the disk before the request runs: however often it is
/// repeated, also after a restart, it is not run again unless nothing came of it.
WebResponse OperatorSite::Inside::callOnce(const std::string& key, const Admitted& admitted,
                                           const WebRequest& request, const CellTime& now) {
  const std::string digest = digestOf(request);
  {
    // Begun and noted in one: a repetition finds it either under way or answered.
    const std::lock_guard<std::mutex> lock(keys_mutex);
    std::optional<KeptRequest> known;
    try {
      known = parts.store.begin(key, digest, now.utc_s);
    } catch (const Error& error) {
      return errorAnswer(500, "not_kept", std::string("nothing was done: ") + error.what());
    }
    if (known) return answerAgain(*known, digest, keys_under_way.count(key) != 0);
    keys_under_way.insert(key);
  }
  WebResponse response = call(admitted, request, now);
  const std::lock_guard<std::mutex> lock(keys_mutex);
  try {
    const bool is_kept = response.status < 500 || response.status == kMayBeDone;
    if (is_kept)
      parts.store.keep(key, {response.status, response.body});
    else
      parts.store.forget(key);
  } catch (const Error& error) {
    parts.desk.report(9003, 0.0, std::string("answers cannot be kept: ") + error.what());
  }
  keys_under_way.erase(key);
  return response;
}

WebResponse OperatorSite::answer(const Admitted& admitted, const WebRequest& request, const CellTime& now) {
  Inside& inside = *inside_;
  const RouteRow& row = inside.routes.at(admitted.route).row;
  const std::string key = request.head.header("idempotency-key");
  WebResponse response;
  // An upload lasts for minutes, in which its token may have been withdrawn.
  const bool is_for_somebody = row.method != HttpMethod::Get && row.right != WebRight::None;
  if (is_for_somebody && !isStillIn(admitted.who, request.head, now))
    response = errorAnswer(401, "token_withdrawn",
                           "the token was withdrawn or has expired while the request came; nothing was done");
  else if (key.size() > kLongestKey)
    response = errorAnswer(400, "bad_key", "Idempotency-Key has more than 100 bytes");
  else if (key.empty() || row.method == HttpMethod::Get || isUrgent(row) || isShownOnce(row))
    response = inside.call(admitted, request, now);
  else
    response = inside.callOnce(std::to_string(admitted.who.token) + ' ' + key, admitted, request, now);
  // Whatever was asked for has been done by now: what stops the unit does not wait for the disk.
  const bool is_refused = response.status >= 400;
  const bool is_for_audit = (row.method != HttpMethod::Get && (is_refused || response.is_audited)) ||
                            response.status == 401 || response.status == 403;
  // What anybody may ask for is refused to anybody, as often as they like.
  const bool is_limited = is_refused && (row.right == WebRight::None || !admitted.who.role);
  if (is_for_audit && (!is_limited || inside.isRefusalWritten(request.head.peer.address, now))) {
    const std::string what = std::string(wordOf(row.method)) + ' ' + request.head.target.substr(0, 120) +
                             (response.note.empty() ? "" : ": " + response.note);
    std::string reason;
    if (is_refused) {
      const auto body = nlohmann::json::parse(response.body, nullptr, false);
      if (body.is_object()) reason = ": " + body.value("message", "");
    }
    inside.audit({now.utc_s, admitted.who.name.empty() ? "nobody" : admitted.who.name,
                  request.head.peer.address, what,
                  (is_refused ? "refused " : "done ") + std::to_string(response.status) + reason});
  }
  inside.tellGuesses(request.head.peer.address);
  inside.noteUse(admitted.who, now);
  return response;
}

void OperatorSite::noteRefusal(const HttpPeer& peer, const std::string& what, const std::string& reason,
                               const CellTime& now) {
  if (!inside_->isRefusalWritten(peer.address, now)) return;
  inside_->audit({now.utc_s, "nobody", peer.address, what, "refused: " + reason});
}

void OperatorSite::observe(const CellTime& now) {
  {
    const CellSnapshot seen = inside_->parts.desk.snapshot();
    const std::lock_guard<std::mutex> lock(inside_->parts.history_mutex);
    inside_->parts.history.observe(seen, now);
  }
  if (!inside_->bell.isHeard()) {
    const std::lock_guard<std::mutex> lock(inside_->mutex);
    for (Live& live : inside_->lives) live.text.reset();
    return;
  }
  bool is_new = false;
  std::size_t place = 0;
  for (const WebRole role : {WebRole::Sender, WebRole::Viewer}) {
    std::string state =
        stateJson(inside_->parts, role, now).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    const std::lock_guard<std::mutex> lock(inside_->mutex);
    Live& live = inside_->lives.at(place);
    std::string& before = inside_->states.at(place++);
    if (live.text && before == state) continue;
    live = {live.number + 1, std::make_shared<const std::string>(withClock(state, now))};
    before = std::move(state);
    is_new = true;
  }
  if (is_new) inside_->bell.ring();
}

StateBell& OperatorSite::bell() { return inside_->bell; }

OperatorSite::Live OperatorSite::live(WebRole role) const {
  const std::lock_guard<std::mutex> lock(inside_->mutex);
  return inside_->lives.at(mayDo(role, WebRight::SeeAll) ? 1 : 0);
}

bool OperatorSite::isStillIn(const WebIdentity& who, const HttpHead& head, const CellTime& now) {
  const auto identified = inside_->parts.access.identify(head, now);
  const auto* identity = std::get_if<WebIdentity>(&identified);
  return identity != nullptr && identity->role == who.role && identity->token == who.token;
}

void OperatorSite::setFrame(std::string jpeg) {
  auto picture = std::make_shared<const std::string>(std::move(jpeg));
  const std::lock_guard<std::mutex> lock(inside_->mutex);
  inside_->frame = {inside_->frame.number + 1, std::move(picture)};
}

OperatorSite::Frame OperatorSite::frame() const {
  const std::lock_guard<std::mutex> lock(inside_->mutex);
  return inside_->frame;
}

}  // namespace lamina
