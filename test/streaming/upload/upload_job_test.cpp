// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/upload_job.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "streaming/upload/upload_fixture.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

using test::HttpFaults;
using test::kOurFile;
using test::orderOf;
using test::SimulatedHttp;

/// Every kind of print server behaves alike.
class UploadJobTest : public testing::TestWithParam<test::ServerKind> {
 protected:
  SimulatedHttp link(const std::string& text, const StreamSettings& settings = {}) const {
    return {orderOf(text), settings, GetParam().make()};
  }
  SimulatedHttp hot(const StreamSettings& settings = {}) const {
    return link(test::hotProgram(2000), settings);
  }
  static void expectSafe(const SimulatedHttp& link) {
    EXPECT_EQ(link.server->printer.state(), EmulatedPrinter::State::Idle);
    EXPECT_EQ(link.server->printer.nozzle_target_c, 0.0);
    EXPECT_EQ(link.server->printer.bed_target_c, 0.0);
  }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_P(UploadJobTest, PrintsAProgramOnce) {
  const std::string text = test::hotProgram(500);
  SimulatedHttp link = this->link(text);
  link.run();
  const StreamStatus& status = link.job.status();
  EXPECT_EQ(status.state, PackmlState::Complete) << status.failure.message;
  EXPECT_EQ(link.server->printer.executed(), test::commandsOf(text));
  EXPECT_EQ(status.lines_total, 502U);
  EXPECT_EQ(status.lines_sent, 502U);
  EXPECT_EQ(status.lines_acknowledged, 502U);
  ASSERT_TRUE(status.temperatures);
  EXPECT_EQ(status.temperatures->nozzle_c, 24.5);
  EXPECT_EQ(status.temperatures->nozzle_target_c, 200.0);
  EXPECT_EQ(status.temperatures->bed_c, 23.5);
  ASSERT_TRUE(status.position);
  EXPECT_EQ(status.position->z, 3.0);
  EXPECT_TRUE(link.server->printer.files.empty());
  const std::vector<PackmlState> expected = {PackmlState::Starting, PackmlState::Execute,
                                             PackmlState::Completing, PackmlState::Complete};
  EXPECT_EQ(link.states, expected);
}

TEST_P(UploadJobTest, RunsALastLineWithoutEnd) {
  SimulatedHttp link = this->link("G1 X1\nG1 X2");
  link.run();
  EXPECT_EQ(link.job.status().state, PackmlState::Complete);
  EXPECT_EQ(link.server->printer.executed(), (std::vector<std::string>{"G1 X1", "G1 X2"}));
}

TEST_P(UploadJobTest, CountsTheLinesThatTheMachineHasRead) {
  SimulatedHttp link = hot();
  link.start();
  link.runUntil(10.0);
  const auto lines = static_cast<double>(link.job.status().lines_acknowledged);
  const auto run = static_cast<double>(link.server->printer.executed().size());
  EXPECT_EQ(link.job.status().state, PackmlState::Execute);
  EXPECT_LE(lines, run);
  EXPECT_GE(lines, run - 2.0 * link.server->printer.lines_per_s);
}

TEST_P(UploadJobTest, AsksForNoOtherFirmware) {
  StreamSettings settings;
  settings.firmware = std::string(GetParam().firmware) == "klipper" ? "reprapfirmware" : "klipper";
  SimulatedHttp link = this->link("G1 X1\n", settings);
  link.run();
  EXPECT_EQ(link.job.status().state, PackmlState::Aborted);
  EXPECT_EQ(link.job.status().failure.code, ErrorCode::Rejected);
  EXPECT_TRUE(link.server->printer.files.empty());
}

TEST_P(UploadJobTest, GivesThePasswordWhereItIsAskedFor) {
  SimulatedHttp right(orderOf("G1 X1\n", "open sesame"), {}, GetParam().make());
  right.server->password = "open sesame";
  right.run();
  EXPECT_EQ(right.job.status().state, PackmlState::Complete) << right.job.status().failure.message;

  for (const std::string password : {"", "wrong"}) {
    SimulatedHttp wrong(orderOf("G1 X1\n", password), {}, GetParam().make());
    wrong.server->password = "open sesame";
    wrong.run();
    const Failure& failure = wrong.job.status().failure;
    EXPECT_EQ(failure.code, ErrorCode::Rejected);
    EXPECT_TRUE(contains(failure.message, "stream.password_file")) << failure.message;
    EXPECT_FALSE(contains(failure.message, "wrong")) << failure.message;
    EXPECT_TRUE(wrong.server->printer.files.empty());
  }
}

TEST_P(UploadJobTest, LeavesAnotherPrintAlone) {
  SimulatedHttp link = hot();
  link.server->printer.files["other.gcode"] = test::hotProgram(10000);
  link.server->printer.print("other.gcode");
  link.run();
  const Failure& failure = link.job.status().failure;
  EXPECT_EQ(failure.code, ErrorCode::Rejected);
  EXPECT_TRUE(contains(failure.message, "other.gcode")) << failure.message;
  EXPECT_EQ(link.server->printer.state(), EmulatedPrinter::State::Printing);
  EXPECT_EQ(link.server->printer.files.size(), 1U);
}

TEST_P(UploadJobTest, LeavesAPrintAloneThatBeginsDuringTheUpload) {
  SimulatedHttp link = hot();
  link.server->printer.files["other.gcode"] = test::hotProgram(10000);
  link.faults.slow = 1.0;
  link.events.push_back({14.0, [](EmulatedPrintServer& server) { server.printer.print("other.gcode"); }});
  link.run();
  EXPECT_EQ(link.job.status().failure.code, ErrorCode::Rejected) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.state(), EmulatedPrinter::State::Printing);
  EXPECT_EQ(link.server->printer.file(), "other.gcode");
}

