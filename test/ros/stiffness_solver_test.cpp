// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Asks the running node stiffness_solver to put parts under load, as a client would.
#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <atomic>
#include <filesystem>

#include "messages.hpp"
#include "names.hpp"
#include "request_settings.hpp"
#include "support/scratch_folder.hpp"
#include "wait_until.hpp"

namespace lamina {
namespace {

using lamina_msgs::Status;
using SolveClient = actionlib::SimpleActionClient<lamina_msgs::ComputeStiffnessAction>;
using SolveGoal = lamina_msgs::ComputeStiffnessGoal;
using SolveResult = lamina_msgs::ComputeStiffnessResult;

constexpr double kModulus = 3861e6;  // Pa: the material's
const ros::Duration kSolvePatience(test::kPatience);

SolveGoal boxGoal(const std::string& voxel_mm) {
  SolveGoal goal;
  goal.part = "box";
  goal.settings = {settingMessage("deposition.voxel_mm", voxel_mm)};
  return goal;
}

class StiffnessSolver : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(client_.waitForServer(kSolvePatience)); }

  SolveResult ask(const SolveGoal& goal) {
    client_.sendGoal(goal);
    EXPECT_TRUE(client_.waitForResult(kSolvePatience)) << "the node does not answer";
    return *client_.getResult();
  }

  ros::NodeHandle node_;
  SolveClient client_{names::kComputeStiffness, true};
  test::ScratchFolder folder_;
};

TEST_F(StiffnessSolver, ABoxIsAsStiffAsItsMaterialAndItsSurfaceMovesAlong) {
  SolveGoal goal = boxGoal("1");
  goal.output = folder_.file("box.vtk");
  const SolveResult result = ask(goal);
  ASSERT_EQ(result.status.code, Status::OK + 0) << result.status.message;
  EXPECT_NEAR(result.modulus, kModulus, 1e-4 * kModulus);
  EXPECT_GT(result.force, 0.0);
  EXPECT_GT(result.elements, 100U);
  EXPECT_EQ(result.elements_left_out, 0U);
  EXPECT_TRUE(std::filesystem::exists(goal.output));

  const auto cloud =
      ros::topic::waitForMessage<sensor_msgs::PointCloud2>(names::kStiffnessPoints, node_, kSolvePatience);
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->header.frame_id, names::kBedFrame);
  sensor_msgs::PointCloud2ConstIterator<float> z(*cloud, "z");
  sensor_msgs::PointCloud2ConstIterator<float> moved(*cloud, "displacement_z");
  sensor_msgs::PointCloud2ConstIterator<float> stress(*cloud, "von_mises");
  float lowest = 1.0F;
  float highest = 0.0F;
  for (; z != z.end(); ++z) lowest = std::min(lowest, *z), highest = std::max(highest, *z);
  const float strain = 0.2e-3F / (highest - lowest);
  const double uniform = static_cast<double>(strain) * kModulus;
  EXPECT_NEAR(result.greatest_stress, uniform, 1e-3 * uniform) << "the same everywhere";
  for (z = sensor_msgs::PointCloud2ConstIterator<float>(*cloud, "z"); z != z.end(); ++z, ++moved, ++stress) {
    EXPECT_NEAR(*moved, -strain * (*z - lowest), 1e-8F);
    EXPECT_NEAR(*stress, strain * static_cast<float>(kModulus),
                1e-3F * static_cast<float>(kModulus) * strain);
  }
}

TEST_F(StiffnessSolver, RefusesWhatItCannotSolve) {
  SolveGoal missing = boxGoal("1");
  missing.part = folder_.file("none.stl");
  EXPECT_EQ(ask(missing).status.code, Status::FILE_ERROR + 0);
  SolveGoal unknown = boxGoal("1");
  unknown.settings.push_back(settingMessage("stiffness.modulus", "1"));
  EXPECT_EQ(ask(unknown).status.code, Status::INVALID_CONFIG + 0);
  SolveGoal fine = boxGoal("0.002");
  fine.output = folder_.file("fine.vtk");
  const SolveResult refused = ask(fine);
  EXPECT_EQ(refused.status.code, Status::INVALID_INPUT + 0);
  EXPECT_NE(refused.status.message.find("mm"), std::string::npos) << refused.status.message;
  EXPECT_FALSE(std::filesystem::exists(fine.output));
}

TEST_F(StiffnessSolver, StopsWhenCancelled) {
  SolveGoal goal = boxGoal("0.125");
  goal.output = folder_.file("box.vtk");
  std::atomic<int> reports{0};
  client_.sendGoal(goal, SolveClient::SimpleDoneCallback(), SolveClient::SimpleActiveCallback(),
                   [&](const lamina_msgs::ComputeStiffnessFeedbackConstPtr&) { ++reports; });
  ASSERT_TRUE(test::waitUntil([&] { return reports > 0; }));
  client_.cancelGoal();
  ASSERT_TRUE(client_.waitForResult(kSolvePatience));
  EXPECT_EQ(client_.getState(), actionlib::SimpleClientGoalState::PREEMPTED);
  EXPECT_EQ(client_.getResult()->status.code, Status::CANCELLED + 0);
  EXPECT_FALSE(std::filesystem::exists(goal.output));
}

}  // namespace
}  // namespace lamina
