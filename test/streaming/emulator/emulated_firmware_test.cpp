// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/emulator/emulated_firmware.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"
#include "streaming/emulator/asked_firmware.hpp"

namespace lamina {
namespace {

class EmulatedFirmwareTest : public test::AskedFirmware {
 protected:
  void makeFirmware(double speed_up, std::vector<Fault> faults = {}) {
    EmulatedSettings settings;
    settings.speed_up = speed_up;
    make(settings, std::move(faults));
  }
};

TEST_F(EmulatedFirmwareTest, AnswersAPlainTerminal) {
  makeFirmware(1.0);
  EXPECT_EQ(ask("M105\n"), "ok T:25.00 /0.00 B:25.00 /0.00 @:0 B@:0\n");
  EXPECT_EQ(ask("M114\r\n"), "X:0.000 Y:0.000 Z:0.000 E:0.0000 Count X:0 Y:0 Z:0\nok\n");
  EXPECT_EQ(ask("M999 S1\n"), "echo:Unknown command: \"M999 S1\"\nok\n");
  EXPECT_NE(ask("M115\n").find("Cap:AUTOREPORT_TEMP:1"), std::string::npos);
  EXPECT_EQ(ask("\n"), "");
}

TEST_F(EmulatedFirmwareTest, IgnoresAFeedFactorThatWouldStopItForEver) {
  makeFirmware(1.0);
  EXPECT_EQ(ask("M220 S0\n"), "echo:Ignored: \"M220 S0\"; expected S above 0 percent\nok\n");
  ask("G1 X10 F600\n");
  wait(10.0);
  ASSERT_EQ(motions_.size(), 1U);
}

TEST_F(EmulatedFirmwareTest, AsksForLinesThatAreMissingOrBroken) {
  makeFirmware(1.0);
  EXPECT_EQ(ask("N0 M110 N0*125\n"), "ok\n");
  EXPECT_EQ(ask(frameLine(1, "G90")), "ok\n");
  EXPECT_EQ(ask(frameLine(3, "G90")),
            "Error:Line Number is not Last Number+1, Last Line: 1\nResend: 2\nok\n");
  EXPECT_EQ(ask("N2 G90*1\n"), "Error:checksum mismatch, Last Line: 1\nResend: 2\nok\n");
  EXPECT_EQ(firmware_->counts().lines_refused, 2U);
}

TEST_F(EmulatedFirmwareTest, HoldsTheOkBackWhileItsQueueIsFull) {
  makeFirmware(1.0);
  int oks = 0;
  for (int i = 1; i <= 20; ++i) {
    oks += ask("G1 X" + std::to_string(i % 2) + " F600\n") == "ok\n" ? 1 : 0;
  }
  EXPECT_EQ(oks, 17);  // one runs, 16 wait
  EXPECT_EQ(wait(0.2).substr(0, 2), "ok");
}

TEST_F(EmulatedFirmwareTest, SaysThatItIsBusyWhileItHeats) {
  makeFirmware(1.0);
  EXPECT_EQ(ask("M109 S75\n"), "");  // 50 degrees more take 10 s
  EXPECT_DOUBLE_EQ(firmware_->nozzleTarget(), 75.0);
  const std::string said = wait(9.9);
  EXPECT_EQ(said,
            "echo:busy: processing\necho:busy: processing\necho:busy: processing\necho:busy: processing\n");
  EXPECT_EQ(wait(10.1), "ok\n");
  EXPECT_EQ(ask("M105\n", 10.1).substr(0, 10), "ok T:75.00");
}

TEST_F(EmulatedFirmwareTest, BreaksHeatingOnM108EvenThoughItIsBusy) {
  makeFirmware(1.0);
  ask("M109 S200\n");
  EXPECT_EQ(ask("M108\n", 1.0), "ok\nok\n");
}

TEST_F(EmulatedFirmwareTest, ReportsOnItsOwnIfAskedTo) {
  makeFirmware(1.0);
  EXPECT_EQ(ask("M155 S1\nM154 S2\n"), "ok\nok\n");
  const std::string said = wait(2.5);
  EXPECT_EQ(said,
            " T:25.00 /0.00 B:25.00 /0.00 @:0 B@:0\n T:25.00 /0.00 B:25.00 /0.00 @:0 B@:0\n"
            "X:0.000 Y:0.000 Z:0.000 E:0.0000 Count X:0 Y:0 Z:0\n");
}

TEST_F(EmulatedFirmwareTest, RunsModalPrograms) {
  makeFirmware(0.0);
  ask("G28\nG90\nM83\nG1 X10 F6000\nG91\nG1 X5 E1\nG90\nG92 X0\nG1 X1\nG2 X3 I1 J0\nM400\n");
  ASSERT_GE(motions_.size(), 4U);
  EXPECT_NEAR(firmware_->position().x(), 18.0, 1e-9);  // 10 + 5, then 0 is there, then to 1 and to 3
  EXPECT_NEAR(motions_[1].filament_mm, 1.0, 1e-12);
  EXPECT_TRUE(firmware_->isIdle());
}

TEST_F(EmulatedFirmwareTest, TakesTheTimeThatMotionsTake) {
  makeFirmware(10.0);
  ask("G1 X100 F6000\nM400\n");  // 100 mm at 100 mm/s and 3000 mm/s^2: 1 s and 1/30 s, after 0.1 s of waiting
  EXPECT_EQ(wait(0.112), "");
  EXPECT_EQ(wait(0.114), "ok\n");
  EXPECT_NEAR(firmware_->position().x(), 100.0, 1e-9);
}

TEST_F(EmulatedFirmwareTest, DwellsAfterItsMotions) {
  makeFirmware(1.0);
  EXPECT_EQ(ask("G4 P500\n"), "");
  EXPECT_EQ(wait(0.49), "");
  EXPECT_EQ(wait(0.51), "ok\n");
}

TEST_F(EmulatedFirmwareTest, RunsTheSameMotionsHoweverFastTimeGoes) {
  std::string program = "G28\nG1 F9000\n";
  for (int i = 0; i < 100; ++i) {
    program += "G1 X" + std::to_string(100.0 + 30.0 * std::sin(0.1 * i)) + " Y" + std::to_string(i) + "\n";
  }
  program += "M400\n";
  std::vector<std::vector<ExecutedMotion>> runs;
  for (const double speed_up : {0.0, 100.0, 1000.0}) {
    motions_.clear();
    makeFirmware(speed_up);
    double now = 0.0;
    for (std::size_t at = 0; at < program.size();) {  // a line whenever the firmware has taken the one before
      const std::size_t end = program.find('\n', at) + 1;
      std::string answer = ask(program.substr(at, end - at), now);
      while (answer.find("ok") == std::string::npos) {
        now = std::max(now, firmware_->nextDeadline());
        firmware_->elapse(now);
        answer += firmware_->takeOutput();
      }
      now += 0.001;
      at = end;
    }
    runs.push_back(motions_);
  }
  for (const auto& run : runs) {
    ASSERT_EQ(run.size(), runs[0].size());
    for (std::size_t i = 0; i < run.size(); ++i) {
      EXPECT_NEAR(run[i].profile.duration_s, runs[0][i].profile.duration_s, 1e-9) << i;
    }
  }
}

TEST_F(EmulatedFirmwareTest, LosesWhatItsReceiveBufferCannotHold) {
  makeFirmware(1.0);
  ask("G4 S10\n");
  ask(std::string(300, 'x'));
  EXPECT_EQ(firmware_->counts().bytes_lost, 300U - 128U);
}

TEST_F(EmulatedFirmwareTest, StopsAtOnceOnM410) {
  makeFirmware(1.0);
  ask("G1 X100 F6000\n");
  wait(0.6);
  ask("M410\n", 0.6);
  EXPECT_TRUE(firmware_->isIdle());
  EXPECT_GT(firmware_->position().x(), 10.0);
  EXPECT_LT(firmware_->position().x(), 90.0);
}

TEST_F(EmulatedFirmwareTest, IsDeadAfterM112) {
  makeFirmware(1.0);
  ask("M104 S200\n");
  EXPECT_NE(ask("M112\n").find("halted"), std::string::npos);
  EXPECT_DOUBLE_EQ(firmware_->nozzleTarget(), 0.0);
  EXPECT_EQ(ask("M105\n"), "");
}

TEST_F(EmulatedFirmwareTest, ForgetsEverythingWhenItIsReset) {
  makeFirmware(1.0, {{FaultKind::Reset, 0.0, {2}}});
  ask(frameLine(1, "M104 S200"));
  EXPECT_EQ(ask(frameLine(2, "G28")).substr(0, 6), "start\n");
  EXPECT_DOUBLE_EQ(firmware_->nozzleTarget(), 0.0);
  EXPECT_EQ(ask(frameLine(1, "G90")), "ok\n");
}

TEST_F(EmulatedFirmwareTest, SaysNothingAndReadsNothingWhileItIsSilent) {
  makeFirmware(1.0, {{FaultKind::Silence, 0.0, {1}}});
  EXPECT_EQ(ask(frameLine(1, "G90")), "");
  EXPECT_EQ(wait(0.9), "");
  EXPECT_EQ(wait(1.1), "ok\n");
}

TEST_F(EmulatedFirmwareTest, LosesDelaysAndInventsAnswers) {
  makeFirmware(1.0, {{FaultKind::LostOk, 0.0, {1}},
                     {FaultKind::DelayedOk, 0.0, {2}},
                     {FaultKind::SpuriousResend, 0.0, {3}}});
  EXPECT_EQ(ask(frameLine(1, "G90")), "");
  EXPECT_EQ(ask(frameLine(2, "G90")), "");
  EXPECT_EQ(wait(0.3), "ok\n");
  EXPECT_EQ(ask(frameLine(3, "G90"), 0.3), "ok\nResend: 4\nok\n");
  EXPECT_EQ(lines_.size(), 3U);
}

}  // namespace
}  // namespace lamina
