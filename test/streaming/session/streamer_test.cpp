// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/session/streamer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "streaming/emulator/simulated_link.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

using test::SimulatedLink;

StreamableProgram streamerProgram(const std::string& text) {
  return StreamableProgram::fromText("test", text);
}

EmulatedSettings instantMachine() {
  EmulatedSettings settings;
  settings.speed_up = 0.0;
  return settings;
}

TEST(Streamer, RunsEveryLineOnceInOrder) {
  const auto spiral = streamerProgram(test::spiralProgram(500));
  SimulatedLink link(spiral, {}, instantMachine(), {});
  link.run();
  EXPECT_EQ(link.streamer.status().state, PackmlState::Complete) << link.streamer.status().failure.message;
  EXPECT_EQ(link.numberedCommands(), test::commandsOf(spiral));
  EXPECT_EQ(link.streamer.status().lines_acknowledged, 500U);
  EXPECT_EQ(link.streamer.status().layer, 4);
  EXPECT_EQ(link.streamer.status().resends, 0U);
  EXPECT_EQ(link.firmware.counts().bytes_lost, 0U);
}

StreamSettings lossyLink() {
  StreamSettings settings;
  settings.link = LinkKind::Lossy;
  return settings;
}

class StreamerUnderFault : public testing::TestWithParam<FaultKind> {};

TEST_P(StreamerUnderFault, RunsEveryLineOnceInOrder) {
  const auto spiral = streamerProgram(test::spiralProgram(2000));
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EmulatedSettings machine = instantMachine();
    machine.fault_seed = static_cast<int>(seed);
    SimulatedLink link(spiral, lossyLink(), machine, {{GetParam(), 0.02, {1, 2, 3, 500, 1999, 2000}}}, seed);
    link.run();
    EXPECT_EQ(link.streamer.status().state, PackmlState::Complete) << link.streamer.status().failure.message;
    EXPECT_EQ(link.numberedCommands(), test::commandsOf(spiral));
    // A line that is asked for without cause is refused when it comes again, and with it the head of the
    // next.
    const std::size_t tails = GetParam() == FaultKind::SpuriousResend ? 2 : 0;
    EXPECT_LE(link.fragments().size(), tails);
    EXPECT_EQ(link.streamer.status().lines_acknowledged, 2000U);
    EXPECT_GT(link.firmware.counts().faults, 20U);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, StreamerUnderFault,
                         testing::Values(FaultKind::LostOk, FaultKind::DelayedOk, FaultKind::LostLine,
                                         FaultKind::CorruptedLine, FaultKind::SpuriousResend,
                                         FaultKind::Silence),
                         [](const auto& tested) { return std::string(toString(tested.param)); });

/// LAMINA_MARLIN_LINES sets how many lines are streamed; few are in every run of the tests.
std::uint64_t marlinLines() {
  const char* const wanted = std::getenv("LAMINA_MARLIN_LINES");
  return wanted == nullptr ? 30000 : std::strtoull(wanted, nullptr, 10);
}

/// Faults that a job survives, and in two jobs of five one that it does not.
std::vector<Fault> faultsOfJob(std::uint64_t job, int lines) {
  std::vector<Fault> faults;
  for (const FaultKind kind : {FaultKind::LostOk, FaultKind::DelayedOk, FaultKind::LostLine,
                               FaultKind::CorruptedLine, FaultKind::Silence})
    faults.push_back({kind, 0.001, {}});
  const auto line = 1 + (job * 7919) % static_cast<std::uint64_t>(lines);
  if (job % 5 == 3) faults.push_back({FaultKind::Reset, 0.0, {line}});
  if (job % 5 == 4) faults.push_back({FaultKind::Disconnect, 0.0, {line}});
  return faults;
}

/// Whether a line is one of the program's whose N was damaged into a G: "G1536 G1 X3". Sessions count lines
/// by numbers of seven digits, so that no firmware knows such a code.
bool isUnknownCode(const std::string& fragment, const std::vector<std::string>& meant) {
  const std::size_t space = fragment.find(' ');
  if (space == std::string::npos) return false;
  const auto number = std::strtoull(fragment.c_str() + 1, nullptr, 10);
  return number > 0 && number <= meant.size() && fragment.substr(space + 1) == meant[number - 1];
}

