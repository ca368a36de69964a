// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Jobs whose streamer dies at any instant, and that another goes on with.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include "lamina/base/error.hpp"
#include "streaming/emulator/simulated_link.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

constexpr std::uint64_t kBase = 4'000'000;

StreamableProgram resumedProgram(int lines) {
  return StreamableProgram::fromText("part", test::spiralProgram(lines));
}

/// A firmware that outlives its streamers, in simulated time. What a streamer has put out may be cut anywhere
/// when it dies; what the firmware says meanwhile is heard by nobody.
class OutlivingMachine {
 public:
  OutlivingMachine(const StreamableProgram& program, double speed_up, std::uint64_t seed)
      : program_(program), random_(seed), firmware_(machineOf(speed_up), {}, observer()) {}

  void begin() { place({program_, settings(), {}, {}, kBase, {}}); }
  void resume() {
    StreamOrder order{program_, settings(), {}, {}, kBase, {}};
    order.settings.firmware = "marlin";
    order.unfinished = known;
    place(std::move(order));
  }

  void runSteps(std::uint64_t steps) {
    for (std::uint64_t i = 0; i < steps && !isFinal(streamer->status().state); ++i) step();
  }

  void kill() {
    to_machine_.resize(random_.below(to_machine_.size() + 1));
    streamer.reset();
    for (int i = 0; i < 5 && !to_machine_.empty(); ++i) deliver();
    firmware_.receive(std::exchange(to_machine_, {}), now_ += 1e-3);
    for (const double end = now_ + random_.uniform(0.0, 1.0); now_ < end;) {
      now_ = std::min(end, std::max(now_ + 1e-6, firmware_.nextDeadline()));
      firmware_.elapse(now_);
    }
    firmware_.takeOutput();
    to_host_.clear();
  }

  void receive(const std::string& bytes) { firmware_.receive(bytes, now_ += 1e-3); }

  /// The program's lines that were run, and tails of such.
  std::vector<std::string> ran() const {
    std::vector<std::string> commands;
    for (const ExecutedLine& line : executed_) {
      const bool is_own = line.command.compare(0, 4, "M110") == 0 || line.command.compare(0, 3, "M10") == 0 ||
                          line.command.compare(0, 4, "M154") == 0 ||
                          line.command.compare(0, 4, "M115") == 0 ||
                          line.command.compare(0, 4, "M155") == 0 || line.command.compare(0, 4, "M400") == 0;
      if (!is_own) commands.push_back(line.command);
    }
    return commands;
  }

  std::unique_ptr<Streamer> streamer;
  UnfinishedLines known;  ///< as a progress file would say

 private:
  static EmulatedSettings machineOf(double speed_up) {
    EmulatedSettings settings;
    settings.speed_up = speed_up;
    return settings;
  }
  static StreamSettings settings() {
    StreamSettings settings;
    settings.link = LinkKind::Reliable;
    return settings;
  }
  EmulatedObserver observer() {
    return {[this](const ExecutedLine& line) { executed_.push_back(line); }, {}};
  }

  void place(StreamOrder order) {
    streamer = std::make_unique<Streamer>(std::move(order));
    streamer->start(now_);
    collect();
  }

  void step() {
    if (to_machine_.empty() && to_host_.empty()) {
      now_ =
          std::min(std::max(now_, std::min(streamer->nextDeadline(), firmware_.nextDeadline())), now_ + 60);
      streamer->elapse(now_);
      firmware_.elapse(now_);
    } else {
      deliver();
      const std::string heard = piece(to_host_);
      if (!heard.empty()) streamer->receive(heard, now_);
    }
    collect();
  }

  void deliver() {
    now_ += 1e-4;
    const std::string sent = piece(to_machine_);
    if (!sent.empty()) firmware_.receive(sent, now_);
  }

  void collect() {
    const StreamStatus& status = streamer->status();
    known.taken_through = status.lines_acknowledged - std::min<std::uint64_t>(status.lines_acknowledged, 8);
    known.sent_through = std::min(status.lines_total, std::max(known.sent_through, status.lines_sent + 200));
    known.firmware_name = status.firmware_name;
    to_machine_ += streamer->takeOutput();
    to_host_ += firmware_.takeOutput();
  }

  std::string piece(std::string& wire) {
    const std::size_t size = std::min<std::size_t>(wire.size(), 1 + random_.below(60));
    std::string taken = wire.substr(0, size);
    wire.erase(0, size);
    return taken;
  }

  StreamableProgram program_;
  Random random_;
  double now_ = 0.0;
  std::vector<ExecutedLine> executed_;
  EmulatedFirmware firmware_;
  std::string to_machine_;
  std::string to_host_;
};

