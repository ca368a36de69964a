// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/scratch_folder.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "ros/node_process.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"

namespace lamina::test {

using Command = lamina_msgs::PackmlCommand::Request;
constexpr int kAccepted = 1;

/// Runs a command of the shell; its exit code.
inline int runs(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The unit of a cell in a namespace of its own, whose controller can be killed, as a client of it sees it.
class UnitOfNodes {
 public:
  /// @param parameters  of the controller, which is not started yet
  UnitOfNodes(const std::string& name, std::vector<std::string> parameters)
      : space_("/" + name), parameters_(std::move(parameters)) {
    const boost::function<void(const lamina_msgs::PackmlStatusConstPtr&)> on_status =
        [this](const auto& message) {
          if (message->header.stamp < launched_) return;  // of a controller that was killed
          status = *message;
          if (states.empty() || states.back() != message->state_name) states.push_back(message->state_name);
          const auto& accepted = message->accepted_now;
          if (message->state_name == "Starting" &&
              std::find(accepted.begin(), accepted.end(), Command::HOLD) != accepted.end())
            could_hold_while_starting = true;
        };
    const boost::function<void(const lamina_msgs::CellAlarmsConstPtr&)> on_alarms =
        [this](const auto& message) {
          if (message->header.stamp >= launched_) alarms = *message;
        };
    const boost::function<void(const lamina_msgs::JobQueueConstPtr&)> on_queue = [this](const auto& message) {
      queue = *message;
    };
    subscribers_ = {
        node_.subscribe<lamina_msgs::PackmlStatus>(space_ + '/' + names::kPackmlStatus, 1000, on_status),
        node_.subscribe<lamina_msgs::CellAlarms>(space_ + '/' + names::kAlarms, 100, on_alarms),
        node_.subscribe<lamina_msgs::JobQueue>(space_ + '/' + names::kJobQueue, 100, on_queue)};
  }

  /// Waits for its first state.
  void startController() {
    launchController();
    EXPECT_TRUE(waitUntil([this] { return status.state != 0; }));
  }
  void launchController(const std::vector<std::string>& environment = {}) {
    launched_ = ros::Time::now();
    status = {};
    alarms = {};
    std::vector<std::string> arguments = {"_journal/folder:=" + folder.path() + "/cell",
                                          "_executor/patience_s:=20"};
    arguments.insert(arguments.end(), parameters_.begin(), parameters_.end());
    controller = start(environment, LAMINA_CELL_NODE, arguments);
  }
  std::string journalFile() const { return folder.path() + "/cell/cell.db"; }

  /// Of a resume all is confirmed that a person has to, as it was seen last.
  /// @return the result; 0 if the node did not answer
  int command(std::uint8_t command, std::uint8_t cut_off = Command::UNDECIDED, std::int64_t expected = -1) {
    lamina_msgs::PackmlCommand call;
    for (const lamina_msgs::ResumeStep& step : status.resume_steps)
      if (step.state == lamina_msgs::ResumeStep::PERSON) call.request.confirmed.push_back(step.name);
    call.request.confirmed_length = confirmed_length;
    call.request.command = command;
    call.request.source = "test";
    call.request.cut_off = cut_off;
    call.request.expected_sequence = expected;
    if (!callService(space_ + '/' + names::kPackmlCommand, call)) return 0;
    reason = call.response.message;
    return call.response.result;
  }
  /// Why a command of somebody else is refused; empty if it is accepted.
  std::string refusalOf(std::uint8_t command, const std::string& source,
                        std::uint8_t cut_off = Command::UNDECIDED) {
    lamina_msgs::PackmlCommand call;
    call.request.command = command;
    call.request.cut_off = cut_off;
    call.request.source = source;
    call.request.expected_sequence = -1;
    return callService(space_ + '/' + names::kPackmlCommand, call) ? call.response.message : "no answer";
  }
  /// Why a command that nobody waits for any more is refused.
  std::string refusalOfExpired(std::uint8_t command) {
    lamina_msgs::PackmlCommand call;
    call.request.command = command;
    call.request.source = "test";
    call.request.expected_sequence = -1;
    call.request.expires = ros::Time(ros::WallTime::now().toSec() - 10.0);
    return callService(space_ + '/' + names::kPackmlCommand, call) ? call.response.message : "no answer";
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
  /// Puts a file of that text into the queue.
  std::uint32_t enqueue(const std::string& text, const std::string& file = "part.gcode") {
    const std::string path = folder.path() + '/' + file;
    std::ofstream(path) << text;
    lamina_msgs::EnqueueJob call;
    call.request.program = path;
    call.request.name = "square";
    call.request.part = "square.stl";
    call.request.source = "test";
    EXPECT_TRUE(callService(space_ + '/' + names::kEnqueueJob, call));
    reason = call.response.status.message;
    return call.response.job;
  }
  std::string change(std::uint32_t job, std::uint8_t change) {
    lamina_msgs::ChangeQueue call;
    call.request.job = job;
    call.request.change = change;
    call.request.source = "test";
    EXPECT_TRUE(callService(space_ + '/' + names::kChangeQueue, call));
    return call.response.status.message;
  }
  bool hasAlarm(int id) const {
    return std::any_of(alarms.alarms.begin(), alarms.alarms.end(),
                       [id](const lamina_msgs::CellAlarm& alarm) { return alarm.id == id; });
  }
  void acknowledgeAll() {
    for (const lamina_msgs::CellAlarm& alarm : std::vector<lamina_msgs::CellAlarm>(alarms.alarms)) {
      lamina_msgs::AcknowledgeAlarm call;
      call.request.id = alarm.id;
      call.request.source = "test";
      callService(space_ + '/' + names::kAcknowledgeAlarm, call);
    }
  }
  bool setMode(std::uint8_t mode) {
    lamina_msgs::SetUnitMode call;
    call.request.mode = mode;
    call.request.source = "test";
    EXPECT_TRUE(callService(space_ + '/' + names::kSetUnitMode, call));
    return call.response.result == kAccepted;
  }
  bool confirmRemoval(const std::string& source) {
    std_srvs::Trigger call;
    auto client = node_.serviceClient<std_srvs::Trigger>(space_ + '/' + names::kConfirmRemoval, true,
                                                         {{"lamina_source", source}});
    return client.call(call) && call.response.success;
  }
  /// Whether the journal, or what is on its way into it, has that text.
  bool isInJournal(const std::string& text) const {
    const auto has = [&text](const std::string& path) {
      std::ifstream file(path, std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(file), {}};
      return bytes.find(text) != std::string::npos;
    };
    return has(journalFile()) || has(journalFile() + "-wal");
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
  std::vector<double> confirmed_length;  ///< with each command
  bool could_hold_while_starting = false;
  std::unique_ptr<NodeProcess> controller;

 protected:
  std::unique_ptr<NodeProcess> start(const std::vector<std::string>& environment, const std::string& node,
                                     const std::vector<std::string>& parameters) const {
    std::vector<std::string> arguments = environment;
    arguments.push_back(node);
    arguments.push_back("__ns:=" + space_);
    arguments.insert(arguments.end(), parameters.begin(), parameters.end());
    return std::make_unique<NodeProcess>("/usr/bin/env", arguments);
  }

  ros::NodeHandle node_;
  const std::string space_;

 private:
  ros::Time launched_;
  std::vector<std::string> parameters_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace lamina::test
