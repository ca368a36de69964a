// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Klipper and RepRapFirmware with all that goes wrong in them: 0 lost, 0 repeated, or not Complete.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "streaming/emulator/ok_paced/emulated_klipper.hpp"
#include "streaming/emulator/ok_paced/emulated_reprap.hpp"
#include "streaming/firmware/klipper/klipper_protocol.hpp"
#include "streaming/firmware/ok_paced/ok_paced_firmware.hpp"
#include "streaming/firmware/ok_paced/paced_link.hpp"
#include "streaming/firmware/reprapfirmware/reprap_protocol.hpp"

namespace lamina {
namespace {

constexpr std::uint64_t kLinesPerJob = 5000;

/// LAMINA_PACED_LINES sets how many lines are streamed; few are in every run of the tests.
std::uint64_t linesToStream() {
  const char* const wanted = std::getenv("LAMINA_PACED_LINES");
  return wanted == nullptr ? 60000 : std::strtoull(wanted, nullptr, 10);
}

/// No line is like another: motions with relative filament, retractions, temperatures.
std::vector<std::string> pacedCommands() {
  std::vector<std::string> commands = {"G90", "M83", "G28", "G1 F6000"};
  for (std::uint64_t i = commands.size(); i < kLinesPerJob; ++i) {
    const std::string number = std::to_string(i);
    if (i % 50 == 0) {
      commands.push_back("G1 E-1." + number);
    } else if (i % 50 == 25) {
      commands.push_back("M104 S2" + std::to_string(10 + i % 80) + "." + number);
    } else {
      commands.push_back("G1 X" + std::to_string(100 + i % 97) + "." + number + " Y" +
                         std::to_string(i % 89) + " E0." + std::to_string(100 + i % 800));
    }
  }
  return commands;
}

/// Compares what is run with what should be.
class RunCheck {
 public:
  explicit RunCheck(const std::vector<std::string>& commands) : commands_(commands) {}

  void ran(const std::string& command) {
    const bool is_of_stop =
        command == "M5" || command == "M140 S0" || command == "M141 S0" || command == "M104 S0";
    if (is_of_stop) return;
    if (next_ < commands_.size() && command == commands_[next_]) {
      ++next_;
    } else if (next_ > 0 && command == commands_[next_ - 1] && command.find('E') == std::string::npos &&
               command.compare(0, 3, "G28") != 0) {
      ++harmless;
    } else {
      ++wrong;
    }
  }
  std::uint64_t count() const { return next_; }

  std::uint64_t wrong = 0;     ///< run twice, out of order, or none of the program
  std::uint64_t harmless = 0;  ///< run twice at once, which changes nothing

