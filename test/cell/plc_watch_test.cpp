// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/plc_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace lamina {
namespace {

PlcReport goodReport() {
  PlcReport report;
  report.heartbeat = PlcHeartbeat::Good;
  report.interlocks = {true, true, true, true, true, true, true, false, false, false};
  report.is_plate_written = true;
  report.is_guard_closed = true;
  return report;
}

PlcReport lostReport(WatchdogAction action) {
  PlcReport report = goodReport();
  report.heartbeat = PlcHeartbeat::Lost;
  report.interlocks.is_alive = false;
  report.on_silence = action;
  return report;
}

UnitStatus statusIn(UnitState state) {
  UnitStatus unit;
  unit.state = state;
  unit.sequence = 7;
  return unit;
}

UnitStatus suspendedBy(int alarm) {
  UnitStatus unit = statusIn(UnitState::Suspended);
  unit.stop_reason = ActiveAlarm{};
  unit.stop_reason->id = static_cast<std::uint16_t>(alarm);
  return unit;
}

std::vector<int> idsOf(const std::vector<PlcAlarm>& alarms) {
  std::vector<int> ids;
  for (const PlcAlarm& alarm : alarms) ids.push_back(alarm.id);
  return ids;
}

TEST(PlcWatch, DoesNothingWithoutAPlc) {
  PlcWatch watch({});
  const PlcDemands demands = watch.demands(statusIn(UnitState::Execute), 1000.0);
  EXPECT_TRUE(demands.raised.empty() && demands.ended.empty() && !demands.command);
  EXPECT_FALSE(watch.interlocks(1000.0).is_alive);
}

TEST(PlcWatch, CountsAZoneThatIsTakenOnTheWayWhereTheUnitCanHold) {
  PlcWatchSettings settings;
  settings.holds_on_the_way = true;
  PlcReport report = goodReport();
  report.interlocks.is_zone_taken = true;
  for (const UnitState state : {UnitState::Starting, UnitState::Unholding, UnitState::Unsuspending}) {
    PlcWatch watch(settings);
    watch.hear(report, 0.0);
    EXPECT_EQ(idsOf(watch.demands(statusIn(state), 0.0).raised), (std::vector<int>{1204})) << toString(state);
    const PlcDemands held = watch.demands(statusIn(UnitState::Held), 0.1);
    EXPECT_TRUE(held.raised.empty() && held.ended.empty()) << "it stays while the unit waits";
    report.interlocks.is_zone_taken = false;
    watch.hear(report, 0.2);
    const PlcDemands free = watch.demands(statusIn(UnitState::Held), 0.2);
    EXPECT_EQ(free.ended, (std::vector<int>{1204}));
    EXPECT_FALSE(watch.demands(statusIn(UnitState::Held), 0.3).command) << "what is held waits for a person";
    report.interlocks.is_zone_taken = true;
  }
  PlcWatch idle(settings);
  idle.hear(report, 0.0);
  EXPECT_TRUE(idle.demands(statusIn(UnitState::Idle), 0.0).raised.empty());
}

TEST(PlcWatch, SuspendsForAZoneThatIsTakenAndGoesOnWhenItIsFree) {
  PlcWatch watch({});
  PlcReport report = goodReport();
  report.interlocks.is_zone_taken = true;
  watch.hear(report, 0.0);
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Starting), 0.0).raised.empty())
      << "nothing there can be suspended";
  EXPECT_EQ(idsOf(watch.demands(statusIn(UnitState::Execute), 0.0).raised), (std::vector<int>{1204}));
  const UnitStatus suspended = suspendedBy(1204);
  const PlcDemands again = watch.demands(suspended, 0.1);
  EXPECT_TRUE(again.raised.empty()) << "reported once";
  EXPECT_FALSE(again.command);
  report.interlocks.is_zone_taken = false;
  watch.hear(report, 0.2);
  EXPECT_EQ(watch.demands(suspended, 0.2).ended, (std::vector<int>{1204}));
  EXPECT_EQ(watch.demands(suspended, 0.3).command, UnitCommand::Unsuspend);
  EXPECT_FALSE(watch.demands(suspended, 0.4).command) << "ordered once";
}

