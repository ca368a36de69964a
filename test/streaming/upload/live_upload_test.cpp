// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What a person changes of a print that a server runs, what the machine complains of meanwhile, and prints
// that are followed from where an earlier session left them.

#include <gtest/gtest.h>

#include <memory>

#include "streaming/upload/upload_fixture.hpp"

namespace lamina {
namespace {

using test::hotProgram;
using test::MakeServer;
using test::orderOf;
using test::ServerKind;
using test::SimulatedHttp;
using Commands = std::vector<std::string>;

constexpr const char* kTwoParts =
    "EXCLUDE_OBJECT_DEFINE NAME=left CENTER=1,1\nEXCLUDE_OBJECT_DEFINE NAME=right\nEXCLUDE_OBJECT_START "
    "NAME=left\n";

std::string layers(int count) {
  std::string text;
  for (int layer = 0; layer < count; ++layer) {
    text += ";LAYER:" + std::to_string(layer) + "\n";
    for (int i = 0; i < 200; ++i) text += "G1 X" + std::to_string(i) + " Y" + std::to_string(layer) + "\n";
  }
  return text;
}

class LiveUpload : public testing::TestWithParam<ServerKind> {
 protected:
  static bool isKlipper() { return GetParam().firmware == std::string("klipper"); }
  static SimulatedHttp linkTo(const std::string& program, const StreamSettings& settings = {}) {
    return {orderOf(program), settings, GetParam().make()};
  }
};

TEST_P(LiveUpload, ChangesThePrintByTheFirmwaresOwnCommands) {
  SimulatedHttp link = linkTo(kTwoParts + hotProgram(1000));
  EXPECT_EQ(link.job.change({LiveSetting::Feed, 90.0}, 0.0), kNoJobToChange);
  link.start();
  link.runUntilState(PackmlState::Execute);
  for (const LiveChange change :
       {LiveChange{LiveSetting::Feed, 90.0}, LiveChange{LiveSetting::Flow, 105.0},
        LiveChange{LiveSetting::Babystep, -0.05}, LiveChange{LiveSetting::CancelPart, 1.0}})
    EXPECT_EQ(link.job.change(change, link.now), "");
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.changes,
            isKlipper() ? (Commands{"M220 S90", "M221 S105", "SET_GCODE_OFFSET Z_ADJUST=-0.05 MOVE=1",
                                    "EXCLUDE_OBJECT NAME=right"})
                        : (Commands{"M220 S90", "M221 S105", "M290 R1 S-0.05", "M486 P1"}));
  EXPECT_EQ(link.job.status().commands_not_done, 0U);
}

TEST_P(LiveUpload, RefusesByNameWhatTheFirmwareHasNot) {
  SimulatedHttp link = linkTo(kTwoParts + hotProgram(1000));
  link.start();
  link.runUntilState(PackmlState::Execute);
  EXPECT_EQ(link.job.change({LiveSetting::Spindle, 50.0}, link.now),
            isKlipper() ? "Klipper has no spindle" : "RepRapFirmware has no spindle");
  if (isKlipper()) {
    EXPECT_EQ(link.job.change({LiveSetting::CancelPart, 2.0}, link.now),
              "part 2 is not in the program, which defines 2 for Klipper (EXCLUDE_OBJECT_DEFINE)");
  }
  link.runUntil(1e5);
  EXPECT_TRUE(link.server->printer.changes.empty());
}

TEST_P(LiveUpload, SendsAChangeThatMayHaveArrivedOnce) {
  SimulatedHttp link = linkTo(hotProgram(3000));
  link.late_words = {"SET_GCODE_OFFSET", "M290"};
  link.start();
  link.runUntilState(PackmlState::Execute);
  EXPECT_EQ(link.job.change({LiveSetting::Babystep, 0.1}, link.now), "");
  link.runUntil(link.now + 11.0);
  EXPECT_NE(link.job.status().message.find("no answer within 10 s; it was not asked for again, for it may"),
            std::string::npos)
      << link.job.status().message;
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.changes.size(), 1U);
}

TEST_P(LiveUpload, SendsAChangeAgainThatTheServerHasNotTaken) {
  SimulatedHttp link = linkTo(hotProgram(3000));
  link.start();
  link.runUntilState(PackmlState::Execute);
  link.turned_away = test::TurnedAway{"M221", {503, "busy"}, link.now + 5.0};
  EXPECT_EQ(link.job.change({LiveSetting::Flow, 105.0}, link.now), "");
  EXPECT_EQ(link.job.change({LiveSetting::Feed, 90.0}, link.now), "");
  link.runUntil(link.now + 3.0);
  EXPECT_EQ(link.job.status().message,
            "M221 S105: the command was refused: busy (HTTP status 503); it is asked for again");
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.changes, (Commands{"M221 S105", "M220 S90"}));
}

