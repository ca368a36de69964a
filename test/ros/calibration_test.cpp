// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// An emulated machine whose sensor is late, and sits elsewhere than its description says, runs the programs
// of `lamina calibrate plan`; what is recorded as bags gives both back.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <sensor_msgs/PointCloud2.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/child_process.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/calibration/calibration_file.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/streaming/client/stream_session.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "node_process.hpp"
#include "ros_home.hpp"
#include "support/scratch_folder.hpp"
#include "tf_recording.hpp"
#include "wait_until.hpp"

namespace lamina {
namespace {

constexpr double kLate = 0.08;  // s, by which the sensor's stamps are late

const std::string kPty = test::inRosHome("calibration_test");

/// The gantry with its sensor 2.5, 1.5 and 0.5 mm and 1.5 deg off.
std::string gantryWithMovedSensor() {
  std::string urdf = machineByName("cartesian_gantry").urdf;
  const std::string there = "<origin xyz=\"0.025 0 0.06\" rpy=\"3.14159265358979 0 0\"/>";
  const std::size_t at = urdf.find(there);
  EXPECT_NE(at, std::string::npos);
  return urdf.replace(at, there.size(),
                      "<origin xyz=\"0.0275 -0.0015 0.0605\" rpy=\"3.14159265358979 0 0.0261799387799\"/>");
}

/// What is recorded while a program runs.
class Recorder {
 public:
  Recorder() : tf_("/") {
    const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> on_profile =
        [this](const auto& profile) { profiles_.push_back(profile); };
    profile_ = node_.subscribe<sensor_msgs::PointCloud2>(names::kProfile, 100000, on_profile);
  }

  bool isConnected() const { return profile_.getNumPublishers() > 0 && tf_.isConnected(); }
  ros::Time lastProfile() const { return profiles_.empty() ? ros::Time() : profiles_.back()->header.stamp; }

  /// A bag whose profiles have late stamps.
  void write(const std::string& path) const {
    rosbag::Bag bag(path, rosbag::bagmode::Write);
    tf_.write(bag);
    for (const auto& profile : profiles_) {
      sensor_msgs::PointCloud2 late = *profile;
      late.header.stamp += ros::Duration(kLate);
      bag.write(names::kProfile, late.header.stamp, late);
    }
  }

 private:
  ros::NodeHandle node_;
  test::TfRecording tf_;
  ros::Subscriber profile_;
  std::vector<sensor_msgs::PointCloud2ConstPtr> profiles_;
};

/// Runs the command as a person does.
void lamina(const std::vector<std::string>& arguments) {
  std::vector<std::string> all{LAMINA_COMMAND};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const ProgramEnd end = runProgram({all, "", 600.0}, NoProgress());
  ASSERT_EQ(end.exit_code, 0) << end.errors;
  std::printf("%s", end.output.c_str());
}

/// Runs the program of a plan and keeps what is seen as a bag.
void recordPlan(const std::string& kind, const std::string& bag) {
  const test::ScratchFolder folder;
  const std::string program = folder.file(kind + ".gcode");
  lamina({"calibrate", "plan", kind, "-o", program, "--set", "program.start_code=G28", "--set",
          "program.end_code=G4 P1000"});
  Recorder recorder;
  ASSERT_TRUE(test::waitUntil([&] { return recorder.isConnected(); }));
  const StreamSession session(StreamableProgram::fromText(kind, readFile(program)), {}, {kPty, 115200}, {});
  lamina_msgs::MachineRest rest;
  ASSERT_TRUE(test::waitUntil([&] {
    return session.isOver() && ros::service::call(names::kMachineRest, rest) && rest.response.is_resting;
  }));
  ASSERT_TRUE(test::waitUntil([&] { return recorder.lastProfile() >= rest.response.last_profile; }));
  recorder.write(bag);
}

TEST(CalibrationTest, FindsHowLateAndWhereAnEmulatedSensorSees) {
  const test::ScratchFolder folder;
  writeFile(folder.file("moved.urdf"), gantryWithMovedSensor());
  const test::NodeProcess machine(
      LAMINA_NODE, {"_pty:=" + kPty, "_machine/urdf:=" + folder.file("moved.urdf"), "_emulator/speed_up:=1",
                    "_deposit/model:=heights"});
  ASSERT_TRUE(test::waitUntil([&] { return std::filesystem::exists(kPty); }));
  const std::string cell = folder.file("cell.yaml");
  recordPlan("bobbing", folder.file("bobbing.bag"));
  lamina({"calibrate", "time", folder.file("bobbing.bag"), "-o", cell});
  recordPlan("cross", folder.file("cross.bag"));
  lamina({"calibrate", "sensor", folder.file("cross.bag"), "-o", cell});
  const Calibration found = readCalibration(cell);
  ASSERT_TRUE(found.time && found.pose);
  EXPECT_NEAR(found.time->offset_s, kLate, 0.001);
  const Eigen::Isometry3d truth = machineFromUrdf(gantryWithMovedSensor()).nozzle_from_sensor;
  const Eigen::Isometry3d pose = found.pose->nozzle_from_sensor;
  EXPECT_EQ(found.pose->kept, "");
  EXPECT_LT((pose.translation() - truth.translation()).norm(), 0.05);
  EXPECT_LT(Eigen::AngleAxisd(Eigen::Matrix3d(pose.linear().transpose() * truth.linear())).angle(),
            0.05 * M_PI / 180.0);
}

}  // namespace
}  // namespace lamina

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "calibration_test");
  const ros::NodeHandle keeps_ros_started;
  return RUN_ALL_TESTS();
}