TEST_P(UploadJobTest, RefusesAPrinterThatIsNotReady) {
  SimulatedHttp link = hot();
  link.server->printer.halt();
  link.run();
  EXPECT_EQ(link.job.status().failure.code, ErrorCode::Rejected);
  EXPECT_TRUE(contains(link.job.status().failure.message, "not ready")) << link.job.status().failure.message;
  EXPECT_TRUE(link.server->printer.files.empty());
}

TEST_P(UploadJobTest, StartsNothingThatWasDamagedOnTheWay) {
  SimulatedHttp link = hot();
  link.faults.damaged = 1.0;
  link.run();
  EXPECT_EQ(link.job.status().state, PackmlState::Aborted);
  EXPECT_EQ(link.job.status().failure.code, ErrorCode::Rejected) << link.job.status().failure.message;
  EXPECT_TRUE(link.server->printer.executed().empty());
  EXPECT_TRUE(link.server->printer.files.empty());
}

TEST_P(UploadJobTest, RefusesAProgramThatWasChanged) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("part.gcode");
  std::ofstream(path) << "G1 X1\n";
  SimulatedHttp link(orderOf(StreamableProgram::fromFile(path)), {}, GetParam().make());
  std::ofstream(path) << "G1 X1\nG1 X2\n";
  link.run();
  EXPECT_EQ(link.job.status().failure.code, ErrorCode::InvalidProgram);
  EXPECT_TRUE(link.server->printer.files.empty());
}

TEST_P(UploadJobTest, PausesAndGoesOn) {
  SimulatedHttp link = hot();
  link.start();
  link.runUntilState(PackmlState::Execute);
  EXPECT_FALSE(link.job.resume(link.now));
  EXPECT_TRUE(link.job.pause(link.now));
  link.runUntilState(PackmlState::Held);
  EXPECT_EQ(link.server->printer.state(), EmulatedPrinter::State::Paused);
  EXPECT_TRUE(link.job.resume(link.now));
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.executed().size(), 2002U);
}

TEST_P(UploadJobTest, PausesAsSoonAsItPrintsIfItIsAskedToBefore) {
  SimulatedHttp link = hot();
  link.start();
  ASSERT_EQ(link.job.status().state, PackmlState::Starting);
  EXPECT_TRUE(link.job.pause(link.now));
  link.runUntilState(PackmlState::Held);
  EXPECT_EQ(link.server->printer.state(), EmulatedPrinter::State::Paused);
  EXPECT_LT(link.server->printer.executed().size(), 2002U);
  EXPECT_TRUE(link.job.resume(link.now));
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.executed().size(), 2002U);
}

TEST_P(UploadJobTest, FollowsAPauseAtTheMachine) {
  SimulatedHttp link = hot();
  link.events.push_back({5.0, [](EmulatedPrintServer& server) { server.printer.pause(); }});
  link.events.push_back({100.0, [](EmulatedPrintServer& server) { server.printer.resume(); }});
  link.start();
  link.runUntil(50.0);
  EXPECT_EQ(link.job.status().state, PackmlState::Held);
  EXPECT_EQ(link.job.status().message, "paused at the machine");
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Complete);
}

