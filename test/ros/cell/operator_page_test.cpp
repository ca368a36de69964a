// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The node operator_page before a cell that prints on an emulated machine: by its interface, and by a
// browser.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/image_encodings.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/journal/cell_journal.hpp"
#include "lamina/journal/execution_log.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "ros/loop/streamed_machine.hpp"
#include "ros/node_process.hpp"
#include "ros/ros_home.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"
#include "web/raw_client.hpp"

namespace lamina {
namespace {

using nlohmann::json;
using test::waitUntil;

/// A wall of some layers, as slicers mark them.
std::string wallProgram(int layers) {
  std::string text = "G90\nM83\n";
  for (int layer = 0; layer < layers; ++layer) {
    text += ";LAYER:" + std::to_string(layer) + "\nG1 Z" + std::to_string(0.2 * (layer + 1)) + " F6000\n";
    for (int i = 0; i < 40; ++i)
      text += "G1 X" + std::to_string(40 + (i % 2) * 60) + " Y" + std::to_string(40 + i) + " E1 F1500\n";
  }
  return text;
}

/// Further fields of the form of an upload.
using Fields = std::vector<std::pair<std::string, std::string>>;

/// The port of the page in a namespace, as its node reports it.
class PagePort {
 public:
  explicit PagePort(const std::string& space)
      : subscriber_(node_.subscribe(space + '/' + names::kPageAddress, 1, &PagePort::onAddress, this)) {}

  /// Waits for a page that is not that of the last call.
  std::uint16_t next() {
    EXPECT_TRUE(waitUntil([this] { return port_ != 0; }));
    return std::exchange(port_, std::uint16_t{0});
  }

 private:
  void onAddress(const std_msgs::StringConstPtr& address) {
    port_ = static_cast<std::uint16_t>(std::stoi(address->data.substr(address->data.rfind(':') + 1)));
  }

  ros::NodeHandle node_;
  std::uint16_t port_ = 0;
  ros::Subscriber subscriber_;
};

/// Machine, streamer, controller and page in a namespace of their own.
class CellWithPage {
 public:
  CellWithPage(const std::string& name, double speed_up, const std::vector<std::string>& page_parameters = {})
      : space_("/" + name), port_(test::inRosHome("page_" + name)), machine_(speed_up, port_) {
    startStreamer();
    controller = std::make_unique<test::NodeProcess>(
        LAMINA_CELL_NODE,
        std::vector<std::string>{"__ns:=" + space_, "_journal/folder:=" + folder.path() + "/cell",
                                 "_executor/patience_s:=20"});
    startPage(page_parameters);
  }

  void startStreamer() {
    streamer = std::make_unique<test::NodeProcess>(
        LAMINA_STREAMER_NODE,
        std::vector<std::string>{"__ns:=" + space_, "_port:=" + port_,
                                 "_stream/journal:=" + folder.path() + "/progress", "_stream/settle_s:=0.01",
                                 "_stream/probe_after_s:=0.3"});
  }

  void startPage(const std::vector<std::string>& parameters) {
    std::vector<std::string> arguments = {
        "__ns:=" + space_,      "_web/port:=0",         "_web/folder:=" + folder.path() + "/cell",
        "_cell/patience_s:=20", "_web/connections:=64", "_web/connections_of_address:=16"};
    arguments.insert(arguments.end(), parameters.begin(), parameters.end());
    page = std::make_unique<test::NodeProcess>(LAMINA_PAGE_NODE, arguments);
    web_port = address_.next();
    csrf_.clear();  // each start of the page has another
  }