TEST(PlcWatch, LeavesASuspensionByAnybodyElse) {
  PlcWatch watch({});
  watch.hear(goodReport(), 0.0);
  EXPECT_FALSE(watch.demands(statusIn(UnitState::Suspended), 0.0).command);
  PlcWatchSettings settings;
  settings.unsuspends = false;
  PlcWatch waiting(settings);
  waiting.hear(goodReport(), 0.0);
  EXPECT_FALSE(waiting.demands(suspendedBy(1204), 0.0).command);
}

TEST(PlcWatch, NeedsPlateAndMaterialOnlyWhereThePlcIsRequired) {
  PlcReport report = goodReport();
  report.interlocks.is_plate_there = report.interlocks.is_plate_clamped = false;
  report.interlocks.has_gas = false;
  report.interlocks.is_blocked = true;
  PlcWatch beside({});
  beside.hear(report, 0.0);
  EXPECT_TRUE(beside.demands(statusIn(UnitState::Execute), 0.0).raised.empty());
  PlcWatchSettings settings;
  settings.is_required = true;
  PlcWatch required(settings);
  required.hear(report, 0.0);
  EXPECT_EQ(idsOf(required.demands(statusIn(UnitState::Execute), 0.0).raised),
            (std::vector<int>{1201, 1202, 1205}))
      << "blocked stands against the next part alone";
  EXPECT_EQ(required.demands(statusIn(UnitState::Stopped), 0.1).ended.size(), 3U);
}

TEST(PlcWatch, RaisesTheSilenceOfAPlcThatHasCalled) {
  PlcWatch watch({});
  watch.hear(goodReport(), 0.0);
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Held), 0.0).raised.empty());
  watch.hear(lostReport(WatchdogAction::Hold), 1.0);
  const PlcDemands lost = watch.demands(statusIn(UnitState::Held), 1.0);
  EXPECT_EQ(idsOf(lost.raised), (std::vector<int>{2101}));
  EXPECT_FALSE(lost.command);
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Held), 10.0).ended.empty()) << "nor by a link that dies";
  PlcReport abandoned = lostReport(WatchdogAction::Hold);
  abandoned.heartbeat = PlcHeartbeat::Abandoned;
  watch.hear(abandoned, 11.0);
  EXPECT_EQ(watch.demands(statusIn(UnitState::Held), 11.0).command, UnitCommand::Stop);
  EXPECT_FALSE(watch.demands(statusIn(UnitState::Stopping), 11.1).command);
  watch.hear(goodReport(), 12.0);
  EXPECT_EQ(watch.demands(statusIn(UnitState::Stopped), 12.0).ended, (std::vector<int>{2101}));
}

TEST(PlcWatch, StopsOrDoesNothingIfAskedTo) {
  PlcWatch stops({});
  stops.hear(goodReport(), 0.0);
  stops.hear(lostReport(WatchdogAction::Stop), 1.0);
  EXPECT_EQ(stops.demands(statusIn(UnitState::Execute), 1.0).raised.size(), 1U);
  EXPECT_EQ(stops.demands(statusIn(UnitState::Holding), 1.1).command, UnitCommand::Stop);
  EXPECT_FALSE(stops.demands(statusIn(UnitState::Stopping), 1.2).command);
  PlcWatch ignores({});
  ignores.hear(goodReport(), 0.0);
  ignores.hear(lostReport(WatchdogAction::None), 1.0);
  const PlcDemands demands = ignores.demands(statusIn(UnitState::Execute), 1.0);
  EXPECT_TRUE(demands.raised.empty() && !demands.command);
  EXPECT_FALSE(ignores.interlocks(1.0).is_alive) << "its interlocks count as not given";
}

