// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The nodes cell_controller and gcode_streamer at an emulated machine that outlives both.
#include <actionlib/client/simple_action_client.h>
#include <actionlib/server/action_server.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <csignal>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "nodes/cell_controller/stream_executor.hpp"
#include "ros/cell/cell_of_nodes.hpp"
#include "ros/loop/controlled_wall.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

using test::CellOfNodes;
using test::Command;
using test::commandsOf;
using test::kAccepted;
using test::runs;
using test::squareProgram;
using test::waitUntil;

TEST(CellController, PrintsReleasedJobsOneAfterTheOther) {
  CellOfNodes cell("prints", 1000.0);
  EXPECT_EQ(cell.status.state_name, "Stopped");
  const std::string late = cell.refusalOfExpired(Command::RESET);
  EXPECT_NE(late.find("after it had expired"), std::string::npos) << late;
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
  EXPECT_FALSE(cell.isInJournal("page: anna"));
  EXPECT_TRUE(cell.confirmRemoval("page: anna"));
  EXPECT_FALSE(cell.confirmRemoval("test"));
  EXPECT_TRUE(cell.isInJournal("page: anna"));
}

TEST(CellController, WritesTheRecordOfAPart) {
  CellOfNodes cell("records", 6.0, {"_journal/copy_hour:=0", "_journal/copies_kept:=2"});
  cell.bringToIdle();
  const std::string program = ";LAYER:0\n" + squareProgram(200) + ";LAYER:1\n" + squareProgram(200);
  const std::uint32_t job = cell.enqueue(program);
  cell.change(job, lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(cell.starts());
  ASSERT_TRUE(waitUntil([&] { return cell.status.remaining > 0.0; }));
  EXPECT_EQ(cell.status.layers, 2);
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_GT(cell.status.since_reset, 0.0);
  EXPECT_EQ(cell.status.elapsed, 0.0) << "its job has ended";
  const std::string folder = cell.folder.path();
  const std::string command = std::string(LAMINA_COMMAND) + " record " + folder + "/cell 1 ";
  EXPECT_EQ(runs(command + "--html " + folder + "/record.html > " + folder + "/text"), 0);
  EXPECT_EQ(runs(command + "--json > " + folder + "/record.json"), 0);
  EXPECT_EQ(runs(command + "--files " + folder + "/files > /dev/null"), 0);
  EXPECT_EQ(readFile(folder + "/files/part.gcode"), program);
  EXPECT_NE(readFile(folder + "/text").find("all digests are right"), std::string::npos);
  EXPECT_NE(readFile(folder + "/record.html").find("<h2>Layers</h2>"), std::string::npos);
  EXPECT_NE(readFile(folder + "/record.json").find("\"count\": 2"), std::string::npos) << "layers";
  EXPECT_EQ(runs("/usr/bin/python3 -c 'import json, jsonschema, sys; jsonschema.validate("
                 "json.load(open(sys.argv[1]))[\"record\"], json.load(open(sys.argv[2])))' " +
                 folder + "/record.json " + LAMINA_SOURCE_DIR + "/docs/cell/part_record.schema.json"),
            0);
  EXPECT_EQ(runs(std::string(LAMINA_COMMAND) + " audit " + folder + "/cell"), 0);
  EXPECT_TRUE(waitUntil([&] { return runs("ls " + folder + "/cell/copies/*.db > /dev/null 2>&1") == 0; }));
}

TEST(CellController, StartsNothingOverAnAuditThatWasChanged) {
  CellOfNodes cell("audited", 1000.0, {"_journal/least_free_gib:=1000000"});
  const std::uint32_t job = cell.enqueue(squareProgram(20));
  cell.change(job, lamina_msgs::ChangeQueue::Request::RELEASE);
  EXPECT_TRUE(waitUntil([&] { return cell.hasAlarm(7002); })) << "no disk has so much room";
  cell.controller.reset();
  const std::string folder = cell.folder.path() + "/cell";
  ASSERT_EQ(runs("/usr/bin/python3 -c 'import sqlite3, sys; database = sqlite3.connect(sys.argv[1]); "
                 "database.execute(\"UPDATE audit SET who = 1 WHERE id = 2\"); database.commit()' " +
                 folder + "/cell.db"),
            0);
  EXPECT_EQ(runs(std::string(LAMINA_COMMAND) + " audit --json " + folder + " > " + folder + "/audit.json"),
            1);
  EXPECT_NE(readFile(folder + "/audit.json").find("\"first_bad_row\": 2"), std::string::npos);
  cell.startController();
  EXPECT_TRUE(waitUntil([&] { return cell.hasAlarm(9003); }));
  cell.bringToIdle();
  EXPECT_EQ(cell.command(Command::START), 6);
  EXPECT_NE(cell.reason.find("row 2 of the audit"), std::string::npos) << cell.reason;
}

TEST(CellController, StartsNoJobWithoutTheLoopAndTheClocksThatItNeeds) {
  CellOfNodes cell("looped", 1000.0, {"_start/needs_loop:=true"});
  ros::NodeHandle node("looped");
  const std::uint32_t job = cell.enqueue(squareProgram(20));
  cell.change(job, lamina_msgs::ChangeQueue::Request::RELEASE);
  cell.bringToIdle();
  EXPECT_EQ(cell.command(Command::START), 6);
  EXPECT_NE(cell.reason.find("height_controller gives no sign of life"), std::string::npos) << cell.reason;

  const auto isRefusedFor = [&cell](const std::string& why) {
    return cell.command(Command::START) == 6 && cell.reason.find(why) != std::string::npos;
  };
  auto loop = node.advertise<lamina_msgs::LoopState>(names::kLoopState, 10, true);
  lamina_msgs::LoopState state;
  state.state = lamina_msgs::LoopState::BLOCKED;
  state.reason = "the sensor's pose is not calibrated";
  loop.publish(state);
  EXPECT_TRUE(waitUntil([&] { return isRefusedFor(state.reason); })) << cell.reason;

  auto reports = node.advertise<lamina_msgs::AlarmReport>("alarm_reports", 10);
  EXPECT_TRUE(waitUntil([&] { return reports.getNumSubscribers() > 0; }));
  lamina_msgs::AlarmReport clocks;
  clocks.id = 8003;
  clocks.source = "host_watch";
  clocks.message = "the clock of sensor is ahead by 8 ms";
  reports.publish(clocks);
  EXPECT_TRUE(waitUntil([&] { return cell.hasAlarm(8003); }));
  state.state = lamina_msgs::LoopState::ACTIVE;
  loop.publish(state);
  EXPECT_TRUE(waitUntil([&] { return isRefusedFor(clocks.message) && !isRefusedFor("calibrated"); }))
      << cell.reason;

  clocks.is_gone = true;
  reports.publish(clocks);
  EXPECT_TRUE(waitUntil([&] { return cell.alarms.alarms.empty(); }));
  EXPECT_TRUE(cell.starts()) << cell.reason;
  EXPECT_TRUE(cell.reaches("Complete"));
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
  EXPECT_TRUE(callService("/launched/packml_command", call));
  EXPECT_TRUE(waitUntil([&] { return state == "Idle"; }));
  call.request.command = Command::START;
  EXPECT_TRUE(callService("/launched/packml_command", call));
  EXPECT_NE(call.response.message.find("no sign of life"), std::string::npos) << call.response.message;
}

TEST(CellController, RefusesWhatTheMachineCannotPrint) {
  CellOfNodes cell("refuses", 1000.0);
  const auto kept = [&cell] {
    const std::filesystem::directory_iterator files(cell.folder.path() + "/cell/artefacts");
    return std::distance(begin(files), end(files));
  };
  EXPECT_EQ(kept(), 0);
  EXPECT_EQ(cell.enqueue("G1 X99999 Y0 E1 F6000\n"), 0U);
  EXPECT_NE(cell.reason.find("line 1 extrudes to"), std::string::npos) << cell.reason;
  EXPECT_EQ(cell.enqueue("G1 Xa\n"), 0U);
  EXPECT_TRUE(cell.queue.jobs.empty());
  EXPECT_EQ(kept(), 0) << "nothing of what was refused";
}

TEST(CellController, HoldsAndGoesOnAndStops) {
  CellOfNodes cell("holds", 20.0, {"_packml/hold_anywhere:=false"});
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

TEST(CellController, HoldsAJobThatStarts) {
  CellOfNodes cell("early", 1000.0);
  cell.bringToIdle();
  const std::string program = squareProgram(200);
  cell.change(cell.enqueue(program), lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(cell.starts());
  ASSERT_EQ(cell.command(Command::HOLD), kAccepted) << cell.reason;
  ASSERT_TRUE(cell.reaches("Held"));
  ASSERT_EQ(cell.command(Command::UNHOLD), kAccepted) << cell.reason;
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_EQ(cell.machine.commands(), commandsOf(program));
}

// However long its program is read, and whatever is said of the machine meanwhile.
TEST(StreamExecutor, AwaitsAJobThatWasTakenUpAsLongAsItIsPrepared) {
  ros::NodeHandle node("prepares");
  actionlib::ActionServer<lamina_msgs::StreamProgramAction>::GoalHandle taken;
  actionlib::ActionServer<lamina_msgs::StreamProgramAction> streamer(
      node, names::kStreamProgram, [&taken](auto goal) { taken = goal; }, [](auto) {}, false);
  streamer.start();
  StreamExecutor executor(node, [](const ExecutorReport&) {});
  ASSERT_TRUE(waitUntil([&] { return executor.isThere(); }));
  executor.start({"/tmp/part.gcode", ExecutionStart::Anew, 1, "first"});
  ASSERT_TRUE(waitUntil([&] { return taken.getGoal() != nullptr; }));
  const double none_s = 1e-9;
  EXPECT_EQ(executor.takeUnanswered(none_s), "start");
  taken.setAccepted();
  EXPECT_TRUE(waitUntil([&] { return executor.takeUnanswered(none_s).empty(); }));
}

/// What is said of a job that ends with this status.
ExecutorReport reportOf(const lamina_msgs::Status& status, const std::string& name) {
  ros::NodeHandle node(name);
  actionlib::ActionServer<lamina_msgs::StreamProgramAction>::GoalHandle taken;
  actionlib::ActionServer<lamina_msgs::StreamProgramAction> streamer(
      node, names::kStreamProgram, [&taken](auto goal) { taken = goal; }, [](auto) {}, false);
  streamer.start();
  std::vector<ExecutorReport> reports;
  StreamExecutor executor(node, [&reports](const ExecutorReport& report) { reports.push_back(report); });
  EXPECT_TRUE(waitUntil([&] { return executor.isThere(); }));
  executor.start({"/tmp/part.gcode", ExecutionStart::Anew, 1, "first"});
  EXPECT_TRUE(waitUntil([&] { return taken.getGoal() != nullptr; }));
  taken.setAccepted();
  lamina_msgs::StreamProgramResult result;
  result.status = status;
  result.lines_acknowledged = 3;
  taken.setAborted(result);
  EXPECT_TRUE(waitUntil([&] { return !reports.empty(); }));
  return reports.empty() ? ExecutorReport() : reports.back();
}

// A job whose machine was told to stop is not offered to be resumed: the streamer would refuse it. A link
// that did not come back has told it nothing.
TEST(StreamExecutor, SaysWhetherTheMachineWasStoppedWithAJobThatRan) {
  using Status = lamina_msgs::Status;
  ros::NodeHandle node("stopped_with");
  actionlib::ActionServer<lamina_msgs::StreamProgramAction>::GoalHandle taken;
  actionlib::ActionServer<lamina_msgs::StreamProgramAction> streamer(
      node, names::kStreamProgram, [&taken](auto goal) { taken = goal; }, [](auto) {}, false);
  streamer.start();
  ros::Publisher states = node.advertise<lamina_msgs::MachineState>(names::kMachineState, 10, true);
  std::vector<ExecutorReport> reports;
  StreamExecutor executor(node, [&reports](const ExecutorReport& report) { reports.push_back(report); });
  EXPECT_TRUE(waitUntil([&] { return executor.isThere() && states.getNumSubscribers() > 0; }));
  std::uint64_t order = 0;
  const auto isLost = [&](std::uint8_t state, std::uint8_t code, const std::string& message) {
    taken = {};
    reports.clear();
    executor.start({"/tmp/part.gcode", ExecutionStart::Resume, ++order, "same"});
    EXPECT_TRUE(waitUntil([&] { return taken.getGoal() != nullptr; }));
    taken.setAccepted();
    lamina_msgs::MachineState machine;
    machine.state = state;
    states.publish(machine);
    EXPECT_TRUE(waitUntil([&] { return !reports.empty(); }));
    lamina_msgs::StreamProgramResult result;
    result.status.code = code;
    result.status.message = message;
    result.lines_acknowledged = 300;
    taken.setAborted(result);
    EXPECT_TRUE(waitUntil([&] { return isAtRest(reports.back().phase); }));
    return reports.back().has_lost_motions;
  };
  constexpr std::uint8_t kRuns = lamina_msgs::MachineState::EXECUTE;
  const std::string gone = "the port is gone; line 300 of 403 was the last acknowledged";
  EXPECT_TRUE(isLost(kRuns, Status::TIMED_OUT, "no answer from the machine for 31 s"));
  EXPECT_TRUE(isLost(kRuns, Status::DISCONNECTED, gone));
  EXPECT_FALSE(isLost(kRuns, Status::DISCONNECTED,
                      gone + "; the link did not come back, so that the machine was not commanded to stop: "
                             "look after it"));
  EXPECT_FALSE(isLost(kRuns, Status::DISCONNECTED,
                      "nothing was heard of the machine for 60 s; it may still be printing, and hot: look "
                      "after it"));
  EXPECT_FALSE(
      isLost(lamina_msgs::MachineState::STARTING, Status::TIMED_OUT, "no machine answered within 10 s"))
      << "the journal keeps what was known before";
}

// Who cancels a job has given it up; whose process is ended has not.
TEST(StreamExecutor, RaisesTheAlarmOfWhatHasEndedAJob) {
  using Status = lamina_msgs::Status;
  struct End {
    std::uint8_t code;
    std::string message;
    int alarm;
  };
  const std::string halted = "the machine halted: ";
  const std::vector<End> ends = {
      {Status::CANCELLED, std::string(names::kNodeEnded) + "; the machine did not confirm the safe stop",
       2202},
      {Status::CANCELLED, "aborted on request", 0},
      {Status::DEVICE_ERROR, "the machine was reset; line 3 of 9 was the last acknowledged", 3102},
      {Status::DEVICE_ERROR, "a line was answered that was not sent", 3106},
      {Status::REJECTED, halted + "\"Error:Printer halted. kill() called!\"", 3103},
      {Status::REJECTED, halted + "\"Error:Thermal Runaway, system stopped! Heater_ID: 0\"", 3104},
      {Status::REJECTED, halted + "\"// Klipper state: Shutdown\"; Heater bed not heating at expected rate",
       3104},
      {Status::REJECTED, "the machine refused line 3 'G5' (error:20)", 3106}};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    Status status;
    status.code = ends[i].code;
    status.message = ends[i].message;
    const ExecutorReport report = reportOf(status, "ends_" + std::to_string(i));
    EXPECT_EQ(report.alarm, ends[i].alarm) << status.message;
    EXPECT_EQ(report.failure, status.message);
    EXPECT_EQ(report.has_lost_motions, status.code == Status::CANCELLED) << status.message;
  }
}

TEST(CellController, AbortsAndOffersTheJobOfAStreamerThatIsEnded) {
  CellOfNodes cell("ended", 20.0);
  cell.bringToIdle();
  cell.change(cell.enqueue(squareProgram(4000)), lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(cell.starts());
  EXPECT_TRUE(waitUntil([&] { return cell.status.lines_acknowledged > 100; }));
  EXPECT_EQ(cell.streamer->end(SIGTERM), 0);
  ASSERT_TRUE(cell.reaches("Aborted"));
  EXPECT_EQ(cell.status.stop_reason, 2202);
  EXPECT_TRUE(cell.status.resume_waits);
}

TEST(CellController, HasItsMachineStoppedByTheWatchWhenTheStreamerDies) {
  CellOfNodes cell("guarded", 20.0);
  const test::NodeProcess watch(
      LAMINA_WATCH_NODE,
      {"__ns:=/guarded", "__name:=host_watch", "_guard/grace_s:=0", "_guard/socket:=" + cell.guardSocket()});
  cell.bringToIdle();
  cell.change(cell.enqueue("M104 S200\nM140 S60\n" + squareProgram(4000)),
              lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(waitUntil([&] { return std::filesystem::exists(cell.guardSocket()); }));
  ASSERT_TRUE(cell.starts());
  ASSERT_TRUE(waitUntil([&] { return cell.machine.commands().size() > 50; }));
  EXPECT_EQ(cell.machine->nozzleTarget(), 200.0);
  cell.streamer->end(SIGKILL);
  EXPECT_TRUE(waitUntil([&] { return cell.hasAlarm(2203); }));
  EXPECT_EQ(cell.machine->nozzleTarget(), 0.0);
  EXPECT_EQ(cell.machine->bedTarget(), 0.0);
  ASSERT_TRUE(cell.reaches("Aborted"));
  ASSERT_TRUE(waitUntil([&] { return !cell.queue.jobs.empty() && cell.queue.jobs[0].state == 4; }))
      << "the job is interrupted";
}

TEST(CellController, OwnsItsExecutor) {
  CellOfNodes cell("owns", 20.0);
  cell.bringToIdle();
  const std::string program = squareProgram(1000);
  cell.change(cell.enqueue(program), lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(cell.starts());
  ASSERT_TRUE(cell.reaches("Execute"));
  for (const char* service : {names::kPause, names::kResume, names::kAbort}) {
    std_srvs::Trigger call;
    EXPECT_TRUE(callService("/owns/" + std::string(service), call));
    EXPECT_FALSE(call.response.success);
    EXPECT_EQ(
        call.response.message,
        "orders are taken from /owns/cell_controller alone, and this one is from /cell_controller_test");
  }
  actionlib::SimpleActionClient<lamina_msgs::StreamProgramAction> stranger(
      "/owns/" + std::string(names::kStreamProgram), false);
  ASSERT_TRUE(waitUntil([&] { return stranger.isServerConnected(); }));
  lamina_msgs::StreamProgramGoal goal;
  goal.program = cell.folder.path() + "/part.gcode";
  stranger.cancelAllGoals();
  stranger.sendGoal(goal);
  EXPECT_TRUE(waitUntil([&] { return stranger.getState() == actionlib::SimpleClientGoalState::REJECTED; }));
  EXPECT_NE(stranger.getState().getText().find("orders are taken from"), std::string::npos);
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_EQ(cell.machine.commands(), commandsOf(program)) << "its job was not disturbed";
}

TEST(CellController, IsAdoptedByItsJobWhenItIsKilled) {
  CellOfNodes cell("adopts", 20.0);
  cell.bringToIdle();
  const std::string program = squareProgram(4000);
  cell.change(cell.enqueue(program), lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(cell.starts());
  ASSERT_TRUE(cell.reaches("Execute"));
  EXPECT_EQ(cell.controller->end(SIGKILL), -1);
  cell.startController();
  EXPECT_EQ(cell.status.state_name, "Execute");
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_EQ(cell.machine.commands(), commandsOf(program));
}

TEST(CellController, FindsItsJobHeldWhenItWasGoneForLong) {
  CellOfNodes cell("gone", 20.0, {}, 5.0);
  cell.bringToIdle();
  const std::string program = squareProgram(4000);
  cell.change(cell.enqueue(program), lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(cell.starts());
  ASSERT_TRUE(cell.reaches("Execute"));
  std::string state;
  ros::NodeHandle node;
  const boost::function<void(const lamina_msgs::MachineStateConstPtr&)> on_state = [&](const auto& message) {
    state = message->state_name;
  };
  const auto subscriber = node.subscribe<lamina_msgs::MachineState>("/gone/machine_state", 10, on_state);
  EXPECT_EQ(cell.controller->end(SIGKILL), -1);
  EXPECT_TRUE(waitUntil([&] { return state == "Held"; }));
  EXPECT_LT(cell.machine.commands().size(), commandsOf(program).size());
  cell.startController();
  EXPECT_EQ(cell.status.state_name, "Held");
  ASSERT_EQ(cell.command(Command::UNHOLD), kAccepted) << cell.reason;
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_EQ(cell.machine.commands(), commandsOf(program));
}

TEST(CellController, TakesAnAlarmAsGoneWhenItHasForAllThatRaisedIt) {
  CellOfNodes cell("sources", 1000.0);
  ros::NodeHandle node;
  auto reports = node.advertise<lamina_msgs::AlarmReport>("/sources/alarm_reports", 10);
  EXPECT_TRUE(waitUntil([&] { return reports.getNumSubscribers() > 0; }));
  const auto report = [&reports](const std::string& source, bool is_gone) {
    lamina_msgs::AlarmReport message;
    message.id = 8002;
    message.source = source;
    message.message = "the master does not answer";
    message.is_gone = is_gone;
    reports.publish(message);
  };
  cell.bringToIdle();
  report("motion", false);
  report("desk", false);
  EXPECT_TRUE(waitUntil([&] { return cell.alarms.alarms.size() == 1 && cell.alarms.alarms[0].times == 2; }));
  report("motion", true);
  report("nobody", true);
  EXPECT_NE(cell.command(Command::START), kAccepted);
  EXPECT_NE(cell.reason.find("master does not answer"), std::string::npos) << cell.reason;
  report("desk", true);
  EXPECT_TRUE(waitUntil([&] { return cell.alarms.alarms.empty(); }));
}

/// A wall of which a piece comes off, under a loop that pauses nothing by itself.
TEST(CellController, HoldsForAnAlarmOfTheLoopOnHeightsAndShowsIt) {
  CellOfNodes cell("heights", 5.0);
  cell.bringToIdle();
  cell.change(cell.enqueue(squareProgram(5000)), lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(cell.starts());
  ASSERT_TRUE(cell.reaches("Execute"));
  test::Controller controller({"_pauses_print:=false", "alarm_reports:=/heights/alarm_reports"});
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.length_mm = 20.0;
  wall.layers = 3;
  wall.befalls = [](std::size_t layer, std::vector<double>& heights) {
    for (double& height : heights) height -= layer == 1 ? 1.4 : 0.0;
  };
  test::LiveWall live(wall);
  live.say([&] { return cell.hasAlarm(6110); });
  ASSERT_TRUE(waitUntil([&] { return cell.hasAlarm(6110); }));
  EXPECT_TRUE(cell.reaches("Held"));
  EXPECT_EQ(cell.status.stop_reason, 6110);
  EXPECT_TRUE(cell.isInJournal("something broke or came off"));
  EXPECT_NE(cell.command(Command::UNHOLD), kAccepted) << "nobody has looked at the part";
  cell.acknowledgeAll();
  EXPECT_TRUE(waitUntil([&] { return cell.command(Command::UNHOLD) == kAccepted; })) << cell.reason;
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
  const std::string unseen = cell.refusalOf(Command::START, "somebody", Command::RESUME);
  EXPECT_NE(unseen.find("a person has to confirm 'part'"), std::string::npos) << unseen;
  ASSERT_TRUE(cell.starts(Command::RESUME));
  ASSERT_TRUE(cell.reaches("Complete"));
  EXPECT_EQ(cell.machine.commands(), commandsOf(program));
}

}  // namespace
}  // namespace lamina
