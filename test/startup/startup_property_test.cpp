// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever happens in whatever order, a machine is ready only if what each step needs was there.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "startup/started_machine.hpp"

namespace lamina {
namespace {

using test::StartedMachine;

/// A start-up to which anything happens, and what it must never do.
class AnyOrder {
 public:
  AnyOrder() : sequence_(makeStartupSequence(test::largeGantry())) {}

  void happen(int what) {
    const StartupStep step = allStartupSteps()[static_cast<std::size_t>(what) % kStartupStepCount];
    const std::set<StartupStep> satisfied_before = satisfied();
    const int kind = what / static_cast<int>(kStartupStepCount);
    try {
      kind < 12 ? perform(kind, step) : disturb(kind);
    } catch (const Error&) {
    }
    for (const StartupStep each : satisfied())
      if (satisfied_before.count(each) == 0) requireNeeds(each, satisfied_before);
    requireNothingRestsOnWhatIsLost();
  }
  bool isReady() const { return machine_.startup.isReady(); }
  bool hasAllSteps() const { return satisfied().size() == kStartupStepCount; }

 private:
  void perform(int kind, StartupStep step) {
    if (kind < 8) return machine_.perform(step);
    if (kind == 8) return machine_.startup.begin(step, machine_.now_s);
    if (kind == 9) return machine_.startup.confirm(step, machine_.now_s);
    if (kind == 10) return machine_.startup.onCodeFinished(step, machine_.now_s);
    machine_.startup.fail(step, "it failed");
  }
  void disturb(int kind) {
    constexpr std::array<const char*, 6> kCommands = {"M84", "M84 X", "M140 S0", "M42 P2 S0", "M112", "M410"};
    constexpr std::array<const char*, 6> kReplies = {"start",         "homed: X",        "zone 4: 90 kPa",
                                                     "zone 4: 9 kPa", "T:20 /0 B:30 /0", "ok"};
    const auto which = static_cast<std::size_t>(kind - 12);
    if (which < 6) return machine_.startup.onCommandSent(kCommands[which]);
    if (which < 12) return machine_.say(kReplies[which - 6]);
    machine_.letPass(which == 12 ? 60.0 : 3600.0);
  }
  std::set<StartupStep> satisfied() const {
    std::set<StartupStep> steps;
    for (const StartupStatus& status : machine_.startup.steps())
      if (isSatisfied(status)) steps.insert(status.step);
    return steps;
  }
  /// A step is satisfied only if what it needs was, the moment before or in the same act.
  void requireNeeds(StartupStep step, const std::set<StartupStep>& before) const {
    for (const SequencedStep& each : sequence_)
      if (each.step == step)
        for (const Prerequisite& needed : each.after) RC_ASSERT(before.count(needed.step) == 1U);
  }
  void requireNothingRestsOnWhatIsLost() const {
    const std::set<StartupStep> now = satisfied();
    for (const SequencedStep& each : sequence_)
      for (const Prerequisite& needed : each.after)
        if (needed.on_loss == OnLoss::Spreads && now.count(each.step) == 1U)
          RC_ASSERT(now.count(needed.step) == 1U);
  }

  std::vector<SequencedStep> sequence_;
  StartedMachine machine_;
};

constexpr int kEvents = 26 * static_cast<int>(kStartupStepCount);

TEST(StartupProperty, NeverReadyUnlessEveryStepHadWhatItNeeds) {
  EXPECT_TRUE(rc::check([] {
    AnyOrder order;
    const auto events = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, kEvents));
    for (const int event : events) {
      order.happen(event);
      RC_ASSERT(order.isReady() == order.hasAllSteps());
    }
  }));
}

TEST(StartupProperty, ReadyIsReachedFromAnyConditionByDoingWhatIsOpen) {
  EXPECT_TRUE(rc::check([] {
    StartedMachine machine;
    const auto commands = *rc::gen::container<std::vector<std::string>>(
        rc::gen::element<std::string>("M84", "M84 Z", "M140 S0", "M42 P1 S0", "M112"));
    for (const std::string& command : commands) {
      machine.performAll();
      RC_ASSERT(machine.refusal().empty());
      machine.startup.onCommandSent(command);

      RC_ASSERT(!machine.startup.isReady());
    }
  }));
}

}  // namespace
}  // namespace lamina
