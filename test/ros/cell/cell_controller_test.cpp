// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The nodes cell_controller and gcode_streamer at an emulated machine that outlives both.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "lamina/base/scratch_folder.hpp"
#include "lamina/streaming/job/streamable_program.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "ros/loop/streamed_machine.hpp"
#include "ros/node_process.hpp"
#include "ros/ros_home.hpp"
#include "ros/wait_until.hpp"

namespace lamina {
namespace {

using test::waitUntil;
using Command = lamina_msgs::PackmlCommand::Request;
constexpr int kAccepted = 1;

/// A square of a few hundred motions.
std::string squareProgram(int motions) {
  std::string text = "M83\nG1 Z0.2 F6000\nG1 X50 Y50 F6000\n";
  for (int i = 0; i < motions; ++i)
    text += "G1 X" + std::to_string(50 + i % 100) + " Y" + std::to_string(50 + (i * 7) % 90) + " E0.05\n";
  return text;
}

std::vector<std::string> commandsOf(const std::string& text) {
  std::vector<std::string> commands;
  ProgramCursor cursor = StreamableProgram::fromText("program", text).open();
  while (const auto line = cursor.next()) commands.push_back(line->command);
  return commands;
}

/// A cell in a namespace of its own: machine, streamer and controller, of which the nodes can be killed.
class CellOfNodes {
 public:
  CellOfNodes(const std::string& name, double speed_up, std::vector<std::string> parameters = {})
      : parameters_(std::move(parameters)),
        space_("/" + name),
        port_(test::inRosHome("cell_" + name)),
        machine(speed_up, port_) {
    const boost::function<void(const lamina_msgs::PackmlStatusConstPtr&)> on_status =
        [this](const auto& message) {
          status = *message;
          if (states.empty() || states.back() != message->state_name) states.push_back(message->state_name);
          const auto& accepted = message->accepted_now;
          if (message->state_name == "Starting" &&
              std::find(accepted.begin(), accepted.end(), Command::HOLD) != accepted.end())
            could_hold_while_starting = true;
        };
    const boost::function<void(const lamina_msgs::CellAlarmsConstPtr&)> on_alarms =
        [this](const auto& message) { alarms = *message; };
    const boost::function<void(const lamina_msgs::JobQueueConstPtr&)> on_queue = [this](const auto& message) {
      queue = *message;
    };
    subscribers_ = {
        node_.subscribe<lamina_msgs::PackmlStatus>(space_ + '/' + names::kPackmlStatus, 1000, on_status),
        node_.subscribe<lamina_msgs::CellAlarms>(space_ + '/' + names::kAlarms, 100, on_alarms),
        node_.subscribe<lamina_msgs::JobQueue>(space_ + '/' + names::kJobQueue, 100, on_queue)};
    startStreamer();
    startController();
  }

  void startStreamer() {
    streamer = std::make_unique<test::NodeProcess>(
        LAMINA_STREAMER_NODE,
        std::vector<std::string>{"__ns:=" + space_, "_port:=" + port_,
                                 "_stream/journal:=" + folder.path() + "/progress", "_stream/settle_s:=0.01",
                                 "_stream/probe_after_s:=0.3"});
  }
  void startController() {
    status = {};
    std::vector<std::string> arguments = {"__ns:=" + space_, "_journal/folder:=" + folder.path() + "/cell",
                                          "_executor/patience_s:=20"};
    arguments.insert(arguments.end(), parameters_.begin(), parameters_.end());
    controller = std::make_unique<test::NodeProcess>(LAMINA_CELL_NODE, arguments);
    EXPECT_TRUE(waitUntil([this] { return status.state != 0; }));
  }

