// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/trajectory_driver/file/resume_desk.hpp"

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <memory>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/program/csv/csv_writer.hpp"
#include "names.hpp"
#include "ros/drive/two_beads.hpp"
#include "ros/set_time.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

constexpr double kOrigin = 7000.0;  // s

/// A desk whose machine rests somewhere off the toolpath.
class ResumeDeskOfRest : public testing::Test {
 protected:
  ResumeDeskOfRest() {
    const ros::Publisher reports = node_.advertise<sensor_msgs::JointState>(names::kJointStates, 10);
    sensor_msgs::JointState state;
    for (const DrivenJoint& joint : model_->joints()) {
      state.name.push_back(joint.name);
      state.position.push_back(0.1);
    }
    EXPECT_TRUE(test::waitUntil([&] { return reports.getNumSubscribers() > 0; }));
    for (const double at_s : {0.0, 0.25}) {
      time_.set(kOrigin + at_s);
      EXPECT_TRUE(test::waitUntil([&] {
        reports.publish(state);
        return isHeardAt(at_s);
      }));
    }
  }

  lamina_msgs::ResumePlace::Response asked(const std::string& program) {
    lamina_msgs::ResumePlace call;
    call.request.program = program;
    call.request.placement = "as_is";
    call.request.laid_length = 0.013;
    EXPECT_TRUE(callService(names::kResumePlace, call));
    return call.response;
  }

  std::string written(const Toolpath& toolpath) {
    std::string path = folder_.path() + "/beads.csv";
    std::ofstream file(path);
    writeCsv(toolpath, [&file](std::string_view piece) { file << piece; });
    return path;
  }

  const test::SetTime time_;
  const ScratchFolder folder_;
  ros::NodeHandle node_;
  DriverSettings settings_;
  std::unique_ptr<const KinematicModel> model_ = kinematicModelOf(settings_.machine);
  PresentJoints joints_{node_, *model_};
  std::atomic<bool> is_driving_{false};
  ResumeDesk desk_{node_, settings_, *model_, joints_, [this] { return is_driving_.load(); }};

 private:
  bool isHeardAt(double at_s) const {
    try {
      joints_.fresh(0.01, 0.0);
      return at_s == 0.0 || joints_.areStillFor(0.2);
    } catch (const TimedOut&) {
      return false;
    }
  }
};

/// Nobody runs the node's callbacks meanwhile: a file that is read for long holds none of them up.
TEST_F(ResumeDeskOfRest, AnswersInAThreadOfItsOwn) {
  const auto place = asked(written(test::twoBeads()));
  EXPECT_EQ(place.status.message, "");
  EXPECT_NE(place.text.find("after 13 mm of its beads, of 80 mm"), std::string::npos) << place.text;
}

TEST_F(ResumeDeskOfRest, ReadsAFileAnewThatWasWrittenAnew) {
  const std::string path = written(test::twoBeads());
  EXPECT_NE(asked(path).text.find("of 80 mm"), std::string::npos);
  Toolpath one = test::twoBeads();
  one.layers[0].paths.resize(1);
  EXPECT_EQ(written(one), path);
  EXPECT_NE(asked(path).text.find("of 40 mm"), std::string::npos);
}

TEST_F(ResumeDeskOfRest, IsNotAskedWhileAJobIsUnderWay) {
  is_driving_ = true;
  const auto place = asked("/there/is/no/such.csv");
  EXPECT_NE(place.status.message.find("a job still moves the machine, or holds it"), std::string::npos)
      << place.status.message << ", and nothing is read";
  is_driving_ = false;
  EXPECT_EQ(asked(written(test::twoBeads())).status.message, "");
}

TEST_F(ResumeDeskOfRest, ReadsNothingWhileTheJointsAreNotKnown) {
  time_.set(kOrigin + 20.0);
  const auto place = asked("/there/is/no/such.csv");
  EXPECT_NE(place.status.message.find("reports nothing of joint"), std::string::npos) << place.status.message;
}

TEST_F(ResumeDeskOfRest, RefusesGoalsWithFiguresThatNothingCanHave) {
  lamina_msgs::DriveToolpathGoal goal;
  goal.program = "beads.csv";
  goal.resume = 1U;
  goal.laid_length = 0.013;
  MachineToolpath placed;
  placed.toolpath = test::twoBeads();
  const auto refusal = [&] {
    try {
      desk_.placeOf(goal, placed);
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(), "");
  goal.laid_volume = std::nan("");
  EXPECT_EQ(refusal(), "laid_volume is nan m3; expected 0 m3 or more");
  goal.laid_volume = -1e-9;
  EXPECT_EQ(refusal(), "laid_volume is -1e-09 m3; expected 0 m3 or more");
  goal.laid_volume = 0.0;
  goal.laid_length = std::nan("");
  EXPECT_EQ(refusal(), "the length of beads reported as laid is nan mm; expected 0 mm or more");
}

}  // namespace
}  // namespace lamina
