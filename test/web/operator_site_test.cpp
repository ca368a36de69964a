// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/operator_site.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <thread>

#include "web/site_of_fakes.hpp"

namespace lamina::test {
namespace {

constexpr std::array kEveryRole = {WebRole::Viewer, WebRole::Sender, WebRole::Operator, WebRole::Maintenance};

/// A pattern with something in its places.
std::string pathOf(const RouteRow& row) {
  std::string path;
  for (std::size_t at = 0; at < row.pattern.size();) {
    if (row.pattern[at] != '{') {
      path += row.pattern[at++];
      continue;
    }
    path += '1';
    at = row.pattern.find('}', at) + 1;
  }
  return path;
}

Headers headersFor(const RouteRow& row) {
  if (row.body != RouteBody::Upload) return {};
  return {{"content-type", "multipart/form-data; boundary=b"}};
}

std::string nameOf(HttpMethod method) {
  return method == HttpMethod::Get ? "GET" : method == HttpMethod::Post ? "POST" : "DELETE";
}

/// What the specification's table of roles says, written down once more.
bool isAllowed(WebRole role, WebRight right) {
  switch (role) {
    case WebRole::Viewer:
      return right <= WebRight::SeeAll;
    case WebRole::Sender:
      return right <= WebRight::SeeState || right == WebRight::Upload;
    case WebRole::Operator:
      return right != WebRight::Maintain;
    case WebRole::Maintenance:
      return true;
  }
  return false;
}

TEST(OperatorSite, RefusesEveryRouteToWhoeverShowsNoTokenAndSaysSoInTheAudit) {
  SiteOfFakes site(closedLoopback());
  for (const RouteRow& row : OperatorSite::routes()) {
    if (row.right == WebRight::None) continue;
    const WebResponse response = site.ask(row.method, pathOf(row), headersFor(row));
    EXPECT_EQ(response.status, 401) << row.pattern;
    EXPECT_NE(site.lastAudit().find(nameOf(row.method) + ' ' + pathOf(row)), std::string::npos)
        << row.pattern;
  }
  EXPECT_TRUE(site.desk.orders().empty());
  EXPECT_EQ(site.store.firstBadAudit(), std::nullopt);
}

TEST(OperatorSite, AdmitsEachRoleToItsRoutesAndToNoOther) {
  SiteOfFakes site(closedLoopback());
  site.peer = {"192.168.1.9", false, true};
  for (const WebRole role : kEveryRole) {
    const std::string token = site.add(role, toString(role));
    for (const RouteRow& row : OperatorSite::routes()) {
      if (row.right == WebRight::None) continue;
      Headers headers = headersFor(row);
      headers["x-api-key"] = token;
      headers["host"] = "localhost";
      const std::size_t before = site.desk.orders().size();
      const WebResponse response = site.ask(row.method, pathOf(row), headers, "{}");
      if (isAllowed(role, row.right)) {
        EXPECT_NE(response.status, 401) << toString(role) << ' ' << row.pattern;
        EXPECT_NE(response.status, 403) << toString(role) << ' ' << row.pattern;
      } else {
        EXPECT_EQ(response.status, 403) << toString(role) << ' ' << row.pattern;
        EXPECT_EQ(site.desk.orders().size(), before);
        EXPECT_NE(site.lastAudit().find(std::string(toString(role)) + " | "), std::string::npos);
        EXPECT_NE(site.lastAudit().find("refused 403"), std::string::npos);
      }
    }
  }
}

TEST(OperatorSite, RefusesWhatBrowsersAreMadeToSend) {
  SiteOfFakes site;
  const Headers page = {{"x-csrf-token", site.get("/api/v1/session")["csrf"]}};
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", page, R"({"command":"Hold"})").status, 200);
  for (const RouteRow& row : OperatorSite::routes()) {
    Headers foreign = page;
    foreign["host"] = "printer.example.org";
    EXPECT_EQ(site.ask(row.method, pathOf(row), foreign).status, 403) << row.pattern << ": host";
    EXPECT_EQ(site.ask(row.method, pathOf(row) + "?apikey=1", page).status, 403) << row.pattern << ": key";
    if (row.method == HttpMethod::Get && row.body != RouteBody::Socket) continue;
    Headers other = page;
    if (row.body == RouteBody::Socket) other["upgrade"] = "websocket";
    other["origin"] = "https://example.org";
    EXPECT_EQ(site.ask(row.method, pathOf(row), other).status, 403) << row.pattern << ": origin";
    other["origin"] = "null";
    EXPECT_EQ(site.ask(row.method, pathOf(row), other).status, 403) << row.pattern << ": no origin";
    other.erase("origin");
    other["sec-fetch-site"] = "cross-site";
    EXPECT_EQ(site.ask(row.method, pathOf(row), other).status, 403) << row.pattern << ": site";
    const bool needs_csrf = row.method != HttpMethod::Get && row.right != WebRight::None;
    if (!needs_csrf) continue;
    EXPECT_EQ(site.ask(row.method, pathOf(row), {{"origin", "http://127.0.0.1:8080"}}).status, 403)
        << row.pattern << ": CSRF";
  }
  EXPECT_EQ(site.desk.orders().size(), 1U);
}

TEST(OperatorSite, KnowsWhoHasLoggedInUntilTheTokenIsGone) {
  SiteOfFakes site(closedLoopback());
  const std::string token = site.add(WebRole::Operator, "anna");
  EXPECT_EQ(site.get("/api/v1/session")["is_known"], false);
  const WebResponse opened =
      site.ask(HttpMethod::Post, "/api/v1/session", {}, R"({"token":")" + token + "\"}");
  ASSERT_EQ(opened.status, 201);
  const std::string cookie = opened.headers.at(0).second;
  EXPECT_NE(cookie.find("; HttpOnly; SameSite=Strict; Max-Age=43200"), std::string::npos) << cookie;
  const std::string csrf = nlohmann::json::parse(opened.body)["csrf"];
  Headers headers = {{"cookie", cookie.substr(0, cookie.find(';'))}, {"x-csrf-token", csrf}};
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", headers, R"({"command":"Stop"})").status, 200);
  EXPECT_EQ(site.desk.orders().back(), "Stop by page: anna");
  EXPECT_EQ(site.lastAudit(), "anna | POST /api/v1/commands: Stop | done 200");
  headers["x-csrf-token"] = csrf.substr(1) + "0";
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", headers, R"({"command":"Stop"})").status, 403);
  EXPECT_TRUE(site.store.remove(site.store.tokens().at(0).id));
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/state", headers).status, 401);
}

TEST(OperatorSite, EndsAPageWhoseTokenIsWithdrawnAlsoWhereNoneIsNeeded) {
  SiteOfFakes site;  // a bench, on which whoever shows no token may do everything
  const std::string token = site.add(WebRole::Viewer, "wall");
  const WebResponse opened =
      site.ask(HttpMethod::Post, "/api/v1/session", {}, R"({"token":")" + token + "\"}");
  const std::string cookie = opened.headers.at(0).second;
  Headers headers = {{"cookie", cookie.substr(0, cookie.find(';'))},
                     {"x-csrf-token", nlohmann::json::parse(opened.body)["csrf"]}};
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/state", headers).status, 200);
  ASSERT_TRUE(site.store.remove(site.store.tokens().at(0).id));
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/state", headers).status, 401);
  const WebResponse session = site.ask(HttpMethod::Get, "/api/v1/session", headers);
  EXPECT_EQ(nlohmann::json::parse(session.body)["is_known"], false);
  ASSERT_FALSE(session.headers.empty());
  EXPECT_NE(session.headers.back().second.find("Max-Age=0"), std::string::npos) << "then it may begin anew";
  headers["x-csrf-token"] = site.get("/api/v1/session")["csrf"];
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", headers, R"({"command":"Start"})").status, 401);
  EXPECT_TRUE(site.desk.orders().empty());
}

