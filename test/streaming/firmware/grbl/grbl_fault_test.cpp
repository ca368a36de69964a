// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Jobs on an emulated grbl with faults. LAMINA_GRBL_LINES=10000000 in the environment runs so many lines.
#include <gtest/gtest.h>

#include <cstdlib>

#include "streaming/emulator/grbl_link.hpp"
#include "streaming/emulator/simulated_link.hpp"

namespace lamina {
namespace {

using test::GrblLink;

StreamSettings grblWire(LinkKind link) {
  StreamSettings settings;
  settings.link = link;
  settings.window_bytes = 1024;
  return settings;
}

std::uint64_t linesToRun() {
  constexpr std::uint64_t kLinesInEveryTest = 100000;
  const char* wanted = std::getenv("LAMINA_GRBL_LINES");
  return wanted == nullptr ? kLinesInEveryTest : std::strtoull(wanted, nullptr, 10);
}

/// What became of many jobs.
struct Tally {
  std::uint64_t lines = 0;
  std::uint64_t jobs = 0;
  std::uint64_t complete = 0;
  std::uint64_t struck = 0;      ///< jobs with at least one fault
  std::uint64_t confirmed = 0;   ///< jobs that ended otherwise, with a safe stop that the machine confirmed
  std::uint64_t wrong = 0;       ///< a line was run twice, or out of order
  std::uint64_t false_ends = 0;  ///< Complete, and what ran is not the program
};

/// Whether lines are run once and in the program's order; some may be missing, as behind one that is refused.
bool isInOrder(const std::vector<std::string>& executed, const std::vector<std::string>& commands) {
  auto next = commands.begin();
  for (const std::string& line : executed) {
    if (line[0] != 'G') continue;  // the tail of a line that a reset has cut
    next = std::find(next, commands.end(), line);
    if (next == commands.end()) return false;
    ++next;
  }
  return true;
}

void tell(GrblLink& wire, const std::vector<std::string>& commands, Tally& tally) {
  wire.run(1e5);
  ++tally.jobs;
  tally.lines += wire.executed.size();
  if (wire.firmware.faults() > 0) ++tally.struck;
  if (!isInOrder(wire.executed, commands)) ++tally.wrong;
  if (wire.isComplete()) ++tally.complete;
  if (wire.isComplete() && wire.executed != commands) ++tally.false_ends;
  const bool is_safe = !wire.isComplete() && !wire.firmware.isInMotion() &&
                       wire.firmware.spindleSpeed() == 0.0 &&
                       wire.message().find("did not confirm") == std::string::npos;
  if (is_safe) ++tally.confirmed;
  // A byte that damage has made a '!' holds the machine until a person goes on.
  const PackmlState state = wire.streamer.status().state;
  EXPECT_TRUE(isFinal(state) || state == PackmlState::Held) << toString(state);
  EXPECT_EQ(wire.firmware.bytesLost(), 0U);
}

/// @param kinds  of faults, which share one in two thousand lines
Tally runMany(const std::vector<GrblFaultKind>& kinds, LinkKind link, std::uint64_t lines) {
  constexpr int kLinesOfProgram = 1000;
  const double rate = 1.0 / 2000.0 / static_cast<double>(kinds.size());
  std::vector<GrblFault> faults;
  for (const GrblFaultKind kind : kinds) faults.push_back({kind, rate, {}});
  const auto program = StreamableProgram::fromText("mill", test::millProgram(kLinesOfProgram), {});
  const auto commands = test::commandsOf(program);
  Tally tally;
  for (std::uint64_t seed = 1; tally.lines < lines; ++seed) {
    EmulatedGrblSettings machine;
    machine.seed = seed;
    GrblLink wire(program, grblWire(link), machine, faults);
    tell(wire, commands, tally);
    if (tally.jobs > lines) break;  // of a job that is refused no line is run
  }
  std::printf(
      "%llu lines, %llu jobs, %llu struck, %llu complete, %llu stopped safely, %llu wrong, %llu false ends\n",
      static_cast<unsigned long long>(tally.lines), static_cast<unsigned long long>(tally.jobs),
      static_cast<unsigned long long>(tally.struck), static_cast<unsigned long long>(tally.complete),
      static_cast<unsigned long long>(tally.confirmed), static_cast<unsigned long long>(tally.wrong),
      static_cast<unsigned long long>(tally.false_ends));
  return tally;
}

const std::vector<GrblFaultKind> kSurvivable = {
    GrblFaultKind::LostOk, GrblFaultKind::DelayedOk, GrblFaultKind::Error,     GrblFaultKind::Alarm,
    GrblFaultKind::Reset,  GrblFaultKind::Silence,   GrblFaultKind::Disconnect};

class GrblUnderFault : public testing::TestWithParam<GrblFaultKind> {};

TEST_P(GrblUnderFault, RunsEveryLineOnceInOrderOrEndsOtherwise) {
  constexpr std::uint64_t kKinds = 7;
  const Tally tally = runMany({GetParam()}, LinkKind::Reliable, linesToRun() / kKinds);
  EXPECT_EQ(tally.wrong, 0U);
  EXPECT_EQ(tally.false_ends, 0U);
  EXPECT_GT(tally.struck, 0U);
  EXPECT_EQ(tally.complete + tally.confirmed, tally.jobs);
}

INSTANTIATE_TEST_SUITE_P(EveryKind, GrblUnderFault, testing::ValuesIn(kSurvivable));

TEST(GrblUnderFaults, RunsEveryLineOnceInOrderOrEndsOtherwiseUnderAllKindsAtOnce) {
  const Tally tally = runMany(kSurvivable, LinkKind::Reliable, linesToRun());
  EXPECT_EQ(tally.wrong, 0U);
  EXPECT_EQ(tally.false_ends, 0U);
  EXPECT_GT(tally.struck, 0U);
  EXPECT_EQ(tally.complete + tally.confirmed, tally.jobs);
}

/// grbl cannot see damage in a line that still makes sense; whoever declares such a link reliable gets an end
/// all the same.
TEST(GrblUnderDamage, EndsWhereALossyLinkIsDeclaredReliable) {
  for (const GrblFaultKind kind : {GrblFaultKind::LostByte, GrblFaultKind::ChangedByte}) {
    const Tally tally = runMany({kind}, LinkKind::Reliable, 20000);
    EXPECT_GT(tally.struck, 0U);
    EXPECT_LT(tally.complete, tally.jobs) << "most damage is seen";
  }
}

TEST(GrblUnderDamage, RunsNothingBehindALossyLink) {
  for (const GrblFaultKind kind : {GrblFaultKind::LostByte, GrblFaultKind::ChangedByte}) {
    const Tally tally = runMany({kind}, LinkKind::Lossy, 20);
    EXPECT_EQ(tally.complete, 0U);
    EXPECT_EQ(tally.lines, 0U);
  }
}

}  // namespace
}  // namespace lamina
