// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/base/version.hpp"
#include "web/site_routes.hpp"

namespace lamina {
namespace {

using nlohmann::json;

constexpr std::size_t kMostAuditRows = 1000;
constexpr double kDay = 86400.0;  // [s]

WebResponse fileNamed(const SiteCall& call, std::string_view name) {
  const auto& files = call.parts.files;
  const auto file =
      std::find_if(files.begin(), files.end(), [&](const PageFile& row) { return row.name == name; });
  if (file == files.end())
    return errorAnswer(404, "not_found", "the page has no file '" + std::string(name) + "'");
  WebResponse response;
  response.type = file->type;
  response.body = file->bytes;
  response.headers = {{"Cache-Control", "no-cache"}};
  return response;
}

WebResponse getPage(SiteCall& call) { return fileNamed(call, "index.html"); }
WebResponse getFile(SiteCall& call) { return fileNamed(call, call.value(0)); }

json sessionJson(const WebIdentity& who) {
  json value = {{"version", laminaVersion()}, {"is_known", who.role.has_value()}};
  if (who.role) {
    value["name"] = who.name;
    value["role"] = toString(*who.role);
    value["csrf"] = who.csrf;
    value["is_local"] = who.is_local;
    value["needs_no_token"] = who.by == IdentifiedBy::Loopback;
  }
  return value;
}

constexpr char kForgottenCookie[] = "lamina_session=; Path=/; HttpOnly; SameSite=Strict; Max-Age=0";

/// A browser forgets a session that is none any more, so that the page can be loaded anew without it.
WebResponse getSession(SiteCall& call) {
  WebResponse response = jsonAnswer(200, sessionJson(call.who()));
  const bool shows_session = !cookieValue(call.request.head.header("cookie"), "lamina_session").empty();
  if (shows_session && !call.who().role) response.headers.emplace_back("Set-Cookie", kForgottenCookie);
  return response;
}

WebResponse openSession(SiteCall& call) {
  const auto opened =
      call.parts.access.openSession(textOf(bodyObject(call), "token"), call.request.head.peer, call.now);
  if (const auto* refusal = std::get_if<WebRefusal>(&opened))
    return errorAnswer(refusal->status, refusal->code, refusal->message);
  const auto& session = std::get<WebSession>(opened);
  WebResponse response = jsonAnswer(201, {{"csrf", session.csrf}});
  const std::string secure = call.request.head.peer.is_encrypted ? "; Secure" : "";
  const auto seconds = static_cast<long long>(call.parts.settings.access.session_s);
  response.headers.emplace_back(
      "Set-Cookie", "lamina_session=" + session.cookie +
                        "; Path=/; HttpOnly; SameSite=Strict; Max-Age=" + std::to_string(seconds) + secure);
  response.note = "login";
  return response;
}

WebResponse closeSession(SiteCall& call) {
  call.parts.access.closeSession(cookieValue(call.request.head.header("cookie"), "lamina_session"));
  WebResponse response = jsonAnswer(200, json::object());
  response.headers.emplace_back("Set-Cookie", kForgottenCookie);
  response.note = "logout";
  return response;
}

json tokenJson(const WebToken& token) {
  return {{"id", token.id},
          {"name", token.name},
          {"role", toString(token.role)},
          {"created_utc_s", token.created_s},
          {"expires_utc_s", token.expires_s ? json(*token.expires_s) : json(nullptr)},
          {"last_used_utc_s", token.last_used_s ? json(*token.last_used_s) : json(nullptr)}};
}

WebResponse getTokens(SiteCall& call) {
  json tokens = json::array();
  for (const WebToken& token : call.parts.store.tokens()) tokens.push_back(tokenJson(token));
  return jsonAnswer(200, {{"tokens", tokens}});
}

WebResponse addToken(SiteCall& call) {
  const json body = bodyObject(call);
  NewToken token{textOf(body, "name"), webRole(textOf(body, "role")), std::nullopt};
  const auto days = body.find("days");
  if (days != body.end() && !days->is_null()) {
    if (!days->is_number() || days->get<double>() <= 0.0 || days->get<double>() > 3650.0)
      throw InvalidInput("days is " + days->dump() + "; expected above 0, at most 3650");
    token.expires_s = call.now.utc_s + days->get<double>() * kDay;
  }
  WebResponse response = jsonAnswer(201, {{"token", call.parts.store.add(token, call.now.utc_s)}});
  response.note = "add token '" + token.name + "' as " + toString(token.role);
  return response;
}

WebResponse removeToken(SiteCall& call) {
  const std::int64_t id = wholeNumber(call.value(0));
  WebResponse response = call.parts.store.remove(id)
                             ? jsonAnswer(200, json::object())
                             : errorAnswer(404, "unknown", "there is no token " + call.value(0));
  response.note = "remove token " + call.value(0);
  return response;
}

std::string tokenNameOf(const std::string& application, const std::string& suffix) {
  std::string name;
  for (const char letter : application)
    if (name.size() < 40) name += static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f ? '_' : letter;
  return (name.empty() ? "application" : name) + " " + suffix;
}

/// Gives an application that asked for it a token of a sender.
WebResponse allowKey(SiteCall& call) {
  const std::int64_t id = wholeNumber(call.value(0));
  const auto requests = call.parts.access.keyRequests(call.now);
  const auto found =
      std::find_if(requests.begin(), requests.end(), [id](const KeyRequest& row) { return row.id == id; });
  if (found == requests.end())
    return errorAnswer(404, "unknown", "no application asks by that number any more");
  const std::string name = tokenNameOf(found->application, randomKey().substr(0, 4));
  const std::string key = call.parts.store.add({name, WebRole::Sender, std::nullopt}, call.now.utc_s);
  call.parts.access.decide(id, key, call.now);
  WebResponse response = jsonAnswer(200, {{"name", name}});
  response.note = "allow '" + name + "' to send";
  return response;
}

WebResponse denyKey(SiteCall& call) {
  const bool is_done = call.parts.access.decide(wholeNumber(call.value(0)), std::nullopt, call.now);
  WebResponse response = is_done ? jsonAnswer(200, json::object())
                                 : errorAnswer(404, "unknown", "no application asks by that number any more");
  response.note = "deny application " + call.value(0);
  return response;
}

WebResponse getAudit(SiteCall& call) {
  json rows = json::array();
  for (const AuditRow& row : call.parts.store.audit(kMostAuditRows))
    rows.push_back({{"utc_s", row.time_s},
                    {"who", row.who},
                    {"from", row.from},
                    {"what", row.what},
                    {"result", row.result}});
  const auto bad = call.parts.store.firstBadAudit();
  return jsonAnswer(200, {{"rows", rows}, {"first_bad_row", bad ? json(*bad) : json(nullptr)}});
}

}  // namespace

std::vector<SiteRoute> pageRoutes() {
  using Body = RouteBody;
  constexpr HttpMethod kGet = HttpMethod::Get;
  constexpr HttpMethod kPost = HttpMethod::Post;
  constexpr HttpMethod kDelete = HttpMethod::Delete;
  return {
      {{kGet, "/", WebRight::None, Body::None}, getPage},
      {{kGet, "/page/{file}", WebRight::None, Body::None}, getFile},
      {{kGet, "/api/v1/session", WebRight::None, Body::None}, getSession},
      {{kPost, "/api/v1/session", WebRight::None, Body::Small}, openSession},
      {{kDelete, "/api/v1/session", WebRight::SeeState, Body::Small}, closeSession},
      {{kGet, "/api/v1/tokens", WebRight::Maintain, Body::None}, getTokens},
      {{kPost, "/api/v1/tokens", WebRight::Maintain, Body::Small}, addToken},
      {{kDelete, "/api/v1/tokens/{id}", WebRight::Maintain, Body::Small}, removeToken},
      {{kPost, "/api/v1/keys/{id}/allow", WebRight::Operate, Body::Small}, allowKey},
      {{kPost, "/api/v1/keys/{id}/deny", WebRight::Operate, Body::Small}, denyKey},
      {{kGet, "/api/v1/audit", WebRight::Maintain, Body::None}, getAudit},
  };
}

}  // namespace lamina