TEST(OperatorSite, DoesNothingForATokenThatIsWithdrawnWhileTheRequestComes) {
  SiteOfFakes site(closedLoopback());
  WebRequest request;
  request.head.method = HttpMethod::Post;
  request.head.target = "/api/v1/commands";
  request.head.headers = {{"host", "127.0.0.1:8080"}, {"x-api-key", site.add(WebRole::Operator, "anna")}};
  request.head.peer = site.peer;
  request.body = R"({"command":"Start"})";
  const auto admission = site.site.admit(request.head, site.now);
  const auto* admitted = std::get_if<OperatorSite::Admitted>(&admission);
  ASSERT_NE(admitted, nullptr);
  ASSERT_TRUE(site.store.remove(site.store.tokens().at(0).id));
  EXPECT_EQ(site.site.answer(*admitted, request, site.now).status, 401);
  EXPECT_TRUE(site.desk.orders().empty());
  EXPECT_NE(site.lastAudit().find("refused 401"), std::string::npos) << site.lastAudit();
}

TEST(OperatorSite, EndsSessionsAfterTwelveHours) {
  SiteOfFakes site(closedLoopback());
  const std::string token = site.add(WebRole::Viewer, "wall");
  const WebResponse opened =
      site.ask(HttpMethod::Post, "/api/v1/session", {}, R"({"token":")" + token + "\"}");
  const std::string cookie = opened.headers.at(0).second;
  const Headers headers = {{"cookie", cookie.substr(0, cookie.find(';'))}};
  site.now.steady_s += 12.0 * 3600.0 - 2.0;
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/state", headers).status, 200);
  site.now.steady_s += 1.0;
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/state", headers).status, 401);
}

