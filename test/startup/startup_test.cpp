// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/startup.hpp"

#include <gtest/gtest.h>

#include "startup/started_machine.hpp"

namespace lamina {
namespace {

using StartupStep = StartupStep;
using StartupState = StartupState;
using test::StartedMachine;

/// What a request is refused with; empty if it is not.
template <class Request>
std::string startupRefusalOf(Request request) {
  try {
    request();
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

void expectPart(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "said: '" << text << "'";
}

TEST(Startup, WithoutASequenceLetsEveryJobStart) {
  const Startup startup{StartupSettings()};
  EXPECT_TRUE(startup.isEmpty());
  EXPECT_TRUE(startup.isReady());
  EXPECT_NO_THROW(startup.requireReady());
}

TEST(Startup, RefusesAJobWithTheFirstStepThatIsNotDone) {
  StartedMachine machine;
  EXPECT_EQ(
      machine.refusal(),
      "the machine is not started up: dry_pellets is Pending: not done yet; to be confirmed by the operator");
  machine.perform(StartupStep::DryPellets);
  expectPart(machine.refusal(), "power_on is Pending");
}

TEST(Startup, IsReadyWhenEveryStepWasDoneInOrder) {
  StartedMachine machine;
  machine.performAll();
  EXPECT_TRUE(machine.startup.isReady()) << machine.refusal();
  EXPECT_EQ(machine.refusal(), "");
}

TEST(Startup, RefusesStepsBeforeThoseThatTheyNeed) {
  StartedMachine machine;
  expectPart(startupRefusalOf([&] { machine.startup.begin(StartupStep::HomeX, 0.0); }),
             "home_x must wait for power_on: without power no axis moves");
  expectPart(startupRefusalOf([&] { machine.startup.confirm(StartupStep::PlaceSheet, 0.0); }),
             "place_sheet must wait for home_x: the axes are homed over the bare bed");
  expectPart(machine.reasonOf(StartupStep::DrawVacuum), "waits for place_sheet: the vacuum needs a sheet");
  EXPECT_EQ(machine.stateOf(StartupStep::HomeX), StartupState::Pending);
}

TEST(Startup, ReportsByHandFromByMachine) {
  StartedMachine machine;
  expectPart(startupRefusalOf([&] { machine.startup.begin(StartupStep::PowerOn, 0.0); }),
             "power_on is done by the operator");
  machine.perform(StartupStep::PowerOn);
  expectPart(startupRefusalOf([&] { machine.startup.confirm(StartupStep::HeatBed, 0.0); }),
             "heat_bed is done by the machine");
  expectPart(startupRefusalOf([&] { machine.startup.confirm(StartupStep::TransferProgram, 0.0); }),
             "needs program, bytes and crc32");
  EXPECT_EQ(machine.startup.nextAutomatic(), StartupStep::HeatBed);
  StartupSettings short_sequence;
  short_sequence.sequence = "home_x";
  Startup startup(short_sequence);
  EXPECT_THROW(startup.begin(StartupStep::HomeY, 0.0), InvalidInput);
}

TEST(Startup, LeavesOutWhatTheConfigurationSkips) {
  StartupSettings settings = test::largeGantry();
  settings.skip = "dry_pellets map_heights";
  StartedMachine machine(settings);
  EXPECT_EQ(machine.stateOf(StartupStep::DryPellets), StartupState::Skipped);
  expectPart(machine.reasonOf(StartupStep::DryPellets), "startup.skip");
  machine.performAll();
  EXPECT_EQ(machine.refusal(), "");
}

TEST(Startup, CountsFourHoursOfDrying) {
  StartedMachine machine;
  machine.startup.confirm(StartupStep::DryPellets, 0.0);
  machine.letPass(3.9 * 3600.0);
  EXPECT_EQ(machine.stateOf(StartupStep::DryPellets), StartupState::Running);
  expectPart(machine.reasonOf(StartupStep::DryPellets), "dried for 3.9 h; expected at least 4 h at 80 degC");
  machine.letPass(0.1 * 3600.0 + 1.0);
  EXPECT_EQ(machine.stateOf(StartupStep::DryPellets), StartupState::Done);
}

TEST(Startup, CountsNoTimeInWhichTheDryerWasCold) {
  StartupSettings settings = test::largeGantry();
  settings.dry_label = "C:";
  StartedMachine machine(settings);
  machine.startup.confirm(StartupStep::DryPellets, 0.0);
  const auto passAt = [&](double dryer_c) {
    machine.now_s += 600.0;
    machine.say("T:25.00 /0.00 B:25.00 /0.00 C:" + std::to_string(dryer_c) + " /80.00");
  };
  for (int i = 0; i < 12; ++i) passAt(30.0);                      // two hours cold
  for (int i = 0; i < 24; ++i) passAt(i % 6 == 0 ? 68.0 : 80.0);  // four hours, with the dips of regeneration
  EXPECT_EQ(machine.stateOf(StartupStep::DryPellets),
            StartupState::Running);  // the first 10 min ended hot, but began cold
  passAt(80.0);
  EXPECT_EQ(machine.stateOf(StartupStep::DryPellets), StartupState::Done);
}

TEST(Startup, DriesAnewWhatWasDryTooLongAgo) {
  StartedMachine machine;
  machine.performAll();
  machine.letPass(7.9 * 3600.0);
  EXPECT_EQ(machine.stateOf(StartupStep::DryPellets), StartupState::Done);
  machine.letPass(0.2 * 3600.0);
  EXPECT_EQ(machine.stateOf(StartupStep::DryPellets), StartupState::Pending);
  expectPart(machine.refusal(), "the pellets were dry 8.1 h ago; expected at most 8 h");
}

TEST(Startup, FailsABedThatHeatsTooFastOrNotAtAll) {
  StartedMachine fast;
  fast.perform(StartupStep::PowerOn);
  fast.startup.begin(StartupStep::HeatBed, 0.0);
  for (int minute = 0; minute <= 2; ++minute) {
    fast.now_s = 60.0 * minute;
    fast.sayBed(20.0 + 5.0 * minute);
  }
  EXPECT_EQ(fast.stateOf(StartupStep::HeatBed), StartupState::Failed);
  expectPart(fast.reasonOf(StartupStep::HeatBed), "the bed heats at 5 K/min; expected at most 4 K/min");

  StartedMachine weak;
  weak.perform(StartupStep::PowerOn);
  weak.startup.begin(StartupStep::HeatBed, 0.0);
  weak.sayBed(71.0);
  weak.startup.onCodeFinished(StartupStep::HeatBed, 59.0 * 60.0);
  EXPECT_EQ(weak.stateOf(StartupStep::HeatBed), StartupState::Running);
  weak.startup.onCodeFinished(StartupStep::HeatBed, 61.0 * 60.0);
  EXPECT_EQ(weak.stateOf(StartupStep::HeatBed), StartupState::Failed);
  EXPECT_EQ(weak.reasonOf(StartupStep::HeatBed),
            "the bed is at 71 degC; expected 89 to 91 degC within 60 min");
}

TEST(Startup, SetsTheTargetOfABedThatIsHotAlready) {
  StartedMachine machine;
  machine.perform(StartupStep::PowerOn);
  machine.startup.begin(StartupStep::HeatBed, 0.0);
  const auto question = machine.startup.nextCode(StartupStep::HeatBed);
  ASSERT_TRUE(question);
  EXPECT_EQ(question->find("M140"), std::string::npos) << "from where the ramp begins is not known yet";
  machine.say("T:25.00 /0.00 B:90.00 /0.00 @:0 B@:0");
  machine.startup.onCodeFinished(StartupStep::HeatBed, 1.0);
  EXPECT_EQ(machine.stateOf(StartupStep::HeatBed), StartupState::Running);
  const auto ramp = machine.startup.nextCode(StartupStep::HeatBed);
  ASSERT_TRUE(ramp);
  EXPECT_NE(ramp->find("M140 S90"), std::string::npos) << *ramp;
  machine.startup.onCodeFinished(StartupStep::HeatBed, 2.0);
  EXPECT_EQ(machine.stateOf(StartupStep::HeatBed), StartupState::Done);
}

TEST(Startup, LosesABedThatCoolsAndTheHeightMapWithIt) {
  StartedMachine machine;
  machine.performAll();
  machine.sayBed(88.5);  // wavers
  EXPECT_TRUE(machine.startup.isReady());
  machine.sayBed(87.0);
  EXPECT_EQ(machine.stateOf(StartupStep::HeatBed), StartupState::Pending);
  EXPECT_EQ(machine.stateOf(StartupStep::MapHeights), StartupState::Pending);
  expectPart(machine.reasonOf(StartupStep::MapHeights),
             "heat_bed was lost: the bed is at 87 degC; expected 88 to 92 degC");
  EXPECT_EQ(machine.stateOf(StartupStep::DrawVacuum), StartupState::Done);
}

TEST(Startup, LosesHomingAndTheSheetWhenMotorsAreOff) {
  for (const char* command : {"M84", "M18", "M84 S60", "M410"}) {
    StartedMachine machine;
    machine.performAll();
    machine.startup.onCommandSent(command);
    for (const StartupStep step : {StartupStep::HomeX, StartupStep::HomeY, StartupStep::HomeZ,
                                   StartupStep::HomeZAgain, StartupStep::PlaceSheet})
      EXPECT_EQ(machine.stateOf(step), StartupState::Pending) << command << " " << toString(step);
    EXPECT_EQ(machine.stateOf(StartupStep::HeatBed), StartupState::Done) << command;
    EXPECT_EQ(machine.stateOf(StartupStep::MapHeights), StartupState::Done) << command;
    expectPart(machine.refusal(), "home_x is Pending: M");

    machine.performAll();
    EXPECT_EQ(machine.refusal(), "") << command;
  }
}

TEST(Startup, LosesOnlyTheAxesWhoseMotorsAreOff) {
  StartedMachine machine;
  machine.performAll();
  machine.startup.onCommandSent("M84 E");
  EXPECT_TRUE(machine.startup.isReady());
  machine.startup.onCommandSent("M84 Y");
  EXPECT_EQ(machine.stateOf(StartupStep::HomeX), StartupState::Done);
  EXPECT_EQ(machine.stateOf(StartupStep::HomeY), StartupState::Pending);
  EXPECT_EQ(machine.stateOf(StartupStep::HomeZ), StartupState::Done);
}

TEST(Startup, LosesHomingThatTheMachineDenies) {
  for (const char* line :
       {"homed: XY", "echo:Home Z First", "echo:Home XYZ first", "Error: G0/G1: insufficient axes homed"}) {
    StartedMachine machine;
    machine.performAll();
    machine.say(line);
    EXPECT_EQ(machine.stateOf(StartupStep::HomeZ), StartupState::Pending) << line;
    EXPECT_EQ(machine.stateOf(StartupStep::HomeZAgain), StartupState::Pending) << line;
  }
}

TEST(Startup, LosesEverythingOfTheMachineWhenItStopsOrStartsAnew) {
  for (const char* line : {"start", "Error:Printer halted. kill() called!"}) {
    StartedMachine machine;
    machine.performAll();
    machine.say(line);
    for (const StartupStatus& status : machine.startup.steps()) {
      const bool is_outside =
          status.step == StartupStep::DryPellets || status.step == StartupStep::TransferProgram;
      EXPECT_EQ(status.state, is_outside ? StartupState::Done : StartupState::Pending)
          << line << " " << toString(status.step);
    }
  }
  StartedMachine machine;
  machine.performAll();
  machine.startup.onCommandSent("M112");
  EXPECT_EQ(machine.stateOf(StartupStep::PowerOn), StartupState::Pending);
}

TEST(Startup, LosesTheBedToAnotherTargetAndTheVacuumToItsOffCode) {
  StartedMachine machine;
  machine.performAll();
  machine.startup.onCommandSent("M190 S90");
  EXPECT_TRUE(machine.startup.isReady());
  machine.startup.onCommandSent("M140 S0");
  expectPart(machine.reasonOf(StartupStep::HeatBed), "M140 S0 has set another target than 90 degC");
  machine.startup.onCommandSent("M42 P3 S0");
  expectPart(machine.reasonOf(StartupStep::DrawVacuum), "M42 P3 S0 has closed a zone");
}

TEST(Startup, ReportsTheZoneThatLeaksAtOnceAndLater) {
  StartedMachine machine;
  machine.perform(StartupStep::PowerOn);
  for (const StartupStep step : {StartupStep::HeatBed, StartupStep::HomeX, StartupStep::HomeY,
                                 StartupStep::HomeZ, StartupStep::PlaceSheet})
    machine.perform(step);
  machine.startup.begin(StartupStep::DrawVacuum, 0.0);
  machine.startup.onCodeFinished(StartupStep::DrawVacuum, 0.0);
  expectPart(machine.reasonOf(StartupStep::DrawVacuum), "has not reported the pressure of zone 1");
  EXPECT_EQ(machine.stateOf(StartupStep::DrawVacuum), StartupState::Failed);
  machine.perform(StartupStep::DrawVacuum);
  EXPECT_EQ(machine.stateOf(StartupStep::DrawVacuum), StartupState::Done);
  machine.say("zone 2: 40.0 kPa");
  EXPECT_EQ(machine.stateOf(StartupStep::DrawVacuum), StartupState::Pending);
  expectPart(machine.reasonOf(StartupStep::DrawVacuum), "zone 2 is at 40 kPa; expected under 40 kPa");
}

TEST(Startup, HoldsTheVacuumBeforeItIsDone) {
  StartedMachine machine;
  machine.perform(StartupStep::PowerOn);
  for (const StartupStep step : {StartupStep::HeatBed, StartupStep::HomeX, StartupStep::HomeY,
                                 StartupStep::HomeZ, StartupStep::PlaceSheet})
    machine.perform(step);
  machine.startup.begin(StartupStep::DrawVacuum, 0.0);
  machine.sayZones(12.0);
  machine.startup.onCodeFinished(StartupStep::DrawVacuum, 30.0);
  EXPECT_EQ(machine.stateOf(StartupStep::DrawVacuum), StartupState::Running);
  machine.sayZones(45.0);
  machine.startup.onCodeFinished(StartupStep::DrawVacuum, 60.0);
  EXPECT_EQ(machine.stateOf(StartupStep::DrawVacuum), StartupState::Failed);
}

TEST(Startup, RefusesABedThatIsNotFlatAndAMapThatIsOld) {
  StartedMachine machine;
  machine.performAll();
  machine.startup.begin(StartupStep::MapHeights, machine.now_s);
  for (const char* line : {"Bilinear Leveling Grid:", " 0 -0.600 +0.600"}) machine.say(line);
  machine.startup.onCodeFinished(StartupStep::MapHeights, machine.now_s);
  expectPart(machine.reasonOf(StartupStep::MapHeights),
             "the bed's 2 heights differ by 1.2 mm; expected at most 1 mm");
  machine.perform(StartupStep::MapHeights);
  machine.letPass(25.0 * 3600.0);
  expectPart(machine.reasonOf(StartupStep::MapHeights), "the height map is 25 h old; expected at most 24 h");
}

TEST(Startup, RefusesAnotherProgramThanTheOneTransferred) {
  StartedMachine machine;
  machine.performAll();
  expectPart(startupRefusalOf([&] {
               machine.startup.requireReadyFor({"other.gcode", 1000, 0x12345678});
             }),
             "part.gcode was transferred; the job asks for other.gcode");
  expectPart(startupRefusalOf([&] {
               machine.startup.requireReadyFor({"part.gcode", 1001, 0x12345678});
             }),
             "part.gcode was changed after it was transferred");
}

TEST(Startup, DoesNotRunAStepAgainOnWhichOthersRest) {
  StartedMachine machine;
  machine.performAll();
  expectPart(startupRefusalOf([&] { machine.startup.begin(StartupStep::HomeX, 0.0); }),
             "home_x is done, and place_sheet after it");
}

TEST(Startup, GivesUpARunningStepButNotTheOperatorsDryer) {
  StartedMachine machine;
  machine.startup.confirm(StartupStep::DryPellets, 0.0);
  machine.perform(StartupStep::PowerOn);
  machine.startup.begin(StartupStep::HeatBed, 0.0);
  for (const StartupStep step : allStartupSteps()) machine.startup.giveUp(step, "aborted");
  EXPECT_EQ(machine.stateOf(StartupStep::HeatBed), StartupState::Pending);
  EXPECT_EQ(machine.stateOf(StartupStep::DryPellets), StartupState::Running);
  EXPECT_EQ(machine.stateOf(StartupStep::PowerOn), StartupState::Done);
}

}  // namespace
}  // namespace lamina