TEST_P(UploadJobTest, EndsThePrintAndTurnsHeatersOffOnAnAbort) {
  SimulatedHttp link = hot();
  link.start();
  link.runUntil(10.0);
  link.job.abort({ErrorCode::Cancelled, "the user said so"}, link.now);
  link.runUntil(1e5);
  const Failure& failure = link.job.status().failure;
  EXPECT_EQ(failure.code, ErrorCode::Cancelled);
  EXPECT_TRUE(contains(failure.message, "its heaters are off")) << failure.message;
  expectSafe(link);
  EXPECT_TRUE(link.server->printer.files.empty());
}

TEST_P(UploadJobTest, KeepsTheHeatersOnWhereItIsTold) {
  StreamSettings settings;
  settings.keep_heaters_on = true;
  SimulatedHttp link = hot(settings);
  link.start();
  link.runUntil(10.0);
  link.job.abort({ErrorCode::Cancelled, "the user said so"}, link.now);
  link.runUntil(1e5);
  EXPECT_EQ(link.server->printer.state(), EmulatedPrinter::State::Idle);
  EXPECT_EQ(link.server->printer.nozzle_target_c, 200.0);
}

TEST_P(UploadJobTest, StopsNothingBeforeTheStart) {
  SimulatedHttp link = hot();
  link.server->printer.nozzle_target_c = 170.0;  // somebody warms it up
  link.faults.slow = 1.0;
  link.start();
  link.runUntil(13.0);
  EXPECT_EQ(link.job.status().state, PackmlState::Starting);
  link.job.abort({ErrorCode::Cancelled, "the user said so"}, link.now);
  link.runUntil(1e5);
  EXPECT_EQ(link.job.status().state, PackmlState::Aborted);
  EXPECT_EQ(link.server->printer.nozzle_target_c, 170.0);
  EXPECT_TRUE(link.server->printer.executed().empty());
}

TEST_P(UploadJobTest, TellsWhatEndedThePrint) {
  struct Case {
    void (*happens)(EmulatedPrintServer&);
    ErrorCode code;
    const char* words;
  };
  const std::vector<Case> cases = {
      {[](EmulatedPrintServer& s) { s.printer.cancel(); }, ErrorCode::Cancelled, "cancelled at the machine"},
      {[](EmulatedPrintServer& s) { s.printer.restart(); }, ErrorCode::DeviceError, "it was restarted"},
      {[](EmulatedPrintServer& s) { s.printer.halt(); }, ErrorCode::DeviceError, "shut itself down"},
      {[](EmulatedPrintServer& s) {
         s.printer.cancel();
         s.printer.files["other.gcode"] = "G1 X1\n";
         s.printer.print("other.gcode");
       },
       ErrorCode::Cancelled, "other.gcode"}};
  for (const Case& fault : cases) {
    SimulatedHttp link = hot();
    link.events.push_back({5.5, fault.happens});
    link.run();
    EXPECT_EQ(link.job.status().failure.code, fault.code) << link.job.status().failure.message;
    EXPECT_TRUE(contains(link.job.status().failure.message, fault.words))
        << link.job.status().failure.message;
    if (link.server->printer.file() != "other.gcode") expectSafe(link);
  }
}

TEST_P(UploadJobTest, TellsAnErrorOfThePrint) {
  SimulatedHttp link = hot();
  link.events.push_back({5.5, [](EmulatedPrintServer& server) { server.printer.breakDown(); }});
  link.run();
  EXPECT_EQ(link.job.status().state, PackmlState::Aborted);
  expectSafe(link);
}

TEST_P(UploadJobTest, FollowsThePrintOnceTheServerIsBack) {
  SimulatedHttp link = hot();
  link.unreachable_from_s = 5.0;
  link.unreachable_until_s = 40.0;  // the print ends at 20 s
  link.events.push_back({20.0, [](EmulatedPrintServer& server) { server.forgetSessions(); }});
  link.run();
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
  EXPECT_EQ(link.server->printer.executed().size(), 2002U);
}