TEST(OperatorSite, LocksAnAddressOutThatGuessesTokensButNoGoodTokenNorHold) {
  SiteOfFakes site(closedLoopback());
  const std::string token = site.add(WebRole::Operator, "anna");
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/state", {{"x-api-key", "guess"}}).status, 401);
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/state", {{"authorization", "Bearer guess"}}).status, 429);
  EXPECT_EQ(site.desk.orders().back().substr(0, 12), "report 9001:");
  EXPECT_EQ(
      site.ask(HttpMethod::Post, "/api/v1/commands", {{"x-api-key", token}}, R"({"command":"Hold"})").status,
      200);
  site.peer.address = "127.0.0.2";
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/state", {{"x-api-key", "guess"}}).status, 401);
  site.peer.address = "127.0.0.1";
  site.now.steady_s += 60.0;
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/state", {{"x-api-key", "guess"}}).status, 401);
}

/// Rows of the audit of 130 requests in 32.5 s, from somebody that is not identified.
std::size_t rowsOfFlood(const std::string& target, const std::string& body,
                        const SiteSettings& settings = closedLoopback()) {
  SiteOfFakes site(settings);
  for (int i = 0; i < 130; ++i) {
    site.now.steady_s -= 0.75;  // of the second that each takes
    site.ask(HttpMethod::Post, target, {}, body);
  }
  return site.store.audit(1000).size();
}

TEST(OperatorSite, WritesRefusalsOfWhatAnybodyMayAskAtMostOnceASecond) {
  // 60 at once, and one more for each whole second of 129 quarters of a second
  constexpr std::size_t kMost = 60 + 32;
  EXPECT_EQ(rowsOfFlood("/api/printer/command", R"({"command":"G28"})"), kMost);
  EXPECT_EQ(rowsOfFlood("/api/printer/command", R"({"command":"G28"})", {}), kMost)
      << "a program on this host, which needs no token";
  EXPECT_EQ(rowsOfFlood("/api/v1/session", R"({"token":"guess"})"), kMost);
  EXPECT_EQ(rowsOfFlood("/plugin/appkeys/request", "no object"), kMost);
}

TEST(OperatorSite, WritesEachRefusalOfWhatSomebodyHasTheRightTo) {
  SiteOfFakes site(closedLoopback());
  const Headers key = {{"x-api-key", site.add(WebRole::Operator, "anna")}};
  site.desk.next = {DeskAnswer::Outcome::Refused, 2, "Start in Held is not accepted", 0};
  for (int i = 0; i < 100; ++i) {
    site.now.steady_s -= 0.75;
    EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", key, R"({"command":"Start"})").status, 409);
  }
  EXPECT_EQ(site.store.audit(1000).size(), 100U);
}

TEST(OperatorSite, LimitsRequestsOfOneTokenButNotHold) {
  SiteOfFakes site(closedLoopback());
  const Headers key = {{"x-api-key", site.add(WebRole::Operator, "script")}};
  int refused = 0;
  for (int i = 0; i < 50; ++i) {
    site.now.steady_s -= 1.0;  // all in one instant
    refused += site.ask(HttpMethod::Get, "/api/v1/state", key).status == 429 ? 1 : 0;
  }
  EXPECT_EQ(refused, 10);
  site.now.steady_s -= 1.0;
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", key, R"({"command":"Hold"})").status, 200);
  site.now.steady_s += 1.0;
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/state", key).status, 200);
}

