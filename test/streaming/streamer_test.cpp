// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/streamer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "simulated_link.hpp"

namespace lamina {
namespace {

using test::SimulatedLink;

StreamableProgram program(const std::string& text) { return StreamableProgram::fromText("test", text, 96); }

EmulatedSettings instantMachine() {
  EmulatedSettings settings;
  settings.speed_up = 0.0;
  return settings;
}

TEST(Streamer, RunsEveryLineOnceInOrder) {
  const auto spiral = program(test::spiralProgram(500));
  SimulatedLink link(spiral, {}, instantMachine(), {});
  link.run();
  EXPECT_EQ(link.streamer.status().state, PackmlState::Complete) << link.streamer.status().failure.message;
  EXPECT_EQ(link.numberedCommands(), test::commandsOf(spiral));
  EXPECT_EQ(link.streamer.status().lines_acknowledged, 500U);
  EXPECT_EQ(link.streamer.status().layer, 4);
  EXPECT_EQ(link.streamer.status().resends, 0U);
  EXPECT_EQ(link.firmware.counts().bytes_lost, 0U);
}

class StreamerUnderFault : public testing::TestWithParam<FaultKind> {};

TEST_P(StreamerUnderFault, RunsEveryLineOnceInOrder) {
  const auto spiral = program(test::spiralProgram(2000));
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EmulatedSettings machine = instantMachine();
    machine.fault_seed = static_cast<int>(seed);
    SimulatedLink link(spiral, {}, machine, {{GetParam(), 0.02, {1, 2, 3, 500, 1999, 2000}}}, seed);
    link.run();
    EXPECT_EQ(link.streamer.status().state, PackmlState::Complete) << link.streamer.status().failure.message;
    EXPECT_EQ(link.numberedCommands(), test::commandsOf(spiral));
    EXPECT_EQ(link.streamer.status().lines_acknowledged, 2000U);
    EXPECT_GT(link.firmware.counts().faults, 20U);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, StreamerUnderFault,
                         testing::Values(FaultKind::LostOk, FaultKind::DelayedOk, FaultKind::LostLine,
                                         FaultKind::CorruptedLine, FaultKind::SpuriousResend,
                                         FaultKind::Silence),
                         [](const auto& tested) { return std::string(toString(tested.param)); });

}  // namespace
}  // namespace lamina