TEST(PlcWatch, ActsOnASilenceThatACellHearsOfFirstAfterItsRestart) {
  PlcWatch stops({});
  stops.hear(lostReport(WatchdogAction::Stop), 0.0);
  EXPECT_EQ(idsOf(stops.demands(statusIn(UnitState::Execute), 0.0).raised), (std::vector<int>{2101}));
  EXPECT_EQ(stops.demands(statusIn(UnitState::Holding), 0.1).command, UnitCommand::Stop);
  PlcReport abandoned = lostReport(WatchdogAction::Stop);
  abandoned.heartbeat = PlcHeartbeat::Abandoned;
  PlcWatch late({});
  late.hear(abandoned, 0.0);
  late.demands(statusIn(UnitState::Execute), 0.0);
  EXPECT_EQ(late.demands(statusIn(UnitState::Holding), 0.1).command, UnitCommand::Stop);
  abandoned.on_silence = WatchdogAction::Hold;
  PlcWatch holds({});
  holds.hear(abandoned, 0.0);
  EXPECT_EQ(idsOf(holds.demands(statusIn(UnitState::Execute), 0.0).raised), (std::vector<int>{2101}));
  EXPECT_FALSE(holds.demands(statusIn(UnitState::Holding), 0.1).command) << "it is held first";
  EXPECT_EQ(holds.demands(statusIn(UnitState::Held), 0.2).command, UnitCommand::Stop);
  EXPECT_FALSE(holds.demands(statusIn(UnitState::Held), 0.3).command) << "ordered once";
  PlcWatch rests({});
  rests.hear(abandoned, 0.0);
  rests.demands(statusIn(UnitState::Idle), 0.0);
  EXPECT_FALSE(rests.demands(statusIn(UnitState::Idle), 0.1).command);
  EXPECT_FALSE(rests.demands(statusIn(UnitState::Held), 0.2).command) << "of a later job";
  PlcWatch again({});
  again.hear(abandoned, 0.0);
  again.demands(statusIn(UnitState::Execute), 0.0);
  again.hear(goodReport(), 0.1);
  again.demands(statusIn(UnitState::Holding), 0.1);
  EXPECT_FALSE(again.demands(statusIn(UnitState::Held), 0.2).command) << "its heartbeat has come back";
}

TEST(PlcWatch, WaitsForALinkThatIsRequiredWithPatience) {
  PlcWatchSettings settings;
  settings.is_required = true;
  settings.patience_s = 10.0;
  PlcWatch watch(settings);
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Stopped), 0.0).raised.empty());
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Execute), 1.0).raised.empty());
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Execute), 11.0).raised.empty());
  EXPECT_EQ(idsOf(watch.demands(statusIn(UnitState::Execute), 11.1).raised), (std::vector<int>{2101}));
  watch.hear(goodReport(), 12.0);
  EXPECT_EQ(watch.demands(statusIn(UnitState::Held), 12.0).ended, (std::vector<int>{2101}));
}

TEST(PlcWatch, TakesAPartAsRemovedWhenItsBitComes) {
  PlcWatch watch({});
  PlcReport report = goodReport();
  report.is_part_removed = true;
  watch.hear(report, 0.0);
  EXPECT_FALSE(watch.demands(statusIn(UnitState::Complete), 0.0).is_part_removed)
      << "it has merely stayed set";
  watch.hear(goodReport(), 1.0);
  watch.hear(report, 2.0);
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Complete), 2.0).is_part_removed);
  EXPECT_FALSE(watch.demands(statusIn(UnitState::Complete), 2.1).is_part_removed);
  watch.hear(goodReport(), 3.0);
  watch.hear(report, 4.0);
  EXPECT_FALSE(watch.demands(statusIn(UnitState::Execute), 4.0).is_part_removed);
  EXPECT_FALSE(watch.demands(statusIn(UnitState::Complete), 4.1).is_part_removed)
      << "that was before this part";
}

TEST(PlcWatch, BelievesNoRemovalOfALinkThatWasStartedAnew) {
  PlcWatch watch({});
  watch.hear(goodReport(), 0.0);
  PlcReport anew = goodReport();
  anew.is_plate_written = false;  // zeroed registers, before the PLC has written them
  watch.hear(anew, 1.0);
  PlcReport as_before = goodReport();
  as_before.is_part_removed = true;
  watch.hear(as_before, 2.0);
  EXPECT_FALSE(watch.demands(statusIn(UnitState::Complete), 2.0).is_part_removed)
      << "the PLC writes its register as it was";
  watch.hear(goodReport(), 3.0);
  watch.hear(as_before, 4.0);
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Complete), 4.0).is_part_removed);
}

