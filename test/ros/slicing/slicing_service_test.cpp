// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Calls the running node slicing_service as a client would.
#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "lamina/base/atomic_file.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "request_settings.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"
#include "support/scratch_folder.hpp"

namespace {

namespace fs = std::filesystem;
using lamina::settingMessage;
using lamina_msgs::SliceMesh;
using lamina_msgs::Status;
using Client = actionlib::SimpleActionClient<lamina_msgs::SliceAction>;

constexpr double kPatience = 240.0;  // s: far above what a job takes, for loaded machines

class SlicingService : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(client_.waitForExistence(ros::Duration(kPatience))); }

  SliceMesh::Response call(const std::string& part, const std::vector<lamina_msgs::Setting>& settings = {},
                           const std::string& output = "") {
    SliceMesh service;
    service.request.part = part;
    service.request.settings = settings;
    service.request.output = output;
    EXPECT_TRUE(lamina::callService(client_.getService(), service)) << "the node does not answer";
    return service.response;
  }

  /// The latched toolpath; null if there is none.
  lamina_msgs::ToolpathConstPtr latchedToolpath() {
    return ros::topic::waitForMessage<lamina_msgs::Toolpath>(lamina::names::kToolpath, node_,
                                                             ros::Duration(kPatience));
  }

  std::vector<visualization_msgs::Marker> latchedMarkers(const std::string& topic) {
    const auto latched =
        ros::topic::waitForMessage<visualization_msgs::MarkerArray>(topic, node_, ros::Duration(kPatience));
    return latched ? latched->markers : std::vector<visualization_msgs::Marker>();
  }

  std::string file(const std::string& name) const { return folder_.file(name); }

  /// A file that a refused request must not touch.
  std::string precious() {
    std::ofstream(file("precious.gcode")) << "G28\n";
    return file("precious.gcode");
  }

  void expectRefused(const SliceMesh::Response& response, std::uint8_t code, const std::string& word) {
    EXPECT_EQ(response.status.code + 0, code + 0) << response.status.message;
    EXPECT_NE(response.status.message.find(word), std::string::npos) << response.status.message;
    EXPECT_EQ(response.toolpath_id, "");
    if (fs::exists(file("precious.gcode"))) {
      EXPECT_EQ(lamina::readFile(file("precious.gcode")), "G28\n");
      EXPECT_EQ(folder_.fileCount(), 1U) << "something was left behind";
    }
  }

  ros::NodeHandle node_;
  ros::ServiceClient client_ = node_.serviceClient<SliceMesh>(lamina::names::kSliceMesh);
  const lamina::test::ScratchFolder folder_;
};

TEST_F(SlicingService, SlicesAParametricPartAndPublishesItsToolpath) {
  const auto response = call("box", {}, file("box.gcode"));
  ASSERT_EQ(response.status.code, Status::OK + 0) << response.status.message;
  const auto& summary = response.summary;
  EXPECT_EQ(summary.triangles, 12U);
  EXPECT_EQ(summary.open_contours, 0U);
  EXPECT_NEAR(summary.sliced_volume, summary.mesh_volume, 1e-9 * summary.mesh_volume);
  EXPECT_GT(fs::file_size(file("box.gcode")), 1000U);
  const auto toolpath = latchedToolpath();
  ASSERT_TRUE(toolpath);
  EXPECT_EQ(toolpath->id, response.toolpath_id);
  EXPECT_EQ(toolpath->header.frame_id, lamina::names::kPartFrame);
  EXPECT_EQ(toolpath->layers.size(), summary.layers);
}

TEST_F(SlicingService, LogsWhichRequestFailed) {
  std::vector<std::string> lines;
  const boost::function<void(const rosgraph_msgs::LogConstPtr&)> onLog =
      [&](const rosgraph_msgs::LogConstPtr& message) { lines.push_back(message->msg); };
  const ros::Subscriber rosout = node_.subscribe<rosgraph_msgs::Log>("/rosout", 1000, onLog);
  const std::string expected = "cannot slice 'nothing' into '" + file("nothing.gcode") + "': ";
  // What was logged before this test heard the node is lost.
  EXPECT_TRUE(lamina::test::waitUntil([&] {
    call("nothing", {}, file("nothing.gcode"));
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.rfind(expected, 0) == 0; });
  }));
}

TEST_F(SlicingService, GivesTheSameIdForTheSameRequest) {
  EXPECT_EQ(call("box").toolpath_id, call("box").toolpath_id);
}

TEST_F(SlicingService, OverridesItsSettingsForOneRequestOnly) {
  const auto fine = call("box");
  const auto coarse = call("box", {settingMessage("slicing.layer_height_mm", "0.4"),
                                   settingMessage("slicing.first_layer_height_mm", "0.4")});
  const auto fine_again = call("box");
  ASSERT_EQ(coarse.status.code, Status::OK + 0) << coarse.status.message;
  EXPECT_EQ(2 * coarse.summary.layers, fine.summary.layers);
  EXPECT_EQ(fine_again.summary.layers, fine.summary.layers);
}

