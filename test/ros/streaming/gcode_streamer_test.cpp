// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs the node gcode_streamer against emulated machines.
#include <actionlib/client/simple_action_client.h>
#include <asm/termbits.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <signal.h>
#include <std_srvs/Trigger.h>
#include <sys/ioctl.h>
#include <sys/wait.h>

#include <cmath>
#include <fstream>
#include <memory>

#include "conversions.hpp"
#include "correction_messages.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"
#include "latched.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "ros/loop/streamed_machine.hpp"
#include "ros/node_process.hpp"
#include "ros/ros_home.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"
#include "support/control_layers.hpp"
#include "support/scratch_folder.hpp"

namespace {

using lamina::test::kPatience;
using lamina::test::waitUntil;
using lamina_msgs::MachineState;
using lamina_msgs::Status;
using Client = actionlib::SimpleActionClient<lamina_msgs::StreamProgramAction>;
using GoalState = actionlib::SimpleClientGoalState;

const std::string kPort = lamina::test::inRosHome("gcode_streamer_test");

/// At the node's port, unless another is given.
class TestMachine : public lamina::test::StreamedMachine {
 public:
  explicit TestMachine(double speed_up, const std::vector<std::string>& faults = {},
                       const std::string& port = kPort)
      : StreamedMachine(speed_up, port, faults) {}
};

std::vector<std::string> zigzag(int lines) {
  std::vector<std::string> commands = {"G90", "M82", "M104 S200", "G1 F3000"};
  for (int i = 0; i < lines; ++i) {
    commands.push_back("G1 X" + std::to_string(10 + i % 50) + " Y" + std::to_string(i % 20) + " E" +
                       std::to_string(0.01 * i));
  }
  return commands;
}

class GcodeStreamer : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(client_.waitForServer(ros::Duration(kPatience)));
    subscriber_ =
        node_.subscribe<MachineState>(lamina::names::kMachineState, 1000, [this](const auto& message) {
          state_ = message;
          if (states_.empty() || states_.back() != message->state_name)
            states_.push_back(message->state_name);
        });
  }
  void TearDown() override { client_.cancelAllGoals(); }

  std::string write(const std::vector<std::string>& commands) {
    std::ofstream file(folder_.file("program.gcode"));
    for (const std::string& command : commands) file << command << " ; comment\n";
    return folder_.file("program.gcode");
  }
  /// Asks for a toolpath as soon as the node has received it.
  lamina_msgs::StreamProgramResult streamPublished(const lamina::MachineToolpath& placed) {
    lamina::publishLatched(publisher_, toMessage(placed));
    lamina_msgs::StreamProgramResult given;
    EXPECT_TRUE(waitUntil([&] {
      start("", placed.id);
      given = result();
      return given.status.message.find("is asked for") == std::string::npos;
    }));
    return given;
  }
  void start(const std::string& program, const std::string& toolpath_id = "") {
    lamina_msgs::StreamProgramGoal goal;
    goal.program = program;
    goal.toolpath_id = toolpath_id;
    client_.sendGoal(goal);
  }
  lamina_msgs::StreamProgramResult result() {
    EXPECT_TRUE(waitUntil([&] { return client_.getState().isDone(); }));
    const auto given = client_.getResult();
    return given ? *given : lamina_msgs::StreamProgramResult();
  }
  std_srvs::Trigger::Response call(const std::string& service) {
    std_srvs::Trigger trigger;
    EXPECT_TRUE(lamina::callService(service, trigger)) << "the node does not answer";
    return trigger.response;
  }
  std::int32_t change(const std::string& setting, double value) {
    lamina_msgs::ChangeJob asked;
    asked.request.setting = setting;
    asked.request.value = value;
    EXPECT_TRUE(lamina::callService(lamina::names::kChangeJob, asked)) << "the node does not answer";
    return asked.response.status.code;
  }
  bool waitForState(std::uint8_t state) {
    return waitUntil([&] { return state_ && state_->state == state; });
  }

  ros::NodeHandle node_;
  Client client_{lamina::names::kStreamProgram, true};
  ros::Publisher publisher_ = node_.advertise<lamina_msgs::Toolpath>(lamina::names::kToolpath, 1, true);
  ros::Subscriber subscriber_;
  MachineState::ConstPtr state_;
  std::vector<std::string> states_;
  lamina::test::ScratchFolder folder_;
};

constexpr double kFilamentArea = 0.25 * M_PI * 1.75 * 1.75;  // mm^2