TEST(PlcWatch, BelievesNoRemovalWithoutAHeartbeat) {
  PlcWatch watch({});
  watch.hear(lostReport(WatchdogAction::Hold), 0.0);
  PlcReport removed = lostReport(WatchdogAction::Hold);
  removed.is_part_removed = true;
  watch.hear(removed, 1.0);
  EXPECT_FALSE(watch.demands(statusIn(UnitState::Complete), 1.0).is_part_removed);
}

TEST(PlcWatch, RaisesAnEmergencyStopUntilItIsReleased) {
  PlcWatch watch({});
  PlcReport pressed = goodReport();
  pressed.interlocks.is_emergency_stop_pressed = true;
  watch.hear(pressed, 0.0);
  EXPECT_EQ(idsOf(watch.demands(statusIn(UnitState::Execute), 0.0).raised), (std::vector<int>{1207}));
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Stopping), 0.1).raised.empty()) << "reported once";
  PlcReport silent = pressed;
  silent.heartbeat = PlcHeartbeat::Lost;
  silent.interlocks.is_alive = false;
  watch.hear(silent, 1.0);
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Stopped), 1.0).ended.empty())
      << "nobody says it was released";
  watch.hear(goodReport(), 2.0);
  const std::vector<int> ended = watch.demands(statusIn(UnitState::Stopped), 2.0).ended;
  EXPECT_NE(std::find(ended.begin(), ended.end(), 1207), ended.end());
}

TEST(PlcWatch, HoldsWhenAGuardIsOpenedNotWhereNoneIsWired) {
  PlcWatch watch({});
  PlcReport open = goodReport();
  open.is_guard_closed = false;
  watch.hear(open, 0.0);
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Execute), 0.0).raised.empty()) << "it was never closed";
  watch.hear(goodReport(), 1.0);
  watch.hear(open, 2.0);
  EXPECT_EQ(idsOf(watch.demands(statusIn(UnitState::Execute), 2.0).raised), (std::vector<int>{1208}));
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Execute), 2.1).raised.empty());
  watch.hear(goodReport(), 3.0);
  watch.hear(open, 4.0);
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Complete), 4.0).raised.empty())
      << "the part has to be taken out";
}

TEST(PlcWatch, MissesALinkThatWasGoodUntilRemoteAccessIsLocked) {
  PlcWatchSettings settings;
  settings.patience_s = 10.0;
  PlcWatch watch(settings);
  watch.hear(goodReport(), 0.0);
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Execute), 3.0).raised.empty());
  EXPECT_EQ(idsOf(watch.demands(statusIn(UnitState::Execute), 13.1).raised), (std::vector<int>{2101}));
  PlcReport anew = goodReport();
  anew.heartbeat = PlcHeartbeat::Unarmed;
  anew.interlocks.is_alive = false;
  watch.hear(anew, 14.0);
  EXPECT_TRUE(watch.demands(statusIn(UnitState::Held), 14.0).ended.empty())
      << "the link is back, the PLC is not";
  watch.disarm();
  EXPECT_EQ(watch.demands(statusIn(UnitState::Held), 14.1).ended, (std::vector<int>{2101}));
}

TEST(PlcWatch, KnowsAPlcThatFellSilentFromOneThatNeverCalled) {
  PlcWatch never({});
  EXPECT_FALSE(never.interlocks(100.0).is_silent);
  PlcReport unarmed = goodReport();
  unarmed.heartbeat = PlcHeartbeat::Unarmed;
  unarmed.interlocks.is_alive = false;
  never.hear(unarmed, 100.0);
  EXPECT_FALSE(never.interlocks(100.0).is_silent) << "a link without a PLC";

  PlcWatch watch({});
  watch.hear(goodReport(), 0.0);
  EXPECT_FALSE(watch.interlocks(1.9).is_silent);
  EXPECT_TRUE(watch.interlocks(2.1).is_silent) << "the link has died";
  watch.hear(unarmed, 3.0);
  EXPECT_TRUE(watch.interlocks(3.0).is_silent) << "the link is back without its PLC";
  watch.disarm();
  EXPECT_FALSE(watch.interlocks(3.0).is_silent) << "the PLC was taken out of use";

  PlcWatch late({});  // of a cell_controller that was started after the heartbeat was lost
  late.hear(lostReport(WatchdogAction::None), 0.0);
  EXPECT_TRUE(late.interlocks(0.0).is_silent);
  late.hear(goodReport(), 1.0);
  EXPECT_FALSE(late.interlocks(1.0).is_silent);
}

