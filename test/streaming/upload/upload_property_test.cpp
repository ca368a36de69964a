// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Many prints under random faults: what is reported Complete was printed once, line by line.

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "streaming/upload/upload_fixture.hpp"

namespace lamina {
namespace {

using test::SimulatedHttp;

/// Lines in all: a number in LAMINA_UPLOAD_LINES, or few.
std::uint64_t linesToPrint() {
  const char* lines = std::getenv("LAMINA_UPLOAD_LINES");
  return lines == nullptr ? 100000 : std::strtoull(lines, nullptr, 10);
}

struct RandomRun {
  std::unique_ptr<SimulatedHttp> link;
  std::vector<std::string> commands;
  bool has_event = false;
};

void addEvent(SimulatedHttp& link, Random& random) {
  using Server = EmulatedPrintServer;
  const std::vector<void (*)(Server&)> kinds = {
      [](Server& s) { s.printer.cancel(); },
      [](Server& s) { s.printer.breakDown(); },
      [](Server& s) { s.printer.restart(); },
      [](Server& s) { s.printer.halt(); },
      [](Server& s) {
        s.printer.cancel();
        s.printer.print("other.gcode");
      },
  };
  link.events.push_back({random.uniform(0.0, 8.0), kinds[random.below(kinds.size())]});
}

RandomRun randomRun(const test::ServerKind& kind, std::uint64_t seed) {
  Random random(seed);
  const std::string text = test::hotProgram(1 + static_cast<int>(random.below(400)));
  RandomRun run{std::make_unique<SimulatedHttp>(test::orderOf(text), StreamSettings{}, kind.make(), seed),
                test::commandsOf(text)};
  run.link->server->printer.files["other.gcode"] = "G4 S1\n";
  run.link->server->printer.lines_per_s = random.uniform(20.0, 1000.0);
  const double queue_s = random.uniform(0.0, 4.0);  // a Duet ends a print when its motions have ended
  if (std::string(kind.firmware) == "klipper") run.link->server->printer.queue_s = queue_s;
  const double rate = random.below(2) == 0 ? 0.0 : 0.1;
  for (double* fault : {&run.link->faults.server_error, &run.link->faults.lost_request,
                        &run.link->faults.lost_response, &run.link->faults.late, &run.link->faults.slow})
    if (random.below(2) == 0) *fault = rate;
  if (random.below(8) == 0) run.link->faults.damaged = 0.5;
  if (random.below(4) == 0) {
    run.link->unreachable_from_s = random.uniform(0.0, 10.0);
    run.link->unreachable_until_s = run.link->unreachable_from_s + random.uniform(0.0, 100.0);
  }
  run.has_event = random.below(4) == 0;
  if (run.has_event) addEvent(*run.link, random);
  return run;
}

/// The commands that were run, without those of another file.
std::vector<std::string> ours(const SimulatedHttp& link) {
  std::vector<std::string> commands = link.server->printer.executed();
  commands.erase(std::remove(commands.begin(), commands.end(), "G4 S1"), commands.end());
  return commands;
}

class UploadProperty : public testing::TestWithParam<test::ServerKind> {};

TEST_P(UploadProperty, CompleteMeansPrintedOnce) {
  std::uint64_t lines = 0;
  std::uint64_t complete = 0;
  std::uint64_t runs = 0;
  for (std::uint64_t seed = 1; lines < linesToPrint(); ++seed, ++runs) {
    RandomRun run = randomRun(GetParam(), seed);
    run.link->run(5000.0);
    const StreamStatus& status = run.link->job.status();
    const std::vector<std::string> executed = ours(*run.link);
    lines += run.commands.size();
    ASSERT_TRUE(isFinal(status.state)) << "seed " << seed << " at " << run.link->now;
    for (std::size_t i = 1; i < run.link->states.size(); ++i)
      ASSERT_TRUE(isLegalTransition(run.link->states[i - 1], run.link->states[i])) << "seed " << seed;
    ASSERT_LE(executed.size(), run.commands.size()) << "seed " << seed;
    ASSERT_TRUE(std::equal(executed.begin(), executed.end(), run.commands.begin())) << "seed " << seed;
    if (status.state == PackmlState::Complete) {
      ++complete;
      ASSERT_EQ(executed, run.commands) << "seed " << seed;
      ASSERT_FALSE(run.link->server->printer.is_halted && run.link->server->printer.isMoving())
          << "seed " << seed;
    } else {
      ASSERT_NE(status.failure.code, ErrorCode::Ok) << "seed " << seed;
    }
    if (status.failure.message.find("its heaters are off") != std::string::npos) {
      ASSERT_EQ(run.link->server->printer.state(), EmulatedPrinter::State::Idle) << "seed " << seed;
      ASSERT_EQ(run.link->server->printer.nozzle_target_c, 0.0) << "seed " << seed;
      run.link->runOn(run.link->now + 30.0);
      ASSERT_EQ(ours(*run.link), executed) << "seed " << seed;
    }
  }
  RecordProperty("runs", std::to_string(runs));
  RecordProperty("complete", std::to_string(complete));
  std::printf("%s: %llu lines in %llu runs, %llu complete\n", GetParam().name,
              static_cast<unsigned long long>(lines), static_cast<unsigned long long>(runs),
              static_cast<unsigned long long>(complete));
  EXPECT_GT(complete, runs / 3);
}

INSTANTIATE_TEST_SUITE_P(Servers, UploadProperty,
                         testing::Values(test::ServerKind{"moonraker", makeEmulatedMoonraker, "klipper"},
                                         test::ServerKind{"duet", makeEmulatedDuet, "reprapfirmware"},
                                         test::ServerKind{"duet_with_computer", makeEmulatedDuetWithComputer,
                                                          "reprapfirmware"}),
                         [](const auto& server) { return std::string(server.param.name); });

}  // namespace
}  // namespace lamina
