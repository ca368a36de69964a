// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines that are revised on their way to Klipper and RepRapFirmware.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <utility>

#include "lamina/base/error.hpp"
#include "streaming/emulator/ok_paced/emulated_klipper.hpp"
#include "streaming/emulator/ok_paced/emulated_reprap.hpp"
#include "streaming/firmware/ok_paced/paced_link.hpp"

namespace lamina {
namespace {

constexpr int kLayers = 6;
constexpr int kLinesPerLayer = 40;

/// Each motion of an odd layer becomes two.
class SplitLayers final : public ProgramRevision {
 public:
  bool isKnown(std::int32_t layer) override {
    if (known_from(layer)) decided.insert(layer);
    return decided.count(layer) > 0;
  }
  void decide(std::int32_t layer) override {
    given_up.push_back(layer);
    decided.insert(layer);
  }
  std::optional<StreamableProgram> successor(std::int32_t) override { return std::exchange(rest, {}); }
  double waitTime() const override { return 2.0; }
  std::string revised(std::string_view line, std::uint64_t) override {
    const std::string text(line);
    if (text.compare(0, 7, ";LAYER:") == 0) layer_ = std::stoi(text.substr(7));
    if (text.find("REFUSED") != std::string::npos) throw InvalidProgram("it cannot be corrected");
    return layer_ % 2 == 1 && text.compare(0, 2, "G1") == 0 ? text + "\n" + text + "5" : text;
  }

  std::function<bool(std::int32_t)> known_from = [](std::int32_t) { return true; };
  std::set<std::int32_t> decided;
  std::vector<std::int32_t> given_up;
  std::optional<StreamableProgram> rest;  ///< takes the place of what is left at the first layer not known

 private:
  std::int32_t layer_ = -1;
};

/// No line is like another, split or not.
std::string layeredText() {
  std::string text = "G90\nM83\nG28\n";
  for (int layer = 0; layer < kLayers; ++layer) {
    text += ";LAYER:" + std::to_string(layer) + "\n";
    for (int i = 0; i < kLinesPerLayer; ++i)
      text += "G1 X" + std::to_string(layer) + "." + std::to_string(100 + i) + " Y" +
              std::to_string((i * 7) % 50) + " E0." + std::to_string(10 + i) + " F6000.\n";
  }
  return text;
}

std::vector<std::string> splitCommands() {
  std::vector<std::string> commands;
  ProgramCursor cursor(std::make_unique<std::istringstream>(layeredText()));
  while (const auto line = cursor.next()) {
    commands.push_back(line->command);
    if (line->layer % 2 == 1) commands.push_back(line->command + "5");
  }
  return commands;
}

struct PacedCase {
  const char* firmware;
  LinkKind link;
};

class OkPacedRevision : public testing::TestWithParam<PacedCase> {
 protected:
  std::unique_ptr<EmulatedPacedFirmware> firmware(const PacedFaults& faults) {
    const auto observe = [this](const std::string& command) { ran.push_back(command); };
    if (std::string(GetParam().firmware) == "klipper")
      return std::make_unique<EmulatedKlipper>(faults, observe);
    const auto checks = GetParam().link == LinkKind::Lossy ? EmulatedRepRap::Checks::RequiresCrc
                                                           : EmulatedRepRap::Checks::IfThere;
    return std::make_unique<EmulatedRepRap>(faults, checks, observe);
  }

  Streamer streamerOf(const std::string& text) {
    StreamSettings settings;
    settings.firmware = GetParam().firmware;
    settings.link = GetParam().link;
    return Streamer(StreamOrder{
        StreamableProgram::fromText("layers", text, settings), settings, {}, {}, 0, {}, 0, revision});
  }

  std::shared_ptr<SplitLayers> revision = std::make_shared<SplitLayers>();
  std::vector<std::string> ran;
};

TEST_P(OkPacedRevision, SendsEveryLineOnceAsItWasRevised) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    ran.clear();
    revision = std::make_shared<SplitLayers>();
    PacedFaults faults;
    faults.lost_ok = 0.01;
    faults.slow = 0.01;
    faults.seed = seed;
    const auto machine = firmware(faults);
    auto streamer = streamerOf(layeredText());
    test::PacedLink link(streamer, *machine, 0.0, seed);
    link.run();
    EXPECT_EQ(streamer.status().state, PackmlState::Complete) << streamer.status().failure.message;
    EXPECT_EQ(ran, splitCommands());
    EXPECT_EQ(streamer.status().lines_total, splitCommands().size()) << "no layer had to be waited for";
    EXPECT_EQ(streamer.status().lines_acknowledged, streamer.status().lines_total);
  }
}

TEST_P(OkPacedRevision, GoesOverToAProgramThatTakesThePlaceOfTheRest) {
  const auto machine = firmware({});
  auto streamer = streamerOf("G90\n;LAYER:0\nG1 X1\n;LAYER:4\nG1 X2\n");
  revision->known_from = [](std::int32_t layer) { return layer != 4; };
  revision->rest = StreamableProgram::fromText("rest", "M83\n;LAYER:0\nG1 X3\nG1 X4\n");
  test::PacedLink link(streamer, *machine);
  link.run();
  EXPECT_EQ(streamer.status().state, PackmlState::Complete) << streamer.status().failure.message;
  EXPECT_EQ(ran, (std::vector<std::string>{"G90", "G1 X1", "M83", "G1 X3", "G1 X4"}));
  EXPECT_EQ(streamer.status().lines_total, 5U);
  EXPECT_EQ(streamer.status().lines_acknowledged, 5U);
}