/// Of a PLC that calls while remote access is locked.
PlcReport lockedReport() {
  PlcReport report = goodReport();
  report.heartbeat = PlcHeartbeat::Unarmed;
  report.interlocks.is_alive = false;
  report.interlocks.is_beating = true;
  return report;
}

TEST(PlcWatch, HearsWhatAPlcForbidsWhileRemoteAccessIsLocked) {
  PlcReport report = lockedReport();
  report.interlocks.is_zone_taken = true;
  PlcWatch watch({});
  watch.hear(report, 0.0);
  const std::vector<UnmetGuard> unmet = againstPlc(watch.interlocks(0.0), PlcNeed::None);
  ASSERT_EQ(unmet.size(), 1U);
  EXPECT_EQ(unmet.front().code, 1204);
  EXPECT_NE(whyZoneIsTaken(watch.interlocks(0.0), PlcNeed::None), "") << "nor is it moved by hand";
  EXPECT_EQ(idsOf(watch.demands(statusIn(UnitState::Execute), 0.1).raised), (std::vector<int>{1204}));
  report.interlocks.is_zone_taken = false;
  report.interlocks.is_emergency_stop_pressed = true;
  report.is_guard_closed = false;
  watch.hear(report, 0.5);
  const PlcDemands pressed = watch.demands(statusIn(UnitState::Execute), 0.5);
  EXPECT_EQ(idsOf(pressed.raised), (std::vector<int>{1207, 1208}));
  EXPECT_EQ(pressed.ended, (std::vector<int>{1204}));
  report.interlocks.is_beating = false;
  watch.hear(report, 1.0);
  EXPECT_TRUE(againstPlc(watch.interlocks(1.0), PlcNeed::None).empty()) << "it was not armed: no silence";
}

TEST(PlcWatch, NeedsAnArmedWatchdogWhereThePlcIsRequired) {
  PlcWatch watch({});
  watch.hear(lockedReport(), 0.0);
  EXPECT_TRUE(againstPlc(watch.interlocks(0.0), PlcNeed::None).empty());
  const std::vector<UnmetGuard> unmet = againstPlc(watch.interlocks(0.0), PlcNeed::Required);
  ASSERT_EQ(unmet.size(), 1U);
  EXPECT_EQ(unmet.front().code, 2101);
  EXPECT_NE(whyZoneIsTaken(watch.interlocks(0.0), PlcNeed::Required), "");
  EXPECT_TRUE(againstPlc(watch.interlocks(2.1), PlcNeed::None).empty());
  PlcReport taken = lockedReport();
  taken.interlocks.is_zone_taken = true;
  watch.hear(taken, 3.0);
  EXPECT_EQ(againstPlc(watch.interlocks(5.0), PlcNeed::None).size(), 1U);
  EXPECT_TRUE(againstPlc(watch.interlocks(5.1), PlcNeed::None).empty()) << "of a link that says nothing";
}

TEST(PlcWatch, LeavesAPartUnderWayToTheActionOnSilence) {
  PlcWatch ignores({});
  ignores.hear(goodReport(), 0.0);
  ignores.hear(lostReport(WatchdogAction::None), 1.0);
  EXPECT_TRUE(ignores.demands(statusIn(UnitState::Execute), 1.0).raised.empty());
  EXPECT_EQ(againstPlc(ignores.interlocks(1.0), PlcNeed::None).front().code, 1204)
      << "it goes on, but nothing begins";
}

}  // namespace
}  // namespace lamina