  int command(std::uint8_t command, std::uint8_t cut_off = Command::UNDECIDED, std::int64_t expected = -1) {
    lamina_msgs::PackmlCommand call;
    call.request.command = command;
    call.request.source = "test";
    call.request.cut_off = cut_off;
    call.request.expected_sequence = expected;
    EXPECT_TRUE(ros::service::call(space_ + '/' + names::kPackmlCommand, call));
    reason = call.response.message;
    return call.response.result;
  }
  /// Starts as soon as the executor is known to be there.
  bool starts(std::uint8_t cut_off = Command::UNDECIDED) {
    bool is_started = false;
    const bool is_in_time = waitUntil([&] {
      is_started = is_started || command(Command::START, cut_off) == kAccepted;
      return is_started;
    });
    EXPECT_TRUE(is_in_time) << reason;
    return is_in_time;
  }
  bool reaches(const std::string& state) {
    const bool is_there = waitUntil([&] { return status.state_name == state; });
    if (!is_there) {
      std::string seen;
      for (const std::string& name : states) seen += name + ' ';
      ADD_FAILURE() << "not " << state << " but " << status.state_name << "; before: " << seen << "; "
                    << status.stop_message;
    }
    return is_there;
  }
  std::uint32_t enqueue(const std::string& text) {
    const std::string path = folder.path() + "/part.gcode";
    std::ofstream(path) << text;
    lamina_msgs::EnqueueJob call;
    call.request.program = path;
    call.request.name = "square";
    call.request.part = "square.stl";
    call.request.source = "test";
    EXPECT_TRUE(ros::service::call(space_ + '/' + names::kEnqueueJob, call));
    reason = call.response.status.message;
    return call.response.job;
  }
  std::string change(std::uint32_t job, std::uint8_t change) {
    lamina_msgs::ChangeQueue call;
    call.request.job = job;
    call.request.change = change;
    call.request.source = "test";
    EXPECT_TRUE(ros::service::call(space_ + '/' + names::kChangeQueue, call));
    return call.response.status.message;
  }
  void acknowledgeAll() {
    for (const lamina_msgs::CellAlarm& alarm : std::vector<lamina_msgs::CellAlarm>(alarms.alarms)) {
      lamina_msgs::AcknowledgeAlarm call;
      call.request.id = alarm.id;
      call.request.source = "test";
      EXPECT_TRUE(ros::service::call(space_ + '/' + names::kAcknowledgeAlarm, call));
    }
  }
  bool setMode(std::uint8_t mode) {
    lamina_msgs::SetUnitMode call;
    call.request.mode = mode;
    call.request.source = "test";
    EXPECT_TRUE(ros::service::call(space_ + '/' + names::kSetUnitMode, call));
    return call.response.result == kAccepted;
  }
  bool confirmRemoval() {
    std_srvs::Trigger call;
    EXPECT_TRUE(ros::service::call(space_ + '/' + names::kConfirmRemoval, call));
    return call.response.success;
  }
  void bringToIdle() {
    ASSERT_EQ(command(Command::RESET), kAccepted) << reason;
    ASSERT_TRUE(reaches("Idle"));
  }

  ScratchFolder folder;
  lamina_msgs::PackmlStatus status;
  lamina_msgs::CellAlarms alarms;
  lamina_msgs::JobQueue queue;
  std::vector<std::string> states;
  std::string reason;
  bool could_hold_while_starting = false;

 private:
  ros::NodeHandle node_;
  std::vector<std::string> parameters_;
  std::string space_;
  std::string port_;
  std::vector<ros::Subscriber> subscribers_;