 private:
  const std::vector<std::string>& commands_;
  std::size_t next_ = 0;
};

struct Totals {
  std::uint64_t lines = 0;
  std::uint64_t jobs = 0;
  std::uint64_t complete = 0;
  std::uint64_t wrong = 0;
  std::uint64_t harmless = 0;
  std::uint64_t false_complete = 0;
  std::uint64_t false_cold = 0;
};

template <class MakeFirmware>
Totals streamMany(const StreamSettings& settings, double noise, MakeFirmware make) {
  Totals totals;
  const std::vector<std::string> commands = pacedCommands();
  std::string text;
  for (const std::string& command : commands) text += command + "\n";
  const auto program = StreamableProgram::fromText("paced", text, settings);
  while (totals.lines < linesToStream()) {
    ++totals.jobs;
    RunCheck check(commands);
    Streamer streamer(program, settings);
    const auto firmware = make(totals.jobs, [&](const std::string& command) { check.ran(command); });
    test::PacedLink link(streamer, *firmware, noise, totals.jobs);
    link.run();
    const bool is_complete = streamer.status().state == PackmlState::Complete;
    totals.lines += std::max<std::uint64_t>(check.count(), 1);
    totals.complete += is_complete ? 1 : 0;
    totals.wrong += check.wrong;
    totals.harmless += check.harmless;
    totals.false_complete += is_complete && check.count() != commands.size() ? 1 : 0;
    const bool is_told_cold = streamer.status().state == PackmlState::Aborted &&
                              streamer.status().failure.message.find("confirm") == std::string::npos &&
                              streamer.status().failure.message.find("look after") == std::string::npos;
    totals.false_cold += is_told_cold && firmware->nozzleTarget() != 0.0 ? 1 : 0;
  }
  std::cout << totals.lines << " lines in " << totals.jobs << " jobs, " << totals.complete << " complete, "
            << totals.harmless << " harmless repetitions\n";
  return totals;
}

void expectNothingLost(const Totals& totals) {
  EXPECT_EQ(totals.wrong, 0U);
  EXPECT_EQ(totals.false_complete, 0U);
  EXPECT_EQ(totals.false_cold, 0U);
  EXPECT_GT(totals.complete, 0U);
}

PacedFaults rareFaults() {
  PacedFaults faults;
  faults.lost_ok = 1e-3;
  faults.slow = 1e-3;
  faults.refusal = 3e-5;
  faults.halt = 2e-5;
  faults.reset = 2e-5;
  faults.disconnect = 2e-5;
  return faults;
}

StreamSettings pacedSettings(const std::string& firmware, LinkKind link) {
  StreamSettings settings;
  settings.firmware = firmware;
  settings.link = link;
  return settings;
}

TEST(OkPacedProperty, KlipperRunsEveryLineOnceOrTheJobIsNotComplete) {
  expectNothingLost(
      streamMany(pacedSettings("klipper", LinkKind::Reliable), 0.0, [](std::uint64_t seed, auto observer) {
        PacedFaults faults = rareFaults();
        faults.seed = seed;
        return std::make_unique<EmulatedKlipper>(faults, observer);
      }));
}

TEST(OkPacedProperty, RepRapFirmwareRunsEveryLineOnceOrTheJobIsNotComplete) {
  expectNothingLost(streamMany(
      pacedSettings("reprapfirmware", LinkKind::Reliable), 0.0, [](std::uint64_t seed, auto observer) {
        PacedFaults faults = rareFaults();
        faults.seed = seed;
        return std::make_unique<EmulatedRepRap>(faults, EmulatedRepRap::Checks::IfThere, observer);
      }));
}

TEST(OkPacedProperty, RepRapFirmwareRunsEveryLineOnceOnANoisyLineOrTheJobIsNotComplete) {
  expectNothingLost(streamMany(
      pacedSettings("reprapfirmware", LinkKind::Lossy), 2e-4, [](std::uint64_t seed, auto observer) {
        PacedFaults faults = rareFaults();
        faults.seed = seed;
        return std::make_unique<EmulatedRepRap>(faults, EmulatedRepRap::Checks::RequiresCrc, observer);
      }));
}

/// A job whose firmware is played by hand.
class PlayedByHand : public testing::Test {
 protected:
  void begin(const std::string& firmware, const std::string& text = "G28\nG1 X1\n") {
    StreamSettings settings = pacedSettings(firmware, LinkKind::Reliable);
    settings.emergency_stop = emergency_;
    settings.safe_stop_timeout_s = safe_stop_timeout_s_;
    settings.temperature_interval_s = 0;
    settings.window_lines = 1;
    program_ = std::make_unique<StreamableProgram>(StreamableProgram::fromText("two lines", text, settings));
    streamer_ = std::make_unique<Streamer>(*program_, settings);
    streamer_->start(0.0);
  }
  std::string answer(const std::string& text, double now) {
    streamer_->takeOutput();
    streamer_->receive(text, now);
    return streamer_->takeOutput();
  }
  void beginKlipper(const std::string& text = "G28\nG1 X1\n") {
    begin("klipper", text);
    EXPECT_EQ(answer("ok FIRMWARE_NAME:Klipper FIRMWARE_VERSION:v0.12\n", 0.1), "STATUS\n");
    EXPECT_EQ(answer("// Klipper state: Ready\nok\n", 0.2), "ECHO LAMINA=1\n");
    EXPECT_EQ(answer("// ECHO LAMINA=1\nok\n", 0.3), text.substr(0, text.find('\n') + 1));
  }
  const StreamStatus& status() const { return streamer_->status(); }

