// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What slicers ask for, without sockets; their requests as bytes are in web_server_test.
#include <gtest/gtest.h>

#include "web/site_of_fakes.hpp"

namespace lamina::test {
namespace {

TEST(OctoPrint, SaysThatItIsOne) {
  SiteOfFakes site;
  const auto version = site.get("/api/version");
  EXPECT_EQ(version["text"].get<std::string>().rfind("OctoPrint (Lamina ", 0), 0U);
  EXPECT_EQ(version["api"], "0.1");
  EXPECT_EQ(site.get("/api/settings")["feature"]["sdSupport"], false);
  EXPECT_EQ(site.get("/api/printerprofiles")["profiles"]["_default"]["current"], true);
  EXPECT_EQ(site.get("/api/currentuser")["name"], "this host");
  EXPECT_EQ(site.get("/api/server")["version"], "1.5.0");
}

TEST(OctoPrint, MapsStatesOfTheUnit) {
  SiteOfFakes site;
  const std::vector<std::pair<UnitState, std::string>> expected = {
      {UnitState::Execute, "Printing"},    {UnitState::Held, "Paused"},
      {UnitState::Suspended, "Paused"},    {UnitState::Idle, "Operational"},
      {UnitState::Stopped, "Operational"}, {UnitState::Complete, "Operational"},
      {UnitState::Aborted, "Error"},       {UnitState::Starting, "Printing"},
      {UnitState::Completing, "Printing"}, {UnitState::Stopping, "Cancelling"},
      {UnitState::Aborting, "Cancelling"}};
  for (const auto& [state, text] : expected) {
    site.desk.seen.unit.state = state;
    const auto printer = site.get("/api/printer");
    EXPECT_EQ(printer["state"]["text"], text) << toString(state);
    EXPECT_EQ(printer["state"]["flags"]["printing"], text == "Printing" || text == "Cancelling");
    EXPECT_EQ(site.get("/api/job")["state"], text);
  }
}

TEST(OctoPrint, QueuesWhatIsSentAndReleasesItOnlyIfAskedTo) {
  SiteOfFakes site(closedLoopback());
  const std::string path = site.folder.path() + "/sent";
  writeFile(path, "G1 X1\n");
  site.upload = {path, "part.gcode", 6, "abc", {{"print", "true"}}};
  const std::map<std::string, std::string> sender = {{"x-api-key", site.add(WebRole::Sender, "slicer")},
                                                     {"content-type", "multipart/form-data; boundary=b"}};
  const WebResponse response = site.ask(HttpMethod::Post, "/api/files/local", sender);
  EXPECT_EQ(response.status, 201) << response.body;
  const auto body = nlohmann::json::parse(response.body);
  EXPECT_EQ(body["done"], true);
  EXPECT_EQ(body["files"]["local"]["name"], "part.gcode");
  EXPECT_EQ(site.desk.uploaded, "G1 X1\n");
  EXPECT_EQ(site.desk.orders(), std::vector<std::string>{"enqueue part.gcode by octoprint: slicer"});
}

TEST(OctoPrint, ReleasesForOperatorsWhereThatIsAllowed) {
  SiteSettings settings = closedLoopback();
  settings.upload_print = UploadPrint::Release;
  SiteOfFakes site(settings);
  const std::string path = site.folder.path() + "/sent";
  writeFile(path, "G1 X1\n");
  site.upload = {path, "part.gcode", 6, "abc", {{"print", "true"}}};
  const auto headers = [&](WebRole role) {
    return std::map<std::string, std::string>{{"x-api-key", site.add(role, toString(role))},
                                              {"content-type", "multipart/form-data; boundary=b"}};
  };
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/files/local", headers(WebRole::Sender)).status, 201);
  EXPECT_EQ(site.desk.orders().size(), 1U) << "a sender releases nothing";
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/files/local", headers(WebRole::Operator)).status, 201);
  EXPECT_EQ(site.desk.orders().back(), "change 0 of 7 by octoprint: operator");
}

// pyoctoprintapi, by which Home Assistant speaks, takes the printer's number from here and fails without it.
TEST(OctoPrint, HasANumberThatIsItsOwnAndStays) {
  const auto numberOf = [](const std::string& identity) {
    SiteSettings settings;
    settings.identity = identity;
    return SiteOfFakes(settings).get("/api/settings")["plugins"]["discovery"]["upnpUuid"].get<std::string>();
  };
  const std::string number = numberOf("cell 1");
  ASSERT_EQ(number.size(), 36U) << number;
  for (const std::size_t at : {8U, 13U, 18U, 23U}) EXPECT_EQ(number[at], '-') << number;
  EXPECT_EQ(number[14], '8') << "version of the UUID";
  EXPECT_EQ(number[19], 'a') << "variant";
  EXPECT_EQ(numberOf("cell 1"), number);
  EXPECT_NE(numberOf("cell 2"), number);
}

// https://docs.octoprint.org/en/1.11.2/api/connection.html
TEST(OctoPrint, SaysThatItIsConnectedAndConnectsNothing) {
  SiteOfFakes site(closedLoopback());
  const std::string token = site.add(WebRole::Operator, "o");
  const auto connection = site.get("/api/connection", token);
  EXPECT_EQ(connection["current"]["state"], "Operational");
  EXPECT_EQ(connection["current"]["printerProfile"], "_default");
  EXPECT_TRUE(connection["options"]["ports"].is_array());
  EXPECT_EQ(connection["options"]["printerProfiles"][0]["id"], "_default");
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/connection", {{"x-api-key", token}}, R"({"command":"connect"})")
                .status,
            403);
  EXPECT_TRUE(site.desk.orders().empty());
}

TEST(OctoPrint, LeavesOutOfThePrinterWhatIsNotAskedFor) {
  SiteOfFakes site;
  const auto whole = site.get("/api/printer");
  EXPECT_EQ(whole["sd"]["ready"], false);
  EXPECT_EQ(whole.size(), 3U);
  const auto state = site.get("/api/printer?exclude=temperature,sd");
  EXPECT_EQ(state["state"]["text"], "Operational");
  EXPECT_EQ(state.size(), 1U);
}

TEST(OctoPrint, SaysWhichWayAJobGoes) {
  SiteOfFakes site;
  site.desk.seen.unit.state = UnitState::Unholding;
  EXPECT_EQ(site.get("/api/printer")["state"]["flags"]["resuming"], true);
  EXPECT_EQ(site.get("/api/printer")["state"]["flags"]["finishing"], false);
  site.desk.seen.unit.state = UnitState::Completing;
  EXPECT_EQ(site.get("/api/printer")["state"]["flags"]["finishing"], true);
  EXPECT_EQ(site.get("/api/printer")["state"]["flags"]["resuming"], false);
}

TEST(OctoPrint, ListsTheQueueAsFilesForWhoMaySeeIt) {
  SiteOfFakes site(closedLoopback());
  ShownJob job;
  job.name = "h\xc3\xa4lfte 2.gcode";
  site.desk.seen.queue = {job};
  const std::string token = site.add(WebRole::Viewer, "v");
  const std::string place = "/api/files/local/h%C3%A4lfte%202.gcode";
  for (const char* path : {"/api/files", "/api/files/local", "/api/files?recursive=true"}) {
    const auto files = site.get(path, token)["files"];
    ASSERT_EQ(files.size(), 1U) << path;
    EXPECT_EQ(files[0]["display"], job.name);
    EXPECT_EQ(files[0]["refs"]["resource"], place);
  }
  EXPECT_EQ(site.get(place, token)["path"], job.name);
  EXPECT_EQ(site.ask(HttpMethod::Get, "/api/files/local/none.gcode", {{"x-api-key", token}}).status, 404);
  const std::string sender = site.add(WebRole::Sender, "s");
  EXPECT_TRUE(site.get("/api/files/local", sender)["files"].empty());
  EXPECT_EQ(site.ask(HttpMethod::Get, place, {{"x-api-key", sender}}).status, 404);
}

std::string headerOf(const WebResponse& response, const std::string& name) {
  for (const auto& [key, value] : response.headers)
    if (key == name) return value;
  return "";
}

// Cura's plug-in takes what follows "api/" of Location, and selects that where it was told to queue.
TEST(OctoPrint, SaysWhereASentFileIsAndLetsItBeSelected) {
  SiteOfFakes site(closedLoopback());
  const std::string path = site.folder.path() + "/sent";
  writeFile(path, "G1 X1\n");
  site.upload = {path, "CE3_h\xc3\xa4lfte 2.gcode", 6, "abc", {}};
  std::map<std::string, std::string> sender = {{"x-api-key", site.add(WebRole::Sender, "slicer")},
                                               {"content-type", "multipart/form-data; boundary=b"}};
  const WebResponse sent = site.ask(HttpMethod::Post, "/api/files/local", sender);
  ASSERT_EQ(sent.status, 201) << sent.body;
  const std::string place = headerOf(sent, "Location");
  EXPECT_EQ(place, "/api/files/local/CE3_h%C3%A4lfte%202.gcode");
  EXPECT_EQ(nlohmann::json::parse(sent.body)["files"]["local"]["refs"]["resource"], place);
  sender["content-type"] = "application/json";
  EXPECT_EQ(site.ask(HttpMethod::Post, place, sender, R"({"command":"select"})").status, 204);
  EXPECT_EQ(site.ask(HttpMethod::Post, place, sender, R"({"command":"select","print":true})").status, 409);
  EXPECT_EQ(site.ask(HttpMethod::Post, place, sender, R"({"command":"slice"})").status, 400);
  EXPECT_EQ(site.desk.orders().size(), 1U) << "nothing but the upload";
}

TEST(OctoPrint, GivesNoTemperatureThatIsNoLongerReported) {
  SiteOfFakes site;
  site.desk.seen.machine.nozzle_degc = 210.0;
  site.desk.seen.machine.nozzle_target_degc = 215.0;
  site.desk.seen.machine_heard_s = site.now.steady_s;
  EXPECT_EQ(site.get("/api/printer")["temperature"]["tool0"]["actual"], 210.0);
  EXPECT_EQ(site.get("/api/printer")["temperature"]["tool0"]["target"], 215.0);
  EXPECT_TRUE(site.get("/api/printer")["temperature"]["bed"]["target"].is_null());
  site.now.steady_s += 10.0;
  EXPECT_TRUE(site.get("/api/printer")["temperature"]["tool0"]["target"].is_null());
  EXPECT_TRUE(site.get("/api/printer")["temperature"]["tool0"]["actual"].is_null());
  const std::string metrics = site.ask(HttpMethod::Get, "/api/v1/metrics", {}).body;
  EXPECT_EQ(metrics.find("lamina_nozzle_celsius"), std::string::npos) << metrics;
}

TEST(OctoPrint, SaysHowFarAJobIs) {
  SiteOfFakes site;
  EXPECT_TRUE(site.get("/api/job")["progress"]["printTime"].is_null());
  site.desk.seen.unit.job = ShownJob{};
  site.desk.seen.unit.fraction = 0.25;
  site.desk.seen.unit.elapsed_s = 90.4;
  const auto progress = site.get("/api/job")["progress"];
  EXPECT_EQ(progress["printTime"], 90.0);
  EXPECT_EQ(progress["completion"], 25.0);
  site.desk.seen.unit.elapsed_s = -5.0;  // a clock that was set back
  EXPECT_EQ(site.get("/api/job")["progress"]["printTime"], 0.0);
}

// https://docs.octoprint.org/en/1.11.2/api/datamodel.html#job-information: what is there in any case.
TEST(OctoPrint, HasEachFieldOfAJob) {
  SiteOfFakes site;
  const auto none = site.get("/api/job");
  for (const char* field : {"name", "display", "path", "origin", "size", "date"}) {
    ASSERT_TRUE(none["job"]["file"].contains(field)) << field;
    EXPECT_TRUE(none["job"]["file"][field].is_null()) << field;
  }
  for (const char* field : {"completion", "filepos", "printTime", "printTimeLeft", "printTimeLeftOrigin"})
    EXPECT_TRUE(none["progress"].contains(field)) << field;
  for (const char* field : {"estimatedPrintTime", "lastPrintTime", "filament"})
    EXPECT_TRUE(none["job"].contains(field)) << field;
  site.desk.seen.unit.job = ShownJob{};
  site.desk.seen.unit.job->name = "part.gcode";
  const auto file = site.get("/api/job")["job"]["file"];
  EXPECT_EQ(file["display"], "part.gcode");
  EXPECT_EQ(file["origin"], "local");
}

TEST(OctoPrint, GoesOnFromWhatItWasPausedFor) {
  SiteOfFakes site(closedLoopback());
  const std::map<std::string, std::string> key = {{"x-api-key", site.add(WebRole::Operator, "o")}};
  for (const UnitState state : {UnitState::Suspended, UnitState::Held}) {
    site.desk.seen.unit.state = state;
    for (const char* action : {"resume", "toggle"})
      EXPECT_EQ(site.ask(HttpMethod::Post, "/api/job", key,
                         std::string(R"({"command":"pause","action":")") + action + "\"}")
                    .status,
                204);
  }
  EXPECT_EQ(site.desk.orders(),
            (std::vector<std::string>{"Unsuspend by octoprint: o", "Unsuspend by octoprint: o",
                                      "Unhold by octoprint: o", "Unhold by octoprint: o"}));
}

TEST(OctoPrint, RefusesWhatCannotBePrintedAndWhatIsBeingPrinted) {
  SiteOfFakes site;
  const std::string path = site.folder.path() + "/sent";
  writeFile(path, "G1 Xa\n");
  site.upload = {path, "part.gcode", 6, "abc", {}};
  const std::map<std::string, std::string> headers = {{"content-type", "multipart/form-data; boundary=b"}};
  site.desk.next = {DeskAnswer::Outcome::BadInput, 13, "line 1: X has no number", 0};
  const WebResponse refused = site.ask(HttpMethod::Post, "/api/files/local", headers);
  EXPECT_EQ(refused.status, 400);
  EXPECT_NE(refused.body.find("line 1: X has no number"), std::string::npos);
  site.desk.seen.unit.state = UnitState::Execute;
  site.desk.seen.unit.job = ShownJob{};
  site.desk.seen.unit.job->name = "part.gcode";
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/files/local", headers).status, 409);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/files/local", {{"content-type", "text/plain"}}).status, 415);
  EXPECT_EQ(
      site.ask(HttpMethod::Post, "/api/files/local",
               {{"content-type", "multipart/form-data; boundary=b"}, {"content-length", "1099511627776"}})
          .status,
      413);
}

