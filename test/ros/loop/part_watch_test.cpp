// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop/part_watch.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

using State = lamina_msgs::MachineState;

State machine(std::uint8_t state, std::int32_t layer) {
  State message;
  message.state = state;
  message.layer = layer;
  return message;
}

/// A job that was cut off while the machine stated that layer.
PartWatch cutOff(std::int32_t layer) {
  PartWatch watch;
  watch.see(machine(State::EXECUTE, layer), 0);
  watch.see(machine(State::STOPPED, layer), 0);
  return watch;
}

TEST(PartWatch, TakesWhatBeginsAfterACompleteJobForAnotherPart) {
  PartWatch watch;
  EXPECT_FALSE(watch.see(machine(State::EXECUTE, 0), 0));
  EXPECT_FALSE(watch.see(machine(State::COMPLETE, 2), 3));
  EXPECT_FALSE(watch.see(machine(State::COMPLETE, 2), 3)) << "executors repeat it";
  EXPECT_FALSE(watch.see(machine(State::IDLE, -1), 3));
  EXPECT_TRUE(watch.see(machine(State::STARTING, -1), 3));
  EXPECT_FALSE(watch.see(machine(State::EXECUTE, 0), 3)) << "once";
}

TEST(PartWatch, KnowsNoEndOfThePartBefore) {
  PartWatch watch;
  EXPECT_FALSE(watch.see(machine(State::COMPLETE, 2), 0)) << "latched";
  EXPECT_FALSE(watch.see(machine(State::STARTING, -1), 0));
  watch.see(machine(State::COMPLETE, 2), 3);
  watch.begin();
  EXPECT_FALSE(watch.see(machine(State::STARTING, -1), 0)) << "the toolpath was announced again";
}

TEST(PartWatch, TellsByItsLayerWhetherAJobGoesOn) {
  EXPECT_FALSE(cutOff(3).see(machine(State::STARTING, -1), 3)) << "nobody knows yet";
  EXPECT_FALSE(cutOff(3).see(machine(State::EXECUTE, 3), 3));
  EXPECT_FALSE(cutOff(2).see(machine(State::EXECUTE, 2), 3)) << "the nozzle is ahead of what is stated";
  EXPECT_FALSE(cutOff(3).see(machine(State::EXECUTE, 2), 2)) << "what is stated is ahead of the nozzle";
  EXPECT_TRUE(cutOff(3).see(machine(State::EXECUTE, 0), 3));
  EXPECT_TRUE(cutOff(1).see(machine(State::EXECUTE, 0), 1)) << "cut off in its second layer";
  EXPECT_FALSE(cutOff(0).see(machine(State::EXECUTE, 0), 1));
}

TEST(PartWatch, LooksAtTheFirstLayerOfAJobThatGoesOn) {
  PartWatch watch = cutOff(3);
  EXPECT_FALSE(watch.see(machine(State::STARTING, -1), 3));
  EXPECT_FALSE(watch.see(machine(State::EXECUTE, 3), 3));
  EXPECT_FALSE(watch.see(machine(State::EXECUTE, 0), 3)) << "it has gone on";
}

}  // namespace
}  // namespace lamina
