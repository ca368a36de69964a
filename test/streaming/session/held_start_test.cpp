// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A job that is asked to hold while it starts, at any instant and by any protocol, sends no line before it
// goes on.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "streaming/emulator/grbl_link.hpp"
#include "streaming/emulator/ok_paced/emulated_klipper.hpp"
#include "streaming/emulator/ok_paced/emulated_reprap.hpp"
#include "streaming/emulator/simulated_link.hpp"
#include "streaming/firmware/ok_paced/paced_link.hpp"
#include "streaming/job/layer_pause.hpp"

namespace lamina {
namespace {

/// Holds after some steps, unless the job has begun by then. @return whether it was asked in time
template <class Link>
bool holdAfter(Link& link, Streamer& streamer, int steps) {
  for (int i = 0; i < steps; ++i) link.step();
  if (streamer.status().state != PackmlState::Starting) return false;
  return streamer.pause(link.now);
}

EmulatedSettings quickMachine() {
  EmulatedSettings settings;
  settings.speed_up = 0.0;
  return settings;
}

RC_GTEST_PROP(HeldStart, OfMarlinSendsNoLine, ()) {
  const auto spiral = StreamableProgram::fromText("spiral", test::spiralProgram(50));
  test::SimulatedLink link(spiral, {}, quickMachine(), {});
  link.start();
  RC_PRE(holdAfter(link, link.streamer, *rc::gen::inRange(0, 40)));
  link.runUntil(link.now + 30.0);
  RC_ASSERT(link.streamer.status().state == PackmlState::Held);
  RC_ASSERT(link.numberedCommands().empty());
  RC_ASSERT(link.streamer.resume(link.now));
  link.collect();
  link.runUntil(1e6);
  RC_ASSERT(link.streamer.status().state == PackmlState::Complete);
  RC_ASSERT(link.numberedCommands() == test::commandsOf(spiral));
}

RC_GTEST_PROP(HeldStart, ThatIsLetGoOnBeforeItBeginsDoesNotHold, ()) {
  const auto spiral = StreamableProgram::fromText("spiral", test::spiralProgram(50));
  test::SimulatedLink link(spiral, {}, quickMachine(), {});
  link.start();
  RC_PRE(holdAfter(link, link.streamer, *rc::gen::inRange(0, 40)));
  RC_ASSERT(link.streamer.resume(link.now));
  link.runUntil(1e6);
  RC_ASSERT(link.streamer.status().state == PackmlState::Complete);
  RC_ASSERT(std::count(link.states.begin(), link.states.end(), PackmlState::Held) == 0);
}

RC_GTEST_PROP(HeldStart, OfGrblSendsNoLine, ()) {
  const auto mill = StreamableProgram::fromText("mill", test::millProgram(50));
  test::GrblLink link(mill, test::reliableGrbl(), {}, {});
  link.start();
  RC_PRE(holdAfter(link, link.streamer, *rc::gen::inRange(0, 40)));
  link.runUntil(link.now + 30.0);
  RC_ASSERT(link.streamer.status().state == PackmlState::Held);
  RC_ASSERT(link.streamer.status().lines_sent == 0U);
  RC_ASSERT(link.streamer.resume(link.now));
  link.collect();
  link.runUntil(1e6);
  RC_ASSERT(link.isComplete());
  RC_ASSERT(link.streamer.status().lines_acknowledged == 50U);
}

class PacedStart : public testing::TestWithParam<bool> {
 protected:
  std::unique_ptr<EmulatedPacedFirmware> firmware() {
    const auto observer = [this](const std::string& command) { ran.push_back(command); };
    if (GetParam()) return std::make_unique<EmulatedKlipper>(PacedFaults{}, observer);
    return std::make_unique<EmulatedRepRap>(PacedFaults{}, EmulatedRepRap::Checks::IfThere, observer);
  }

  std::vector<std::string> ran;
};

TEST_P(PacedStart, SendsNoLineWhileItIsHeld) {
  const std::string text = "G90\nG28\nG1 X1 F600\nG1 X2\nG1 X3\n";
  int asked_in_time = 0;
  for (int steps = 0; steps < 25; ++steps) {
    ran.clear();
    StreamSettings settings;
    settings.firmware = GetParam() ? "klipper" : "reprapfirmware";
    settings.link = LinkKind::Reliable;
    Streamer streamer(StreamableProgram::fromText("job", text, settings), settings);
    const auto machine = firmware();
    test::PacedLink link(streamer, *machine);
    streamer.start(0.0);
    if (!holdAfter(link, streamer, steps)) continue;
    ++asked_in_time;
    link.run([&] { return streamer.status().state == PackmlState::Held; });
    EXPECT_TRUE(ran.empty()) << ran.front();
    EXPECT_TRUE(streamer.resume(link.now));
    link.run();
    EXPECT_EQ(streamer.status().state, PackmlState::Complete) << streamer.status().failure.message;
    EXPECT_EQ(ran, (std::vector<std::string>{"G90", "G28", "G1 X1 F600", "G1 X2", "G1 X3"}));
  }
  EXPECT_GE(asked_in_time, 3);
}

TEST(LayerPause, BeforeTheNextLineIsTakenBackAlone) {
  JobRecord record;
  record.enter(PackmlState::Starting);
  LayerPause pause;
  EXPECT_TRUE(pause.take({LiveSetting::PauseAtLayer, 3}));
  EXPECT_EQ(pause.pauseNow(record), LayerPause::Wish::Kept);
  EXPECT_TRUE(pause.takeBack(record));
  EXPECT_FALSE(pause.takeIfDueAt(-1));
  EXPECT_TRUE(pause.takeIfDueAt(3));
  EXPECT_FALSE(pause.takeIfDueAt(4)) << "once";
  EXPECT_EQ(pause.pauseNow(record), LayerPause::Wish::Kept);
  EXPECT_TRUE(pause.takeIfDueAt(-1));
  EXPECT_FALSE(pause.takeIfDueAt(-1)) << "once";
  EXPECT_EQ(record.status.state, PackmlState::Starting);
}

TEST(LayerPause, OfAJobUnderWayBeginsAtOnce) {
  JobRecord record;
  LayerPause pause;
  EXPECT_EQ(pause.pauseNow(record), LayerPause::Wish::Refused);
  record.enter(PackmlState::Execute);
  EXPECT_EQ(pause.pauseNow(record), LayerPause::Wish::Begun);
  EXPECT_EQ(record.status.state, PackmlState::Holding);
  EXPECT_EQ(pause.pauseNow(record), LayerPause::Wish::Refused);
  EXPECT_FALSE(pause.takeBack(record));
  EXPECT_FALSE(pause.takeIfDueAt(0)) << "it does not wait for a line";
}

INSTANTIATE_TEST_SUITE_P(Firmware, PacedStart, testing::Bool());

}  // namespace
}  // namespace lamina