TEST_F(SlicingService, LetsWhatNobodyTypedGiveWayToTheMachine) {
  const lamina_msgs::Setting no_fan = settingMessage("machine.has_fan", "false");
  EXPECT_EQ(call("box", {no_fan}).status.code, Status::OK + 0);
  expectRefused(call("box", {no_fan, settingMessage("fan.use", "true")}, precious()), Status::INVALID_CONFIG,
                "fan.use is true");
  const auto usual = call("box");
  const auto wide = call("box", {settingMessage("machine.nozzle_mm", "0.8")});
  EXPECT_EQ(2 * wide.summary.layers, usual.summary.layers) << wide.status.message;
}

TEST_F(SlicingService, ShowsWhatHangsInTheAirIfAskedTo) {
  const auto markers = [this] { return latchedMarkers(lamina::names::kOverhangMarkers); };
  // Sparse infill bridges the gaps of the layer before.
  const std::vector<lamina_msgs::Setting> sparse = {settingMessage("overhang.report", "true"),
                                                    settingMessage("skins.top_layers", "0"),
                                                    settingMessage("skins.bottom_layers", "0")};
  ASSERT_EQ(call("box", sparse).status.code, Status::OK + 0);
  ASSERT_EQ(markers().size(), 2U);
  EXPECT_EQ(markers()[1].ns, "bridge");
  EXPECT_EQ(markers()[1].header.frame_id, lamina::names::kPartFrame);
  EXPECT_GT(markers()[1].points.size(), 1000U);
  ASSERT_EQ(call("box").status.code, Status::OK + 0);
  EXPECT_EQ(markers().size(), 1U) << "those of the part before are deleted";
}

TEST_F(SlicingService, ShowsWhereTheHeadCollidesIfAskedTo) {
  const auto markers = [this] { return latchedMarkers(lamina::names::kCollisionMarkers); };
  const std::vector<lamina_msgs::Setting> steep = {settingMessage("slicing.plane.angle_deg", "75"),
                                                   settingMessage("slicing.plane.tool_axis", "down"),
                                                   settingMessage("clearance.report", "true")};
  ASSERT_EQ(call("box", steep).status.code, Status::OK + 0);
  ASSERT_GT(markers().size(), 2U);
  EXPECT_EQ(markers().back().ns, "first_collision");
  EXPECT_EQ(markers().back().header.frame_id, lamina::names::kBedFrame);
  ASSERT_EQ(call("box", {settingMessage("clearance.report", "true")}).status.code, Status::OK + 0);
  EXPECT_EQ(markers().size(), 1U) << "a nozzle upright over level layers clears them";
}

// The shells of a cone lean so far that a five-axis head is in the bed.
TEST_F(SlicingService, ShowsWhereMachinesAndRobotsOfAnyJointsCollide) {
  const auto markers = [this] { return latchedMarkers(lamina::names::kCollisionMarkers); };
  ASSERT_EQ(
      call("box", {settingMessage("machine.name", "irb_4600"), settingMessage("clearance.report", "true")})
          .status.code,
      Status::OK + 0);
  EXPECT_EQ(markers().size(), 1U) << "the robot clears level layers";
  const auto response =
      call("cone", {settingMessage("machine.name", "five_axis_head_table"),
                    settingMessage("clearance.report", "true"), settingMessage("slicing.mode", "curved"),
                    settingMessage("input.scale", "0.5"), settingMessage("slicing.layer_height_mm", "1"),
                    settingMessage("bead.width_mm", "1.5")});
  ASSERT_EQ(response.status.code, Status::OK + 0) << response.status.message;
  ASSERT_GT(markers().size(), 2U);
  EXPECT_EQ(markers().back().ns, "first_collision");
}

TEST_F(SlicingService, SlicesIntoCurvedLayersWithTheNozzleAlongThem) {
  const auto response = call(
      "sphere", {settingMessage("slicing.mode", "curved"), settingMessage("slicing.layer_height_mm", "1"),
                 settingMessage("bead.width_mm", "1.5"), settingMessage("frames.every_mm", "5")});
  ASSERT_EQ(response.status.code, Status::OK + 0) << response.status.message;
  EXPECT_EQ(response.summary.mode, "curved");
  EXPECT_EQ(response.summary.mode_reason, "");
  EXPECT_FALSE(response.summary.notes.empty());
  // 10 mm of 1 mm on each side, but for the innermost shells, in which no bead finds room.
  EXPECT_EQ(response.summary.layers, 18U);
  const auto markers = latchedMarkers(lamina::names::kFrameMarkers);
  ASSERT_EQ(markers.size(), 4U);
  EXPECT_EQ(markers[3].ns, "nozzle_z");
  // The tool axis of the uppermost layer's first frame points into the sphere.
  const auto& points = markers[3].points;
  const auto& tip = points[points.size() - 2];
  const auto& end = points[points.size() - 1];
  EXPECT_LT((end.x - tip.x) * tip.x + (end.y - tip.y) * tip.y + (end.z - tip.z) * (tip.z - 0.01), 0.0);
}