 public:
  test::StreamedMachine machine;
  std::unique_ptr<test::NodeProcess> streamer;
  std::unique_ptr<test::NodeProcess> controller;
};

TEST(CellController, PrintsReleasedJobsOneAfterTheOther) {
  CellOfNodes cell("prints", 1000.0, {"_packml/hold_anywhere:=true"});
  EXPECT_EQ(cell.status.state_name, "Stopped");
  cell.bringToIdle();
  const std::string program = squareProgram(200);
  const std::uint32_t first = cell.enqueue(program);
  ASSERT_NE(first, 0U) << cell.reason;
  EXPECT_NE(cell.command(Command::START), kAccepted) << "not released";
  EXPECT_NE(cell.reason.find("no job of the queue"), std::string::npos) << cell.reason;
  EXPECT_EQ(cell.change(first, lamina_msgs::ChangeQueue::Request::RELEASE), "");
  EXPECT_TRUE(waitUntil([&] { return cell.queue.jobs.size() == 1 && cell.queue.jobs[0].state == 2; }));
  EXPECT_EQ(cell.queue.jobs[0].released_by, "test");
  EXPECT_EQ(cell.command(Command::START, Command::UNDECIDED, 0), 10) << "meant for another state";
  ASSERT_TRUE(cell.starts());
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_EQ(cell.machine.commands(), commandsOf(program));
  EXPECT_TRUE(cell.could_hold_while_starting);
  EXPECT_EQ(cell.status.parts, 1U);
  EXPECT_TRUE(cell.status.is_part_on_plate);
  EXPECT_NE(cell.change(first, lamina_msgs::ChangeQueue::Request::REVOKE), "") << "it has ended";
  cell.bringToIdle();
  EXPECT_FALSE(cell.setMode(9));
  EXPECT_TRUE(cell.setMode(2));
  EXPECT_TRUE(waitUntil([&] { return cell.status.mode_name == "Maintenance"; }));
  EXPECT_TRUE(cell.confirmRemoval());
  EXPECT_FALSE(cell.confirmRemoval());
}

TEST(CellController, IsLaunchedAndSaysThatItsExecutorIsMissing) {
  std::string state;
  ros::NodeHandle node;
  const boost::function<void(const lamina_msgs::PackmlStatusConstPtr&)> on_status = [&](const auto& message) {
    state = message->state_name;
  };
  const auto subscriber = node.subscribe<lamina_msgs::PackmlStatus>("/launched/packml_status", 10, on_status);
  EXPECT_TRUE(waitUntil([&] { return state == "Stopped"; }));
  lamina_msgs::PackmlCommand call;
  call.request.command = Command::RESET;
  call.request.expected_sequence = -1;
  EXPECT_TRUE(ros::service::call("/launched/packml_command", call));
  EXPECT_TRUE(waitUntil([&] { return state == "Idle"; }));
  call.request.command = Command::START;
  EXPECT_TRUE(ros::service::call("/launched/packml_command", call));
  EXPECT_NE(call.response.message.find("no sign of life"), std::string::npos) << call.response.message;
}

TEST(CellController, RefusesWhatTheMachineCannotPrint) {
  CellOfNodes cell("refuses", 1000.0);
  EXPECT_EQ(cell.enqueue("G1 X99999 Y0 E1 F6000\n"), 0U);
  EXPECT_NE(cell.reason.find("line 1 extrudes to"), std::string::npos) << cell.reason;
  EXPECT_EQ(cell.enqueue("G1 Xa\n"), 0U);
  EXPECT_TRUE(cell.queue.jobs.empty());
}

TEST(CellController, HoldsAndGoesOnAndStops) {
  CellOfNodes cell("holds", 20.0);
  cell.bringToIdle();
  cell.change(cell.enqueue(squareProgram(2000)), lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(cell.starts());
  ASSERT_TRUE(cell.reaches("Execute"));
  EXPECT_FALSE(cell.could_hold_while_starting);
  ASSERT_EQ(cell.command(Command::HOLD), kAccepted) << cell.reason;
  ASSERT_TRUE(cell.reaches("Held"));
  EXPECT_EQ(cell.status.stop_reason, 1001);
  EXPECT_LE(cell.status.in_state, cell.status.in_mode) << "the mode has not changed since the node began";
  EXPECT_TRUE(waitUntil([&] { return !cell.alarms.alarms.empty(); }));
  EXPECT_EQ(cell.alarms.alarms.front().category, "I");
  EXPECT_FALSE(cell.alarms.alarms.front().is_acknowledged);
  ASSERT_EQ(cell.command(Command::UNHOLD), kAccepted) << cell.reason;
  ASSERT_TRUE(cell.reaches("Execute"));
  ASSERT_EQ(cell.command(Command::STOP), kAccepted) << cell.reason;
  ASSERT_TRUE(cell.reaches("Stopped"));
  EXPECT_EQ(cell.status.job.id, 0U);
}

TEST(CellController, IsAdoptedByItsJobWhenItIsKilled) {
  CellOfNodes cell("adopts", 20.0);
  cell.bringToIdle();
  const std::string program = squareProgram(1500);
  cell.change(cell.enqueue(program), lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(cell.starts());
  ASSERT_TRUE(cell.reaches("Execute"));
  EXPECT_EQ(cell.controller->end(SIGKILL), -1);
  cell.startController();
  EXPECT_EQ(cell.status.state_name, "Execute");
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_EQ(cell.machine.commands(), commandsOf(program));
}

TEST(CellController, OffersTheJobOfAKilledStreamerAndRunsEachLineOnce) {
  CellOfNodes cell("resumes", 20.0);
  cell.bringToIdle();
  const std::string program = squareProgram(1500);
  cell.change(cell.enqueue(program), lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(cell.starts());
  EXPECT_TRUE(waitUntil([&] { return cell.status.lines_acknowledged > 100; }));
  EXPECT_EQ(cell.streamer->end(SIGKILL), -1);
  cell.startStreamer();
  ASSERT_TRUE(cell.reaches("Aborted"));
  EXPECT_TRUE(cell.status.resume_waits);
  bool is_clearing = false;
  EXPECT_TRUE(waitUntil([&] {
    cell.acknowledgeAll();
    is_clearing = is_clearing || cell.command(Command::CLEAR) == kAccepted;
    return is_clearing;
  })) << cell.reason;
  ASSERT_TRUE(cell.reaches("Stopped"));
  cell.bringToIdle();
  EXPECT_NE(cell.command(Command::START), kAccepted) << "nothing goes on by itself";
  ASSERT_TRUE(cell.starts(Command::RESUME));
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_EQ(cell.machine.commands(), commandsOf(program));
}

}  // namespace
}  // namespace lamina

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "cell_controller_test");
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
