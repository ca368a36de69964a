// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What a person changes of a print that a server runs, what the machine complains of meanwhile, and prints
// that are followed from where an earlier session left them.

#include <gtest/gtest.h>

#include "streaming/upload/upload_fixture.hpp"

namespace lamina {
namespace {

using test::hotProgram;
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
  EXPECT_NE(link.job.status().message.find("no answer, so that it may still be done"), std::string::npos)
      << link.job.status().message;
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.changes.size(), 1U);
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
                    UploadAim::Follow,
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

INSTANTIATE_TEST_SUITE_P(Servers, LiveUpload,
                         testing::Values(ServerKind{"Moonraker", makeEmulatedMoonraker, "klipper"},
                                         ServerKind{"Duet", makeEmulatedDuet, "reprapfirmware"},
                                         ServerKind{"DuetWithComputer", makeEmulatedDuetWithComputer,
                                                    "reprapfirmware"}),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// Klipper that hears nothing while it waits for heat.
SimulatedHttp stoppedInVain(EmergencyStop emergency) {
  StreamSettings settings;
  settings.emergency_stop = emergency;
  SimulatedHttp link(orderOf(hotProgram(500)), settings, makeEmulatedMoonraker());
  link.faults.late_s = 1000.0;
  link.late_words = {"print/cancel"};
  link.start();
  link.runUntilState(PackmlState::Execute);
  link.job.abort({ErrorCode::Cancelled, "the user said so"}, link.now);
  link.runUntil(100.0);
  return link;
}

TEST(EmergencyStopOfAnUpload, IsOfferedWhereTheStopIsNotConfirmed) {
  const SimulatedHttp link = stoppedInVain(EmergencyStop::Never);
  const std::string& message = link.job.status().failure.message;
  EXPECT_NE(message.find("has not confirmed within 10 s"), std::string::npos) << message;
  EXPECT_NE(message.find("POST /printer/emergency_stop"), std::string::npos) << message;
  EXPECT_FALSE(link.server->printer.is_halted);
}

TEST(EmergencyStopOfAnUpload, LeavesAColdMachineWhereItIsAskedFor) {
  const SimulatedHttp link = stoppedInVain(EmergencyStop::Unconfirmed);
  const std::string& message = link.job.status().failure.message;
  EXPECT_NE(message.find("was shut down by an emergency stop"), std::string::npos) << message;
  EXPECT_TRUE(link.server->printer.is_halted);
  EXPECT_EQ(link.server->printer.nozzle_target_c, 0.0);
}

}  // namespace
}  // namespace lamina