TEST(OperatorSite, LetsViewersOnThisHostHoldAndDoNothingElse) {
  SiteOfFakes site(closedLoopback());
  const Headers viewer = {{"x-api-key", site.add(WebRole::Viewer, "wall")}};
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", viewer, R"({"command":"Hold"})").status, 200);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", viewer, R"({"command":"Stop"})").status, 403);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/job", viewer, R"({"command":"cancel"})").status, 403);
  Headers proxied = viewer;
  proxied["x-forwarded-for"] = "10.0.0.1";
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", proxied, R"({"command":"Hold"})").status, 403);
  site.peer = {"192.168.1.9", false, true};
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", viewer, R"({"command":"Hold"})").status, 403);
  EXPECT_EQ(site.desk.orders(), std::vector<std::string>{"Hold by page: wall"});
}

TEST(OperatorSite, AnswersWhatTheCellRefusesWithTheReasonAndWhatItWouldAccept) {
  SiteOfFakes site;
  const Headers page = {{"x-csrf-token", site.get("/api/v1/session")["csrf"]}};
  site.desk.next = {DeskAnswer::Outcome::Refused, 10, "meant for another state", 0};
  const WebResponse stale = site.ask(HttpMethod::Post, "/api/v1/commands", page,
                                     R"({"command":"Start","if_sequence":12,"cut_off":"resume"})");
  EXPECT_EQ(stale.status, 409);
  EXPECT_EQ(
      stale.body,
      R"({"accepted_now":["Start","Stop","Abort"],"code":"stale_sequence","message":"meant for another state"})");
  EXPECT_EQ(site.desk.orders().back(), "Start by page: this host at 12 cut_off 1");
  EXPECT_EQ(site.lastAudit(),
            "this host | POST /api/v1/commands: Start | refused 409: meant for another state");
  site.ask(HttpMethod::Post, "/api/v1/commands", page,
           R"({"command":"Start","cut_off":"resume","confirmed":["part","way"]})");
  EXPECT_EQ(site.desk.orders().back(), "Start by page: this host cut_off 1 confirmed part, way");
  EXPECT_EQ(site.lastAudit(),
            "this host | POST /api/v1/commands: Start; confirmed: part, way | refused 409: meant for another "
            "state");
  site.ask(HttpMethod::Post, "/api/v1/commands", page,
           R"({"command":"Start","cut_off":"resume","confirmed":["place"],"confirmed_begin_mm":12.5})");
  EXPECT_EQ(site.desk.orders().back(), "Start by page: this host cut_off 1 confirmed place from 12.5");
  EXPECT_NE(site.lastAudit().find("confirmed: place, from 12.5 mm |"), std::string::npos);
  site.desk.next = {DeskAnswer::Outcome::Silent, 0, "no answer", 0};
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/3/release", page).status, 503);
  EXPECT_EQ(site.desk.orders().back(), "change 0 of 3 by page: this host");
}

TEST(OperatorSite, PassesOnWhatAPersonSaysOfAPart) {
  SiteOfFakes site;
  const Headers page = {{"x-csrf-token", site.get("/api/v1/session")["csrf"]}};
  EXPECT_EQ(
      site.ask(HttpMethod::Post, "/api/v1/jobs/12/verdict", page, R"({"verdict":"scrap","reason":"a hole"})")
          .status,
      200);
  EXPECT_EQ(site.desk.orders().back(), "verdict of 12: scrap by page: this host, a hole");
  EXPECT_EQ(site.lastAudit(), "this host | POST /api/v1/jobs/12/verdict: job 12 is scrap | done 200");
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/12/verdict", page, R"({"verdict":"aborted"})").status,
            400);
}

