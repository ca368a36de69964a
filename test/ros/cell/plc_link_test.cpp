// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The node plc_link beside cell_controller and gcode_streamer at an emulated machine, commanded by clients of
// others.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <algorithm>
#include <csignal>
#include <memory>
#include <string>
#include <vector>

#include "lamina/journal/execution_log.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "ros/cell/cell_of_nodes.hpp"
#include "ros/cell/plc_client.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

using test::CellOfNodes;
using test::kAccepted;
using test::LibmodbusClient;
using test::MbpollClient;
using test::PlcClient;
using test::PymodbusClient;
using test::Registers;
using test::squareProgram;
using test::waitUntil;
using Command = lamina_msgs::PackmlCommand::Request;

constexpr int kRemoteLocked = 4;
constexpr int kGuardFailed = 6;
constexpr unsigned kRemoteAllowed = 1U << 1U;
constexpr unsigned kPartOnPlate = 1U << 11U;

/// A cell with a PLC link, of which the test is the PLC.
class LinkedCell {
 public:
  LinkedCell(const std::string& name, double speed_up, const std::vector<std::string>& link_parameters,
             const std::vector<std::string>& cell_parameters = {})
      : cell(name, speed_up, cell_parameters), space_("/" + name) {
    const boost::function<void(const lamina_msgs::PlcInputsConstPtr&)> on_inputs =
        [this](const auto& message) { said = *message; };
    const boost::function<void(const lamina_msgs::HeaterStateConstPtr&)> on_heaters =
        [this](const auto& message) { heaters = *message; };
    heater_subscriber_ =
        node_.subscribe<lamina_msgs::HeaterState>(space_ + '/' + names::kHeaterState, 100, on_heaters);
    subscriber_ = node_.subscribe<lamina_msgs::PlcInputs>(space_ + '/' + names::kPlcInputs, 100, on_inputs);
    startLink(link_parameters);
  }

  void startLink(const std::vector<std::string>& parameters) {
    link.reset();
    port = 0;
    ros::param::set(space_ + "/plc_link/listening_port", port);  // as a run before that was killed leaves one
    std::vector<std::string> arguments = {"__ns:=" + space_, "_modbus/port:=0"};
    arguments.insert(arguments.end(), parameters.begin(), parameters.end());
    link = std::make_unique<test::NodeProcess>(LAMINA_PLC_NODE, arguments);
    EXPECT_TRUE(waitUntil(
        [this] { return ros::param::get(space_ + "/plc_link/listening_port", port) && port != 0; }));
  }

  std::string setRemoteAccess(bool is_allowed) {
    lamina_msgs::SetRemoteAccess call;
    call.request.is_allowed = is_allowed;
    call.request.source = "test";
    EXPECT_TRUE(callService(space_ + '/' + names::kSetRemoteAccess, call));
    return call.response.status.message;
  }

  /// Writes a command with the next sequence several times, and gives the result.
  int command(PlcClient& plc, std::uint16_t command, int times = 1) {
    const auto sequence = static_cast<std::uint16_t>(plc.input(13) + 1);
    if (sequence == 1) plc.write(2, {0});  // so that the first sequence of a link counts
    for (int i = 0; i < times; ++i) plc.write(1, {command, sequence});
    EXPECT_TRUE(waitUntil([&] { return plc.input(13) == sequence; }));
    EXPECT_EQ(plc.input(12), command);
    return plc.input(14);
  }

  /// Gives a command until it is accepted.
  bool succeeds(PlcClient& plc, std::uint16_t number, int times = 1) {
    bool is_accepted = false;
    return waitUntil([&] {
      is_accepted = is_accepted || command(plc, number, times) == kAccepted;
      return is_accepted;
    });
  }

  bool reaches(PlcClient& plc, std::uint16_t state) {
    return waitUntil([&] { return plc.input(10) == state; });
  }

  /// Reports an alarm as another node does, and waits until the unit has it, or has it no longer.
  bool isReported(std::uint16_t alarm, bool is_gone) {
    lamina_msgs::AlarmReport report;
    report.id = alarm;
    report.source = "test";
    report.is_gone = is_gone;
    ros::Publisher reports =
        node_.advertise<lamina_msgs::AlarmReport>(space_ + '/' + names::kAlarmReports, 1, true);
    reports.publish(report);
    return waitUntil([&] { return cell.hasAlarm(alarm) != is_gone; });
  }

  std::size_t timesIn(const std::string& state) const {
    return static_cast<std::size_t>(std::count(cell.states.begin(), cell.states.end(), state));
  }
  CellOfNodes cell;
  std::unique_ptr<test::NodeProcess> link;
  lamina_msgs::PlcInputs said;
  lamina_msgs::HeaterState heaters;
  int port = 0;