TEST(ResumedJob, RunsEveryLineOnceHoweverOftenItsStreamerDies) {
  const auto program = resumedProgram(300);
  Random random(7);
  int kills = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    OutlivingMachine machine(program, seed % 2 == 0 ? 0.0 : 200.0, seed);
    machine.begin();
    while (machine.streamer->status().state != PackmlState::Execute) machine.runSteps(1);
    while (true) {
      machine.runSteps(1 + random.below(150));
      if (machine.streamer->status().state != PackmlState::Execute) break;
      machine.kill();
      ++kills;
      machine.resume();
      while (machine.streamer->status().state == PackmlState::Starting) machine.runSteps(1);
      ASSERT_EQ(machine.streamer->status().state, PackmlState::Execute)
          << machine.streamer->status().failure.message;
    }
    machine.runSteps(1'000'000);
    ASSERT_EQ(machine.streamer->status().state, PackmlState::Complete)
        << machine.streamer->status().failure.message;
    const auto ran = machine.ran();
    const auto meant = test::commandsOf(program);
    const auto differ = std::mismatch(meant.begin(), meant.end(), ran.begin(), ran.end());
    ASSERT_EQ(ran.size(), meant.size()) << (differ.second == ran.end() ? "" : *differ.second);
    ASSERT_TRUE(differ.first == meant.end())
        << "seed " << seed << ": ran \"" << *differ.second << "\" instead of \"" << *differ.first << "\"";
    EXPECT_EQ(machine.streamer->status().lines_acknowledged, 300U);
    EXPECT_EQ(machine.streamer->status().layer, 2);
  }
  EXPECT_GT(kills, 200);
}

/// A job that was killed amid its lines.
std::unique_ptr<OutlivingMachine> killedJob(const StreamableProgram& program) {
  auto machine = std::make_unique<OutlivingMachine>(program, 0.0, 3);
  machine->begin();
  while (machine->streamer->status().lines_acknowledged < 100) machine->runSteps(1);
  machine->kill();
  return machine;
}

void expectRefused(OutlivingMachine& machine, const std::string& why) {
  const auto ran = machine.ran();
  machine.resume();
  machine.runSteps(100'000);
  const StreamStatus& status = machine.streamer->status();
  EXPECT_EQ(status.state, PackmlState::Aborted);
  EXPECT_NE(status.failure.message.find(why), std::string::npos) << status.failure.message;
  EXPECT_NE(status.failure.message.find("of 300 was certainly taken"), std::string::npos)
      << status.failure.message;
  EXPECT_EQ(machine.ran(), ran) << "nothing is run, and nothing stopped";
}

TEST(ResumedJob, IsRefusedWhereTheCounterIsAnothers) {
  const auto program = resumedProgram(300);
  for (const char* const set : {"N0 M110 N0*125\n", "N0 M110 N0*125\nN1 G4 P0*108\n"}) {
    const auto machine = killedJob(program);
    machine->receive("\n");  // ends what was cut off
    machine->receive(set);
    expectRefused(*machine, "expected one from 4000");
  }
}

TEST(ResumedJob, IsRefusedWhereMoreOrLessWasTakenThanIsKnown) {
  const auto program = resumedProgram(300);
  for (const std::uint64_t off : {1U, 50U}) {
    const auto machine = killedJob(program);
    machine->known.taken_through += 20 + off;
    expectRefused(*machine, "reset or stopped");
  }
  const auto machine = killedJob(program);
  machine->known.taken_through = machine->known.sent_through = 90;
  expectRefused(*machine, "no line beyond 90 was sent");
}

TEST(ResumedJob, IsRefusedWhereItsProgramIsGoneMeanwhile) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("part.gcode");
  std::ofstream(path) << test::spiralProgram(300);
  const auto machine = killedJob(StreamableProgram::fromFile(path));
  const auto ran = machine->ran();
  machine->resume();
  std::filesystem::remove(path);
  machine->runSteps(100'000);
  const StreamStatus& status = machine->streamer->status();
  EXPECT_EQ(status.state, PackmlState::Aborted);
  EXPECT_EQ(status.failure.code, ErrorCode::FileError);
  EXPECT_NE(status.failure.message.find(path), std::string::npos) << status.failure.message;
  EXPECT_EQ(machine->ran(), ran) << "nothing is run, and nothing stopped";
}

TEST(ResumedJob, GoesOnWhereANameWasDamagedOnItsWay) {
  const StreamableProgram program = resumedProgram(300);
  const auto machine = killedJob(program);
  std::string& name = machine->known.firmware_name;
  ASSERT_GT(name.size(), 16U);
  name[5] = name[5] == 'x' ? 'y' : 'x';
  name.erase(9, 1);
  machine->resume();
  machine->runSteps(100'000);
  EXPECT_EQ(machine->streamer->status().state, PackmlState::Complete)
      << machine->streamer->status().failure.message;
}

TEST(ResumedJob, IsRefusedOnOtherFirmware) {
  const auto machine = killedJob(resumedProgram(300));
  machine->known.firmware_name = "Marlin of another printer";
  expectRefused(*machine, "that of the job was \"Marlin of another printer\"");
}

TEST(ResumedJob, IsRefusedAfterItsSafeStop) {
  const auto machine = std::make_unique<OutlivingMachine>(resumedProgram(300), 0.0, 3);
  machine->begin();
  while (machine->streamer->status().lines_acknowledged < 100) machine->runSteps(1);
  machine->streamer->abort({ErrorCode::Cancelled, "enough"}, 1e3);
  machine->runSteps(40);
  machine->kill();
  machine->known.sent_through = 300;
  const auto ran = machine->ran();
  machine->resume();
  machine->runSteps(100'000);
  EXPECT_EQ(machine->streamer->status().state, PackmlState::Aborted);
  EXPECT_EQ(machine->ran(), ran);
}

TEST(ResumedJob, NeedsAProtocolThatKnowsHow) {
  StreamOrder order{resumedProgram(10), {}, {}, {}, kBase, UnfinishedLines{1, 5, ""}};
  EXPECT_THROW(Streamer{order}, InvalidConfig) << "auto: nobody knows who was spoken to";
}

}  // namespace
}  // namespace lamina