TEST_F(GcodeStreamer, StreamsAFileThroughEveryFaultOfTheLine) {
  lamina_msgs::PrintProgress printed;
  const boost::function<void(const lamina_msgs::PrintProgressConstPtr&)> on_printed =
      [&printed](const auto& message) { printed = *message; };
  const ros::Subscriber progress =
      node_.subscribe<lamina_msgs::PrintProgress>(lamina::names::kPrintProgress, 100, on_printed);
  ASSERT_TRUE(waitUntil([&] { return progress.getNumPublishers() > 0; }));
  const TestMachine machine(0.0, {"lost_ok=0.004", "corrupted_line=0.01", "lost_line=0.002",
                                  "spurious_resend=0.004", "delayed_ok=0.002", "silence=0.001"});
  const auto program = zigzag(2000);
  start(write(program));
  const auto given = result();
  EXPECT_EQ(client_.getState(), GoalState::SUCCEEDED) << given.status.message;
  EXPECT_EQ(given.status.code, Status::OK);
  EXPECT_EQ(given.lines_acknowledged, program.size());
  EXPECT_GT(given.resends, 0U);
  EXPECT_EQ(machine.commands(), program);
  ASSERT_TRUE(waitForState(MachineState::COMPLETE));
  EXPECT_EQ(state_->lines_total, program.size());
  EXPECT_NE(std::find(states_.begin(), states_.end(), "Execute"), states_.end());
  // What it has laid, each line once: along x by 1 mm, back by 49 mm after 50 lines, along y by 1 mm or back
  // by 19.
  double length_mm = 0.0;
  for (int i = 1; i < 2000; ++i) length_mm += std::hypot(i % 50 == 0 ? 49.0 : 1.0, i % 20 == 0 ? 19.0 : 1.0);
  EXPECT_TRUE(waitUntil([&] { return std::abs(1e3 * printed.laid_length - length_mm) < 1e-6; }))
      << printed.laid_length;
  EXPECT_EQ(printed.job, folder_.file("program.gcode"));
  EXPECT_NEAR(1e9 * printed.laid_volume, 19.99 * kFilamentArea, 1e-6);
}

/// Of what the machine has run nothing heats, extrudes or blows, and its feeds are half of the program's.
TEST_F(GcodeStreamer, RunsAProgramDry) {
  const TestMachine machine(0.0, {});
  lamina_msgs::StreamProgramGoal goal;
  goal.program = write({"M104 S210", "M109 S210", "G28", "G92 E0", "M83", "G1 X10 Y10 E2 F1200", "M106 S255",
                        "G1 E-1 F2400", "G0 X20", "G1 E1", "G1 Y20 E1", "START_PRINT", "M104 S0", "M84"});
  goal.dry = "air";
  goal.speed = 0.5;
  client_.sendGoal(goal);
  const auto given = result();
  EXPECT_EQ(given.status.code, Status::OK) << given.status.message;
  const std::vector<std::string> expected = {"G28", "M83",    "G1 X10 Y10 F600", "G1 F1200", "G0 X20",
                                             "G1",  "G1 Y20", "M104 S0",         "M84"};
  EXPECT_EQ(machine.commands(), expected);
  for (const auto& [dry, speed, resume] : {std::tuple("lift", 0.0, false), std::tuple("", 0.5, false),
                                           std::tuple("air", 5.0, false), std::tuple("air", 0.0, true)}) {
    goal.dry = dry;
    goal.speed = speed;
    goal.resume = resume;
    client_.sendGoal(goal);
    const auto code = result().status.code;
    EXPECT_TRUE(code == Status::INVALID_INPUT || code == Status::INVALID_CONFIG) << dry << " at " << speed;
  }
}