TEST(OctoPrint, CommandsTheUnitAndTakesNoGcodeEver) {
  SiteOfFakes site(closedLoopback());
  const std::map<std::string, std::string> key = {{"x-api-key", site.add(WebRole::Maintenance, "m")}};
  site.desk.seen.unit.state = UnitState::Execute;
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/job", key, R"({"command":"pause","action":"pause"})").status,
            204);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/job", key, R"({"command":"pause","action":"resume"})").status,
            204);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/job", key, R"({"command":"pause"})").status, 204);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/job", key, R"({"command":"cancel"})").status, 204);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/job", key, R"({"command":"start"})").status, 204);
  EXPECT_EQ(site.desk.orders(), (std::vector<std::string>{"Hold by octoprint: m", "Unhold by octoprint: m",
                                                          "Hold by octoprint: m", "Stop by octoprint: m",
                                                          "Start by octoprint: m"}));
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/printer/command", key, R"({"command":"M104 S300"})").status,
            403);
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/printer/command", {}, R"({"command":"M112"})").status, 403);
  EXPECT_EQ(site.desk.orders().size(), 5U);
}

TEST(OctoPrint, GivesAnApplicationATokenOnceSomebodyAllowsIt) {
  SiteOfFakes site(closedLoopback());
  const std::map<std::string, std::string> anna = {{"x-api-key", site.add(WebRole::Operator, "anna")}};
  EXPECT_EQ(site.ask(HttpMethod::Get, "/plugin/appkeys/probe", {}).status, 204);
  const WebResponse asked = site.ask(HttpMethod::Post, "/plugin/appkeys/request", {}, R"({"app":"Cura"})");
  ASSERT_EQ(asked.status, 201);
  const std::string place = asked.headers.at(0).second;
  EXPECT_EQ(site.ask(HttpMethod::Get, place, {}).status, 202);
  const auto requests =
      nlohmann::json::parse(site.ask(HttpMethod::Get, "/api/v1/state", anna).body)["key_requests"];
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0]["application"], "Cura");
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/keys/1/allow", anna).status, 200);
  const WebResponse given = site.ask(HttpMethod::Get, place, {});
  ASSERT_EQ(given.status, 200);
  const std::string key = nlohmann::json::parse(given.body)["api_key"];
  EXPECT_EQ(site.get("/api/v1/session", key)["role"], "sender");
  EXPECT_EQ(site.ask(HttpMethod::Get, place, {}).status, 404) << "a key is shown once";
  const WebResponse second = site.ask(HttpMethod::Post, "/plugin/appkeys/request", {}, R"({"app":"Other"})");
  EXPECT_EQ(site.ask(HttpMethod::Post, "/api/v1/keys/2/deny", anna).status, 200);
  EXPECT_EQ(site.ask(HttpMethod::Get, second.headers.at(0).second, {}).status, 404);
  for (int i = 0; i < 8; ++i) site.ask(HttpMethod::Post, "/plugin/appkeys/request", {}, R"({"app":"Many"})");
  EXPECT_EQ(site.ask(HttpMethod::Post, "/plugin/appkeys/request", {}, R"({"app":"Many"})").status, 429);
}

}  // namespace
}  // namespace lamina::test
