// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines that are revised on their way, layer by layer.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "lamina/base/error.hpp"
#include "lamina/streaming/session/stream_session.hpp"
#include "streaming/emulator/simulated_link.hpp"

namespace lamina {
namespace {

using test::SimulatedLink;

/// Motions of an odd layer are halved into two lines.
class HalvedLayers final : public ProgramRevision {
 public:
  bool isKnown(std::int32_t layer) override {
    asked.insert(layer);
    if (known_from(layer)) decided.insert(layer);
    return decided.count(layer) > 0;
  }
  void decide(std::int32_t layer) override {
    given_up.push_back(layer);
    decided.insert(layer);
  }
  double waitTime() const override { return 2.0; }
  std::string revised(std::string_view line, std::uint64_t number) override {
    EXPECT_EQ(number, ++last_number_) << "each line once, in order";
    const std::string text(line);
    if (text.compare(0, 7, ";LAYER:") == 0) layer_ = std::stoi(text.substr(7));
    if (text.find("REFUSED") != std::string::npos) throw InvalidProgram("line " + std::to_string(number));
    const bool is_halved = layer_ % 2 == 1 && text.compare(0, 4, "G1 X") == 0;
    return is_halved ? "G1 F100\n" + text : text;
  }

  std::function<bool(std::int32_t)> known_from = [](std::int32_t) { return true; };
  std::set<std::int32_t> asked;
  std::set<std::int32_t> decided;
  std::vector<std::int32_t> given_up;