TEST_P(UploadJobTest, SaysThatTheMachineMayStillPrint) {
  SimulatedHttp link = this->link(test::hotProgram(100000));
  link.unreachable_from_s = 5.0;
  link.run();
  EXPECT_EQ(link.job.status().state, PackmlState::Aborted);
  EXPECT_EQ(link.job.status().failure.code, ErrorCode::Disconnected);
  EXPECT_TRUE(contains(link.job.status().failure.message, "may still be printing"))
      << link.job.status().failure.message;
  EXPECT_NEAR(link.now, 65.0, 5.0);
}

TEST_P(UploadJobTest, SaysThatAStopWasNotConfirmed) {
  SimulatedHttp link = hot();
  link.start();
  link.runUntil(6.0);
  link.unreachable_from_s = 6.0;
  link.job.abort({ErrorCode::Cancelled, "the user said so"}, link.now);
  link.runUntil(1e5);
  EXPECT_TRUE(contains(link.job.status().failure.message, "has not confirmed within 10 s"))
      << link.job.status().failure.message;
  EXPECT_NEAR(link.now, 16.0, 0.1);
}

TEST_P(UploadJobTest, NeverStartsTwice) {
  for (const double at : {0.0, 1.0}) {
    HttpFaults faults;
    (at == 0.0 ? faults.lost_response : faults.lost_request) = 1.0;
    SimulatedHttp link = this->link("G1 X1\nG1 X2\n");
    link.start();
    while (link.targets.empty() || !link.server->printer.files.count(kOurFile))
      link.runUntil(link.now + 0.005);
    link.runUntil(link.now + 0.015);
    link.faults = faults;
    link.runUntil(link.now + 2.0);
    link.faults = {};
    link.runUntil(1e5);
    const std::size_t run = link.server->printer.executed().size();
    EXPECT_TRUE(run == 0 || run == 2) << run;
    EXPECT_EQ(link.job.status().state == PackmlState::Complete, run == 2)
        << link.job.status().failure.message;
  }
}

/// The time to begin counts from the answer: the request may have waited for the progress file before.
TEST_P(UploadJobTest, AStartThatWasLongUnderWayIsStillAwaited) {
  SimulatedHttp link = this->link("G1 X1\nG1 X2\n");
  link.late_words = {"print/start", "M32"};
  link.faults.late_s = 15.0;  // the request is given up after 10 s
  link.run();
  EXPECT_EQ(link.job.status().state, PackmlState::Complete) << link.job.status().failure.message;
}

TEST_P(UploadJobTest, AStartThatComesTooLateComesToNothing) {
  SimulatedHttp link = this->link("G1 X1\nG1 X2\n");
  link.late_words = {"print/start", "M32"};
  link.faults.late_s = 60.0;
  link.run();
  EXPECT_EQ(link.job.status().failure.code, ErrorCode::TimedOut) << link.job.status().failure.message;
  EXPECT_TRUE(contains(link.job.status().failure.message, "its heaters are off"))
      << link.job.status().failure.message;
  EXPECT_LT(link.now, 40.0);
  link.runOn(100.0);
  EXPECT_TRUE(link.server->printer.executed().empty());
}

TEST(PrintServer, SwitchesOffAllThatTheProgramSwitchesOn) {
  const auto order = test::orderOf("M104 S200\nM3 S100\nG1 X1\nM106 S255\nM106 P2 S100\nM8\n");
  for (const auto& server : printServers("auto", order)) {
    const auto request = server->request(UploadStep::HeatersOff);
    ASSERT_TRUE(request) << server->firmware();
    const std::string asked = request->target + escapedForUrl(request->head);
    EXPECT_TRUE(contains(asked, "M5%0AM106%20P2%20S0%0AM9%0A")) << asked;
    EXPECT_TRUE(contains(asked, "M107")) << asked;
  }
  const auto plain = printServers("klipper", test::orderOf("M104 S200\nG1 X1\n"));
  EXPECT_EQ(plain.front()->request(UploadStep::HeatersOff)->target,
            "/printer/gcode/script?script=TURN_OFF_HEATERS%0AM107");
}

INSTANTIATE_TEST_SUITE_P(Servers, UploadJobTest,
                         testing::Values(test::ServerKind{"moonraker", makeEmulatedMoonraker, "klipper"},
                                         test::ServerKind{"duet", makeEmulatedDuet, "reprapfirmware"},
                                         test::ServerKind{"duet_with_computer", makeEmulatedDuetWithComputer,
                                                          "reprapfirmware"}),
                         [](const auto& server) { return std::string(server.param.name); });

}  // namespace
}  // namespace lamina
