// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Asks the running node deposition_simulator what toolpaths leave behind, as a client would.
#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "conversions.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"
#include "lamina/job/slice_job.hpp"
#include "latched.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "point_cloud.hpp"
#include "request_settings.hpp"
#include "ros/wait_until.hpp"
#include "support/scratch_folder.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using lamina_msgs::Status;
using Client = actionlib::SimpleActionClient<lamina_msgs::SimulateDepositionAction>;
using Goal = lamina_msgs::SimulateDepositionGoal;
using Result = lamina_msgs::SimulateDepositionResult;

constexpr double kVoxel = 1e-12;  // m3: a cube of 0.1 mm
const ros::Duration kPatience(test::kPatience);

MachineToolpath placedSquare() {
  MachineToolpath placed;
  placed.toolpath = test::twoLayers();
  placed.machine = "cartesian_gantry";
  placed.bed_from_part = Eigen::Translation3d(50, 60, 0) * Eigen::Isometry3d::Identity();
  placed.id = toolpathId(placed.toolpath);
  return placed;
}

/// So much that it takes a while: 1.2 km of beads.
MachineToolpath placedBlock() {
  MachineToolpath placed;
  placed.toolpath.part_name = "block";
  for (int layer = 1; layer <= 50; ++layer) {
    const double z = 0.2 * layer;
    std::vector<Point3> points;
    for (int line = 0; line < 250; ++line)
      for (const double x : {line % 2 == 0 ? 0.0 : 100.0, line % 2 == 0 ? 100.0 : 0.0})
        points.emplace_back(x, 0.4 * line, z);
    Path infill = test::straightPath(points.front(), points.back());
    infill.points = points;
    Path travel = test::straightPath(points.back(), {0, 0, z + 0.2});
    travel.role = PathRole::Travel;
    travel.bead = Bead{};
    placed.toolpath.layers.push_back({z, 0.2, {infill, travel}});
  }
  placed.id = toolpathId(placed.toolpath);
  return placed;
}

class DepositionSimulator : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(client_.waitForServer(kPatience)); }

  /// Publishes a toolpath and waits until the node has it.
  void latch(const MachineToolpath& placed) {
    publishLatched(toolpath_, stamped(placed, ros::Time::now()));
    Goal probe;
    probe.toolpath_id = placed.id;
    probe.output = "none.xyz";  // refused, for this reason only once the toolpath is there
    ASSERT_TRUE(
        test::waitUntil([&] { return ask(probe).status.message.find("none.xyz") != std::string::npos; }));
  }

  Result ask(const Goal& goal) {
    client_.sendGoal(goal);
    EXPECT_TRUE(client_.waitForResult(kPatience)) << "the node does not answer";
    return *client_.getResult();
  }

  void expectRefused(const Goal& goal, std::uint8_t code, const std::string& word) {
    const Result result = ask(goal);
    EXPECT_EQ(client_.getState(), actionlib::SimpleClientGoalState::ABORTED);
    EXPECT_EQ(result.status.code + 0, code + 0) << result.status.message;
    EXPECT_NE(result.status.message.find(word), std::string::npos) << result.status.message;
    EXPECT_EQ(result.summary.voxels, 0U);
  }

  template <class Message>
  boost::shared_ptr<const Message> published(const std::string& topic) {
    auto message = ros::topic::waitForMessage<Message>(topic, node_, kPatience);
    EXPECT_TRUE(message) << topic;
    return message;
  }

  ros::NodeHandle node_;
  ros::Publisher toolpath_ = node_.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  Client client_{names::kSimulateDeposition, true};
  test::ScratchFolder folder_;
};

TEST_F(DepositionSimulator, LaysTheLatchedToolpathVolumeForVolume) {
  const MachineToolpath placed = placedSquare();
  latch(placed);
  Goal goal;
  goal.toolpath_id = placed.id;
  goal.output = folder_.file("square.stl");
  const Result result = ask(goal);
  ASSERT_EQ(result.status.code, Status::OK + 0) << result.status.message;
  EXPECT_EQ(client_.getState(), actionlib::SimpleClientGoalState::SUCCEEDED);
  EXPECT_EQ(result.toolpath_id, placed.id);
  const double extruded = toCubicMetres(totals(placed.toolpath).deposited_mm3);
  EXPECT_NEAR(result.summary.extruded_volume, extruded, 1e-6 * extruded);
  EXPECT_NEAR(result.summary.model_volume, extruded, kVoxel);
  EXPECT_NEAR(static_cast<double>(result.summary.voxels) * kVoxel, result.summary.model_volume, 1e-18);
  EXPECT_EQ(result.summary.outside_volume, 0.0) << "the voxels reach round the whole part";
  EXPECT_NEAR(result.summary.path, 0.05, 1e-9);
  EXPECT_NEAR(result.summary.highest, 0.4e-3, 1e-9);
  EXPECT_GT(result.summary.porosity, 0.5) << "a square without infill";
  EXPECT_GT(result.summary.surface, 0.0);
  EXPECT_GT(readMesh(goal.output).triangles.size(), 1000U);

  const auto cloud = published<sensor_msgs::PointCloud2>(names::kDeposited);
  EXPECT_EQ(cloud->header.frame_id, names::kBedFrame);
  Box3 box;
  for (const Point3& point : fromMessage(*cloud, Eigen::Isometry3d::Identity()).points) box.include(point);
  EXPECT_TRUE(box.low.isApprox(Point3(49.8, 59.8, 0.05), 0.1)) << box.low.transpose();
  EXPECT_NEAR(box.high.x(), 60.2, 0.15);
  const auto markers = published<visualization_msgs::MarkerArray>(names::kDepositedMarkers);
  ASSERT_EQ(markers->markers.size(), 1U);
  EXPECT_EQ(markers->markers[0].header.frame_id, names::kBedFrame);
  EXPECT_GT(markers->markers[0].points.size(), 3000U);
  EXPECT_LE(markers->markers[0].points.size(), 300000U);
}