  /// Klipper that waits for heat: it reports each second, and reads nothing.
  std::string heatUntil(double end) {
    std::string sent;
    for (double now = 2.0; now <= end && !isFinal(status().state); now += 1.0) {
      streamer_->receive("B:60.0 /60.0 T0:50.0 /210.0\n", now);
      streamer_->elapse(now);
      sent += streamer_->takeOutput();
    }
    return sent;
  }

  /// Klipper that dwells: it says nothing, and reads nothing.
  std::string waitUntil(double end) {
    std::string sent;
    for (; waited_s_ <= end && !isFinal(status().state); waited_s_ += 0.5) {
      streamer_->elapse(waited_s_);
      sent += streamer_->takeOutput();
    }
    return sent;
  }

  double waited_s_ = 2.0;
  EmergencyStop emergency_ = EmergencyStop::Never;
  double safe_stop_timeout_s_ = StreamSettings().safe_stop_timeout_s;
  std::unique_ptr<StreamableProgram> program_;
  std::unique_ptr<Streamer> streamer_;
};

TEST_F(PlayedByHand, AStopThatKlipperDoesNotHearIsToldAndNotPiledUp) {
  beginKlipper();
  streamer_->abort({ErrorCode::Cancelled, "enough"}, 1.0);
  heatUntil(10.0);
  EXPECT_EQ(status().message, "");
  const std::string sent = heatUntil(600.0);
  EXPECT_EQ(status().state, PackmlState::Aborting);
  EXPECT_NE(status().message.find("has not heard the stop for 10 s"), std::string::npos) << status().message;
  EXPECT_NE(status().message.find("M112 at the port"), std::string::npos) << status().message;
  EXPECT_LT(std::count(sent.begin(), sent.end(), '\n'), 20) << "Klipper keeps twenty and reads no more";
}

TEST_F(PlayedByHand, AnEmergencyStopEndsWhatDoesNotHearAStop) {
  emergency_ = EmergencyStop::Unconfirmed;
  beginKlipper();
  streamer_->abort({ErrorCode::Cancelled, "enough"}, 1.0);
  EXPECT_EQ(heatUntil(10.0).find("M112"), std::string::npos);
  EXPECT_NE(heatUntil(12.0).find("M112\n"), std::string::npos);
  answer("// Klipper state: Shutdown\n", 13.0);
  EXPECT_EQ(status().state, PackmlState::Aborted);
  EXPECT_NE(status().failure.message.find(
                "not confirmed within 10 s, so that an emergency stop was sent; the machine "
                "halted"),
            std::string::npos)
      << status().failure.message;
}

/// Of what was sent and not answered; Klipper looks for an emergency stop among fewer than twenty lines.
void expectThatKlipperHearsAnEmergencyStop(const std::string& unanswered) {
  EXPECT_NE(unanswered.find("M112\n"), std::string::npos) << unanswered;
  EXPECT_LT(std::count(unanswered.begin(), unanswered.end(), '\n'), 20) << unanswered;
}

TEST_F(PlayedByHand, QuestionsToAMachineThatDwellsLeaveRoomForAnEmergencyStop) {
  emergency_ = EmergencyStop::Unconfirmed;
  beginKlipper();
  std::string unanswered = "G28\n" + waitUntil(900.0);
  EXPECT_EQ(status().state, PackmlState::Execute);
  EXPECT_GT(std::count(unanswered.begin(), unanswered.end(), '\n'), 5) << "it is asked now and then";
  streamer_->abort({ErrorCode::Cancelled, "enough"}, 900.0);
  unanswered += waitUntil(1000.0);
  EXPECT_NE(unanswered.find("TURN_OFF_HEATERS\n"), std::string::npos);
  expectThatKlipperHearsAnEmergencyStop(unanswered);
}

TEST_F(PlayedByHand, ChangesOfAMachineThatDwellsLeaveRoomForAnEmergencyStop) {
  emergency_ = EmergencyStop::Unconfirmed;
  beginKlipper();
  std::string refusal;
  for (int i = 0; i < 30; ++i) refusal += streamer_->change({LiveSetting::Feed, 90.0 + i}, 1.0);
  EXPECT_EQ(refusal.find("the machine waits, and has 13 commands to answer"), 0U) << refusal;
  streamer_->abort({ErrorCode::Cancelled, "enough"}, 1.0);
  expectThatKlipperHearsAnEmergencyStop("G28\n" + waitUntil(20.0));
}

TEST_F(PlayedByHand, StopsThatAreRepeatedForLongLeaveRoomForAnEmergencyStop) {
  emergency_ = EmergencyStop::Unconfirmed;
  safe_stop_timeout_s_ = 600.0;
  beginKlipper("M106 S255\nM106 P1 S255\nM3 S1\nG28\n");
  answer("ok\n", 0.4);
  answer("ok\n", 0.5);
  EXPECT_EQ(answer("ok\n", 0.6), "G28\n");
  streamer_->abort({ErrorCode::Cancelled, "enough"}, 1.0);
  const std::string unanswered = "G28\n" + waitUntil(700.0);
  EXPECT_NE(unanswered.find("M5\nM107\n"), std::string::npos) << unanswered;
  expectThatKlipperHearsAnEmergencyStop(unanswered);
}

TEST_F(PlayedByHand, AMachineWhoseHeatersAreOffGetsNoEmergencyStop) {
  emergency_ = EmergencyStop::Unconfirmed;
  beginKlipper();
  streamer_->abort({ErrorCode::Cancelled, "enough"}, 1.0);
  EXPECT_EQ(answer("ok\nok\nok B:60.0 /0.0 T0:210.0 /0.0\n// ECHO LAMINA=2\nok\n", 1.5),
            "M400\nECHO LAMINA=3\n");
  EXPECT_EQ(waitUntil(30.0).find("M112"), std::string::npos) << "only a long motion is waited for";
  EXPECT_EQ(status().failure.message,
            "enough; its heaters are off, but it did not confirm that its motions have ended");
}

TEST_F(PlayedByHand, AStopAfterALostLinkHasItsTime) {
  beginKlipper();
  streamer_->disconnect("the cable was pulled", 1.0);
  streamer_->reconnect(10.9);
  EXPECT_NE(streamer_->takeOutput().find("TURN_OFF_HEATERS"), std::string::npos);
  streamer_->receive("B:60.0 /60.0 T0:50.0 /210.0\n", 11.5);
  EXPECT_EQ(status().message, "") << "sent 0.6 s ago";
  streamer_->receive("B:60.0 /60.0 T0:50.0 /210.0\n", 20.9);
  EXPECT_NE(status().message.find("has not heard the stop for 10 s"), std::string::npos) << status().message;
}

TEST_F(PlayedByHand, KlipperIsCompleteWhenItHasSaidTheLastNumber) {
  beginKlipper();
  EXPECT_EQ(answer("ok\n", 1.0), "G1 X1\n");
  EXPECT_EQ(answer("ok\n", 1.1), "M400\n");
  EXPECT_EQ(answer("ok\n", 1.2), "ECHO LAMINA=2\n");
  EXPECT_EQ(status().state, PackmlState::Completing);
  answer("// ECHO LAMINA=2\n", 1.3);
  EXPECT_EQ(status().state, PackmlState::Complete);
}

TEST_F(PlayedByHand, KlipperThatIsNotReadyIsLeftAlone) {
  begin("klipper");
  answer("ok FIRMWARE_NAME:Klipper FIRMWARE_VERSION:v0.12\n", 0.1);
  EXPECT_EQ(answer("// Shutdown due to M112 command\n// Once the underlying issue is corrected\n"
                   "// Klipper state: Not ready\n!! Shutdown due to M112 command\nok\n",
                   0.2),
            "");
  EXPECT_EQ(status().state, PackmlState::Aborted);
  EXPECT_NE(status().failure.message.find("Shutdown due to M112 command"), std::string::npos);
}

TEST_F(PlayedByHand, AnErrorOfKlipperEndsTheJobByASafeStop) {
  beginKlipper();
  EXPECT_EQ(answer("!! Must home axis first\nok\n", 1.0), "TURN_OFF_HEATERS\nM105\nECHO LAMINA=2\n");
  EXPECT_NE(status().failure.message.find("line 1, 'G28': \"!! Must home axis first\""), std::string::npos);
  EXPECT_EQ(answer("ok\nok B:60.0 /0.0 T0:210.0 /0.0\n// ECHO LAMINA=2\nok\n", 1.1), "M400\nECHO LAMINA=3\n");
  answer("ok\n// ECHO LAMINA=3\nok\n", 2.0);
  EXPECT_EQ(status().state, PackmlState::Aborted);
  EXPECT_EQ(status().failure.message.find("confirm"), std::string::npos);
}

TEST_F(PlayedByHand, AChangeThatKlipperRefusesIsToldAndTheJobGoesOn) {
  beginKlipper();
  EXPECT_EQ(streamer_->change({LiveSetting::Babystep, -0.05}, 0.5), "");
  EXPECT_EQ(streamer_->takeOutput(), "SET_GCODE_OFFSET Z_ADJUST=-0.05 MOVE=1\n");
  EXPECT_EQ(answer("ok\n", 1.0), "") << "an error is the change's as long as no line is under way";
  EXPECT_EQ(answer("!! Must home axis first\nok\n", 1.1), "G1 X1\n");
  EXPECT_EQ(status().state, PackmlState::Execute);
  EXPECT_EQ(status().message,
            "change SET_GCODE_OFFSET Z_ADJUST=-0.05 MOVE=1 was refused: \"!! Must home axis first\"");
  answer("!! Move out of range\nok\n", 1.2);
  EXPECT_EQ(status().failure.code, ErrorCode::Rejected);
  EXPECT_NE(status().failure.message.find("line 2, 'G1 X1'"), std::string::npos) << status().failure.message;
}

TEST_F(PlayedByHand, AnErrorToALineInFrontOfAChangeEndsTheJob) {
  beginKlipper();
  EXPECT_EQ(streamer_->change({LiveSetting::Feed, 50.0}, 0.5), "");
  answer("!! Must home axis first\nok\n", 1.0);
  EXPECT_NE(status().failure.message.find("line 1, 'G28'"), std::string::npos) << status().failure.message;
}

TEST_F(PlayedByHand, AHotNozzleIsNotConfirmed) {
  beginKlipper();
  streamer_->abort({ErrorCode::Cancelled, "enough"}, 1.0);
  answer("ok\nok B:60.0 /0.0 T0:210.0 /200.0\n// ECHO LAMINA=2\nok\n", 1.1);
  for (double now = 1.5; now < 12.0; now += 0.5) streamer_->elapse(now);
  EXPECT_EQ(status().failure.message.find("enough; the machine did not confirm the safe stop"), 0U)
      << status().failure.message;
}

TEST_F(PlayedByHand, AShutdownOfKlipperIsToldWithItsReason) {
  beginKlipper();
  EXPECT_EQ(answer("// Klipper state: Shutdown\n", 1.0), "STATUS\n");
  answer(
      "!! Lost communication with MCU 'mcu'\nok\n// Lost communication with MCU 'mcu'\n"
      "// Klipper state: Not ready\n!! Lost communication with MCU 'mcu'\nok\n",
      1.1);
  EXPECT_EQ(status().state, PackmlState::Aborted);
  EXPECT_NE(status().failure.message.find("Lost communication with MCU"), std::string::npos);
  EXPECT_NE(status().failure.message.find("does not confirm"), std::string::npos);
}

TEST_F(PlayedByHand, CommandsThatKlipperDoesNotKnowAreCounted) {
  beginKlipper();
  answer("// Unknown command:\"G28\"\nok\n", 1.0);
  EXPECT_EQ(status().state, PackmlState::Execute);
  EXPECT_EQ(status().commands_not_done, 1U);
}

TEST_F(PlayedByHand, AChangeThatKlipperDoesNotKnowIsNoLineThatWasNotDone) {
  beginKlipper();
  EXPECT_EQ(streamer_->change({LiveSetting::Babystep, -0.05}, 0.5), "");
  answer("ok\n", 1.0);
  EXPECT_EQ(answer("// Unknown command:\"SET_GCODE_OFFSET\"\nok\n", 1.1), "G1 X1\n");
  answer("ok\n", 1.2);
  EXPECT_EQ(status().commands_not_done, 0U);
  EXPECT_EQ(status().message, "// Unknown command:\"SET_GCODE_OFFSET\"");
}

TEST_F(PlayedByHand, KlipperPausesAndCancels) {
  beginKlipper();
  EXPECT_EQ(answer("// action:pause\nok\n", 1.0), "");
  EXPECT_EQ(status().state, PackmlState::Held);
  EXPECT_EQ(answer("// action:resume\n", 2.0), "G1 X1\n");
  answer("// action:cancel\n", 3.0);
  EXPECT_EQ(status().failure.code, ErrorCode::Cancelled);
}

// PAUSE does nothing more in Klipper until RESUME has come: the next pause of the program would be passed
// over.
TEST_F(PlayedByHand, APauseOfKlipperIsEndedByItsOwnCommand) {
  beginKlipper("PAUSE\nG1 X1\n");
  EXPECT_EQ(answer("// action:paused\nok\n", 1.0), "");
  EXPECT_EQ(status().state, PackmlState::Held);
  EXPECT_TRUE(streamer_->resume(2.0));
  EXPECT_EQ(streamer_->takeOutput(), "RESUME\n");
  EXPECT_EQ(answer("// action:resumed\nok\n", 2.5), "G1 X1\n");
  EXPECT_TRUE(streamer_->pause(2.6));
  answer("ok\n", 2.7);
  EXPECT_TRUE(streamer_->resume(3.0));
  EXPECT_EQ(streamer_->takeOutput(), "M400\n") << "a pause of Lamina's own is none of Klipper's";
}

TEST_F(PlayedByHand, AMachineThatPrintsFromItsCardIsLeftAlone) {
  begin("reprapfirmware");
  EXPECT_NE(answer("FIRMWARE_NAME: RepRapFirmware for Duet 3 MB6HC FIRMWARE_VERSION: 3.5.3\nok\n", 0.1)
                .find("M409 K\"state.status\"*"),
            std::string::npos);
  EXPECT_EQ(answer("{\"key\":\"state.status\",\"flags\":\"\",\"result\":\"processing\"}\n\nok\n", 0.2), "");
  EXPECT_EQ(status().failure.message, "the machine is \"processing\"; expected it to be idle");
}

TEST_F(PlayedByHand, AHeaterFaultEndsAHeldJob) {
  begin("reprapfirmware");
  answer("FIRMWARE_NAME: RepRapFirmware for Duet 3 MB6HC FIRMWARE_VERSION: 3.5.3\nok\n", 0.1);
  answer("{\"key\":\"state.status\",\"flags\":\"\",\"result\":\"idle\"}\n\nok\n", 0.2);
  EXPECT_NE(answer("lamina1\nok\n", 0.3).find("G28*"), std::string::npos);
  EXPECT_TRUE(streamer_->pause(0.4));
  answer("ok\n", 0.5);
  ASSERT_EQ(status().state, PackmlState::Held);
  answer("Error: in file macro line 1: Movement outside the bed\n", 0.6);
  EXPECT_EQ(status().state, PackmlState::Held) << "another sender's";
  answer("Error: Heater 1 fault: temperature excursion exceeded 15.0C\n", 0.7);
  EXPECT_EQ(status().state, PackmlState::Aborting);
  EXPECT_EQ(status().failure.code, ErrorCode::DeviceError);
  EXPECT_NE(status().failure.message.find("Heater 1 fault: temperature excursion"), std::string::npos)
      << status().failure.message;
}

TEST(OkPacedJob, RefusesALossyLinkToAMachineThatRunsDamagedLines) {
  const StreamSettings settings = pacedSettings("reprapfirmware", LinkKind::Lossy);
  Streamer streamer(StreamableProgram::fromText("one", "G1 X1\n", settings), settings);
  EmulatedRepRap firmware({}, EmulatedRepRap::Checks::IfThere, nullptr);
  test::PacedLink(streamer, firmware).run();
  EXPECT_EQ(streamer.status().failure.code, ErrorCode::Rejected);
  EXPECT_NE(streamer.status().failure.message.find("requires CRC"), std::string::npos);
}

TEST(OkPacedJob, EndsWhereItCannotBeToldWhetherALineRan) {
  const StreamSettings settings = pacedSettings("reprapfirmware", LinkKind::Lossy);
  Streamer streamer(StreamableProgram::fromText("one", "M98 P\"x.g\"\nM98 P\"y.g\"\n", settings), settings);
  std::vector<std::string> ran;
  PacedFaults faults;
  EmulatedRepRap firmware(faults, EmulatedRepRap::Checks::RequiresCrc,
                          [&](const std::string& command) { ran.push_back(command); });
  test::PacedLink link(streamer, firmware);
  link.run([&] { return streamer.status().state == PackmlState::Execute; });
  streamer.takeOutput();  // the first line is lost
  link.run();
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  EXPECT_NE(streamer.status().failure.message.find("is not known whether the machine ran line 1"),
            std::string::npos);
  EXPECT_EQ(std::count(ran.begin(), ran.end(), "M98 P\"x.g\""), 0);
}

TEST(OkPacedJob, MakesAChangeOnceNothingElseIsUnderWayWhereAnswersMayBeLost) {
  const StreamSettings settings = pacedSettings("reprapfirmware", LinkKind::Lossy);
  Streamer streamer(StreamableProgram::fromText("two", "G90\nG1 X1 E1\n", settings), settings);
  std::vector<std::string> ran;
  EmulatedRepRap firmware({}, EmulatedRepRap::Checks::RequiresCrc,
                          [&](const std::string& command) { ran.push_back(command); });
  test::PacedLink link(streamer, firmware);
  link.run([&] { return streamer.status().state == PackmlState::Execute; });
  for (const double feed_percent : {50.0, 70.0})
    EXPECT_EQ(streamer.change({LiveSetting::Feed, feed_percent}, link.now), "");
  const std::string sent = streamer.takeOutput();  // and lost
  EXPECT_NE(sent.find("G90"), std::string::npos);
  EXPECT_EQ(sent.find("M220"), std::string::npos) << sent;
  link.run();
  EXPECT_EQ(streamer.status().state, PackmlState::Complete) << streamer.status().failure.message;
  EXPECT_EQ(ran, (std::vector<std::string>{"M220 S50", "M220 S70", "G90", "G1 X1 E1"}));
}

TEST(OkPacedJob, GoesOnWhereAChangeIsLost) {
  const StreamSettings settings = pacedSettings("reprapfirmware", LinkKind::Lossy);
  const std::vector<std::string> commands = {"G90", "M83", "G1 X1 E1", "G1 X2 E1"};
  Streamer streamer(StreamableProgram::fromText("four", "G90\nM83\nG1 X1 E1\nG1 X2 E1\n", settings),
                    settings);
  std::vector<std::string> ran;
  EmulatedRepRap firmware({}, EmulatedRepRap::Checks::RequiresCrc,
                          [&](const std::string& command) { ran.push_back(command); });
  test::PacedLink link(streamer, firmware);
  link.run([&] { return streamer.status().state == PackmlState::Execute; });
  EXPECT_TRUE(streamer.pause(link.now));
  link.run([&] { return streamer.status().state == PackmlState::Held; });
  EXPECT_EQ(streamer.change({LiveSetting::Feed, 50.0}, link.now), "");
  streamer.takeOutput();  // the change is lost
  EXPECT_TRUE(streamer.resume(link.now));
  link.run();
  EXPECT_EQ(streamer.status().state, PackmlState::Complete) << streamer.status().failure.message;
  EXPECT_EQ(streamer.status().message, "no answer to M220 S50, which may not have been done");
  EXPECT_EQ(ran, commands);
}

TEST(RepRapProtocol, ChecksLinesByTheCrcOfTheFirmware) {
  EXPECT_EQ(reprapCrc("123456789"), 0x31c3);  // the check value of CRC-16/XMODEM
  EXPECT_EQ(reprapFrame(1, "M105").substr(0, 8), "N1 M105*");
  EXPECT_EQ(reprapFrame(1, "M105").size(), 14U) << "always five digits";
}

TEST(RepRapProtocol, CountsMissedStepsThatTheFirmwareReports) {
  for (const char* stall : {"Warning: Driver 0 stall", "Warning: Driver 1.2 stall",
                            "Warning: motor stall reported by driver(s) 0 1"})
    EXPECT_EQ(readReprapReply(stall).reply.kind, ReplyKind::NotDone) << stall;
  EXPECT_EQ(readReprapReply("Warning: Driver 0 warning: high temperature").reply.kind, ReplyKind::Warning);
}

TEST(RepRapProtocol, NamesWhatTheFirmwareWouldMisread) {
  for (const char* taken :
       {"G1 X{1*2}", "M117 \"a*b\"", "echo \"hello\"", "T0", "set global.x = 1", "G1 X1 M106 S1"})
    EXPECT_EQ(reprapDefectOf(taken, 0), "") << taken;
  for (const char* misread : {"G1 X1*5", "M117 \"open", "if true", "START_PRINT", "M555 P1", "G1 X{1"})
    EXPECT_NE(reprapDefectOf(misread, 0), "") << misread;
}

TEST(KlipperProtocol, NamesWhatTheFirmwareWouldMisread) {
  for (const char* taken : {"START_PRINT BED=60", "G1 X1*5", "M117 #1", "SET_DISPLAY_TEXT MSG=\"a#b\""})
    EXPECT_EQ(klipperDefectOf(taken, 0), "") << taken;
  for (const char* misread : {"SET_DISPLAY_TEXT MSG=a#b", "M117 \"a;b\"", "SAY MSG=\"open", "M117 \xc3\xa4"})
    EXPECT_NE(klipperDefectOf(misread, 0), "") << misread;
}

TEST(OkPacedFirmware, SaysAChangeInItsOwnWords) {
  const auto klipper = firmwareProtocols().find("klipper");
  const auto reprap = firmwareProtocols().find("reprapfirmware");
  const auto changed = [](const auto& protocol, const LiveChange& change) {
    const auto program = StreamableProgram::fromText(
        "parts", "EXCLUDE_OBJECT_DEFINE NAME=a POLYGON=[[0,0]]\nEXCLUDE_OBJECT_DEFINE NAME=b\nG1 X1\n");
    const ChangeCommand made = dynamic_cast<const OkPacedFirmware&>(*protocol).changed(change, program);
    return made.command + made.refusal;
  };
  EXPECT_EQ(changed(klipper, {LiveSetting::Feed, 90.0}), "M220 S90");
  EXPECT_EQ(changed(klipper, {LiveSetting::Babystep, -0.05}), "SET_GCODE_OFFSET Z_ADJUST=-0.05 MOVE=1");
  EXPECT_EQ(changed(klipper, {LiveSetting::CancelPart, 1.0}), "EXCLUDE_OBJECT NAME=b");
  EXPECT_EQ(changed(klipper, {LiveSetting::Rapid, 50.0}), "Klipper has no rapid");
  EXPECT_EQ(changed(reprap, {LiveSetting::Spindle, 50.0}), "RepRapFirmware has no spindle");
  EXPECT_EQ(changed(reprap, {LiveSetting::Flow, 102.5}), "M221 S102.5");
  EXPECT_EQ(changed(reprap, {LiveSetting::Babystep, 0.02}), "M290 R1 S0.02");
  EXPECT_EQ(changed(reprap, {LiveSetting::CancelPart, 1.0}), "M486 P1");
}

}  // namespace
}  // namespace lamina