TEST_P(LiveUpload, TellsWhatAServerSaysThatMayHaveMadeAChange) {
  SimulatedHttp link = linkTo(hotProgram(3000));
  link.start();
  link.runUntilState(PackmlState::Execute);
  link.turned_away = test::TurnedAway{"M221", {504, "gateway timeout"}};
  EXPECT_EQ(link.job.change({LiveSetting::Flow, 105.0}, link.now), "");
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_EQ(
      link.job.status().message,
      "M221 S105: the command was refused: gateway timeout (HTTP status 504); it was not asked for again, "
      "for it may still be done");
  EXPECT_TRUE(link.server->printer.changes.empty());
}

TEST_P(LiveUpload, FollowsAPrintThatAnswersNoChangeForLong) {
  SimulatedHttp link = linkTo(hotProgram(20000));  // 200 s
  link.late_words = {"M220"};
  link.faults.late_s = 90.0;  // as Klipper does that waits for heat
  link.start();
  link.runUntilState(PackmlState::Execute);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(link.job.change({LiveSetting::Feed, 90.0 + i}, link.now), "");
  link.runUntil(link.now + 100.0);
  EXPECT_EQ(link.job.status().state, PackmlState::Execute) << link.job.status().failure.message;
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.changes.size(), 8U);
}

TEST_P(LiveUpload, HoldsOnceInALayer) {
  SimulatedHttp link = linkTo(layers(5));
  link.start();
  link.runUntilState(PackmlState::Execute);
  EXPECT_EQ(link.job.change({LiveSetting::PauseAtLayer, 2.0}, link.now), "");
  link.runUntilState(PackmlState::Held);
  const std::size_t run = link.server->printer.executed().size();
  EXPECT_GT(run, 400U) << "two layers of 200 lines";
  EXPECT_LT(run, 460U) << "at 100 lines a second, and five looks";
  EXPECT_TRUE(link.job.resume(link.now));
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
}

TEST_P(LiveUpload, CountsWhatTheMachineDidNotKnow) {
  SimulatedHttp link = linkTo("G1 X1\nUNKNOWN_1\nG1 X2\nUNKNOWN_2\nG1 X3\n");
  link.server->printer.unknown = {"UNKNOWN_0"};  // of an earlier print
  link.run();
  const StreamStatus& status = link.job.status();
  EXPECT_EQ(status.state, PackmlState::Complete) << status.failure.message;
  EXPECT_EQ(status.commands_not_done, 2U);
  EXPECT_NE(status.first_not_done.find("UNKNOWN_1"), std::string::npos) << status.first_not_done;
}

TEST_P(LiveUpload, TellsStallsWhereTheMachineCountsThem) {
  SimulatedHttp link = linkTo(hotProgram(500));
  link.server->printer.stalls = 7;
  link.events.push_back({3.0, [](EmulatedPrintServer& server) { server.printer.stalls += 2; }});
  link.run();
  const Starvation& starvation = link.job.status().starvation;
  EXPECT_EQ(starvation.source, isKlipper() ? StarvationSource::Machine : StarvationSource::Nobody);
  EXPECT_EQ(starvation.count, isKlipper() ? 2U : 0U);
}

std::shared_ptr<const UploadOrder> following(const std::string& text) {
  UploadOrder order{ProgramBody(StreamableProgram::fromText("part", text)),
                    "lamina/part-2.gcode",
                    "",
                    60.0,
                    10.0,
                    JobStart::Resume,
                    "lamina/part-"};
  return std::make_shared<const UploadOrder>(std::move(order));
}

TEST_P(LiveUpload, FollowsAPrintThatAnEarlierSessionBegan) {
  const std::string text = hotProgram(500);
  SimulatedHttp link(following(text), {}, GetParam().make());
  link.server->printer.files["lamina/part-1.gcode"] = text;
  ASSERT_TRUE(link.server->printer.print("lamina/part-1.gcode"));
  link.server->printer.elapse(2.0);
  link.now = 2.0;
  link.run();
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_EQ(link.job.status().lines_acknowledged, 502U);
  EXPECT_EQ(link.server->printer.executed(), test::commandsOf(text)) << "nothing is started again";
  EXPECT_TRUE(link.server->printer.files.empty());
}

