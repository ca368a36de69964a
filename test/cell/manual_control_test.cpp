// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/manual_control.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace lamina {
namespace {

constexpr CellTime kNoon{100.0, 1.7e9};

CellTime after(double seconds) { return {kNoon.steady_s + seconds, kNoon.utc_s + seconds}; }

ManualConditions readyByHand() {
  ManualConditions found;
  found.mode = kManual;
  found.has_driver = true;
  found.joints = {"joint_1", "rail"};
  return found;
}

/// Downwards along the tool by 1 mm at 5 mm/s: 0.2 s.
const ManualStep kDown{"nozzle", "z", -0.001, 0.005};

/// A control whose lease anna has taken at noon.
struct HeldByAnna {
  ManualControl control;
  ManualCaller anna{"page: anna", 0};
  ManualConditions found = readyByHand();

  HeldByAnna() {
    EXPECT_EQ(control.take(anna, found, kNoon).result, CommandResult::Accepted);
    anna.lease = control.lease();
  }
  CommandAnswer jogs(const ManualStep& step, double at_s) {
    return control.jog(anna, step, found, after(at_s));
  }
};

bool says(const CommandAnswer& answer, CommandResult result, const std::string& words) {
  return answer.result == result && answer.reason.find(words) != std::string::npos;
}

TEST(ManualControl, BelongsToOneHolderUntilItsLeaseRunsOut) {
  HeldByAnna held;
  EXPECT_NE(held.anna.lease, 0U);
  const ManualCaller ben{"page: ben", 0};
  EXPECT_TRUE(says(held.control.take(ben, held.found, after(4.0)), CommandResult::Busy, "'page: anna'"));
  const ManualCaller other_window{"page: anna", 0};
  EXPECT_TRUE(says(held.control.take(other_window, held.found, after(4.0)), CommandResult::Busy, "6 s"));
  EXPECT_EQ(held.control.follow(held.found, after(9.9)), "");
  EXPECT_EQ(held.control.follow(held.found, after(10.0)), "the lease was not used for 10 s");
  EXPECT_EQ(held.control.holder(), "");
  EXPECT_EQ(held.control.follow(held.found, after(10.1)), "") << "told once";
  EXPECT_EQ(held.control.take(ben, held.found, after(10.1)).result, CommandResult::Accepted);
  EXPECT_TRUE(says(held.jogs(kDown, 10.2), CommandResult::GuardFailed, "'page: ben' has it"));
  EXPECT_TRUE(says(held.control.release(held.anna, after(10.2)), CommandResult::GuardFailed, "lease"));
  EXPECT_EQ(held.control.holder(), "page: ben");
}

TEST(ManualControl, IsRenewedByUse) {
  HeldByAnna held;
  EXPECT_EQ(held.jogs(kDown, 9.0).result, CommandResult::Accepted);
  EXPECT_DOUBLE_EQ(held.control.left(109.0), 10.0);
  EXPECT_EQ(held.control.follow(held.found, after(18.9)), "");
  EXPECT_EQ(held.control.take(held.anna, held.found, after(18.9)).result, CommandResult::Accepted);
  EXPECT_EQ(held.control.lease(), held.anna.lease) << "renewed, not another";
  EXPECT_EQ(held.control.follow(held.found, after(28.8)), "");
  EXPECT_EQ(held.control.release(held.anna, after(28.8)).result, CommandResult::Accepted);
  EXPECT_EQ(held.control.lease(), 0U);
}

TEST(ManualControl, NoLeaseHoldsOverARestart) {
  HeldByAnna before;
  ManualControl restarted;
  EXPECT_EQ(restarted.take({"page: anna", 0}, before.found, after(1.0)).result, CommandResult::Accepted);
  EXPECT_EQ(restarted.jog(before.anna, kDown, before.found, after(1.1)).result, CommandResult::GuardFailed);
}

TEST(ManualControl, AStepEndsByItself) {
  HeldByAnna held;
  ASSERT_EQ(held.jogs(kDown, 1.0).result, CommandResult::Accepted);
  held.control.follow(held.found, after(1.19));
  ASSERT_TRUE(held.control.motion());
  EXPECT_EQ(held.control.motion()->axis, "z");
  held.control.follow(held.found, after(1.21));
  EXPECT_FALSE(held.control.motion());
  EXPECT_EQ(held.control.holder(), "page: anna");
}

TEST(ManualControl, RefusesWhatIsNoShortStepOfAKnownAxis) {
  HeldByAnna held;
  EXPECT_TRUE(
      says(held.jogs({"joints", "joint_7", 0.1, 1.0}, 1.0), CommandResult::BadValue, "joint_1, rail"));
  EXPECT_TRUE(says(held.jogs({"sky", "x", 0.001, 0.01}, 1.0), CommandResult::BadValue, "'sky'"));
  EXPECT_TRUE(says(held.jogs({"bed", "w", 0.001, 0.01}, 1.0), CommandResult::BadValue, "'w'"));
  EXPECT_TRUE(says(held.jogs({"bed", "x", 0.01, 0.01}, 1.0), CommandResult::BadValue, "takes 1 s"));
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [step, speed] :
       {std::pair{0.0, 0.1}, {none, 0.1}, {0.01, 0.0}, {0.01, -1.0}, {0.01, none}})
    EXPECT_EQ(held.jogs({"bed", "x", step, speed}, 1.0).result, CommandResult::BadValue);
  EXPECT_FALSE(held.control.motion());
  EXPECT_EQ(held.jogs({"bed", "x", 0.003, 0.01}, 1.0).result, CommandResult::Accepted) << "0.3 s";
  EXPECT_EQ(held.jogs({"joints", "rail", -0.01, 0.1}, 1.0).result, CommandResult::Accepted);
}

