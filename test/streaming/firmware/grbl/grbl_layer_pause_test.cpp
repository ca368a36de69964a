// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A pause in front of a layer, on an emulated grbl whose motions take their time.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "streaming/emulator/grbl_link.hpp"
#include "streaming/emulator/simulated_link.hpp"

namespace lamina {
namespace {

using test::GrblLink;

/// Layers of a hundred lines behind three lines of modes.
StreamableProgram layeredProgram() {
  return StreamableProgram::fromText("mill", test::millProgram(1000), test::reliableGrbl());
}

/// Until the machine holds in front of a layer, or the job is over.
void runToLayer(GrblLink& link, int layer) {
  link.start();
  while (link.streamer.status().state != PackmlState::Execute) link.step();
  ASSERT_EQ(link.streamer.change({LiveSetting::PauseAtLayer, static_cast<double>(layer)}, link.now), "");
  while (link.streamer.status().state != PackmlState::Held && !isFinal(link.streamer.status().state))
    link.step();
}

RC_GTEST_PROP(GrblLayerPauseProperty, StandsBetweenTwoLayersAndGoesOn, ()) {
  const int layer = *rc::gen::inRange(1, 10);
  EmulatedGrblSettings machine;
  machine.seed = *rc::gen::inRange<std::uint64_t>(1, 1000000);
  machine.obeys_holds = *rc::gen::arbitrary<bool>();
  GrblLink link(layeredProgram(), test::reliableGrbl(), machine, {});
  runToLayer(link, layer);
  const std::vector<std::string> meant = test::commandsOf(layeredProgram());
  const auto before = meant.begin() + 3 + 100 * static_cast<std::ptrdiff_t>(layer);
  RC_ASSERT(link.executed == std::vector<std::string>(meant.begin(), before));
  RC_ASSERT(!link.firmware.isInMotion());
  link.runUntil(link.now + 100.0);
  RC_ASSERT(link.streamer.status().state == PackmlState::Held);
  RC_ASSERT(link.executed.size() == static_cast<std::size_t>(before - meant.begin()));
  RC_ASSERT(link.streamer.resume(link.now));
  link.collect();
  link.runUntil(1e6);
  RC_ASSERT(link.isComplete());
  RC_ASSERT(link.executed == meant);
}

TEST(GrblLayerPause, EndsTheJobWhereAnAnswerIsLostOnTheWayToIt) {
  GrblLink link(layeredProgram(), test::reliableGrbl(), {}, {{GrblFaultKind::LostOk, 0.0, {60}}});
  runToLayer(link, 1);
  link.runUntil(1e6);
  EXPECT_EQ(link.streamer.status().state, PackmlState::Aborted);
  EXPECT_NE(link.message().find("in doubt"), std::string::npos) << link.message();
  EXPECT_LE(link.executed.size(), 103U);
}

}  // namespace
}  // namespace lamina