TEST_F(GcodeStreamer, HoldsOnPauseAndGoesOnOnResume) {
  const TestMachine machine(5.0);
  const auto program = zigzag(600);  // 8 s
  start(write(program));
  ASSERT_TRUE(waitUntil([&] { return machine->counts().lines_run > 20; }));
  EXPECT_TRUE(call(lamina::names::kPause).success);
  ASSERT_TRUE(waitForState(MachineState::HELD));
  const auto held_at = machine.commands().size();
  EXPECT_FALSE(call(lamina::names::kPause).success);
  EXPECT_EQ(change("babystep", 0.00005), Status::OK);
  EXPECT_EQ(change("feed", 2.0), Status::OK);
  EXPECT_EQ(change("feed", 30.0), Status::INVALID_INPUT);
  EXPECT_EQ(change("flow", 3.1), Status::INVALID_INPUT);
  EXPECT_EQ(change("power", 0.9), Status::REJECTED) << "Marlin has none";
  EXPECT_EQ(change("colour", 1.0), Status::INVALID_INPUT);
  EXPECT_TRUE(waitUntil([&] { return machine->isIdle(); }));
  EXPECT_EQ(machine.commands().size(), held_at);
  EXPECT_LT(held_at, program.size());
  EXPECT_TRUE(call(lamina::names::kResume).success);
  EXPECT_EQ(result().status.code, Status::OK);
  EXPECT_EQ(machine.commands(), program);
  EXPECT_EQ(change("feed", 1.0), Status::REJECTED) << "the job is over";
  EXPECT_TRUE(waitUntil([&] { return state_->nozzle_temperature > 190.0; })) << state_->nozzle_temperature;
  EXPECT_NEAR(state_->bed_temperature, 25.0, 0.1) << "nobody heats it";
}

TEST_F(GcodeStreamer, StopsSafelyOnAbort) {
  const TestMachine machine(2.0);
  start(write(zigzag(3000)));
  ASSERT_TRUE(waitUntil([&] { return machine->counts().lines_run > 20; }));
  EXPECT_GT(machine->nozzleTarget(), 0.0);
  EXPECT_TRUE(call(lamina::names::kAbort).success);
  const auto given = result();
  EXPECT_EQ(client_.getState(), GoalState::ABORTED);
  EXPECT_EQ(given.status.code, Status::CANCELLED);
  EXPECT_DOUBLE_EQ(machine->nozzleTarget(), 0.0);
  EXPECT_TRUE(waitUntil([&] { return machine->isIdle(); }));
  EXPECT_LT(machine.commands().size(), 2000U);
  EXPECT_FALSE(call(lamina::names::kAbort).success);
}

/// The program comes through a pipe of the node: it is prepared for as long as the test writes nothing.
TEST_F(GcodeStreamer, BeginsNothingThatIsAbortedWhileItIsPrepared) {
  const std::string port = kPort + "_prepared";
  const TestMachine machine(0.0, {}, port);
  int ends[2] = {-1, -1};
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::fcntl(ends[1], F_SETFD, FD_CLOEXEC), 0);
  const lamina::test::NodeProcess node(LAMINA_STREAMER_NODE, {"__ns:=/prepared", "_port:=" + port});
  Client client("/prepared/stream_program", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(kPatience)));
  MachineState::ConstPtr state;
  const ros::Subscriber states = node_.subscribe<MachineState>(
      "/prepared/machine_state", 100, [&](const MachineState::ConstPtr& message) { state = message; });
  lamina_msgs::StreamProgramGoal goal;
  goal.program = "/proc/self/fd/" + std::to_string(ends[0]);
  client.sendGoal(goal);
  EXPECT_TRUE(waitUntil([&] { return state && state->state == MachineState::STARTING; }));
  EXPECT_EQ(state->job, goal.program);
  const std_srvs::Trigger::Response answer = call("/prepared/abort");
  EXPECT_TRUE(answer.success);
  EXPECT_EQ(answer.message, "nothing is begun");
  EXPECT_EQ(::write(ends[1], "G1 X1\n", 6), 6);
  for (const int end : ends) ::close(end);
  EXPECT_TRUE(waitUntil([&] { return client.getState().isDone(); }));
  EXPECT_EQ(client.getState(), GoalState::ABORTED);
  ASSERT_TRUE(client.getResult());
  EXPECT_EQ(client.getResult()->status.code, Status::CANCELLED) << client.getResult()->status.message;
  EXPECT_TRUE(machine.commands().empty());
}

TEST_F(GcodeStreamer, StopsSafelyWhenTheGoalIsCancelled) {
  const TestMachine machine(2.0);
  start(write(zigzag(3000)));
  ASSERT_TRUE(waitUntil([&] { return machine->counts().lines_run > 20; }));
  client_.cancelGoal();
  const auto given = result();
  EXPECT_EQ(client_.getState(), GoalState::PREEMPTED);
  EXPECT_EQ(given.status.code, Status::CANCELLED);
  EXPECT_DOUBLE_EQ(machine->nozzleTarget(), 0.0);
}