TEST(ManualControl, NeedsModeStateZoneDriverAndNoEmergencyStop) {
  const auto answerWhere = [](const auto& change) {
    ManualConditions found = readyByHand();
    change(found);
    return ManualControl().take({"page: anna", 0}, found, kNoon);
  };
  using Found = ManualConditions;
  EXPECT_EQ(answerWhere([](Found& found) { found.state = UnitState::Idle; }).result, CommandResult::Accepted);
  EXPECT_TRUE(says(answerWhere([](Found& found) { found.mode = kProduction; }), CommandResult::NotInThisMode,
                   "expected 3 (Manual)"));
  EXPECT_TRUE(says(answerWhere([](Found& found) { found.state = UnitState::Aborted; }),
                   CommandResult::NotInThisState, "Aborted"));
  EXPECT_TRUE(says(answerWhere([](Found& found) { found.zone_fault = "a robot is in the zone"; }),
                   CommandResult::GuardFailed, "in the zone"));
  EXPECT_TRUE(says(answerWhere([](Found& found) { found.is_emergency_stopped = true; }),
                   CommandResult::GuardFailed, "alarm 1207"));
  EXPECT_TRUE(says(answerWhere([](Found& found) { found.has_driver = false; }), CommandResult::GuardFailed,
                   "trajectory_driver"));
}

TEST(ManualControl, EndsLeaseAndStepWhereTheyAreNotAllowedAnyLonger) {
  for (int what = 0; what < 5; ++what) {
    HeldByAnna held;
    ASSERT_EQ(held.jogs(kDown, 1.0).result, CommandResult::Accepted);
    if (what == 0) held.found.mode = kProduction;
    if (what == 1) held.found.state = UnitState::Aborting;
    if (what == 2) held.found.zone_fault = "a robot is in the zone";
    if (what == 3) held.found.has_driver = false;
    if (what == 4) held.found.is_emergency_stopped = true;
    EXPECT_NE(held.control.follow(held.found, after(1.02)), "") << what;
    EXPECT_FALSE(held.control.motion()) << what;
    EXPECT_EQ(held.control.holder(), "") << what;
  }
}

TEST(ManualControl, AReleaseEndsTheStepUnderWay) {
  HeldByAnna held;
  ASSERT_EQ(held.jogs(kDown, 1.0).result, CommandResult::Accepted);
  EXPECT_EQ(held.control.release(held.anna, after(1.05)).result, CommandResult::Accepted);
  EXPECT_FALSE(held.control.motion());
}

}  // namespace
}  // namespace lamina