TEST(OperatorSite, RefusesBadBodiesAsAWhole) {
  SiteOfFakes site;
  const Headers page = {{"x-csrf-token", site.get("/api/v1/session")["csrf"]}};
  for (const char* body :
       {"", "[]", "{", R"({"command":3})", R"({"command":"Fly"})", R"({"command":"Start","if_sequence":-1})",
        R"({"command":"Start","if_sequence":1.5})", R"({"command":"Start","cut_off":"both"})",
        R"({"command":"Start","confirmed":"part"})", R"({"command":"Start","confirmed":[1]})",
        R"({"command":"Start","confirmed":["a name of seventeen"]})",
        R"({"command":"Start","confirmed_begin_mm":"12"})", R"({"command":"Start","confirmed_begin_mm":-1})"})
    EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", page, body).status, 400) << body;
  for (const char* path : {"/api/v1/jobs/x/release", "/api/v1/jobs/-1/release",
                           "/api/v1/jobs/99999999999999999/move", "/api/v1/alarms/70000/acknowledge"})
    EXPECT_EQ(site.ask(HttpMethod::Post, path, page).status, 400) << path;
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/mode", page, R"({"mode":0})").status, 400);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/loop", page, R"({"request":"maybe"})").status, 400);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/startup", page, R"({"command":"jump"})").status, 400);
  EXPECT_TRUE(site.desk.orders().empty());
}

TEST(OperatorSite, MovesByHandWithoutARowOfTheAuditForEachStep) {
  SiteOfFakes site;
  const Headers page = {{"x-csrf-token", site.get("/api/v1/session")["csrf"]}};
  const auto post = [&](const char* body) {
    return site.ask(HttpMethod::Post, "/api/v1/manual", page, body);
  };
  EXPECT_TRUE(site.get("/api/v1/state")["manual"].is_null());
  site.desk.next.lease = 17;
  EXPECT_EQ(nlohmann::json::parse(post(R"({"request":"take"})").body)["lease"], 17);
  EXPECT_EQ(site.desk.orders().back(), "by hand 0 lease 0 by page: this host   0 0");
  const std::string taken = "this host | POST /api/v1/manual: by hand: take | done 200";
  EXPECT_EQ(site.lastAudit(), taken);
  const char* step =
      R"({"request":"step","lease":17,"frame":"nozzle","axis":"z","step":-0.001,"speed":0.005})";
  EXPECT_EQ(post(step).status, 200);
  EXPECT_EQ(site.desk.orders().back(), "by hand 1 lease 17 by page: this host nozzle z -0.001 0.005");
  EXPECT_EQ(site.lastAudit(), taken);
  const std::size_t given = site.desk.orders().size();
  for (const char* body :
       {R"({"request":"fly"})", R"({"request":"step","lease":17,"frame":"bed","axis":"x"})",
        R"({"request":"take","lease":-1})"})
    EXPECT_EQ(post(body).status, 400) << body;
  EXPECT_EQ(site.desk.orders().size(), given);
  site.desk.next = {DeskAnswer::Outcome::Refused, 7, "'page: ben' moves the machine by hand", 0};
  EXPECT_EQ(post(step).status, 409);
  EXPECT_NE(site.lastAudit().find("refused 409: 'page: ben'"), std::string::npos) << site.lastAudit();
  site.desk.seen.manual =
      ShownManual{"page: ben", 7.0, true, 0.5, "joint_1 is near its limit", {{"joint_1", false}}};
  const nlohmann::json manual = site.get("/api/v1/state")["manual"];
  EXPECT_EQ(manual["holder"], "page: ben");
  EXPECT_EQ(manual["joints"][0]["name"], "joint_1");
  const std::string anna = site.add(WebRole::Operator, "anna");
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/manual", {{"x-api-key", anna}}, step).status, 403);
}

TEST(OperatorSite, RefusesAddressesThatAreNoPlainPaths) {
  SiteOfFakes site;
  for (const char* path : {"/page/../cell.db", "/page/%2e%2e", "/page/%2E%2e/x", "/page/a%00b", "/page/a%2fb",
                           "/page/a%5cb", "/page//x", "page/x", "/page/%zz", "/page/%4", "*", "/page/a\tb"})
    EXPECT_EQ(site.ask(HttpMethod::Get, path, {}).status, 400) << path;
  EXPECT_EQ(site.ask(HttpMethod::Get, "/page/other.html", {}).status, 404);
  EXPECT_EQ(site.ask(HttpMethod::Get, "/page/index.html", {}).body, "<p>page</p>");
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/state", {}).status, 405);
  EXPECT_EQ(site.ask(HttpMethod::Other, "/api/v1/state", {}).status, 405);
}