TEST(Streamer, CompletesOnlyJobsWhoseEveryLineWasRunOnce) {
  constexpr int kLines = 5000;
  const auto spiral = streamerProgram(test::spiralProgram(kLines));
  const std::vector<std::string> meant = test::commandsOf(spiral);
  std::uint64_t lines = 0;
  std::uint64_t complete = 0;
  std::uint64_t jobs = 0;
  for (; lines < marlinLines(); ++jobs) {
    EmulatedSettings machine = instantMachine();
    machine.fault_seed = static_cast<int>(jobs + 1);
    SimulatedLink link(spiral, lossyLink(), machine, faultsOfJob(jobs, kLines), jobs + 1);
    link.run();
    const std::vector<std::string> ran = link.numberedCommands();
    lines += link.streamer.status().lines_sent;
    const bool is_complete = link.streamer.status().state == PackmlState::Complete;
    complete += is_complete ? 1 : 0;
    EXPECT_EQ(is_complete, jobs % 5 < 3) << link.streamer.status().failure.message;
    if (is_complete) {
      ASSERT_EQ(ran, meant) << "job " << jobs;
    }
    ASSERT_TRUE(ran.size() <= meant.size() + 8) << "job " << jobs;
    const std::size_t common = std::min(link.streamer.status().lines_acknowledged, ran.size());
    ASSERT_TRUE(std::equal(ran.begin(), ran.begin() + static_cast<std::ptrdiff_t>(common), meant.begin()))
        << "job " << jobs;
    for (const std::string& fragment : link.fragments())
      ASSERT_TRUE(isUnknownCode(fragment, meant)) << "job " << jobs << ": " << fragment;
  }
  std::printf("%llu lines in %llu jobs, %llu complete\n", static_cast<unsigned long long>(lines),
              static_cast<unsigned long long>(jobs), static_cast<unsigned long long>(complete));
}

TEST(Streamer, ProvesAnAnsweringMachineAgainBeforeItGivesUp) {
  // The machine has "N0 M110 N0" and answers it; the line that it must refuse is lost, three times.
  const auto spiral = streamerProgram(test::spiralProgram(10));
  SimulatedLink link(spiral, lossyLink(), instantMachine(), {{FaultKind::LostLine, 0.0, {3, 5, 7}}});
  link.run();
  EXPECT_EQ(link.firmware.counts().faults, 3U);
  EXPECT_EQ(link.streamer.status().state, PackmlState::Complete) << link.streamer.status().failure.message;
  EXPECT_EQ(link.numberedCommands(), test::commandsOf(spiral));
}

TEST(Streamer, WouldRunTailsOfLinesBehindADamagedOne) {
  const auto spiral = streamerProgram(test::spiralProgram(2000));
  const std::vector<Fault> faults = {{FaultKind::CorruptedLine, 0.05, {}}};
  SimulatedLink four(spiral, {}, instantMachine(), faults);
  four.run();
  EXPECT_FALSE(four.fragments().empty()) << "four lines under way: why a lossy link has one";
  SimulatedLink one(spiral, lossyLink(), instantMachine(), faults);
  one.run();
  EXPECT_EQ(one.fragments(), std::vector<std::string>());
  EXPECT_EQ(one.numberedCommands(), test::commandsOf(spiral));
}

/// Any mix of the faults that a job must survive, each up to 3 %.
rc::Gen<std::vector<Fault>> anyFaults() {
  const auto rate = rc::gen::map(rc::gen::inRange(0, 31), [](int per_mille) { return per_mille / 1000.0; });
  return rc::gen::map(rc::gen::container<std::vector<double>>(6, rate), [](const std::vector<double>& rates) {
    constexpr std::array<FaultKind, 6> kKinds = {FaultKind::LostOk,         FaultKind::DelayedOk,
                                                 FaultKind::LostLine,       FaultKind::CorruptedLine,
                                                 FaultKind::SpuriousResend, FaultKind::Silence};
    std::vector<Fault> faults;
    for (std::size_t i = 0; i < kKinds.size(); ++i) faults.push_back({kKinds[i], rates[i], {}});
    return faults;
  });
}

RC_GTEST_PROP(StreamerProperty, EveryLineIsRunOnceInOrderUnderAnyFaults, ()) {
  const auto spiral = streamerProgram(test::spiralProgram(*rc::gen::inRange(5, 400)));
  EmulatedSettings machine;
  machine.speed_up = *rc::gen::element(0.0, 1.0, 50.0);
  machine.fault_seed = *rc::gen::inRange(1, 1000000);
  machine.command_queue = *rc::gen::inRange(1, 9);
  StreamSettings settings = lossyLink();
  settings.window_bytes = *rc::gen::inRange(96, 256);
  std::vector<Fault> faults = *anyFaults();
  // Lines sent again without need are refused, and the head of the next may be lost with them.
  const bool asks_without_cause = *rc::gen::arbitrary<bool>();
  for (Fault& fault : faults)
    if (fault.kind == FaultKind::SpuriousResend && !asks_without_cause) fault.rate = 0.0;
  SimulatedLink link(spiral, settings, machine, faults, *rc::gen::inRange<std::uint64_t>(1, 1000000));
  link.run();
  RC_ASSERT(link.streamer.status().state == PackmlState::Complete);
  const std::vector<std::string> meant = test::commandsOf(spiral);
  RC_ASSERT(link.numberedCommands() == meant);
  for (const std::string& fragment : link.fragments())
    RC_ASSERT(asks_without_cause || isUnknownCode(fragment, meant));
}