TEST_F(DepositionSimulator, LaysPrograms) {
  SliceJob job;
  job.part = "box";
  job.output = folder_.file("box.gcode");
  job.settings.slicing.layer_height_mm = 0.4;
  job.settings.slicing.first_layer_height_mm = 0.4;
  NoProgress nobody;
  const SlicedPart sliced = runSliceJob(job, nobody);
  double without_skirt = 0.0;
  for (const ToolpathLayer& layer : sliced.toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Skirt) without_skirt += depositedVolume(path);
  Goal goal;
  goal.program = job.output;
  goal.settings = {settingMessage("deposition.voxel_mm", "0.2")};
  const Result result = ask(goal);
  ASSERT_EQ(result.status.code, Status::OK + 0) << result.status.message;
  EXPECT_NEAR(result.summary.extruded_volume, toCubicMetres(without_skirt),
              1e-3 * toCubicMetres(without_skirt));
  EXPECT_NEAR(result.summary.model_volume, result.summary.extruded_volume, 8.0 * kVoxel);
  EXPECT_NEAR(result.summary.voxel, 0.2e-3, 1e-12) << "for this goal only";
}

/// 10 mm of filament of 2 mm are 10 pi mm3; of the 2.85 mm that the program states they would be 63.8 mm3.
TEST_F(DepositionSimulator, TakesTheFilamentOfAGoalBeforeThatOfItsProgram) {
  Goal goal;
  goal.program = folder_.file("thick.gcode");
  std::ofstream(goal.program) << "; filament_diameter = 2.85\nM83\nG90\nG1 X10 Y10 Z0.4 F6000\n;LAYER:0\n"
                                 ";TYPE:WALL-OUTER\n;WIDTH:0.8\n;HEIGHT:0.4\nG1 X110 Y10 E10 F1200\n";
  goal.settings = {settingMessage("program.filament_diameter_mm", "2"),
                   settingMessage("deposition.voxel_mm", "0.2")};
  const Result result = ask(goal);
  ASSERT_EQ(result.status.code, Status::OK + 0) << result.status.message;
  EXPECT_NEAR(result.summary.extruded_volume, toCubicMetres(10.0 * M_PI), toCubicMetres(0.01));
}

TEST_F(DepositionSimulator, RefusesWhatItCannotLay) {
  latch(placedSquare());
  Goal other;
  other.toolpath_id = "0123456789abcdef";
  expectRefused(other, Status::INVALID_INPUT, "0123456789abcdef");
  Goal missing;
  missing.program = folder_.file("none.gcode");
  expectRefused(missing, Status::FILE_ERROR, "none.gcode");
  Goal unknown;
  unknown.settings = {settingMessage("deposition.voxel", "0.2")};
  expectRefused(unknown, Status::INVALID_CONFIG, "deposition.voxel_mm");
}

TEST_F(DepositionSimulator, RefusesVoxelsThatDoNotFitIntoMemoryAndNamesOnesThatDo) {
  latch(placedSquare());
  Goal fine;
  fine.settings = {settingMessage("deposition.voxel_mm", "0.001"),
                   settingMessage("deposition.memory_limit_mb", "1")};
  fine.output = folder_.file("fine.stl");
  expectRefused(fine, Status::INVALID_INPUT, "fit");
  EXPECT_FALSE(std::filesystem::exists(fine.output));
}

TEST_F(DepositionSimulator, ReportsHowFarItIsAndStopsWhenCancelled) {
  latch(placedBlock());
  Goal goal;
  goal.output = folder_.file("block.stl");
  std::atomic<int> reports{0};
  client_.sendGoal(goal, Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                   [&](const lamina_msgs::SimulateDepositionFeedbackConstPtr& feedback) {
                     EXPECT_GE(feedback->fraction, 0.0F);
                     EXPECT_LE(feedback->fraction, 1.0F);
                     if (feedback->stage == "deposit" && feedback->fraction > 0.0F) ++reports;
                   });
  ASSERT_TRUE(test::waitUntil([&] { return reports > 0; }));
  client_.cancelGoal();
  ASSERT_TRUE(client_.waitForResult(kPatience));
  EXPECT_EQ(client_.getState(), actionlib::SimpleClientGoalState::PREEMPTED);
  EXPECT_EQ(client_.getResult()->status.code, Status::CANCELLED + 0);
  EXPECT_FALSE(std::filesystem::exists(goal.output));
}

}  // namespace
}  // namespace lamina