/// There is no machine: if the port were tried, the job would have failed for that.
TEST_F(GcodeStreamer, ReportsThatNoMachineIsThereAndLivesOn) {
  for (int attempt = 0; attempt < 2; ++attempt) {
    start(write(zigzag(10)));
    const auto given = result();
    EXPECT_EQ(client_.getState(), GoalState::ABORTED);
    EXPECT_EQ(given.status.code, Status::DISCONNECTED);
    EXPECT_NE(given.status.message.find(kPort), std::string::npos) << given.status.message;
  }
}

TEST_F(GcodeStreamer, ReportsWhereTheLinkWasLost) {
  const TestMachine machine(0.0, {"disconnect=50"});
  start(write(zigzag(100)));
  const auto given = result();
  EXPECT_EQ(given.status.code, Status::DISCONNECTED);
  EXPECT_GE(given.lines_acknowledged, 40U);
  EXPECT_LT(given.lines_acknowledged, 50U);
}

TEST_F(GcodeStreamer, RefusesBadProgramsBeforeTheFirstLine) {
  const TestMachine machine(0.0);
  start("/nowhere/at/all.gcode");
  EXPECT_EQ(result().status.code, Status::FILE_ERROR);
  start(write({"G28", "G1 X1*33"}));
  EXPECT_EQ(result().status.code, Status::INVALID_PROGRAM);
  start("", "0123456789abcdef");
  EXPECT_EQ(result().status.code, Status::INVALID_INPUT);
  start("", "");
  EXPECT_EQ(result().status.code, Status::INVALID_INPUT);
  EXPECT_EQ(machine.commands(), std::vector<std::string>()) << "asked who it is, no more";
}

/// Two lines from a corner, for a part at (5, 6) mm on the bed.
lamina::MachineToolpath corner() {
  lamina::Path path;
  path.points = {{10, 10, 0.2}, {60, 10, 0.2}, {60, 40, 0.2}};
  path.bead = lamina::Bead{0.4, 0.2};
  path.feed_mm_s = 30.0;
  lamina::MachineToolpath placed;
  placed.toolpath.part_name = "corner";
  placed.toolpath.layers.push_back({0.2, 0.2, {path}});
  placed.id = "corner";
  placed.bed_from_part.translation() = lamina::Point3(5, 6, 0);
  return placed;
}

TEST_F(GcodeStreamer, StreamsThePublishedToolpath) {
  const TestMachine machine(0.0);
  const lamina_msgs::StreamProgramResult given = streamPublished(corner());
  EXPECT_EQ(given.status.code, Status::OK) << given.status.message;
  EXPECT_EQ(given.firmware.compare(0, 6, "Marlin"), 0) << given.firmware;
  EXPECT_EQ(given.commands_not_done, 0U) << given.first_not_done;
  EXPECT_EQ(given.starvations, 0U) << given.longest_starvation << " s before line "
                                   << given.longest_starvation_line;
  EXPECT_NEAR(machine->position().x(), 65.0, 1e-6);
  EXPECT_NEAR(machine->position().y(), 46.0, 1e-6);
}

TEST_F(GcodeStreamer, RefusesAToolpathThatItsMachineCannotRun) {
  const TestMachine machine(0.0);
  lamina::MachineToolpath foreign = corner();
  foreign.id = "foreign";
  foreign.machine = "gantry_45";
  EXPECT_EQ(streamPublished(foreign).status.code, Status::INVALID_INPUT);
  lamina::MachineToolpath far = corner();
  far.id = "far";
  far.bed_from_part.translation() = lamina::Point3(5000, 6, 0);
  EXPECT_EQ(streamPublished(far).status.code, Status::UNREACHABLE);
  EXPECT_NEAR(machine->position().norm(), 0.0, 1e-9);
}

/// Of a serial port, or of what stands in for one.
unsigned baudOf(const std::string& port) {
  const int file = ::open(port.c_str(), O_RDWR | O_NOCTTY);
  termios2 set{};
  EXPECT_EQ(::ioctl(file, TCGETS2, &set), 0) << port;
  ::close(file);
  return set.c_ospeed;
}

