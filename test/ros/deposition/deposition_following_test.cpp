// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The node deposition_simulator lays a toolpath behind machines that run it: played ones, with tool axes that
// lean where they can, and an emulated one that is streamed to.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <memory>
#include <vector>

#include "conversions.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "lamina/streaming/session/stream_session.hpp"
#include "latched.hpp"
#include "names.hpp"
#include "ros/leaning_square.hpp"
#include "ros/node_process.hpp"
#include "ros/ros_home.hpp"
#include "ros/wait_until.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

constexpr double kVoxelVolume = 1e-12;  // m3: a cube of 0.1 mm

/// What a follower in a namespace publishes.
class Followed {
 public:
  Followed(const std::string& space, const std::string& deposited) : node_(space) {
    const boost::function<void(const lamina_msgs::DepositionStateConstPtr&)> on_state =
        [this](const auto& message) { states.push_back(message); };
    const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> on_cloud =
        [this](const auto& message) { clouds.push_back(message); };
    state_ = node_.subscribe<lamina_msgs::DepositionState>(names::kDepositionState, 1000, on_state);
    const boost::function<void(const tf2_msgs::TFMessageConstPtr&)> on_tf = [this](const auto&) {
      is_machine_seen = true;
    };
    cloud_ = node_.subscribe<sensor_msgs::PointCloud2>(deposited, 1000, on_cloud);
    tf_ = node_.subscribe<tf2_msgs::TFMessage>("tf", 1000, on_tf);
    toolpath_ = node_.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  }

  void latch(const MachineToolpath& placed) { publishLatched(toolpath_, stamped(placed, ros::Time::now())); }
  bool isReadyFor(unsigned subscribers) const {
    return state_.getNumPublishers() > 0 && cloud_.getNumPublishers() > 0 &&
           toolpath_.getNumSubscribers() >= subscribers;
  }
  bool isFollowing(const std::string& id) const {
    return !states.empty() && states.back()->toolpath_id == id && states.back()->planned_volume > 0.0;
  }
  bool isComplete() const { return !states.empty() && states.back()->is_complete != 0; }

  std::vector<lamina_msgs::DepositionStateConstPtr> states;
  std::vector<sensor_msgs::PointCloud2ConstPtr> clouds;
  bool is_machine_seen = false;  ///< on tf

 private:
  ros::NodeHandle node_;
  ros::Subscriber state_;
  ros::Subscriber cloud_;
  ros::Subscriber tf_;
  ros::Publisher toolpath_;
};

/// Without skirts.
double depositedVolume(const Toolpath& toolpath) {
  double volume = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Skirt) volume += depositedVolume(path);
  return toCubicMetres(volume);
}

/// What was deposited grew bit by bit to the whole.
void expectGrown(const Followed& followed, double volume) {
  const lamina_msgs::DepositionState& last = *followed.states.back();
  EXPECT_NEAR(last.planned_volume, volume, 1e-6 * volume);
  EXPECT_NEAR(last.fraction, 1.0F, 1e-5F);
  EXPECT_NEAR(last.summary.extruded_volume, volume, 1e-5 * volume);
  EXPECT_NEAR(last.summary.model_volume + last.summary.excess_volume, volume,
              1.01 * kVoxelVolume + 1e-6 * volume);
  EXPECT_NEAR(last.summary.excess_volume, 0.0, 1e-3 * volume);
  std::size_t half_way = 0;
  double before = 0.0;
  for (const auto& state : followed.states) {
    EXPECT_GE(state->summary.model_volume, before);
    before = state->summary.model_volume;
    EXPECT_NEAR(state->summary.extruded_volume, static_cast<double>(state->fraction) * volume, 1e-3 * volume);
    if (state->fraction > 0.2F && state->fraction < 0.8F) ++half_way;
  }
  EXPECT_GT(half_way, 0U) << "of " << followed.states.size() << " states";
}

