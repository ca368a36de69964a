// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/servoj_drive.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/servo/emulated_robot.hpp"
#include "servo/servo_arm.hpp"
#include "servo/soon.hpp"

namespace lamina::test {
namespace {

/// Of a drive whose host and robot may stand for as long as a loaded machine has them stand.
ServojDriveSettings patientDrive(std::uint16_t script_port) {
  ServojDriveSettings settings;
  settings.robot.script_port = script_port;
  settings.robot.port = 0;
  settings.robot.report_silence_s = 60.0;
  settings.servoj.silence_s = 60.0;
  settings.cyclic.late_cycles = 1e5;
  return settings;
}

bool connects(ServojDrive& drive) {
  return isSoon([&] { return drive.keepConnected().empty(); });
}

/// From where the first joint is, by 0.2 rad, within a second.
TrajectoryChunk onward(double from, double by = 0.2) {
  const double begin_s = SteadyClock().now() + 0.1;
  return {{jointPoint(begin_s, sixValues(from), sixValues(0.0)),
           jointPoint(begin_s + 1.0, sixValues(from + by), sixValues(0.0))}};
}

/// A minute by 0.04 rad/s: long enough to be interrupted.
TrajectoryChunk slowly(double from) {
  TrajectoryChunk chunk = onward(from, 2.4);
  chunk.points[1].time_s += 59.0;
  return chunk;
}

TEST(ServojDrive, LeadsARobotWhereItIsToGo) {
  EmulatedRobot robot({}, sixValues(0.25));
  ServojDrive drive(sixJoints(), patientDrive(robot.port()));
  EXPECT_THROW(drive.accept(onward(0.25)), Disconnected);
  ASSERT_TRUE(connects(drive));
  EXPECT_NEAR(drive.state().actual[0], 0.25, 1e-6);
  EXPECT_NE(drive.rights().find("real time"), std::string::npos);
  EXPECT_THROW(drive.accept(onward(0.5)), InvalidInput) << "not where the robot is";
  drive.accept(onward(0.25));
  ASSERT_TRUE(isSoon([&] { return drive.state().is_at_rest; }));
  EXPECT_EQ(drive.state().fault, "");
  EXPECT_TRUE(isSoon([&] { return std::abs(robot.report().position[0] - 0.45) < 1e-4; }));
  EXPECT_TRUE(isSoon([&] { return std::abs(drive.state().actual[0] - 0.45) < 1e-4; }));
}

TEST(ServojDrive, SaysThatTheRobotHasStoppedAndCallsItAgain) {
  EmulatedRobot robot({}, sixValues(0.0));
  ServojDrive drive(sixJoints(), patientDrive(robot.port()));
  ASSERT_TRUE(connects(drive));
  drive.accept(slowly(0.0));
  ASSERT_TRUE(isSoon([&] { return robot.report().position[0] > 0.02; }));
  robot.stop();
  ASSERT_TRUE(isSoon([&] { return drive.state().is_at_rest; }));
  EXPECT_EQ(drive.state().fault, "the robot has ended its program");
  EXPECT_FALSE(drive.state().is_connected);
  ASSERT_TRUE(connects(drive));
  drive.accept(onward(drive.state().actual[0]));
  EXPECT_EQ(drive.state().fault, "");
}

TEST(ServojDrive, BrakesOnThePathAtItsEnd) {
  EmulatedRobot robot({}, sixValues(0.0));
  {
    ServojDrive drive(sixJoints(), patientDrive(robot.port()));
    ASSERT_TRUE(connects(drive));
    drive.accept(slowly(0.0));
    ASSERT_TRUE(isSoon([&] { return robot.report().position[0] > 0.02; }));
  }
  ASSERT_TRUE(isSoon([&] { return robot.isAtRest(); }));
  EXPECT_EQ(robot.report().state, ServojState::Ended);
  EXPECT_LT(robot.report().position[0], 2.0);
}

TEST(ServojDrive, BrakesWhenItIsAskedTo) {
  EmulatedRobot robot({}, sixValues(0.0));
  ServojDrive drive(sixJoints(), patientDrive(robot.port()));
  ASSERT_TRUE(connects(drive));
  drive.accept(slowly(0.0));
  ASSERT_TRUE(isSoon([&] { return robot.report().position[0] > 0.02; }));
  drive.brake();
  ASSERT_TRUE(isSoon([&] { return drive.state().is_at_rest; }));
  EXPECT_EQ(drive.state().fault, "");
  EXPECT_TRUE(drive.state().is_connected);
}

/// The test is the robot: it calls back, and does what no robot does.
TEST(ServojDrive, NamesWhatIsWrongWithTheLink) {
  const TcpSocket scripts = TcpSocket::listeningOn("127.0.0.1", 0);
  ServojDriveSettings settings = patientDrive(scripts.port());
  ServojDrive drive(sixJoints(), settings);
  EXPECT_NE(drive.keepConnected().find("has not called back"), std::string::npos);
  const ReportBytes good = reportBytes({ServojState::Following, 1, sixValues(0.1)});
  const auto call = [&] {
    TcpSocket robot = TcpSocket::connectedTo("127.0.0.1", drive.port(), 1.0);
    EXPECT_TRUE(robot.send({good.data(), good.size()}));
    EXPECT_TRUE(connects(drive));
    drive.accept(slowly(0.1));
    return robot;
  };
  const auto ends = [&] {
    EXPECT_TRUE(isSoon([&] { return !drive.state().is_connected; }));
    return drive.state().fault;
  };
  TcpSocket robot = call();
  robot.send(std::string(32, 'x'));
  EXPECT_EQ(ends(), "the robot sent what is no report");
  robot = call();
  const ReportBytes silent = reportBytes({ServojState::Silent, 1, sixValues(0.1)});
  robot.send({silent.data(), silent.size()});
  EXPECT_EQ(ends(), "the robot heard nothing in time and has stopped");
  robot = call();
  robot.close();
  EXPECT_EQ(ends(), "the robot has ended its program");
  EXPECT_THROW(drive.accept(onward(0.1)), Disconnected);
}

TEST(ServojDrive, CountsARobotAsLostThatReportsNothing) {
  const TcpSocket scripts = TcpSocket::listeningOn("127.0.0.1", 0);
  ServojDriveSettings settings = patientDrive(scripts.port());
  settings.robot.report_silence_s = 0.02;
  ServojDrive drive(sixJoints(), settings);
  const TcpSocket robot = TcpSocket::connectedTo("127.0.0.1", drive.port(), 1.0);
  drive.keepConnected();
  ASSERT_TRUE(isSoon([&] { return drive.keepConnected().find("has not called back") != std::string::npos; }));
  try {
    drive.accept(onward(0.1));
    FAIL() << "no robot is there";
  } catch (const Disconnected& error) {
    EXPECT_NE(std::string(error.what()).find("the robot reports nothing"), std::string::npos);
  }
}

TEST(ServojDrive, TakesRobotsOfSixRotaryJointsOnly) {
  std::vector<DrivenJoint> joints = sixJoints();
  joints.pop_back();
  EXPECT_THROW(ServojDrive(joints, patientDrive(1)), InvalidConfig);
  joints.push_back({"rail", JointKind::Linear, 0.0, 1000.0, 100.0});
  EXPECT_THROW(ServojDrive(joints, patientDrive(1)), InvalidConfig);
  ServojDriveSettings elsewhere = patientDrive(1);
  elsewhere.robot.bind = "everywhere";
  EXPECT_THROW(ServojDrive(sixJoints(), elsewhere), InvalidConfig);
}

}  // namespace
}  // namespace lamina::test