TEST(OperatorSite, GivesTheSameAnswerToARepeatedRequestForADay) {
  SiteOfFakes site;
  Headers page = {{"x-csrf-token", site.get("/api/v1/session")["csrf"]}, {"idempotency-key", "k1"}};
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/3/release", page).status, 200);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/3/release", page).status, 200);
  EXPECT_EQ(site.desk.orders().size(), 1U);
  site.now.utc_s += 86400.0;
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/3/release", page).status, 200);
  EXPECT_EQ(site.desk.orders().size(), 2U);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", page, R"({"command":"Hold"})").status, 200);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/commands", page, R"({"command":"Hold"})").status, 200);
  EXPECT_EQ(site.desk.orders().size(), 4U);
}

TEST(OperatorSite, RefusesAKeyThatWasShownWithAnotherRequest) {
  SiteOfFakes site;
  const Headers page = {{"x-csrf-token", site.get("/api/v1/session")["csrf"]}, {"idempotency-key", "k1"}};
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/5/release", page).status, 200);
  const WebResponse other = site.ask(HttpMethod::Post, "/api/v1/jobs/6/release", page);
  EXPECT_EQ(other.status, 409);
  EXPECT_EQ(nlohmann::json::parse(other.body)["code"], "other_request");
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/5/release", page, R"({"more":1})").status, 409);
  EXPECT_EQ(site.ask(HttpMethod::Delete, "/api/v1/jobs/5", page).status, 409);
  EXPECT_EQ(site.desk.orders().size(), 1U);
}

TEST(OperatorSite, DoesNotRunARequestAgainThatWasCutOff) {
  SiteOfFakes site;
  const Headers page = {{"x-csrf-token", site.get("/api/v1/session")["csrf"]}, {"idempotency-key", "k1"}};
  site.desk.next = {DeskAnswer::Outcome::Silent, 0, "nothing was asked of it", 0};
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/5/release", page).status, 503);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/5/release", page).status, 503) << "asked again";
  EXPECT_EQ(site.desk.orders().size(), 2U);
  site.desk.next = {DeskAnswer::Outcome::Unsure, 0, "it may still do what was asked", 0};
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/5/release", page).status, 504);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/5/release", page).status, 504) << "reported again";
  EXPECT_EQ(site.desk.orders().size(), 3U);
  // As a page leaves it that is killed between the deed and its answer.
  EXPECT_FALSE(site.store.begin("0 k2", "its digest", site.now.utc_s));
  Headers other = page;
  other["idempotency-key"] = "k2";
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/5/release", other).status, 409);
  EXPECT_EQ(site.desk.orders().size(), 3U);
}

TEST(OperatorSite, RunsARequestOnceHoweverManyRepeatItAtATime) {
  SiteOfFakes site;
  const std::string csrf = site.get("/api/v1/session")["csrf"];
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    WebRequest request;
    request.head.method = HttpMethod::Post;
    request.head.target = "/api/v1/jobs/5/release";
    request.head.headers = {
        {"host", "localhost"}, {"x-csrf-token", csrf}, {"idempotency-key", "r" + std::to_string(round)}};
    request.head.peer = site.peer;
    site.now.steady_s += 10.0;
    auto admission = site.site.admit(request.head, site.now);
    ASSERT_TRUE(std::holds_alternative<OperatorSite::Admitted>(admission));
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
      threads.emplace_back([&] {
        const int status =
            site.site.answer(std::get<OperatorSite::Admitted>(admission), request, site.now).status;
        EXPECT_TRUE(status == 200 || status == 409) << status;
      });
    for (std::thread& thread : threads) thread.join();
  }
  EXPECT_EQ(site.desk.orders().size(), static_cast<std::size_t>(kRounds));
}

TEST(OperatorSite, RefusesNumbersOfJobsThatMessagesDoNotCarry) {
  SiteOfFakes site;
  const Headers page = {{"x-csrf-token", site.get("/api/v1/session")["csrf"]}};
  for (const char* word : {"release", "revoke", "move"})
    EXPECT_EQ(site.ask(HttpMethod::Post, std::string("/api/v1/jobs/4294967297/") + word, page).status, 400);
  EXPECT_EQ(site.ask(HttpMethod::Delete, "/api/v1/jobs/4294967296", page).status, 400);
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/jobs/4294967296", page).status, 400);
  EXPECT_TRUE(site.desk.orders().empty());
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/jobs/4294967295/release", page).status, 200);
}