  /// Asks, again where there were too many requests at a time.
  /// @return status and body
  std::pair<int, json> ask(const std::string& method, const std::string& target, const std::string& body = "",
                           const std::string& type = "application/json") {
    if (csrf_.empty()) csrf_ = askOnce("GET", "/api/v1/session", "", type).second.value("csrf", "");
    std::pair<int, json> answer = askOnce(method, target, body, type);
    EXPECT_TRUE(waitUntil([&] {
      if (answer.first == 429) answer = askOnce(method, target, body, type);
      return answer.first != 429;
    }));
    return answer;
  }
  std::pair<int, json> command(const std::string& command) {
    return ask("POST", "/api/v1/commands", json{{"command", command}}.dump());
  }
  /// Asks less often than the rate that one client has: what is asked for next must not be refused.
  json state() {
    ros::WallDuration(0.06).sleep();
    return ask("GET", "/api/v1/state").second;
  }
  bool reaches(const std::string& name) {
    return waitUntil([&] {
      const json now = state();
      return now.contains("unit") && now["unit"]["state"] == name;
    });
  }
  bool starts() {
    bool is_started = false;
    return waitUntil([&] {
      if (!is_started) ros::WallDuration(0.06).sleep();
      is_started = is_started || command("Start").first == 200;
      return is_started;
    });
  }
  std::pair<int, json> upload(const std::string& program, const std::string& name,
                              const Fields& fields = {}) {
    std::string form;
    for (const auto& [field, value] : fields)
      form += "--b\r\nContent-Disposition: form-data; name=\"" + field + "\"\r\n\r\n" + value + "\r\n";
    form += "--b\r\nContent-Disposition: form-data; name=\"file\"; filename=\"" + name + "\"\r\n\r\n" +
            program + "\r\n--b--\r\n";
    return ask("POST", "/api/v1/jobs", form, "multipart/form-data; boundary=b");
  }
  /// The body of what is no JSON.
  std::string text(const std::string& target) const {
    const test::RawClient client(web_port);
    client.send("GET " + target + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
    const std::string answer = client.answer();
    return answer.substr(std::min(answer.size(), answer.find("\r\n\r\n")));
  }
  /// The status of what the owner of a token asks for.
  int statusOfPost(const std::string& target, const std::string& body, const std::string& token) const {
    const test::RawClient client(web_port);
    client.send("POST " + target + " HTTP/1.1\r\nHost: localhost\r\nX-Api-Key: " + token +
                "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) +
                "\r\n\r\n" + body);
    return std::stoi(client.answer().substr(9, 3));
  }
  /// Starts a job of eight layers.
  void beginPart() {
    ASSERT_TRUE(reaches("Stopped"));
    ASSERT_EQ(upload(wallProgram(8), "wall.gcode").first, 201);
    ASSERT_EQ(ask("POST", "/api/v1/jobs/1/release").first, 200);
    ASSERT_EQ(command("Reset").first, 200);
    ASSERT_TRUE(reaches("Idle"));
    ASSERT_TRUE(starts());
  }
  const std::string& space() const { return space_; }

  ScratchFolder folder;
  std::uint16_t web_port = 0;

 private:
  std::pair<int, json> askOnce(const std::string& method, const std::string& target, const std::string& body,
                               const std::string& type) const {
    const test::RawClient client(web_port);
    client.send(method + ' ' + target + " HTTP/1.1\r\nHost: localhost\r\nX-CSRF-Token: " + csrf_ +
                "\r\nContent-Type: " + type + "\r\nContent-Length: " + std::to_string(body.size()) +
                "\r\n\r\n" + body);
    const std::string answer = client.answer();
    const std::size_t head = answer.find("\r\n\r\n");
    if (head == std::string::npos) return {0, {}};
    return {std::stoi(answer.substr(9, 3)), json::parse(answer.substr(head + 4), nullptr, false)};
  }

  std::string space_;
  std::string port_;
  std::string csrf_;
  PagePort address_{space_};
  test::StreamedMachine machine_;

 public:
  std::unique_ptr<test::NodeProcess> streamer;
  std::unique_ptr<test::NodeProcess> controller;
  std::unique_ptr<test::NodeProcess> page;
};

TEST(OperatorPage, IsLaunchedAndSaysThatTheCellIsNotThere) {
  PagePort port("/launched");
  const test::RawClient client(port.next());
  client.send("GET /api/v1/state HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_NE(client.answer().find(R"("is_fresh":false)"), std::string::npos);
}

/// A box as a mesh of ASCII STL, of so many millimetres in x, and 10 mm in y and z.
std::string boxMesh(double length_mm) {
  const std::array<std::array<int, 4>, 6> sides = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  const auto vertex = [length_mm](int corner) {
    return "vertex " + std::to_string((corner & 1) != 0 ? length_mm : 0.0) +
           ((corner & 2) != 0 ? " 10" : " 0") + ((corner & 4) != 0 ? " 10\n" : " 0\n");
  };
  std::string text = "solid box\n";
  for (const auto& side : sides)
    for (const auto& [b, c] : {std::pair(1, 2), std::pair(2, 3)})
      text += "facet normal 0 0 0\nouter loop\n" + vertex(side[0]) +
              vertex(side[static_cast<std::size_t>(b)]) + vertex(side[static_cast<std::size_t>(c)]) +
              "endloop\nendfacet\n";
  return text + "endsolid box\n";
}

/// Bytes of all files that a cell has kept, one after the other.
std::string keptBytes(const std::string& folder) {
  std::string bytes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    bytes += std::string{std::istreambuf_iterator<char>(file), {}};
  }
  return bytes;
}

// slicing_service is launched in this namespace.
TEST(OperatorPage, SlicesAMeshAndQueuesItsProgramWithTheMesh) {
  CellWithPage cell("meshes", 100.0);
  ASSERT_TRUE(cell.reaches("Stopped"));
  ASSERT_TRUE(waitUntil([&] { return ros::service::exists(cell.space() + "/slice_mesh", false); }));
  bool is_published = false;
  ros::NodeHandle node;
  const boost::function<void(const lamina_msgs::ToolpathConstPtr&)> on_toolpath = [&](const auto&) {
    is_published = true;
  };
  const ros::Subscriber toolpaths =
      node.subscribe<lamina_msgs::Toolpath>(cell.space() + '/' + names::kToolpath, 1, on_toolpath);
  const auto [status, sent] = cell.upload(boxMesh(20.0), "box.stl",
                                          {{"material", "pla"}, {"settings", "slicing.layer_height_mm=0.5"}});
  ASSERT_EQ(status, 201) << sent;
  json queue;
  ASSERT_TRUE(waitUntil([&] {
    queue = cell.state().value("queue", json::array());
    return queue.size() == 1;
  }));
  EXPECT_EQ(queue[0]["name"], "box.gcode");
  EXPECT_EQ(queue[0]["state"], "NotAllowedToStart");
  const std::string kept = keptBytes(cell.folder.path() + "/cell/artefacts");
  EXPECT_NE(kept.find("endsolid box"), std::string::npos) << "the mesh is not kept";
  EXPECT_NE(kept.find("slicing.layer_height_mm = 0.5"), std::string::npos) << "its settings do not count";
  EXPECT_FALSE(is_published) << "nodes that follow a print would take it for that of the print";

  const auto expectRefused = [&](const std::string& mesh, const Fields& fields, const std::string& word) {
    const auto [code, answer] = cell.upload(mesh, "box.stl", fields);
    EXPECT_EQ(code, 400) << answer;
    EXPECT_NE(answer.value("message", "").find(word), std::string::npos) << answer;
    EXPECT_EQ(answer.value("message", "").find("/uploads/"), std::string::npos) << answer;
  };
  expectRefused("solid box\nendsolid box\n", {}, "box.stl");
  expectRefused(boxMesh(1000.0), {}, "reach");
  expectRefused(boxMesh(20.0), {{"material", "cheese"}}, "there is no material 'cheese'");
  expectRefused(boxMesh(20.0), {{"settings", "slicing.layer_hight_mm=0.5"}}, "slicing.layer_height_mm");
  EXPECT_EQ(cell.state()["queue"].size(), 1U);
  const std::filesystem::directory_iterator uploads(cell.folder.path() + "/cell/uploads");
  EXPECT_TRUE(uploads == std::filesystem::directory_iterator()) << uploads->path();
}

TEST(OperatorPage, PrintsWhatWasUploadedAndShowsHowFarItIs) {
  CellWithPage cell("uploads", 100.0);
  ASSERT_TRUE(cell.reaches("Stopped"));
  EXPECT_EQ(cell.upload("G1 X99999 Y0 E1 F6000\n", "far.gcode").first, 400);
  const auto [status, sent] = cell.upload(wallProgram(20), "wall.gcode");
  ASSERT_EQ(status, 201) << sent;
  const std::string job = std::to_string(sent["job"].get<int>());
  EXPECT_EQ(cell.command("Reset").first, 200);
  ASSERT_TRUE(cell.reaches("Idle"));
  const auto refused = cell.command("Start");
  EXPECT_EQ(refused.first, 409);
  EXPECT_EQ(refused.second["code"], "guard_failed");
  EXPECT_EQ(cell.ask("POST", "/api/v1/jobs/" + job + "/release").first, 200);
  EXPECT_EQ(cell.ask("POST", "/api/v1/jobs/" + job + "/release").first, 409) << "once";
  ASSERT_TRUE(cell.starts());
  ASSERT_TRUE(cell.reaches("Execute"));
  EXPECT_TRUE(waitUntil([&] { return cell.state()["progress"]["layer"].get<int>() > 2; }));
  std::pair<int, json> preview;
  EXPECT_TRUE(waitUntil([&] {
    preview = cell.ask("GET", "/api/v1/preview/2");
    return preview.first != 202;
  }));
  ASSERT_EQ(preview.first, 200) << preview.second;
  EXPECT_EQ(preview.second["layers"], 20);
  EXPECT_NEAR(preview.second["z_m"].get<double>(), 0.0006, 1e-9);
  EXPECT_EQ(preview.second["lines"][0].size(), 82U) << "40 lines from one to the next";
  EXPECT_EQ(cell.ask("GET", "/api/v1/preview/20").first, 404);
  EXPECT_EQ(cell.command("Hold").first, 200);
  ASSERT_TRUE(cell.reaches("Held"));
  EXPECT_EQ(cell.ask("POST", "/api/v1/alarms/1001/acknowledge").first, 200);
  EXPECT_EQ(cell.ask("POST", "/api/v1/alarms/9999/acknowledge").first, 400);
  EXPECT_EQ(cell.command("Unhold").first, 200);
  ASSERT_TRUE(cell.reaches("Execute"));
  EXPECT_EQ(cell.command("Stop").first, 200);
  ASSERT_TRUE(cell.reaches("Stopped"));
  EXPECT_EQ(cell.ask("POST", "/api/v1/mode", R"({"mode":2})").first, 200);
  EXPECT_TRUE(waitUntil([&] { return cell.state()["unit"]["mode"] == "Maintenance"; }));
  const bool is_part_on_plate = cell.state()["unit"]["is_part_on_plate"];
  EXPECT_EQ(cell.ask("POST", "/api/v1/removal").first, is_part_on_plate ? 200 : 409);
}

TEST(OperatorPage, GoesOnWhereItWasWhenItIsKilledAndReportsWhenTheCellIsSilent) {
  CellWithPage cell("killed", 20.0);
  ASSERT_TRUE(cell.reaches("Stopped"));
  ASSERT_EQ(cell.upload(wallProgram(3), "wall.gcode").first, 201);
  EXPECT_EQ(cell.page->end(SIGKILL), -1);
  cell.startPage({"_auth/loopback:=token"});
  EXPECT_EQ(cell.ask("GET", "/api/v1/state").first, 401);
  EXPECT_EQ(cell.page->end(SIGINT), 0);
  cell.startPage({"_auth/loopback:=none"});  // parameters outlive a node
  EXPECT_TRUE(waitUntil([&] { return cell.state().value("queue", json::array()).size() == 1; }));
  EXPECT_EQ(cell.controller->end(SIGKILL), -1);
  EXPECT_TRUE(waitUntil([&] { return cell.state()["is_fresh"] == false; }));
  EXPECT_EQ(cell.command("Hold").first, 503);
}

TEST(OperatorPage, ShowsMeasuredLayersAndPicturesOfTheCamera) {
  CellWithPage cell("measured", 20.0, {"_camera/topic:=eye", "_web/largest_upload_mb:=1"});
  ros::NodeHandle node(cell.space());
  auto layers = node.advertise<lamina_msgs::LayerHeight>(names::kLayerHeight, 1, true);
  auto loop = node.advertise<lamina_msgs::LoopState>(names::kLoopState, 1, true);
  auto deviation = node.advertise<sensor_msgs::Image>(names::kHeightDeviation, 1, true);
  auto raw = node.advertise<sensor_msgs::Image>("eye", 1, true);
  lamina_msgs::LayerHeight layer;
  layer.layer = 4;
  layer.mean_error = 2e-5;
  layer.coverage = 0.75;
  layers.publish(layer);
  lamina_msgs::LoopState state;
  state.state_name = "COASTING";
  state.reason = "no sight";
  loop.publish(state);
  sensor_msgs::Image map;
  map.encoding = sensor_msgs::image_encodings::TYPE_32FC1;
  map.width = 2;
  map.height = 1;
  map.step = 8;
  const std::array<float, 2> errors = {1e-4F, std::nanf("")};
  map.data.resize(8);
  std::memcpy(map.data.data(), errors.data(), 8);
  deviation.publish(map);
  sensor_msgs::Image picture;
  picture.encoding = sensor_msgs::image_encodings::BGR8;
  picture.width = picture.height = 16;
  picture.step = 48;
  picture.data.resize(768, 90);
  EXPECT_TRUE(waitUntil([&] {
    raw.publish(picture);
    const json now = cell.state();
    return now.contains("layers") && now["layers"].size() == 1 && now["deviation_number"] == 1 &&
           now["has_camera"] == true && now["loop"].is_object();
  }));
  EXPECT_EQ(cell.ask("GET", "/api/v1/loop").second["reason"], "no sight");
  EXPECT_EQ(cell.ask("GET", "/api/v1/layers").second["layers"][0]["coverage"], 0.75);
  const json shown = cell.ask("GET", "/api/v1/deviation").second;
  EXPECT_NEAR(shown["errors_m"][0].get<double>(), 1e-4, 1e-9);
  EXPECT_TRUE(shown["errors_m"][1].is_null());
  const test::RawClient viewer(cell.web_port);
  viewer.send("GET /api/v1/camera HTTP/1.1\r\nHost: localhost\r\n\r\n");
  const std::string pictures = viewer.until("\xff\xd9");
  EXPECT_NE(pictures.find("\xff\xd8"), std::string::npos) << "a JPEG file, from start to end: " << pictures;
  EXPECT_EQ(cell.upload(std::string(2 << 20, ';'), "large.gcode").first, 413);
}

/// A token of anna, made by the command; empty if it made none.
std::string tokenOf(const CellWithPage& cell, const std::string& role) {
  FILE* command = popen((std::string(LAMINA_TOKEN_COMMAND) + " token add --role " + role + " --name anna " +
                         cell.folder.path() + "/cell 2>/dev/null")
                            .c_str(),
                        "r");
  std::array<char, 128> line{};
  EXPECT_NE(std::fgets(line.data(), line.size(), command), nullptr);
  EXPECT_EQ(pclose(command), 0);
  return {line.data(), std::strcspn(line.data(), "\n")};
}

TEST(OperatorPage, TakesTokensThatTheCommandHasMade) {
  CellWithPage cell(
      "tokens", 20.0,
      {"_auth/loopback:=token", "_api/octoprint_print:=release", "_web/hosts:=cell.example.org"});
  const std::string token = tokenOf(cell, "operator");
  const std::string form =
      "--b\r\nContent-Disposition: form-data; name=\"print\"\r\n\r\ntrue\r\n--b\r\n"
      "Content-Disposition: form-data; name=\"file\"; filename=\"sent.gcode\"\r\n\r\n" +
      wallProgram(2) + "\r\n--b--\r\n";
  EXPECT_TRUE(
      waitUntil([&] { return ros::service::exists(cell.space() + '/' + names::kEnqueueJob, false); }));
  const test::RawClient slicer(cell.web_port);
  slicer.send("POST /api/files/local HTTP/1.1\r\nHost: cell.example.org\r\nX-Api-Key: " + token +
              "\r\nContent-Type: multipart/form-data; boundary=b\r\nContent-Length: " +
              std::to_string(form.size()) + "\r\n\r\n" + form);
  const std::string answer = slicer.answer();
  EXPECT_NE(answer.find("\"is_released\":true"), std::string::npos) << answer;
}

lamina_msgs::LayerHeight scanOf(const std::string& toolpath, double mean_error) {
  lamina_msgs::LayerHeight scan;
  scan.toolpath_id = toolpath;
  scan.mean_error = mean_error;
  return scan;
}

/// A scan of a layer comes after the end, and joins the record if it is of what was measured before.
TEST(OperatorPage, ShowsALayerThatIsMeasuredAfterTheEnd) {
  CellWithPage cell("scanned", 20.0);
  ros::NodeHandle node(cell.space());
  auto scans = node.advertise<lamina_msgs::LayerHeight>(names::kLayerHeight, 10);
  cell.beginPart();
  ASSERT_EQ(cell.command("Hold").first, 200);
  ASSERT_TRUE(cell.reaches("Held"));
  EXPECT_TRUE(waitUntil([&] {
    scans.publish(scanOf("wall", 1.25e-4));
    CellJournal journal = CellJournal::read(cell.folder.path() + "/cell/cell.db");
    const auto layers = ExecutionLog(journal).layers(1);
    return std::any_of(layers.begin(), layers.end(),
                       [](const LayerRow& layer) { return layer.mean_mm == 0.125; });
  }));
  ASSERT_EQ(cell.command("Unhold").first, 200);
  ASSERT_TRUE(cell.reaches("Complete"));
  const auto has = [&](const char* error) {
    ros::WallDuration(0.06).sleep();
    return cell.text("/api/v1/jobs/1/layers").find(error) != std::string::npos;
  };
  EXPECT_TRUE(has(",0.125,"));
  EXPECT_TRUE(waitUntil([&] {
    scans.publish(scanOf("another", 5e-4));
    scans.publish(scanOf("wall", 3.75e-4));
    return has(",0.375,");
  }));
  EXPECT_FALSE(has(",0.5,")) << "of another toolpath";
  EXPECT_EQ(std::system((std::string(LAMINA_COMMAND) + " audit " + cell.folder.path() + "/cell").c_str()), 0);
}

/// Why a verdict is refused that a node gives; empty if it is not.
std::string refusalOfVerdict(const CellWithPage& cell, const std::string& verdict,
                             const std::string& source) {
  lamina_msgs::JudgePart call;
  call.request.verdict = verdict;
  call.request.source = source;
  EXPECT_TRUE(callService(cell.space() + '/' + names::kJudgePart, call));
  return call.response.status.message;
}

TEST(OperatorPage, TakesTheVerdictOfWhoMayJudge) {
  CellWithPage cell("judged", 100.0);
  ASSERT_TRUE(cell.reaches("Stopped"));
  const std::string target = "/api/v1/jobs/1/verdict";
  const std::string scrap = R"({"verdict":"scrap","reason":"a hole"})";
  EXPECT_EQ(refusalOfVerdict(cell, "good", "anna"), "no part was made yet");
  cell.beginPart();
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_EQ(cell.statusOfPost(target, scrap, tokenOf(cell, "viewer")), 403);
  EXPECT_NE(refusalOfVerdict(cell, "good", "").find("nobody is named"), std::string::npos);
  EXPECT_NE(refusalOfVerdict(cell, "fine", "anna").find("expected good, scrap or rework"), std::string::npos);
  EXPECT_EQ(cell.ask("GET", "/api/v1/records").second["records"][0]["verdict"], "good");
  EXPECT_EQ(cell.ask("POST", target, scrap).first, 200);
  const json record = json::parse(cell.text("/api/v1/jobs/1/record"), nullptr, false);
  ASSERT_TRUE(record.is_object());
  EXPECT_EQ(record["verdict"]["value"], "scrap");
  EXPECT_EQ(record["verdict"]["before"], "good");
  EXPECT_EQ(record["verdict"]["reason"], "a hole");
  EXPECT_EQ(refusalOfVerdict(cell, "rework", "anna"), "");
  // Who, and with which words, in the audit of the cell.
  const std::string rows =
      "import sqlite3, sys; print(sqlite3.connect(sys.argv[1]).execute("
      "\"SELECT who, result FROM audit WHERE what LIKE ?\", (\"verdict%\",)).fetchall())";
  const std::string kept = cell.folder.path() + "/rows";
  EXPECT_EQ(
      std::system(
          ("/usr/bin/python3 -c '" + rows + "' " + cell.folder.path() + "/cell/cell.db > " + kept).c_str()),
      0);
  EXPECT_EQ(readFile(kept),
            "[('page: this host', 'scrap, was good: a hole'), ('anna', 'rework, was scrap')]\n");
}

TEST(OperatorPage, IsServedByHttpsWithACertificateOfItsOwnAndNotBeyondThisHostWithout) {
  const ScratchFolder folder;
  test::NodeProcess open(LAMINA_PAGE_NODE, {"__ns:=/open", "_web/bind:=0.0.0.0", "_web/port:=0",
                                            "_web/folder:=" + folder.path() + "/open"});
  EXPECT_EQ(open.wait(), 1) << "refused";
  test::NodeProcess half(LAMINA_PAGE_NODE,
                         {"__ns:=/half", "_web/tls:=true", "_web/port:=0", "_web/certificate:=x",
                          "_web/folder:=" + folder.path() + "/half"});
  EXPECT_EQ(half.wait(), 1) << "a certificate without web.key, which would be _web/key:=";
  PagePort encrypted_port("/encrypted");
  const test::NodeProcess encrypted(
      LAMINA_PAGE_NODE, {"__ns:=/encrypted", "_web/tls:=true", "_web/allow_plain:=false",
                         "_web/bind:=127.0.0.1", "_web/port:=0", "_web/folder:=" + folder.path() + "/tls"});
  const std::string port = std::to_string(encrypted_port.next());
  EXPECT_EQ(
      std::system(("curl -s --cacert " + folder.path() +
                   "/tls/page_certificate.pem https://localhost:" + port + "/api/version | grep -q OctoPrint")
                      .c_str()),
      0);
}

bool hasBrowser() {
  return std::system(
             "test -x /usr/bin/chromium && test -x /usr/bin/chromedriver && /usr/bin/python3 -c 'import "
             "selenium'") == 0;
}
constexpr char kNoBrowser[] =
    "Chromium, its driver or python3-selenium is not installed (tools/install-dependencies --checks)";

/// A job whose streamer was killed, by the steps that the page shows; test/ros/cell/operator_page_resume.py
/// says what is done.
TEST(OperatorPage, WalksThroughAResume) {
  if (!hasBrowser()) GTEST_SKIP() << kNoBrowser;
  CellWithPage cell("resume", 20.0);
  ASSERT_TRUE(cell.reaches("Stopped"));
  ASSERT_EQ(cell.upload(wallProgram(400), "wall.gcode").first, 201);
  ASSERT_EQ(cell.ask("POST", "/api/v1/jobs/1/release").first, 200);
  ASSERT_EQ(cell.command("Reset").first, 200);
  ASSERT_TRUE(cell.reaches("Idle"));
  ASSERT_TRUE(cell.starts());
  ASSERT_TRUE(waitUntil([&] { return cell.state()["progress"]["lines_acknowledged"] > 100; }));
  EXPECT_EQ(cell.streamer->end(SIGKILL), -1);
  ASSERT_TRUE(cell.reaches("Aborted"));
  cell.startStreamer();
  EXPECT_EQ(std::system(("/usr/bin/python3 -B " LAMINA_SOURCE_DIR
                         "/test/ros/cell/operator_page_resume.py http://localhost:" +
                         std::to_string(cell.web_port) + "/ " + cell.folder.path())
                            .c_str()),
            0);
  const std::string audit = cell.ask("GET", "/api/v1/audit").second.dump();
  EXPECT_NE(audit.find("Start; confirmed: part, ready, way"), std::string::npos) << audit;
}

/// By keyboard alone, in a browser that nobody sees; test/ros/cell/operator_page_browser.py says what is
/// done.
TEST(OperatorPage, IsOperatedByKeyboardAlone) {
  if (!hasBrowser()) GTEST_SKIP() << kNoBrowser;
  CellWithPage cell("browser", 20.0);
  ASSERT_TRUE(cell.reaches("Stopped"));
  const std::string program = cell.folder.path() + "/wall.gcode";
  std::ofstream(program) << wallProgram(400);
  EXPECT_EQ(std::system(("/usr/bin/python3 -B " LAMINA_SOURCE_DIR
                         "/test/ros/cell/operator_page_browser.py http://localhost:" +
                         std::to_string(cell.web_port) + "/ " + program + ' ' + cell.folder.path() + ' ' +
                         std::to_string(cell.page->id()))
                            .c_str()),
            0);
}

}  // namespace
}  // namespace lamina