 private:
  ros::NodeHandle node_;
  std::string space_;
  ros::Subscriber subscriber_;
  ros::Subscriber heater_subscriber_;
};

/// Takes a part through its whole life, from Stopped or Idle to Idle, by registers alone.
void cycle(LinkedCell& linked, PlcClient& plc, const Registers& check) {
  EXPECT_EQ(plc.inputs(4, 4), check);
  linked.cell.change(linked.cell.enqueue(squareProgram(20)), lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(waitUntil([&] { return plc.input(43) == 1; })) << "a job waits";
  if (plc.input(10) == 2) {
    EXPECT_EQ(linked.command(plc, Command::RESET), kAccepted);
  }
  ASSERT_TRUE(linked.reaches(plc, 4));
  plc.write(11, {3});  // as it is: only what changes from here on counts
  const std::size_t starts = linked.timesIn("Starting");
  ASSERT_TRUE(linked.succeeds(plc, Command::START, 3));
  ASSERT_TRUE(linked.reaches(plc, 17));
  EXPECT_TRUE(waitUntil(
      [&] { return linked.timesIn("Starting") > starts && linked.cell.states.back() == "Complete"; }));
  EXPECT_EQ(linked.timesIn("Starting"), starts + 1) << "each command is followed once";
  EXPECT_NE(plc.input(3) & kPartOnPlate, 0U);
  plc.write(11, {7});
  EXPECT_EQ(linked.command(plc, Command::RESET, 3), kAccepted);
  ASSERT_TRUE(linked.reaches(plc, 4));
  EXPECT_TRUE(waitUntil([&] { return (plc.input(3) & kPartOnPlate) == 0; }));
  plc.write(11, {3});
}

void cycleByAllClients(LinkedCell& linked, const Registers& check) {
  {
    LibmodbusClient plc(linked.port);
    ASSERT_TRUE(waitUntil([&] { return (plc.input(3) & kRemoteAllowed) != 0; }));
    ASSERT_NO_FATAL_FAILURE(cycle(linked, plc, check)) << "libmodbus";
    for (int i = 0; i < 100; ++i) ASSERT_EQ(linked.command(plc, Command::UNHOLD), 2) << "not in this state";
    EXPECT_TRUE(waitUntil([&] { return linked.cell.hasAlarm(2102); })) << "refused a hundred times";
  }
  {
    PymodbusClient plc(linked.port, std::string(LAMINA_SOURCE_DIR) + "/test/ros/cell/pymodbus_client.py",
                       linked.cell.folder.path());
    ASSERT_NO_FATAL_FAILURE(cycle(linked, plc, check)) << "pymodbus";
  }
  MbpollClient plc(linked.port);
  ASSERT_NO_FATAL_FAILURE(cycle(linked, plc, check)) << "mbpoll";
}

TEST(PlcLink, TakesPartsThroughTheirLifeByRegistersAlone) {
  LinkedCell linked("cycles", 1000.0, {"_modbus/word_order:=high_first", "_modbus/connections:=2"});
  EXPECT_EQ(linked.setRemoteAccess(true), "");
  cycleByAllClients(linked, {0x1234, 0x5678, 0x449a, 0x5000});
  linked.startLink({"_modbus/word_order:=low_first"});
  cycleByAllClients(linked, {0x5678, 0x1234, 0x5000, 0x449a});
}

/// Keeps a PLC's heart beating while it waits.
template <class Condition>
bool beatUntil(PlcClient& plc, std::uint16_t& heartbeat, Condition is_true) {
  return waitUntil([&] {
    plc.write(0, {++heartbeat});
    return is_true();
  });
}

/// An emergency stop ends the job, which waits then; its PLC alone does not start again.
void pressAndRelease(LinkedCell& linked, PlcClient& plc, std::uint16_t& heartbeat) {
  plc.write(10, {4});
  ASSERT_TRUE(beatUntil(plc, heartbeat, [&] { return plc.input(10) == 2; })) << "Stopped";
  EXPECT_TRUE(beatUntil(plc, heartbeat, [&] { return linked.cell.hasAlarm(1207); }));
  plc.write(10, {3});
  std::uint16_t acknowledged = 0;
  ASSERT_TRUE(beatUntil(plc, heartbeat, [&] {
    plc.write(14, {acknowledged});
    acknowledged = acknowledged == 0 ? 1207 : 0;
    return !linked.cell.hasAlarm(1207);
  }));
  ASSERT_TRUE(linked.succeeds(plc, Command::RESET));
  ASSERT_TRUE(beatUntil(plc, heartbeat, [&] { return plc.input(10) == 4; }));
  const std::string from_plc = linked.cell.refusalOf(Command::START, "plc: anna");
  EXPECT_NE(from_plc.find("emergency stop was pressed"), std::string::npos) << from_plc;
  EXPECT_NE(from_plc.find("was cut off"), std::string::npos) << "the job waits: " << from_plc;
  const std::string from_anna = linked.cell.refusalOf(Command::START, "page: anna");
  EXPECT_EQ(from_anna.find("emergency stop"), std::string::npos) << from_anna;
}

TEST(PlcLink, NeedsTheInterlocksOfAPlcThatIsRequired) {
  LinkedCell linked("required", 20.0, {"_modbus/watchdog_s:=10"},
                    {"_plc/required:=true", "_plc/patience_s:=60", "_start/local_after_estop:=true"});
  LibmodbusClient plc(linked.port);
  std::uint16_t heartbeat = 0;
  ASSERT_TRUE(linked.reaches(plc, 2));
  EXPECT_EQ(linked.command(plc, Command::RESET), kRemoteLocked);
  EXPECT_EQ(linked.setRemoteAccess(true), "");
  linked.cell.controller.reset();
  linked.cell.startController();
  EXPECT_TRUE(waitUntil([&] { return linked.cell.status.remote_access != 0; })) << "kept over restarts";
  ASSERT_TRUE(
      beatUntil(plc, heartbeat, [&] { return linked.said.watchdog == lamina_msgs::PlcInputs::GOOD; }));
  linked.cell.change(linked.cell.enqueue(squareProgram(2000)), lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(linked.succeeds(plc, Command::RESET));
  ASSERT_TRUE(beatUntil(plc, heartbeat, [&] { return plc.input(10) == 4; }));
  plc.write(20, {0x616e, 0x6e61});  // the badge of anna
  EXPECT_EQ(linked.command(plc, Command::START), kGuardFailed) << "there is no plate";
  EXPECT_EQ(plc.input(3) & 4U, 4U) << "refused";
  plc.write(8, {15, 0, 0, 3});
  ASSERT_TRUE(linked.succeeds(plc, Command::START));
  ASSERT_TRUE(beatUntil(plc, heartbeat, [&] { return plc.input(10) == 6; }));
  plc.write(12, {0x3f00, 0});  // half the speed
  CellJournal journal = CellJournal::read(linked.cell.folder.path() + "/cell/cell.db");
  EXPECT_TRUE(beatUntil(plc, heartbeat, [&] { return !ExecutionLog(journal).setpoints(1).empty(); }));
  EXPECT_EQ(ExecutionLog(journal).setpoints(1).at(0).key, "feed");
  EXPECT_DOUBLE_EQ(ExecutionLog(journal).setpoints(1).at(0).value, 0.5);
  plc.write(11, {11});
  ASSERT_TRUE(beatUntil(plc, heartbeat, [&] { return plc.input(10) == 5; }))
      << "the zone is taken: Suspended";
  EXPECT_EQ(plc.input(15), 1204);
  plc.write(11, {3});
  ASSERT_TRUE(beatUntil(plc, heartbeat, [&] { return plc.input(10) == 6; })) << "and free again";
  EXPECT_EQ(linked.command(plc, Command::HOLD), kAccepted);
  ASSERT_TRUE(beatUntil(plc, heartbeat, [&] { return plc.input(10) == 11; }));
  EXPECT_TRUE(waitUntil([&] { return linked.cell.status.stop_message == "by plc: anna"; }))
      << linked.cell.status.stop_message;
  const auto isNozzleShown = [&] {
    const Registers words = plc.inputs(60, 2);
    return linked.heaters.nozzle > 0.0 && linked.heaters.nozzle_target == 0.0 && linked.heaters.bed > 0.0 &&
           linked.heaters.bed_target == 0.0 && modbus_get_float_dcba(words.data()) >= 0.0F && words[0] != 0;
  };
  EXPECT_TRUE(beatUntil(plc, heartbeat, isNozzleShown));
  EXPECT_EQ(plc.inputs(50, 2).at(0), 0U) << "not gone for 18 hours yet";
  ASSERT_NO_FATAL_FAILURE(pressAndRelease(linked, plc, heartbeat));
}

TEST(PlcLink, HoldsTheUnitWhenItsPlcFallsSilent) {
  LinkedCell linked("silent", 20.0, {"_modbus/watchdog_s:=3", "_modbus/abandon_s:=600"});
  EXPECT_EQ(linked.setRemoteAccess(true), "");
  LibmodbusClient plc(linked.port);
  linked.cell.bringToIdle();
  linked.cell.change(linked.cell.enqueue(squareProgram(4000)), lamina_msgs::ChangeQueue::Request::RELEASE);
  ASSERT_TRUE(linked.cell.starts());
  ASSERT_TRUE(linked.cell.reaches("Execute"));
  ASSERT_TRUE(waitUntil([&] { return (plc.input(3) & kRemoteAllowed) != 0; }));
  plc.write(0, {1});
  ASSERT_TRUE(linked.cell.reaches("Held"));
  EXPECT_EQ(linked.cell.status.stop_reason, 2101);
  EXPECT_TRUE(waitUntil([&] { return linked.said.watchdog == lamina_msgs::PlcInputs::LOST; }));
  EXPECT_EQ(linked.said.on_silence, lamina_msgs::PlcInputs::HOLD);
  EXPECT_EQ(linked.command(plc, Command::UNHOLD), 9) << "its commands are not taken";
  std::uint16_t heartbeat = 1;
  std::uint16_t acknowledged = 0;
  EXPECT_TRUE(beatUntil(plc, heartbeat, [&] {
    plc.write(14, {acknowledged});
    acknowledged = acknowledged == 0 ? 2101 : 0;
    return plc.input(18) == 0;
  })) << "no alarm is left";
  EXPECT_EQ(linked.command(plc, Command::STOP), kAccepted);
  EXPECT_TRUE(linked.reaches(plc, 2));
  linked.startLink({"_modbus/watchdog_s:=0.5", "_modbus/watchdog_action:=none"});
  LibmodbusClient another(linked.port);
  EXPECT_TRUE(waitUntil([&] { return (another.input(3) & kRemoteAllowed) != 0; }));
  another.write(1, {Command::RESET, 50});
  EXPECT_EQ(another.inputs(13, 2), (Registers{50, 10})) << "it may be of the link before";
  another.write(0, {1});
  // The link before may have said the same of its own PLC.
  EXPECT_TRUE(waitUntil([&] {
    return linked.said.on_silence == lamina_msgs::PlcInputs::NONE &&
           linked.said.watchdog == lamina_msgs::PlcInputs::LOST;
  }));
}

TEST(PlcLink, HearsWhatItsPlcForbidsWhileRemoteAccessIsLocked) {
  LinkedCell linked("locked", 20.0, {"_modbus/watchdog_s:=10"});
  LibmodbusClient plc(linked.port);
  linked.cell.bringToIdle();
  std::uint16_t heartbeat = 0;
  std::string refusal;
  // No job is released, so that a Start that comes too early begins nothing.
  const auto isZoneAgainstStart = [&] {
    refusal = linked.cell.refusalOf(Command::START, "page: anna");
    return refusal.find("another robot in the zone") != std::string::npos;
  };
  plc.write(11, {8});
  EXPECT_TRUE(beatUntil(plc, heartbeat, isZoneAgainstStart)) << refusal;
  EXPECT_TRUE(beatUntil(plc, heartbeat, [&] { return linked.said.is_beating; }));
  EXPECT_EQ(linked.said.watchdog, lamina_msgs::PlcInputs::UNARMED);
  plc.write(11, {0});
  EXPECT_TRUE(beatUntil(plc, heartbeat, [&] { return !isZoneAgainstStart(); })) << refusal;
}

TEST(PlcLink, ListensWhereItIsSetTo) {
  LinkedCell linked("elsewhere", 1000.0, {"_modbus/bind:=0.0.0.0", "_modbus/allow:=192.0.2.1, 127.0.0.1"});
  EXPECT_TRUE(waitUntil([&] { return linked.cell.hasAlarm(9002); })) << "reachable from other hosts";
  EXPECT_TRUE(linked.isReported(8003, false));
  EXPECT_TRUE(linked.isReported(8003, true));
  LibmodbusClient plc(linked.port);
  EXPECT_EQ(plc.input(0), 1);
  const std::uint16_t beat = plc.input(1);
  EXPECT_TRUE(waitUntil([&] { return plc.input(1) != beat; }));
  EXPECT_EQ(linked.cell.controller->end(SIGKILL), -1);
  bool is_busy = false;
  EXPECT_TRUE(waitUntil([&] {
    is_busy = is_busy || linked.command(plc, Command::STOP) == 7;
    return is_busy;
  })) << "the unit says nothing";
  for (int i = 0; i < 21; ++i) {
    try {
      LibmodbusClient broken(linked.port);
      broken.inputs(0, 200);
    } catch (const std::runtime_error&) {
    }
  }
  linked.link.reset();
  linked.startLink({"_modbus/allow:=192.0.2.1"});
  EXPECT_THROW(LibmodbusClient(linked.port).input(0), std::runtime_error) << "nobody who is not named";
}

TEST(PlcLink, IsLaunched) {
  int port = 0;
  EXPECT_TRUE(waitUntil([&] { return ros::param::get("/launched/plc_link/listening_port", port); }));
  LibmodbusClient plc(port);
  EXPECT_EQ(plc.input(0), 1);
  EXPECT_EQ(plc.input(1), 0) << "without a unit its heart does not beat";
}

}  // namespace
}  // namespace lamina