TEST_F(GcodeStreamer, StopsTheMachineSafelyOnSigterm) {
  const std::string port = kPort + "_sigterm";
  const TestMachine machine(2.0, {}, port);
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl(LAMINA_STREAMER_NODE, LAMINA_STREAMER_NODE, "__ns:=/terminated", ("_port:=" + port).c_str(),
            "_baud:=57600", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  Client client("/terminated/stream_program", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(kPatience)));
  MachineState::ConstPtr state;
  const ros::Subscriber states = node_.subscribe<MachineState>(
      "/terminated/machine_state", 1000, [&](const MachineState::ConstPtr& message) { state = message; });
  lamina_msgs::StreamProgramGoal goal;
  goal.program = write(zigzag(3000));
  client.sendGoal(goal);
  EXPECT_TRUE(waitUntil([&] { return state && machine->counts().lines_run > 20; }));
  EXPECT_GT(machine->nozzleTarget(), 0.0);
  EXPECT_EQ(baudOf(port), 57600U);
  ::kill(child, SIGTERM);
  int status = -1;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  EXPECT_DOUBLE_EQ(machine->nozzleTarget(), 0.0);
  EXPECT_TRUE(waitUntil([&] { return client.getState().isDone(); }));
  EXPECT_EQ(client.getState(), GoalState::ABORTED);
  ASSERT_TRUE(client.getResult());
  EXPECT_EQ(client.getResult()->status.code, Status::CANCELLED) << client.getResult()->status.message;
  EXPECT_TRUE(waitUntil([&] { return state->state == MachineState::ABORTED; })) << state->state_name;
}

/// Three layers of two beads each.
lamina::MachineToolpath threeLayers() {
  lamina::MachineToolpath placed;
  placed.toolpath.part_name = "beads";
  for (int k = 1; k <= 3; ++k) {
    lamina::ToolpathLayer layer = lamina::test::straightBeadLayer({0.0, 3.0}, 40.0, 1.5 * k);
    lamina::Path up;
    up.role = lamina::PathRole::Travel;
    up.feed_mm_s = 50.0;
    if (k > 1) {
      up.points = {placed.toolpath.layers.back().paths.back().lastPoint(), layer.paths[0].firstPoint()};
      layer.paths.insert(layer.paths.begin(), up);
    }
    placed.toolpath.layers.push_back(layer);
  }
  placed.bed_from_part = Eigen::Translation3d(50.0, 60.0, 0.0);
  placed.id = lamina::toolpathId(placed.toolpath);
  return placed;
}

/// All that commands push forth [mm].
double filamentOf(const std::vector<std::string>& commands) {
  double sum = 0.0;
  lamina::GcodeHandlers handlers;
  handlers.motion = [&](const lamina::GcodeMotion& motion) { sum += motion.extrusion_mm; };
  lamina::GcodeReader reader({}, handlers);
  for (const std::string& command : commands) reader.read(command + "\n");
  reader.finish();
  return sum;
}