 private:
  std::int32_t layer_ = -1;
  std::uint64_t last_number_ = 0;
};

StreamOrder revisedOrder(const StreamableProgram& program, std::shared_ptr<ProgramRevision> revision) {
  StreamSettings settings;
  settings.link = LinkKind::Lossy;
  return {program, settings, {}, {}, 1000, {}, 0, std::move(revision)};
}

StreamableProgram spiralOf(int lines) {
  return StreamableProgram::fromText("spiral", test::spiralProgram(lines));
}

/// What the spiral becomes.
std::vector<std::string> halvedCommands(const StreamableProgram& program) {
  std::vector<std::string> commands;
  ProgramCursor cursor = program.open();
  while (auto line = cursor.next()) {
    if (line->layer % 2 == 1) commands.emplace_back("G1 F100");
    commands.push_back(line->command);
  }
  return commands;
}

EmulatedSettings swiftMachine() {
  EmulatedSettings machine;
  machine.speed_up = 0.0;
  return machine;
}

TEST(RevisedJob, SendsEveryLineOnceAsItWasRevised) {
  const auto program = spiralOf(450);
  for (const auto kind : {FaultKind::LostOk, FaultKind::LostLine, FaultKind::CorruptedLine}) {
    const auto revision = std::make_shared<HalvedLayers>();
    SimulatedLink link(revisedOrder(program, revision), swiftMachine(), {{kind, 0.02, {1, 2, 300}}});
    link.run();
    EXPECT_EQ(link.streamer.status().state, PackmlState::Complete) << link.streamer.status().failure.message;
    EXPECT_EQ(link.numberedCommands(), halvedCommands(program));
    EXPECT_EQ(link.streamer.status().lines_total, halvedCommands(program).size());
    EXPECT_EQ(link.streamer.status().lines_acknowledged, link.streamer.status().lines_total);
  }
}

TEST(RevisedJob, OfNothingIsTheProgram) {
  const auto program = spiralOf(90);
  const auto revision = std::make_shared<HalvedLayers>();
  SimulatedLink link(revisedOrder(program, revision), swiftMachine(), {});
  link.run();
  EXPECT_EQ(link.numberedCommands(), test::commandsOf(program));
}

TEST(RevisedJob, WaitsForALayerFromWhenTheMachineRests) {
  const auto program = spiralOf(250);
  const auto revision = std::make_shared<HalvedLayers>();
  EmulatedSettings machine;
  machine.speed_up = 1.0;
  double known_at = 0.0;
  SimulatedLink link(revisedOrder(program, revision), machine, {});
  double asked_at = 0.0;
  revision->known_from = [&](std::int32_t layer) {
    if (layer != 1) return true;
    if (asked_at == 0.0) asked_at = link.now;
    return known_at > 0.0 && link.now >= known_at;
  };
  link.start();
  link.runUntil(1.0);
  while (asked_at == 0.0) link.step();
  // Motions that the machine has taken are still being run.
  EXPECT_LT(link.motions.size(), 96U);
  while (revision->decided.count(1) == 0 && link.motions.size() < 96U) link.step();
  EXPECT_TRUE(revision->given_up.empty()) << "the time counts from the end of the motions";
  known_at = link.now + 1.5;
  link.run();
  EXPECT_TRUE(revision->given_up.empty());
  EXPECT_EQ(link.streamer.status().state, PackmlState::Complete) << link.streamer.status().failure.message;
  EXPECT_EQ(link.numberedCommands(), halvedCommands(program));
}

TEST(RevisedJob, GoesOnWithoutALayerThatIsLate) {
  const auto program = spiralOf(250);
  const auto revision = std::make_shared<HalvedLayers>();
  revision->known_from = [](std::int32_t layer) { return layer != 1; };
  SimulatedLink link(revisedOrder(program, revision), swiftMachine(), {});
  link.run();
  EXPECT_EQ(link.streamer.status().state, PackmlState::Complete) << link.streamer.status().failure.message;
  EXPECT_EQ(revision->given_up, std::vector<std::int32_t>{1});
  EXPECT_GT(link.now, 2.0);
  EXPECT_LT(link.now, 60.0);
}

TEST(RevisedJob, IsPausedAndAbortedWhileItWaits) {
  const auto program = spiralOf(250);
  for (const bool is_aborted : {false, true}) {
    const auto revision = std::make_shared<HalvedLayers>();
    bool is_held_back = true;
    revision->known_from = [&](std::int32_t layer) { return layer != 1 || !is_held_back; };
    SimulatedLink link(revisedOrder(program, revision), swiftMachine(), {});
    link.start();
    while (revision->asked.count(1) == 0) link.step();
    for (int i = 0; i < 50; ++i) link.step();
    if (is_aborted) {
      link.streamer.abort({ErrorCode::Cancelled, "asked for"}, link.now);
    } else {
      EXPECT_TRUE(link.streamer.pause(link.now));
      EXPECT_EQ(link.streamer.status().state, PackmlState::Held);
      is_held_back = false;
      EXPECT_TRUE(link.streamer.resume(link.now));
    }
    link.collect();
    link.runUntil(1e4);
    EXPECT_EQ(link.streamer.status().state, is_aborted ? PackmlState::Aborted : PackmlState::Complete)
        << link.streamer.status().failure.message;
  }
}

/// Its map may come only once the operator lets the job go on.
TEST(RevisedJob, WaitsAnewForALayerAfterAPause) {
  const auto program = spiralOf(250);
  const auto revision = std::make_shared<HalvedLayers>();
  double known_at = 1e9;
  SimulatedLink link(revisedOrder(program, revision), swiftMachine(), {});
  revision->known_from = [&](std::int32_t layer) { return layer != 1 || link.now >= known_at; };
  link.start();
  while (revision->asked.count(1) == 0) link.step();
  for (int i = 0; i < 50; ++i) link.step();
  EXPECT_TRUE(link.streamer.pause(link.now));
  link.runUntil(link.now + 10.0);
  EXPECT_TRUE(link.streamer.resume(link.now));
  link.collect();
  known_at = link.now + 1.5;
  link.run();
  EXPECT_TRUE(revision->given_up.empty()) << "within two seconds of the machine's rest";
  EXPECT_EQ(link.streamer.status().state, PackmlState::Complete) << link.streamer.status().failure.message;
  EXPECT_EQ(link.numberedCommands(), halvedCommands(program));
}

TEST(RevisedJob, EndsWhereALineCannotBeRevised) {
  const auto program = StreamableProgram::fromText("odd", "G28\n;LAYER:0\nG1 X1\nM117 REFUSED\nG1 X2\n");
  SimulatedLink link(revisedOrder(program, std::make_shared<HalvedLayers>()), swiftMachine(), {});
  link.run();
  EXPECT_EQ(link.streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(link.streamer.status().failure.code, ErrorCode::InvalidProgram);
  EXPECT_NE(link.streamer.status().failure.message.find("line 4"), std::string::npos)
      << link.streamer.status().failure.message;
}

/// In front of layer 1 another program takes the place of the rest, once, when the machine has waited.
class ReplacedRest final : public ProgramRevision {
 public:
  explicit ReplacedRest(StreamableProgram rest) : rest_(std::move(rest)) {}

  bool isKnown(std::int32_t layer) override { return has_gone_over || layer != 1; }
  void decide(std::int32_t layer) override { ADD_FAILURE() << "layer " << layer << " was given up"; }
  double waitTime() const override { return 5.0; }
  std::optional<StreamableProgram> successor(std::int32_t layer) override {
    EXPECT_EQ(layer, 1);
    if (++asked < 20) return std::nullopt;
    has_gone_over = true;
    return rest_;
  }
  std::string revised(std::string_view line, std::uint64_t number) override {
    if (has_gone_over) numbers.push_back(number);
    return std::string(line);
  }

  int asked = 0;
  bool has_gone_over = false;
  std::vector<std::uint64_t> numbers;  ///< of the lines of the rest

 private:
  StreamableProgram rest_;
};

TEST(RevisedJob, GoesOverToAProgramThatTakesThePlaceOfTheRest) {
  const std::string text = "G21\nG90\n;LAYER:0\nG1 X1 F600\n;LAYER:1\nG1 X2\n";
  const std::string rest = "M83\n;LAYER:0\nG1 X3\n;LAYER:1\nG1 X4\nG1 X5\n";
  const auto revision = std::make_shared<ReplacedRest>(StreamableProgram::fromText("rest", rest));
  SimulatedLink link(revisedOrder(StreamableProgram::fromText("planned", text), revision), swiftMachine(),
                     {});
  link.run();
  const StreamStatus& status = link.streamer.status();
  EXPECT_EQ(status.state, PackmlState::Complete) << status.failure.message;
  EXPECT_EQ(link.numberedCommands(),
            (std::vector<std::string>{"G21", "G90", "G1 X1 F600", "M83", "G1 X3", "G1 X4", "G1 X5"}));
  EXPECT_EQ(status.lines_total, 7U);
  EXPECT_EQ(status.lines_acknowledged, 7U);
  EXPECT_EQ(status.layer, 1) << "of the rest";
  EXPECT_EQ(revision->numbers, (std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6}));
}

TEST(RevisedJob, IsRefusedByFirmwareThatCannotWaitForALayer) {
  const auto program = StreamableProgram::fromText("cut", "G21\nG90\n;LAYER:0\nG1 X1 F100\n");
  StreamOrder order = revisedOrder(program, std::make_shared<HalvedLayers>());
  order.settings.firmware = "grbl";
  try {
    Streamer streamer(order);
    FAIL() << "expected to be refused";
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("speaks grbl"), std::string::npos) << error.what();
  }
  SessionOptions options;
  options.revision = order.revision;
  EXPECT_THROW(StreamSession(program, {}, {"http://127.0.0.1:1", 0}, {}, options), InvalidConfig);
}

}  // namespace
}  // namespace lamina