TEST_P(OkPacedRevision, RestsInFrontOfALayerUntilItIsKnown) {
  const auto machine = firmware({});
  auto streamer = streamerOf(layeredText());
  test::PacedLink link(streamer, *machine);
  const std::ptrdiff_t behind =
      3 + std::ptrdiff_t{4} * kLinesPerLayer;  // layers 0 to 2, of which one is split
  double rested_at = 0.0;
  const auto rests = [&] {
    const bool is_at_rest = streamer.status().lines_acknowledged == static_cast<std::uint64_t>(behind) + 1;
    if (is_at_rest && rested_at == 0.0) rested_at = link.now;
    return is_at_rest;
  };
  revision->known_from = [&](std::int32_t layer) {
    return layer != 3 || (rested_at > 0.0 && link.now > rested_at + 1.5);
  };
  link.run(rests);
  const std::vector<std::string> all = splitCommands();
  EXPECT_EQ(ran, std::vector<std::string>(all.begin(), all.begin() + behind))
      << "all below the layer is laid, none of it";
  link.run();
  EXPECT_TRUE(revision->given_up.empty());
  EXPECT_EQ(streamer.status().state, PackmlState::Complete) << streamer.status().failure.message;
  EXPECT_EQ(ran, splitCommands());
  EXPECT_EQ(streamer.status().lines_acknowledged, splitCommands().size() + 1) << "the rest is a line";
}

TEST_P(OkPacedRevision, GoesOnWithoutALayerThatIsLate) {
  revision->known_from = [](std::int32_t layer) { return layer != 1; };
  const auto machine = firmware({});
  auto streamer = streamerOf(layeredText());
  test::PacedLink link(streamer, *machine);
  link.run();
  EXPECT_EQ(streamer.status().state, PackmlState::Complete) << streamer.status().failure.message;
  EXPECT_EQ(revision->given_up, std::vector<std::int32_t>{1});
  EXPECT_EQ(ran, splitCommands());
  EXPECT_GT(link.now, 2.0);
}

TEST_P(OkPacedRevision, IsPausedAndStoppedWhileItWaits) {
  for (const bool is_stopped : {false, true}) {
    ran.clear();
    revision = std::make_shared<SplitLayers>();
    bool is_held_back = true;
    revision->known_from = [&](std::int32_t layer) { return layer != 1 || !is_held_back; };
    const auto machine = firmware({});
    auto streamer = streamerOf(layeredText());
    test::PacedLink link(streamer, *machine);
    link.run([&] { return streamer.status().lines_acknowledged == 3U + kLinesPerLayer + 1U; });
    for (int i = 0; i < 20; ++i) link.step();
    if (is_stopped) {
      streamer.abort({ErrorCode::Cancelled, "asked for"}, link.now);
    } else {
      EXPECT_TRUE(streamer.pause(link.now));
      EXPECT_EQ(streamer.status().state, PackmlState::Held);
      is_held_back = false;
      EXPECT_TRUE(streamer.resume(link.now));
    }
    link.run();
    EXPECT_EQ(streamer.status().state, is_stopped ? PackmlState::Aborted : PackmlState::Complete)
        << streamer.status().failure.message;
    if (!is_stopped) {
      EXPECT_EQ(ran, splitCommands());
    }
  }
}

TEST_P(OkPacedRevision, WaitsAnewForALayerAfterAPause) {
  double known_at = 1e9;
  const auto machine = firmware({});
  auto streamer = streamerOf(layeredText());
  test::PacedLink link(streamer, *machine);
  revision->known_from = [&](std::int32_t layer) { return layer != 1 || link.now >= known_at; };
  link.run([&] { return streamer.status().lines_acknowledged == 3U + kLinesPerLayer + 1U; });
  for (int i = 0; i < 20; ++i) link.step();
  EXPECT_TRUE(streamer.pause(link.now));
  link.now += 10.0;
  EXPECT_TRUE(streamer.resume(link.now));
  known_at = link.now + 1.5;
  link.run();
  EXPECT_TRUE(revision->given_up.empty()) << "within two seconds of the machine's rest";
  EXPECT_EQ(streamer.status().state, PackmlState::Complete) << streamer.status().failure.message;
  EXPECT_EQ(ran, splitCommands());
}

TEST_P(OkPacedRevision, EndsWhereALineCannotBeRevised) {
  const auto machine = firmware({});
  auto streamer = streamerOf("G28\n;LAYER:0\nG1 X1\nM117 REFUSED\nG1 X2\n");
  test::PacedLink link(streamer, *machine);
  link.run();
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  EXPECT_EQ(streamer.status().failure.code, ErrorCode::InvalidProgram);
  EXPECT_NE(streamer.status().failure.message.find("it cannot be corrected"), std::string::npos);
  EXPECT_EQ(std::count(ran.begin(), ran.end(), "G1 X2"), 0);
}

INSTANTIATE_TEST_SUITE_P(Firmware, OkPacedRevision,
                         testing::Values(PacedCase{"klipper", LinkKind::Reliable},
                                         PacedCase{"reprapfirmware", LinkKind::Reliable},
                                         PacedCase{"reprapfirmware", LinkKind::Lossy}));

}  // namespace
}  // namespace lamina
