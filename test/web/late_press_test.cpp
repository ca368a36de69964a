// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Orders that were held up on their way, with the time at which they were pressed.
#include <gtest/gtest.h>

#include "web/site_of_fakes.hpp"

namespace lamina::test {
namespace {

/// A page on this host that has seen a state, and whose link then breaks.
class HeldUpPage {
 public:
  HeldUpPage() : csrf_(site.get("/api/v1/session")["csrf"]), seen_s_(site.get("/api/v1/state")["clock_s"]) {}

  /// Posts what was pressed with that state; it arrives some seconds after that.
  WebResponse post(const std::string& target, const std::string& body, double after_s) {
    site.now.steady_s = seen_s_ + after_s - 1.0;  // of which one goes by while it is asked
    return site.ask(HttpMethod::Post, target,
                    {{"x-csrf-token", csrf_}, {"x-pressed-at", std::to_string(seen_s_)}}, body);
  }
  WebResponse command(const std::string& name, double after_s) {
    return post("/api/v1/commands", R"({"command":")" + name + R"("})", after_s);
  }

  SiteOfFakes site;

 private:
  std::string csrf_;
  double seen_s_;
};

TEST(LatePress, LetsNothingMoveThatWasPressedLongAgo) {
  HeldUpPage page;
  const WebResponse late = page.command("Unhold", 40.0);
  EXPECT_EQ(late.status, 409);
  EXPECT_EQ(
      late.body,
      R"({"code":"too_late","message":"Unhold came 40 s after it was pressed; expected at most 5 s; nothing was done"})");
  for (const char* name : {"Start", "Reset", "Unsuspend", "Clear", "Complete"})
    EXPECT_EQ(page.command(name, 5.5).status, 409) << name;
  EXPECT_EQ(page.post("/api/v1/startup", R"({"command":"run"})", 5.5).status, 409);
  EXPECT_EQ(page.post("/api/v1/startup", R"({"command":"confirm","step":"plate"})", 5.5).status, 409);
  EXPECT_EQ(page.post("/api/v1/loop", R"({"request":"active"})", 5.5).status, 409);
  // A queue that goes on by itself starts the next part.
  EXPECT_EQ(page.post("/api/v1/jobs/3/release", "{}", 5.5).status, 409);
  EXPECT_EQ(page.post("/api/v1/removal", "{}", 5.5).status, 409);
  EXPECT_EQ(page.post("/api/v1/loop", R"({"request":"active"})", 5.5).status, 409);
  EXPECT_TRUE(page.site.desk.orders().empty());
  EXPECT_EQ(page.site.lastAudit(),
            "this host | POST /api/v1/loop: loop active | refused 409: loop active came 5.5 s after it was "
            "pressed; expected at most 5 s; nothing was done");
}

TEST(LatePress, TakesWhatWasPressedJustNowAndWhatStopsAtAnyTime) {
  HeldUpPage page;
  EXPECT_EQ(page.command("Unhold", 4.5).status, 200);
  for (const char* name : {"Hold", "Suspend", "Stop", "Abort"})
    EXPECT_EQ(page.command(name, 400.0).status, 200) << name;
  EXPECT_EQ(page.post("/api/v1/startup", R"({"command":"abort"})", 400.0).status, 200);
  EXPECT_EQ(page.post("/api/v1/loop", R"({"request":"off"})", 400.0).status, 200);
  EXPECT_EQ(page.site.desk.orders().size(), 7U);
}

TEST(LatePress, TakesStepsByHandForHalfASecond) {
  HeldUpPage page;
  const std::string step =
      R"({"request":"step","lease":4,"frame":"bed","axis":"x","step":0.001,"speed":0.004})";
  EXPECT_EQ(page.post("/api/v1/manual", step, 0.45).status, 200);
  EXPECT_EQ(page.post("/api/v1/manual", step, 0.55).status, 409);
  EXPECT_EQ(page.site.desk.orders().size(), 1U);
  EXPECT_EQ(page.post("/api/v1/manual", R"({"request":"release","lease":4})", 40.0).status, 200);
}

TEST(LatePress, RefusesTimesOfAnotherStartOfTheHostAndWhatIsNoTime) {
  SiteOfFakes site;
  const std::string csrf = site.get("/api/v1/session")["csrf"];
  const auto statusWith = [&](Headers headers) {
    headers["x-csrf-token"] = csrf;
    return site.ask(HttpMethod::Post, "/api/v1/commands", headers, R"({"command":"Start"})").status;
  };
  EXPECT_EQ(statusWith({{"x-pressed-at", std::to_string(site.now.steady_s + 100.0)}}), 409);
  EXPECT_EQ(statusWith({{"x-pressed-at", "now"}}), 400);
  EXPECT_TRUE(site.desk.orders().empty());
  EXPECT_EQ(statusWith({}), 200) << "a program that does not say when";
}

TEST(LatePress, GoesByTheTimeAtWhichAStateWasWritten) {
  SiteOfFakes site;
  site.desk.seen.heard_s = 1000.0;
  const StateBell::Ear ear(site.site.bell());
  site.site.observe({1000.25, 5000.0});
  const auto first = site.site.live(WebRole::Viewer);
  EXPECT_EQ(nlohmann::json::parse(*first.text)["clock_s"], 1000.25);
  site.site.observe({1000.5, 5000.25});
  EXPECT_EQ(site.site.live(WebRole::Viewer).number, first.number) << "time alone is no news within a second";
  site.site.observe({1001.5, 5001.25});
  EXPECT_EQ(nlohmann::json::parse(*site.site.live(WebRole::Viewer).text)["clock_s"], 1001.5);
}

}  // namespace
}  // namespace lamina::test
