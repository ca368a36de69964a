// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Machines that are stopped in the place of their streamer, over real pseudo-terminals and sockets.
#include "lamina/streaming/guard/machine_stop.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "lamina/base/error.hpp"
#include "streaming/firmware/marlin/stop_commands.hpp"
#include "streaming/guard/left_machine.hpp"

namespace lamina {
namespace {

using test::inTemporary;
using test::LeftMachine;

MachinePulse machineWith(const std::string& firmware) {
  MachinePulse machine;
  machine.firmware = firmware;
  return machine;
}

MachinePulse keepingItsHeat(const std::string& firmware) {
  MachinePulse machine = machineWith(firmware);
  machine.keeps_heaters_on = true;
  return machine;
}

TEST(UrgentStop, HasTheBeamAndTheHeatersOff) {
  EXPECT_EQ(urgentStopOf(machineWith("marlin")), "M108\nM410\nM5\nM104 S0\nM140 S0\n");
  EXPECT_EQ(urgentStopOf(keepingItsHeat("marlin")), "M108\nM410\nM5\n");
  EXPECT_EQ(urgentStopOf(machineWith("auto")), urgentStopOf(machineWith("marlin")));
  EXPECT_EQ(urgentStopOf(machineWith("klipper")), "M5\nTURN_OFF_HEATERS\n");
  EXPECT_EQ(urgentStopOf(keepingItsHeat("klipper")), "M5\n");
  EXPECT_EQ(urgentStopOf(machineWith("grbl")), "!");
  EXPECT_NE(urgentStopOf(machineWith("reprapfirmware")).find("M104 S0\n"), std::string::npos);
}

TEST(UrgentStop, FitsIntoAReceiveBuffer) {
  for (const char* firmware : {"marlin", "klipper", "reprapfirmware", "grbl"})
    EXPECT_LT(urgentStopOf(machineWith(firmware)).size(), 127U) << firmware;
}

TEST(UrgentStop, WaitsForNoProgramToBeRead) {
  const std::string program = inTemporary("stop_urgent.gcode");
  std::ofstream(program) << "M106 P2 S255\nM141 S60\nG1 X1\n";
  for (const char* firmware : {"marlin", "klipper", "reprapfirmware", "grbl"}) {
    MachinePulse machine = machineWith(firmware);
    machine.program = program;
    EXPECT_EQ(urgentStopOf(machine), urgentStopOf(machineWith(firmware))) << firmware;
  }
}

TEST(MachineStop, IsConfirmedByTheMachine) {
  const LeftMachine machine("stop_confirmed");
  machine.heat();
  int begun = 0;
  const MachineStopReport report = stopMachine(machine.pulse(), [&begun] { ++begun; });
  EXPECT_TRUE(report.is_confirmed) << report.message;
  EXPECT_EQ(report.message, "it is at rest, its heaters are off");
  EXPECT_EQ(begun, 1);
  EXPECT_TRUE(report.has_begun);
  EXPECT_EQ(machine->nozzleTarget(), 0.0);
  EXPECT_EQ(machine->bedTarget(), 0.0);
}

TEST(MachineStop, WaitsForAPortThatTheDeadProcessStillHolds) {
  const LeftMachine machine("stop_busy");
  machine.heat();
  const int held = ::open(machine.pulse().port.name.c_str(), O_RDWR | O_NOCTTY);
  ASSERT_EQ(::flock(held, LOCK_EX | LOCK_NB), 0);
  std::thread dying([held] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ::close(held);
  });
  const MachineStopReport report = stopMachine(machine.pulse(), {});
  dying.join();
  EXPECT_TRUE(report.is_confirmed) << report.message;
  EXPECT_EQ(machine->nozzleTarget(), 0.0);
}

TEST(MachineStop, LeavesHeatersOnThatAreToStayOn) {
  const LeftMachine machine("stop_kept");
  machine.heat();
  MachinePulse pulse = machine.pulse();
  pulse.keeps_heaters_on = true;
  const MachineStopReport report = stopMachine(pulse, {});
  EXPECT_TRUE(report.is_confirmed) << report.message;
  EXPECT_EQ(machine->nozzleTarget(), 200.0);
}

TEST(MachineStop, SwitchesOffWhatTheProgramHasUsed) {
  const LeftMachine machine("stop_used");
  machine.heat();
  MachinePulse pulse = machine.pulse();
  pulse.program = inTemporary("stop_used.gcode");
  std::ofstream(pulse.program) << "M106 P2 S255\nM141 S60\nM104 T1 S200\nG1 X1\n";
  EXPECT_TRUE(stopMachine(pulse, {}).is_confirmed);
  const std::string ran = machine.ran();
  for (const char* command : {"M106 P2 S0", "M141 S0", "M104 T1 S0"})
    EXPECT_NE(ran.find(command), std::string::npos) << command << " in " << ran;
}

TEST(MachineStop, SwitchesOffWhatIsReportedAsOnWithoutAProgram) {
  EmulatedSettings settings;
  settings.has_dryer = true;
  const LeftMachine machine("stop_reported", settings);
  machine.heat("M141 S60\n");
  const MachineStopReport report = stopMachine(machine.pulse(), {});
  EXPECT_TRUE(report.is_confirmed) << report.message;
  EXPECT_NE(machine.ran().find("M141 S0"), std::string::npos) << machine.ran();
}

TEST(MachineStop, SwitchesOffTheToolsThatAReportNames) {
  using Commands = std::vector<std::string>;
  EXPECT_EQ(reportedHeatersOff("ok T:200.0 /200.0 B:60.0 /60.0 T0:200.0 /200.0 T1:190.0 /190.0 @:127 B@:0"),
            (Commands{"M104 T0 S0", "M104 T1 S0", "M141 S0"}));
  EXPECT_EQ(reportedHeatersOff("T:200.0 /200.0 B:60.0 /60.0"), Commands{"M141 S0"});
}

TEST(MachineStop, SaysThatNobodyIsThere) {
  const MachineStopReport report = stopMachine({true, {"/nowhere/machine", 115200}, "marlin", "", false}, {});
  EXPECT_FALSE(report.is_confirmed);
  EXPECT_FALSE(report.has_begun);
  EXPECT_NE(report.message.find("/nowhere/machine"), std::string::npos) << report.message;
}

}  // namespace
}  // namespace lamina