TEST_P(LiveUpload, FollowsNoPrintOfAnotherProgram) {
  SimulatedHttp link(following(hotProgram(500)), {}, GetParam().make());
  link.server->printer.files["lamina/part-1.gcode"] = hotProgram(499);
  ASSERT_TRUE(link.server->printer.print("lamina/part-1.gcode"));
  link.run();
  EXPECT_EQ(link.job.status().failure.code, ErrorCode::Rejected);
  EXPECT_EQ(link.server->printer.state(), EmulatedPrinter::State::Printing);

  SimulatedHttp idle(following(hotProgram(500)), {}, GetParam().make());
  idle.run();
  EXPECT_NE(idle.job.status().failure.message.find("it knows of no print"), std::string::npos)
      << idle.job.status().failure.message;
}

/// The machine has printed the program of `following` for a while, and what comes then.
template <class Happens>
std::unique_ptr<SimulatedHttp> linkToAnEarlierPrint(const MakeServer& make, Happens happens) {
  auto held = std::make_unique<SimulatedHttp>(following(hotProgram(500)), StreamSettings{}, make());
  SimulatedHttp& link = *held;
  EmulatedPrinter& printer = link.server->printer;
  printer.files["lamina/part-1.gcode"] = hotProgram(500);
  EXPECT_TRUE(printer.print("lamina/part-1.gcode"));
  printer.elapse(2.0);
  link.now = 2.0;
  happens(printer);
  return held;
}

void expectLeftAlone(const SimulatedHttp& link) {
  EXPECT_EQ(link.server->printer.nozzle_target_c, 170.0) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.files.size(), 1U);
  EXPECT_NE(link.job.status().failure.message.find("left as they are"), std::string::npos)
      << link.job.status().failure.message;
}

TEST_P(LiveUpload, LeavesAMachineAloneWhosePrintHasEnded) {
  const auto held_cancelled = linkToAnEarlierPrint(GetParam().make, [](EmulatedPrinter& printer) {
    printer.cancel();
    printer.nozzle_target_c = 170.0;  // for another job
  });
  SimulatedHttp& cancelled = *held_cancelled;
  cancelled.run();
  EXPECT_EQ(cancelled.job.status().failure.code, ErrorCode::Cancelled);
  expectLeftAlone(cancelled);

  const auto held_failed = linkToAnEarlierPrint(GetParam().make, [](EmulatedPrinter& printer) {
    printer.breakDown();
    printer.nozzle_target_c = 170.0;
  });
  SimulatedHttp& failed = *held_failed;
  failed.run();
  EXPECT_EQ(failed.job.status().state, PackmlState::Aborted);
  expectLeftAlone(failed);
}

TEST_P(LiveUpload, LeavesAMachineAloneWhosePrintEndsWhileItIsLookedAt) {
  const auto held_link = linkToAnEarlierPrint(GetParam().make, [](EmulatedPrinter&) {});
  SimulatedHttp& link = *held_link;
  link.faults.slow = 1.0;  // 4 s for each answer
  link.server->printer.lines_per_s = 1.0;
  link.start();
  const auto asksForTheFile = [&] { return link.targets.back().find("file") != std::string::npos; };
  while (!asksForTheFile()) link.runUntil(link.now + 0.5);
  link.server->printer.cancel();
  link.server->printer.nozzle_target_c = 170.0;
  link.runUntilState(PackmlState::Aborted);
  expectLeftAlone(link);
}

TEST_P(LiveUpload, TellsThatAnEarlierPrintIsComplete) {
  const auto held_link = linkToAnEarlierPrint(GetParam().make, [](EmulatedPrinter& printer) {
    printer.elapse(100.0);
    printer.nozzle_target_c = 170.0;
  });
  SimulatedHttp& link = *held_link;
  link.now = 100.0;
  link.run();
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_EQ(link.job.status().lines_acknowledged, 502U);
  EXPECT_EQ(link.server->printer.nozzle_target_c, 170.0);
}