TEST(OperatorSite, MovesJobsToThePlaceThatTheBodyNames) {
  SiteOfFakes site;
  const Headers page = {{"x-csrf-token", site.get("/api/v1/session")["csrf"]}};
  const auto move = [&](const std::string& body) {
    return site.ask(HttpMethod::Post, "/api/v1/jobs/12/move", page, body).status;
  };
  EXPECT_EQ(move(""), 200);
  EXPECT_EQ(move(R"({"place": 3})"), 200);
  EXPECT_EQ(site.desk.orders(), (std::vector<std::string>{"change 2 of 12 by page: this host",
                                                          "move 12 to 3 by page: this host"}));
  for (const char* wrong : {R"({"place": 0})", R"({"place": -1})", R"({"place": 1.5})", R"({"place": "2"})",
                            R"({"place": 99999999999999999999})"})
    EXPECT_EQ(move(wrong), 400) << wrong;
  EXPECT_EQ(site.desk.orders().size(), 2U);
}

TEST(OperatorSite, GivesSendersTheStateOnly) {
  SiteOfFakes site(closedLoopback());
  site.desk.seen.queue.push_back({3, "part.gcode", "", "", "", JobState::AllowedToStart, "anna", "anna"});
  const auto of_sender = site.get("/api/v1/state", site.add(WebRole::Sender, "slicer"));
  EXPECT_EQ(of_sender["unit"]["state"], "Idle");
  EXPECT_EQ(of_sender["is_fresh"], true);
  EXPECT_FALSE(of_sender.contains("queue"));
  const auto of_viewer = site.get("/api/v1/state", site.add(WebRole::Viewer, "wall"));
  EXPECT_EQ(of_viewer["queue"][0]["state"], "AllowedToStart");
  EXPECT_TRUE(of_viewer["loop"].is_null());
  site.site.observe(site.now);
  EXPECT_FALSE(site.site.live(WebRole::Viewer).text) << "nobody hears it";
  const StateBell::Ear ear(site.site.bell());
  site.site.observe(site.now);
  EXPECT_EQ(site.site.live(WebRole::Sender).text->find("queue"), std::string::npos);
  EXPECT_NE(site.site.live(WebRole::Viewer).text->find("queue"), std::string::npos);
}

TEST(OperatorSite, ReportsThatTheCellHasGoneSilent) {
  SiteOfFakes site;
  const StateBell::Ear ear(site.site.bell());
  site.desk.seen.heard_s = site.now.steady_s;
  site.site.observe({site.now.steady_s + 3.0, site.now.utc_s});
  EXPECT_NE(site.site.live(WebRole::Viewer).text->find(R"("is_fresh":true)"), std::string::npos);
  site.site.observe({site.now.steady_s + 3.5, site.now.utc_s});
  EXPECT_NE(site.site.live(WebRole::Viewer).text->find(R"("is_fresh":false)"), std::string::npos);
}

TEST(OperatorSite, ReportsThatAProgramIsBeingReadWithoutWaitingForIt) {
  SiteOfFakes site;
  site.desk.shown_layer = LayerPreview{};
  site.desk.is_being_read = true;
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/preview/0", {}).status, 202);
  EXPECT_EQ(site.get("/api/v1/preview/0")["is_being_read"], true);
  site.desk.is_being_read = false;
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/preview/0", {}).status, 200);
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/preview/1", {}).status, 404);
}

TEST(OperatorSite, SwitchesTheAccessOfThePlcForMaintenanceAlone) {
  SiteOfFakes site(closedLoopback());
  const Headers keeper = {{"x-api-key", site.add(WebRole::Maintenance, "mia")}};
  const Headers anna = {{"x-api-key", site.add(WebRole::Operator, "anna")}};
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/remote", anna, R"({"allowed": true})").status, 403);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/remote", keeper, R"({"allowed": 1})").status, 400);
  EXPECT_TRUE(site.desk.orders().empty());
  EXPECT_LT(site.ask(HttpMethod::Post, "/api/v1/remote", keeper, R"({"allowed": true})").status, 300);
  EXPECT_LT(site.ask(HttpMethod::Post, "/api/v1/remote", keeper, R"({"allowed": false})").status, 300);
  EXPECT_EQ(site.desk.orders(),
            (std::vector<std::string>{"PLC allowed by page: mia", "PLC locked by page: mia"}));
  site.desk.seen.unit.plc_access = PlcAccess::Allowed;
  EXPECT_EQ(
      nlohmann::json::parse(site.ask(HttpMethod::Get, "/api/v1/state", keeper).body)["unit"]["takes_plc"],
      true);
}