RC_GTEST_PROP(StreamerProperty, EveryLineIsRunOnceInOrderThroughAnyWindowIfNoneIsRefused, ()) {
  const auto spiral = streamerProgram(test::spiralProgram(*rc::gen::inRange(5, 400)));
  EmulatedSettings machine;
  machine.speed_up = *rc::gen::element(0.0, 1.0, 50.0);
  machine.fault_seed = *rc::gen::inRange(1, 1000000);
  machine.command_queue = *rc::gen::inRange(1, 9);
  StreamSettings settings;
  settings.window_lines = *rc::gen::inRange(1, 9);
  std::vector<Fault> faults = *anyFaults();
  for (Fault& fault : faults) {
    const bool is_line_refused = fault.kind == FaultKind::LostLine ||
                                 fault.kind == FaultKind::CorruptedLine ||
                                 fault.kind == FaultKind::SpuriousResend;
    if (is_line_refused) fault.rate = 0.0;
  }
  SimulatedLink link(spiral, settings, machine, faults, *rc::gen::inRange<std::uint64_t>(1, 1000000));
  link.run();
  RC_ASSERT(link.streamer.status().state == PackmlState::Complete);
  RC_ASSERT(link.numberedCommands() == test::commandsOf(spiral));
  RC_ASSERT(link.fragments().empty());
}

RC_GTEST_PROP(StreamerProperty, NothingIsLostHoweverOftenAJobIsHeld, ()) {
  const auto spiral = streamerProgram(test::spiralProgram(300));
  EmulatedSettings machine;
  machine.speed_up = 50.0;
  machine.fault_seed = *rc::gen::inRange(1, 1000000);
  SimulatedLink link(spiral, lossyLink(), machine, *anyFaults());
  link.start();
  for (const int pause : *rc::gen::container<std::vector<int>>(5, rc::gen::inRange(1, 400))) {
    for (int i = 0; i < pause && !isFinal(link.streamer.status().state); ++i) link.step();
    link.streamer.pause(link.now);
    link.runUntil(link.now + 100.0);
    const auto held = link.numberedCommands().size();
    link.runUntil(link.now + 100.0);
    RC_ASSERT(isFinal(link.streamer.status().state) || link.numberedCommands().size() == held ||
              link.streamer.status().state != PackmlState::Held);
    link.streamer.resume(link.now);
    link.collect();
  }
  link.runUntil(1e6);
  RC_ASSERT(link.streamer.status().state == PackmlState::Complete);
  RC_ASSERT(link.numberedCommands() == test::commandsOf(spiral));
}

TEST(Streamer, TurnsHeatersOffThoughTheMachineHearsNothingWhileItHeats) {
  EmulatedSettings deaf;
  deaf.emergency_parser = false;
  SimulatedLink link(streamerProgram("M109 S200\nG1 X1\n"), {}, deaf, {});
  link.start();
  while (link.firmware.nozzleTarget() == 0.0) link.step();
  link.runUntil(link.now + 1.0);
  link.streamer.abort({ErrorCode::Cancelled, "enough"}, link.now);
  link.collect();
  link.runUntil(link.now + 100.0);
  EXPECT_EQ(link.streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(link.streamer.status().failure.message, "enough");
  EXPECT_GT(link.now, 30.0) << "the machine heats to 200 degC at 5 degC/s before it hears anything";
  EXPECT_DOUBLE_EQ(link.firmware.nozzleTarget(), 0.0);
}

RC_GTEST_PROP(StreamerProperty, EveryConfirmedAbortLeavesTheMachineCold, ()) {
  const auto hot = streamerProgram("M104 S200\nM140 S60\n" + test::spiralProgram(200));
  EmulatedSettings machine;
  machine.speed_up = *rc::gen::element(0.0, 1.0, 50.0);
  machine.fault_seed = *rc::gen::inRange(1, 1000000);
  machine.emergency_parser = *rc::gen::arbitrary<bool>();
  SimulatedLink link(hot, {}, machine, *anyFaults());
  link.start();
  const int steps = *rc::gen::inRange(1, 2000);
  for (int i = 0; i < steps && !isFinal(link.streamer.status().state); ++i) link.step();
  link.streamer.abort({ErrorCode::Cancelled, "enough"}, link.now);
  link.collect();
  link.runUntil(link.now + 100.0);
  RC_ASSERT(isFinal(link.streamer.status().state));
  if (link.streamer.status().state == PackmlState::Complete) return;
  const bool is_confirmed = link.streamer.status().failure.message == "enough";
  RC_ASSERT(!is_confirmed || (link.firmware.nozzleTarget() == 0.0 && link.firmware.bedTarget() == 0.0));
}

TEST(Streamer, EndsTheJobIfTheProgramIsGoneWhenTheFirmwareIsKnown) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("part.gcode");
  writeFile(path, "G28\nG1 X1\n");
  StreamSettings settings;
  settings.firmware = kAnyFirmware;
  Streamer streamer(StreamableProgram::fromFile(path, settings), settings);
  streamer.start(0.0);
  EXPECT_EQ(streamer.takeOutput(), "M115\n");
  std::filesystem::remove(path);
  streamer.receive("FIRMWARE_NAME:Marlin 2.1.2\nok\n", 0.1);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(streamer.status().failure.code, ErrorCode::FileError) << streamer.status().failure.message;
  EXPECT_EQ(streamer.takeOutput(), "") << "the machine has got no line";
}

}  // namespace
}  // namespace lamina