TEST_F(SlicingService, ShowsTheRegionThatStandsInTheWay) {
  expectRefused(call("sphere", {settingMessage("slicing.mode", "adapted")}, precious()), Status::INVALID_MESH,
                "lean more");
  auto markers = latchedMarkers(lamina::names::kRefusalMarkers);
  ASSERT_GT(markers.size(), 4U);
  EXPECT_EQ(markers[1].ns, "region");
  EXPECT_GT(markers[1].points.size(), 300U);
  EXPECT_NE(markers[3].text.find("lean"), std::string::npos);
  ASSERT_EQ(call("sphere").status.code, Status::OK + 0);
  EXPECT_EQ(latchedMarkers(lamina::names::kRefusalMarkers).size(), 1U) << "those of the refusal are deleted";
}

TEST_F(SlicingService, RefusesAMissingFile) {
  expectRefused(call("/nowhere/part.stl", {}, precious()), Status::FILE_ERROR, "/nowhere/part.stl");
}

TEST_F(SlicingService, RefusesAPartItDoesNotKnow) {
  EXPECT_NE(call("no_such_part").status.code, Status::OK + 0);
}

TEST_F(SlicingService, RefusesAMeshThatIsNotFinite) {
  const lamina::test::ScratchFolder folder;
  const std::string mesh = folder.file("nan.stl");
  std::ofstream(mesh)
      << "solid s\nfacet normal 0 0 1\nouter loop\nvertex nan 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
         "endloop\nendfacet\nendsolid s\n";
  expectRefused(call(mesh, {}, precious()), Status::INVALID_MESH, "");
}

TEST_F(SlicingService, RefusesAnUnknownSetting) {
  expectRefused(call("box", {settingMessage("slicing.layer_heigth_mm", "0.2")}, precious()),
                Status::INVALID_CONFIG, "slicing.layer_height_mm");
}

TEST_F(SlicingService, RefusesALayerHeightOfZero) {
  expectRefused(call("box", {settingMessage("slicing.layer_height_mm", "0")}, precious()),
                Status::INVALID_CONFIG, "slicing.layer_height_mm is '0'");
}

TEST_F(SlicingService, RefusesAPartLargerThanTheMachine) {
  expectRefused(call("box", {settingMessage("input.scale", "100")}, precious()), Status::UNREACHABLE, "mm");
}

TEST_F(SlicingService, RefusesAnOutputItCannotWrite) {
  EXPECT_EQ(call("box", {}, "/nowhere/box.gcode").status.code, Status::FILE_ERROR + 0);
}

TEST_F(SlicingService, ReportsProgressAndGivesTheAnswerOfTheService) {
  Client client(lamina::names::kSlice, true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(kPatience)));
  lamina_msgs::SliceGoal goal;
  goal.part = "sphere";
  std::vector<std::string> stages;
  client.sendGoal(goal, {}, {}, [&](const lamina_msgs::SliceFeedbackConstPtr& feedback) {
    stages.push_back(feedback->stage);
  });
  ASSERT_TRUE(client.waitForResult(ros::Duration(kPatience)));
  EXPECT_EQ(client.getState(), actionlib::SimpleClientGoalState::SUCCEEDED);
  EXPECT_EQ(client.getResult()->toolpath_id, call("sphere").toolpath_id);
  EXPECT_FALSE(stages.empty());
}

TEST_F(SlicingService, StopsWhenTheGoalIsCancelledAndServesTheNext) {
  Client client(lamina::names::kSlice, true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(kPatience)));
  const auto before = call("box");
  lamina_msgs::SliceGoal goal;
  goal.part = "sphere";
  goal.settings = {settingMessage("slicing.layer_height_mm", "0.001"),
                   settingMessage("slicing.first_layer_height_mm", "0.001")};
  goal.output = precious();
  client.sendGoal(goal);
  ASSERT_TRUE(
      lamina::test::waitUntil([&] { return client.getState() == actionlib::SimpleClientGoalState::ACTIVE; }));
  EXPECT_EQ(call("box").status.code, Status::REJECTED + 0) << "one part at a time";
  client.cancelGoal();
  ASSERT_TRUE(client.waitForResult(ros::Duration(kPatience)));
  EXPECT_EQ(client.getState(), actionlib::SimpleClientGoalState::PREEMPTED);
  EXPECT_EQ(client.getResult()->status.code, Status::CANCELLED + 0);
  EXPECT_EQ(lamina::readFile(file("precious.gcode")), "G28\n");
  EXPECT_EQ(latchedToolpath()->id, before.toolpath_id);
  EXPECT_EQ(call("box").toolpath_id, before.toolpath_id);
}

}  // namespace