INSTANTIATE_TEST_SUITE_P(Servers, LiveUpload,
                         testing::Values(ServerKind{"Moonraker", makeEmulatedMoonraker, "klipper"},
                                         ServerKind{"Duet", makeEmulatedDuet, "reprapfirmware"},
                                         ServerKind{"DuetWithComputer", makeEmulatedDuetWithComputer,
                                                    "reprapfirmware"}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(LiveUploadToADuet, SendsAChangeAgainForWhichItHasNoRoom) {
  SimulatedHttp link(orderOf(hotProgram(3000)), {}, makeEmulatedDuet());
  link.start();
  link.runUntilState(PackmlState::Execute);
  link.turned_away = test::TurnedAway{"M221", {200, R"({"err":1})"}, link.now + 5.0};
  EXPECT_EQ(link.job.change({LiveSetting::Flow, 105.0}, link.now), "");
  link.runUntil(link.now + 3.0);
  EXPECT_NE(link.job.status().message.find("no room for another command; it is asked for again"),
            std::string::npos)
      << link.job.status().message;
  link.runUntil(1e5);
  EXPECT_EQ(link.server->printer.changes, Commands{"M221 S105"});
}

// Somebody moves it for another job.
TEST(LiveUploadToMoonraker, StopsNothingWhereAnEarlierPrintIsComplete) {
  const auto held_link = linkToAnEarlierPrint(makeEmulatedMoonraker, [](EmulatedPrinter& printer) {
    printer.elapse(100.0);
    printer.nozzle_target_c = 170.0;
    printer.moveFor(50.0);
  });
  SimulatedHttp& link = *held_link;
  link.now = 100.0;
  link.start();
  link.runUntilState(PackmlState::Completing);
  link.job.abort({ErrorCode::Cancelled, "the user said so"}, link.now);
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Aborted);
  EXPECT_EQ(link.server->printer.nozzle_target_c, 170.0);
}

/// Klipper that hears nothing while it waits for heat.
std::unique_ptr<SimulatedHttp> stoppedInVain(EmergencyStop emergency,
                                             const std::optional<test::TurnedAway>& turned_away = {}) {
  StreamSettings settings;
  settings.emergency_stop = emergency;
  auto held = std::make_unique<SimulatedHttp>(orderOf(hotProgram(500)), settings, makeEmulatedMoonraker());
  SimulatedHttp& link = *held;
  link.faults.late_s = 1000.0;
  link.late_words = {"print/cancel"};
  link.turned_away = turned_away;
  link.start();
  link.runUntilState(PackmlState::Execute);
  link.job.abort({ErrorCode::Cancelled, "the user said so"}, link.now);
  link.runUntil(100.0);
  return held;
}

TEST(EmergencyStopOfAnUpload, IsOfferedWhereTheStopIsNotConfirmed) {
  const auto held_link = stoppedInVain(EmergencyStop::Never);
  SimulatedHttp& link = *held_link;
  const std::string& message = link.job.status().failure.message;
  EXPECT_NE(message.find("has not confirmed within 10 s"), std::string::npos) << message;
  EXPECT_NE(message.find("POST /printer/emergency_stop"), std::string::npos) << message;
  EXPECT_FALSE(link.server->printer.is_halted);
}

TEST(EmergencyStopOfAnUpload, LeavesAColdMachineWhereItIsAskedFor) {
  const auto held_link = stoppedInVain(EmergencyStop::Unconfirmed);
  SimulatedHttp& link = *held_link;
  const std::string& message = link.job.status().failure.message;
  EXPECT_NE(message.find("was shut down by an emergency stop"), std::string::npos) << message;
  EXPECT_TRUE(link.server->printer.is_halted);
  EXPECT_EQ(link.server->printer.nozzle_target_c, 0.0);
}

HttpResponse unavailable() {
  return {503, R"({"error":{"code":503,"message":"Klippy Host not connected"}})"};
}

TEST(EmergencyStopOfAnUpload, IsAskedForAgainUntilItIsTaken) {
  const auto held_link =
      stoppedInVain(EmergencyStop::Unconfirmed, test::TurnedAway{"emergency_stop", unavailable(), 15.0});
  SimulatedHttp& link = *held_link;
  EXPECT_TRUE(link.server->printer.is_halted) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.nozzle_target_c, 0.0);
  EXPECT_NE(link.job.status().failure.message.find("was shut down by an emergency stop"), std::string::npos);
}

TEST(EmergencyStopOfAnUpload, IsAskedForAgainWhereTheServerCannotBeReached) {
  StreamSettings settings;
  settings.emergency_stop = EmergencyStop::Unconfirmed;
  SimulatedHttp link(orderOf(hotProgram(5000)), settings, makeEmulatedMoonraker());
  link.start();
  link.runUntil(6.0);
  link.unreachable_from_s = 6.0;
  link.unreachable_until_s = 20.0;  // the stop is given up at 16 s
  link.job.abort({ErrorCode::Cancelled, "the user said so"}, link.now);
  link.runUntil(100.0);
  EXPECT_TRUE(link.server->printer.is_halted) << link.job.status().failure.message;
}

TEST(EmergencyStopOfAnUpload, IsToldWhereItWasInVain) {
  const auto held_link =
      stoppedInVain(EmergencyStop::Unconfirmed, test::TurnedAway{"emergency_stop", unavailable()});
  SimulatedHttp& link = *held_link;
  EXPECT_FALSE(link.server->printer.is_halted);
  const std::string& message = link.job.status().failure.message;
  EXPECT_NE(
      message.find("an emergency stop was asked for: the command was refused: Klippy Host not connected"),
      std::string::npos)
      << message;
}

}  // namespace
}  // namespace lamina