constexpr std::uint64_t kGibibyte = std::uint64_t{1} << 30;

TEST(OperatorSite, PromisesRoomOnTheDiskToAllUploadsTogetherAndToTheirCopies) {
  SiteSettings settings;
  settings.free_bytes = [](const std::string&) { return kGibibyte + 5000; };
  SiteOfFakes site(settings);
  WebRequest upload;
  upload.head.method = HttpMethod::Post;
  upload.head.target = "/api/files/local";
  upload.head.headers = {
      {"host", "localhost"}, {"content-type", "multipart/form-data; boundary=b"}, {"content-length", "1300"}};
  upload.head.peer = site.peer;
  const auto statusOf = [](const std::variant<OperatorSite::Admitted, WebResponse>& admission) {
    const auto* refused = std::get_if<WebResponse>(&admission);
    return refused == nullptr ? 0 : refused->status;
  };
  {
    const auto first = site.site.admit(upload.head, site.now);
    EXPECT_EQ(statusOf(first), 0) << "2600 bytes of 5000";
    EXPECT_EQ(statusOf(site.site.admit(upload.head, site.now)), 507) << "2600 of the 2400 that are left";
  }
  EXPECT_EQ(statusOf(site.site.admit(upload.head, site.now)), 0) << "the first has ended";
  upload.head.headers.erase("content-length");
  upload.head.headers["transfer-encoding"] = "chunked";
  EXPECT_EQ(statusOf(site.site.admit(upload.head, site.now)), 411);
}

TEST(OperatorSite, MakesAndRemovesTokens) {
  SiteOfFakes site;
  const Headers page = {{"x-csrf-token", site.get("/api/v1/session")["csrf"]}};
  const WebResponse made =
      site.ask(HttpMethod::Post, "/api/v1/tokens", page, R"({"name":"anna","role":"operator","days":2})");
  ASSERT_EQ(made.status, 201);
  const std::string token = nlohmann::json::parse(made.body)["token"];
  EXPECT_EQ(token.size(), 64U);
  EXPECT_EQ(site.lastAudit(), "this host | POST /api/v1/tokens: add token 'anna' as operator | done 201");
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/tokens", page, R"({"name":"anna","role":"viewer"})").status,
            400);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/tokens", page, R"({"name":"","role":"viewer"})").status, 400);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/tokens", page, R"({"name":"b","role":"king"})").status, 400);
  EXPECT_EQ(site.get("/api/v1/session", token)["role"], "operator");
  Headers keyed = page;
  keyed["idempotency-key"] = "t1";
  const std::string asked = R"({"name":"c","role":"viewer"})";
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/tokens", keyed, asked).status, 201);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/tokens", keyed, asked).status, 400)
      << "a token is shown once, and its answer is not kept";
  EXPECT_EQ(site.ask(HttpMethod::Delete, "/api/v1/tokens/2", page).status, 200);
  site.now.utc_s += 2.0 * 86400.0;
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/v1/state", {{"x-api-key", token}}).status, 401);
  EXPECT_EQ(site.ask(HttpMethod::Delete, "/api/v1/tokens/1", page).status, 200);
  EXPECT_EQ(site.ask(HttpMethod::Delete, "/api/v1/tokens/1", page).status, 404);
  EXPECT_TRUE(site.get("/api/v1/tokens")["tokens"].empty());
  EXPECT_TRUE(site.get("/api/v1/audit")["first_bad_row"].is_null());
}

TEST(OperatorSite, SpeaksOfEachRouteInItsDocumentation) {
  std::ifstream file(std::string(LAMINA_SOURCE_DIR) + "/docs/cell/operator-page.md");
  std::stringstream text;
  text << file.rdbuf();
  for (const RouteRow& row : OperatorSite::routes())
    EXPECT_NE(
        text.str().find("| `" + nameOf(row.method) + ' ' + row.pattern + "` | " + toString(row.right) + " |"),
        std::string::npos)
        << "docs/cell/operator-page.md lacks: | `" << nameOf(row.method) << ' ' << row.pattern << "` | "
        << toString(row.right) << " |";
}

}  // namespace
}  // namespace lamina::test