TEST_F(GcodeStreamer, CorrectsLayersOnTheirWay) {
  const lamina::MachineToolpath placed = threeLayers();
  const lamina::LayerCells cells = layerCells(placed.toolpath.layers[1], 1, 0.5);
  const auto map = correctionMap(cells, {std::vector<double>(cells.size(), 0.3), {}, {}}, placed.id, 1);
  const std::string port = kPort + "_corrected";
  const TestMachine machine(0.0, {}, port);
  const lamina::test::NodeProcess node(
      LAMINA_STREAMER_NODE, {"__ns:=/corrected", "_port:=" + port, "_corrections/use:=true",
                             "_loop/wait_s:=5", "_corrections/folder:=" + folder_.file("corrections")});
  Client client("/corrected/stream_program", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(kPatience)));
  ros::Publisher toolpath = node_.advertise<lamina_msgs::Toolpath>("/corrected/toolpath", 1, true);
  ros::Publisher correction = node_.advertise<lamina_msgs::CorrectionMap>("/corrected/correction", 10, true);
  lamina::publishLatched(toolpath, toMessage(placed));
  ASSERT_TRUE(
      waitUntil([&] { return toolpath.getNumSubscribers() > 0 && correction.getNumSubscribers() > 0; }));
  MachineState::ConstPtr state;
  const ros::Subscriber states = node_.subscribe<MachineState>(
      "/corrected/machine_state", 100, [&](const MachineState::ConstPtr& message) { state = message; });
  std::vector<lamina_msgs::AppliedCorrection> applied;
  const ros::Subscriber uses = node_.subscribe<lamina_msgs::AppliedCorrection>(
      "/corrected/applied_correction", 100,
      [&](const lamina_msgs::AppliedCorrection::ConstPtr& message) { applied.push_back(*message); });
  ASSERT_TRUE(waitUntil([&] { return uses.getNumPublishers() > 0; }));
  lamina_msgs::PrintProgress printed;
  const boost::function<void(const lamina_msgs::PrintProgressConstPtr&)> on_printed =
      [&printed](const auto& message) { printed = *message; };
  const ros::Subscriber progress =
      node_.subscribe<lamina_msgs::PrintProgress>("/corrected/print_progress", 100, on_printed);
  ASSERT_TRUE(waitUntil([&] { return progress.getNumPublishers() > 0; }));
  lamina_msgs::StreamProgramGoal goal;
  goal.toolpath_id = placed.id;
  client.sendGoal(goal);
  ASSERT_TRUE(waitUntil([&] { return state && state->state == MachineState::EXECUTE; }));
  lamina::publishLatched(correction, toMessage(map));
  EXPECT_TRUE(waitUntil([&] { return client.getState().isDone(); }));
  EXPECT_EQ(client.getState().toString(), "SUCCEEDED") << client.getState().getText();
  // The map of the last layer never comes: what the layer before ended with fades by 0.5 a second, at 10 mm/s
  // by 0.025 from one cell of 0.5 mm to the next, from 0.275 in the first to 0.025 in the eleventh.
  constexpr double kFadedMm = 0.5 * 0.025 * (11.0 * 12.0 / 2.0);
  const double of_layer_mm = 2.0 * 40.0 * crossSection(lamina::Bead{3.0, 1.5}) / kFilamentArea;
  EXPECT_NEAR(filamentOf(machine.commands()), (3.0 + 0.3 + kFadedMm / 80.0) * of_layer_mm, 1e-3);
  EXPECT_TRUE(waitUntil([&] { return std::abs(printed.laid_length - 0.240) < 1e-5; })) << printed.laid_length;
  EXPECT_NEAR(1e9 * printed.laid_volume, (3.3 + kFadedMm / 80.0) * of_layer_mm * kFilamentArea, 0.01)
      << "as it was corrected";
  std::ifstream file(folder_.file("corrections") + "/record.csv");
  const std::string record((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  EXPECT_NE(record.find("\n1,1," + toMessage(map).digest + ","), std::string::npos) << record;
  EXPECT_NE(record.find("\n2,0,"), std::string::npos) << record;
  EXPECT_EQ(record.find("\n2,0,none,"), std::string::npos) << "it has the map of the fade";
  ASSERT_TRUE(waitUntil([&] { return applied.size() == 3; }));
  const std::vector<std::string> digests = {"", toMessage(map).digest, ""};
  for (std::size_t layer = 0; layer < 3; ++layer) {
    EXPECT_EQ(applied[layer].toolpath_id, placed.id);
    EXPECT_EQ(applied[layer].layer, layer);
    EXPECT_EQ(applied[layer].digest, digests[layer]);
    EXPECT_EQ(applied[layer].waited, layer == 2 ? 5.0 : 0.0);
  }
}

TEST_F(GcodeStreamer, GoesOnWithTheJobOfANodeThatWasKilled) {
  const std::string port = kPort + "_killed";
  const TestMachine machine(20.0, {}, port);
  const std::vector<std::string> commands = zigzag(1000);
  lamina_msgs::StreamProgramGoal goal;
  goal.program = write(commands);
  const std::vector<std::string> arguments = {"__ns:=/killed", "_port:=" + port,
                                              "_stream/journal:=" + folder_.file("job.progress")};
  Client client("/killed/stream_program", true);
  {
    lamina::test::NodeProcess node(LAMINA_STREAMER_NODE, arguments);
    ASSERT_TRUE(client.waitForServer(ros::Duration(kPatience)));
    client.sendGoal(goal);
    EXPECT_TRUE(waitUntil([&] { return machine->counts().lines_run > 100; }));
    EXPECT_EQ(node.end(SIGKILL), -1);
  }
  EXPECT_LT(machine.commands().size(), commands.size());
  lamina::test::NodeProcess node(LAMINA_STREAMER_NODE, arguments);
  goal.resume = true;
  Client again("/killed/stream_program", true);
  ASSERT_TRUE(again.waitForServer(ros::Duration(kPatience)));
  again.sendGoal(goal);
  EXPECT_TRUE(waitUntil([&] { return again.getState().isDone(); }));
  EXPECT_EQ(again.getState().toString(), "SUCCEEDED") << again.getState().getText();
  EXPECT_EQ(machine.commands(), commands);
}

}  // namespace
