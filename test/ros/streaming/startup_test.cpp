// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs start-up sequences of the node gcode_streamer on machines of the node emulated_machine.
#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cstdio>
#include <fstream>

#include "lamina/startup/program_identity.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"
#include "support/scratch_folder.hpp"

namespace {

using lamina::test::kPatience;
using lamina::test::waitUntil;
using lamina_msgs::MachineState;
using lamina_msgs::RunStartup;
using lamina_msgs::StartupStep;
using lamina_msgs::Status;
using Client = actionlib::SimpleActionClient<lamina_msgs::StreamProgramAction>;

/// A streamer node and what it reports.
class Cell {
 public:
  explicit Cell(const std::string& name) : node_(name), client_(node_, lamina::names::kStreamProgram, true) {
    EXPECT_TRUE(client_.waitForServer(ros::Duration(kPatience)));
    subscriber_ = node_.subscribe<MachineState>(lamina::names::kMachineState, 1000,
                                                [this](const auto& message) { state_ = message; });
    EXPECT_TRUE(waitUntil([this] { return state_ != nullptr; }));
  }

  StartupStep step(const std::string& name) const {
    for (const StartupStep& each : state_->startup)
      if (each.name == name) return each;
    ADD_FAILURE() << "no step " << name;
    return {};
  }
  bool waitFor(const std::string& name, std::uint8_t state) {
    const bool has_come = waitUntil([&] { return step(name).state == state; });
    EXPECT_TRUE(has_come) << name << " is " << step(name).state_name << ": " << step(name).reason;
    return has_come;
  }
  Status call(RunStartup::Request request) {
    RunStartup service;
    service.request = std::move(request);
    EXPECT_TRUE(lamina::callService(node_.resolveName(lamina::names::kRunStartup), service));
    return service.response.status;
  }
  Status call(std::uint8_t command, const std::string& name = "") {
    RunStartup::Request request;
    request.command = command;
    request.step = name;
    return call(request);
  }
  Status stream(const std::string& program) {
    lamina_msgs::StreamProgramGoal goal;
    goal.program = program;
    client_.sendGoal(goal);
    EXPECT_TRUE(waitUntil([&] { return client_.getState().isDone(); }));
    const auto given = client_.getResult();
    return given ? given->status : Status();
  }
  /// Runs everything up to the next step of the operator, as soon as no other step is being run.
  void run() {
    Status status;
    bool is_taken = false;
    EXPECT_TRUE(waitUntil([&] {
      if (is_taken) return true;
      status = call(RunStartup::Request::RUN);
      is_taken = status.code == Status::OK;
      return is_taken;
    })) << status.message;
  }
  void confirm(const std::string& name) {
    EXPECT_EQ(call(RunStartup::Request::CONFIRM, name).message, "");
    waitFor(name, StartupStep::DONE);
  }

 private:
  ros::NodeHandle node_;
  Client client_;
  ros::Subscriber subscriber_;
  MachineState::ConstPtr state_;
};

std::string hexadecimal(std::uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "%08x", value);
  return text;
}

class StartupSequence : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.file(name)) << text;
    return folder_.file(name);
  }
  static RunStartup::Request transferOf(const std::string& program) {
    const auto identity = lamina::identityOfFile(program);
    RunStartup::Request request;
    request.command = RunStartup::Request::CONFIRM;
    request.step = "transfer_program";
    request.program = program;
    request.bytes = identity.bytes;
    request.crc32 = hexadecimal(identity.crc32);
    return request;
  }

  lamina::test::ScratchFolder folder_;
};

TEST_F(StartupSequence, LetsAJobStartWhenEveryStepIsSatisfiedAndNoLongerWhenHomingIsLost) {
  Cell cell("tight");
  const std::string program = write("part.gcode", "G90\nG1 X100 Y100 Z50 F6000\nM84\n");
  const Status refused = cell.stream(program);
  EXPECT_EQ(refused.code, Status::REJECTED);
  EXPECT_NE(refused.message.find("dry_pellets is Pending"), std::string::npos) << refused.message;

  cell.confirm("power_on");
  const Status too_early = cell.call(RunStartup::Request::CONFIRM, "place_sheet");
  EXPECT_EQ(too_early.code, Status::REJECTED);
  EXPECT_NE(too_early.message.find("place_sheet must wait for home_x"), std::string::npos)
      << too_early.message;
  cell.run();
  cell.waitFor("home_z", StartupStep::DONE);
  EXPECT_NEAR(cell.step("heat_bed").value, 90.0, 2.0);
  cell.confirm("place_sheet");
  cell.run();
  cell.waitFor("map_heights", StartupStep::DONE);
  EXPECT_NEAR(cell.step("map_heights").value, 0.2, 0.005);  // the bump of the emulated bed
  cell.waitFor("dry_pellets", StartupStep::DONE);

  EXPECT_EQ(cell.call(transferOf(program)).message, "");
  cell.waitFor("transfer_program", StartupStep::DONE);
  EXPECT_EQ(cell.stream(program).message, "");

  cell.waitFor("home_x", StartupStep::PENDING);
  EXPECT_NE(cell.step("home_x").reason.find("M84 has switched the motors off"), std::string::npos);
  const Status again = cell.stream(program);
  EXPECT_EQ(again.code, Status::REJECTED);
  EXPECT_NE(again.message.find("home_x is Pending"), std::string::npos) << again.message;
  EXPECT_EQ(cell.step("heat_bed").state, StartupStep::DONE);

  EXPECT_EQ(cell.call(RunStartup::Request::ABORT).message, "");
  cell.waitFor("heat_bed", StartupStep::PENDING);
  EXPECT_NE(cell.step("heat_bed").reason.find("M140 S0"), std::string::npos) << cell.step("heat_bed").reason;
}

TEST_F(StartupSequence, ReportsWhichZoneLeaks) {
  Cell cell("leaky");
  EXPECT_EQ(cell.step("heat_bed").state, StartupStep::SKIPPED);
  cell.confirm("power_on");
  cell.run();
  cell.waitFor("home_z", StartupStep::DONE);
  cell.confirm("place_sheet");
  cell.run();
  cell.waitFor("draw_vacuum", StartupStep::FAILED);
  const StartupStep vacuum = cell.step("draw_vacuum");
  EXPECT_NE(vacuum.reason.find("zone 3 is at 7"), std::string::npos) << vacuum.reason;
  EXPECT_GE(vacuum.value, 70.0);
  EXPECT_EQ(vacuum.unit, "kPa");
  EXPECT_EQ(vacuum.expected, "under 40 kPa");
  const Status refused = cell.stream(write("part.gcode", "G1 X1\n"));
  EXPECT_EQ(refused.code, Status::REJECTED);
  EXPECT_NE(refused.message.find("zone 3"), std::string::npos) << refused.message;
}

TEST_F(StartupSequence, RefusesAProgramThatDidNotComeWhole) {
  Cell cell("tight");
  const std::string program = write("part.gcode", "G1 X1\nG1 X2\n");
  auto request = transferOf(program);
  request.bytes += 6;
  const Status cut = cell.call(request);
  EXPECT_EQ(cut.code, Status::INVALID_PROGRAM);
  EXPECT_NE(cut.message.find("has 12 bytes; expected 18"), std::string::npos) << cut.message;
  request = transferOf(program);
  request.crc32 = "00000000";
  EXPECT_EQ(cell.call(request).code, Status::INVALID_PROGRAM);
}

}  // namespace