class DepositionFollowing : public testing::TestWithParam<std::string> {};

TEST_P(DepositionFollowing, LaysWhatAPlayedMachineHasPassed) {
  const std::string& name = GetParam();
  const test::PlayedSquare played = test::squareOn(*kinematicModelByName(name));
  Followed followed(name, names::kDeposited);
  const std::vector<std::string> in_space = {"__ns:=/" + name, "/tf:=/" + name + "/tf",
                                             "/tf_static:=/" + name + "/tf_static", "_machine/name:=" + name};
  std::vector<std::string> simulator = in_space;
  simulator.insert(simulator.end(), {"_mode:=follow", "_following/period_s:=0.1"});
  const test::NodeProcess following(LAMINA_DEPOSITION_NODE, simulator);
  ASSERT_TRUE(test::waitUntil([&] { return followed.isReadyFor(1); }));
  followed.latch(played.placed);
  ASSERT_TRUE(test::waitUntil([&] { return followed.isFollowing(played.placed.id); }));
  const test::NodeProcess publisher(LAMINA_PUBLISHER_NODE, in_space);
  ASSERT_TRUE(test::waitUntil([&] { return followed.isComplete() && followed.clouds.size() > 1; }));
  expectGrown(followed, depositedVolume(played.placed.toolpath));
  EXPECT_EQ(followed.clouds.back()->header.frame_id, names::kBedFrame);
  EXPECT_LT(followed.clouds.front()->width * followed.clouds.front()->height,
            followed.clouds.back()->width * followed.clouds.back()->height);
  // Nobody has asked for markers so far, and nothing is deposited any more.
  visualization_msgs::MarkerArray shown;
  const boost::function<void(const visualization_msgs::MarkerArrayConstPtr&)> on_markers =
      [&shown](const auto& message) { shown = *message; };
  const ros::Subscriber late =
      ros::NodeHandle("/" + name)
          .subscribe<visualization_msgs::MarkerArray>(names::kDepositedMarkers, 1, on_markers);
  EXPECT_TRUE(test::waitUntil([&] { return !shown.markers.empty(); }));
}

INSTANTIATE_TEST_SUITE_P(Machines, DepositionFollowing,
                         testing::Values("cartesian_gantry", "five_axis_head_ac"),
                         [](const auto& machine) { return machine.param; });

TEST(DepositionFollowingTest, LaysWhatAnEmulatedMachineHasPassed) {
  const test::ScratchFolder folder;
  SliceJob job;
  job.part = "box";
  job.output = folder.file("box.gcode");
  job.settings.slicing.layer_height_mm = 2.0;
  job.settings.slicing.first_layer_height_mm = 2.0;
  job.settings.planning.bead.width_mm = 2.0;
  NoProgress nobody;
  runSliceJob(job, nobody);
  MachineToolpath placed;
  placed.toolpath = toolpathFromGcodeFile(job.output, {});
  placed.id = toolpathId(placed.toolpath);
  Followed followed("emulated", "followed");
  ASSERT_TRUE(test::waitUntil([&] { return followed.isReadyFor(2) && followed.is_machine_seen; }));
  followed.latch(placed);
  ASSERT_TRUE(test::waitUntil([&] { return followed.isFollowing(placed.id); }));
  const auto program = StreamableProgram::fromText("box", readFile(job.output));
  const StreamSession session(program, {}, {test::inRosHome("deposition_following_test"), 115200}, {});
  ASSERT_TRUE(test::waitUntil([&] { return followed.isComplete(); }));
  expectGrown(followed, depositedVolume(placed.toolpath));
  ASSERT_TRUE(test::waitUntil([&] { return !followed.clouds.empty(); }));
  EXPECT_GT(followed.states.back()->summary.surface, 1e-4) << "ten thousand faces of voxels";
  for (const auto& cloud : followed.clouds) EXPECT_LE(cloud->width, 1000U) << "shown/points";
}

}  // namespace
}  // namespace lamina
