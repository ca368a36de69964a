// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/guards.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "lamina/cell/unit_counters.hpp"

namespace lamina {
namespace {

const PlcInterlocks kAllGiven = {true, true, true, true, true, true, true, false, false, false};

StartConditions readyToStart() {
  StartConditions found;
  found.job = "bracket";
  found.is_checked = true;
  found.plc_need = PlcNeed::Required;
  found.plc = kAllGiven;
  found.needs_loop = true;
  found.free_bytes = 2e9;
  return found;
}

TEST(Guards, LetAReadyUnitStart) { EXPECT_TRUE(againstStart(readyToStart()).empty()); }

TEST(Guards, EachStopsTheStartAlone) {
  const std::vector<std::pair<int, std::function<void(StartConditions&)>>> each = {
      {1301, [](StartConditions& found) { found.mode = kMaintenance; }},
      {1302, [](StartConditions& found) { found.job.clear(); }},
      {1303, [](StartConditions& found) { found.unready = {"bed is 40 degC; expected 60"}; }},
      {1304, [](StartConditions& found) { found.is_checked = false; }},
      {1304, [](StartConditions& found) { found.machine_differences = {"reach in x is 1 mm"}; }},
      {1305, [](StartConditions& found) { found.loop_fault = "not calibrated"; }},
      {1203, [](StartConditions& found) { found.is_part_removed = false; }},
      {2101, [](StartConditions& found) { found.plc.is_alive = false; }},
      {1201, [](StartConditions& found) { found.plc.is_plate_there = false; }},
      {1202, [](StartConditions& found) { found.plc.is_plate_clamped = false; }},
      {1204, [](StartConditions& found) { found.plc.is_zone_taken = true; }},
      {1205, [](StartConditions& found) { found.plc.has_gas = false; }},
      {1206, [](StartConditions& found) { found.plc.is_blocked = true; }},
      {1312, [](StartConditions& found) { found.plc.is_emergency_stop_pressed = true; }},
      {8003, [](StartConditions& found) { found.clock_fault = "the clock of sensor is ahead by 8 ms"; }},
      {7002, [](StartConditions& found) { found.free_bytes = 1e9; }},
      {7002, [](StartConditions& found) { found.free_bytes = std::nullopt; }},
      {7101, [](StartConditions& found) { found.torn = {"bracket.gcode"}; }},
  };
  for (const auto& [code, spoil] : each) {
    StartConditions found = readyToStart();
    spoil(found);
    const std::vector<UnmetGuard> unmet = againstStart(found);
    ASSERT_EQ(unmet.size(), 1U) << code;
    EXPECT_EQ(unmet.front().code, code);
    EXPECT_FALSE(unmet.front().sentence.empty());
  }
}

TEST(Guards, AreAllReportedAtOnce) {
  StartConditions found = readyToStart();
  found.job.clear();
  found.plc.has_gas = found.plc.has_vacuum = false;
  found.free_bytes = 0.0;
  const std::vector<UnmetGuard> unmet = againstStart(found);
  ASSERT_EQ(unmet.size(), 3U);
  EXPECT_EQ(unmet[0].sentence, "the PLC reports no gas, vacuum");
  EXPECT_EQ(unmet[1].code, 1302);
  EXPECT_EQ(unmet[2].sentence, "the journal's disk has 0 MiB left; expected at least 1024 MiB");
}

TEST(Guards, SayThatTheRoomOnTheDiskIsNotKnown) {
  StartConditions found = readyToStart();
  found.free_bytes = std::nullopt;
  ASSERT_EQ(againstStart(found).size(), 1U);
  EXPECT_EQ(againstStart(found).front().sentence,
            "the journal's disk does not say how much it has left; expected at least 1024 MiB");
}

TEST(Guards, LeaveOutWhatTheCellDoesNotHave) {
  StartConditions found = readyToStart();
  found.plc_need = PlcNeed::None;
  found.plc = {};
  found.needs_loop = false;
  found.loop_fault = "not calibrated";
  found.clock_fault = "the clock of sensor is ahead by 8 ms";
  EXPECT_TRUE(againstStart(found).empty());
}

TEST(Guards, HoldAUnitThatIsNotSureOfItself) {
  ContinueConditions found;
  found.is_position_known = true;
  EXPECT_TRUE(againstContinuing(found).empty());
  found.is_position_known = false;
  found.out_of_band = {"nozzle is 180 degC; expected 210 +- 5"};
  found.has_master = false;
  const std::vector<UnmetGuard> unmet = againstContinuing(found);
  ASSERT_EQ(unmet.size(), 3U);
  EXPECT_EQ(unmet[2].code, 8002);
}

TEST(Guards, HearOfAPlcThatIsNotRequiredWhatItForbids) {
  PlcInterlocks said;
  EXPECT_TRUE(againstPlc(said, PlcNeed::None).empty());
  said.is_zone_taken = true;
  EXPECT_TRUE(againstPlc(said, PlcNeed::None).empty()) << "it is not alive";
  said.is_alive = true;
  ASSERT_EQ(againstPlc(said, PlcNeed::None).size(), 1U);
  EXPECT_EQ(againstPlc(said, PlcNeed::None).front().code, 1204);
  EXPECT_EQ(againstPlc(said, PlcNeed::Required).size(), 4U) << "plate, clamp and material are missing, too";
}

TEST(Guards, TakeTheZoneOfASilentPlcAsTaken) {
  PlcInterlocks plc;
  EXPECT_EQ(whyZoneIsTaken(plc, PlcNeed::None), "") << "there is no PLC";
  EXPECT_NE(whyZoneIsTaken(plc, PlcNeed::Required).find("is required"), std::string::npos);
  plc.is_silent = true;  // it reported the zone free before it fell silent
  const std::vector<UnmetGuard> unmet = againstPlc(plc, PlcNeed::None);
  ASSERT_EQ(unmet.size(), 1U);
  EXPECT_EQ(unmet.front().code, 1204);
  EXPECT_NE(unmet.front().sentence.find("silent"), std::string::npos);
  EXPECT_EQ(whyZoneIsTaken(plc, PlcNeed::None), unmet.front().sentence);
  ASSERT_EQ(againstPlc(plc, PlcNeed::Required).size(), 1U);
  EXPECT_EQ(againstPlc(plc, PlcNeed::Required).front().code, 2101) << "all its interlocks count as not given";
  plc = kAllGiven;
  EXPECT_EQ(whyZoneIsTaken(plc, PlcNeed::Required), "");
  plc.is_zone_taken = true;
  EXPECT_NE(whyZoneIsTaken(plc, PlcNeed::None).find("another robot"), std::string::npos);
}

TEST(Guards, LetAPartGoOnThatCannotBeTakenAwayYet) {
  ContinueConditions found;
  found.is_position_known = true;
  found.plc_need = PlcNeed::Required;
  found.plc = kAllGiven;
  found.plc.is_blocked = true;
  EXPECT_TRUE(againstContinuing(found).empty());
  found.plc.is_zone_taken = true;
  EXPECT_EQ(againstContinuing(found).size(), 1U);
}

TEST(UnitCounters, RollOverAsTheStandardsTagsDo) {
  EXPECT_EQ(rolledOver(2147483647.0), 2147483647U);
  EXPECT_EQ(rolledOver(2147483648.0), 0U);
  EXPECT_EQ(rolledOver(2147483658.9), 10U);
  EXPECT_EQ(rolledOver(-1.0), 0U);
}

TEST(UnitCounters, ComeBackByTheirNamesInTheJournal) {
  UnitCounters counters;
  counters = counted(counters, kProduction, UnitState::Held, 20.0);
  counters.parts = 7;
  counters.defective = 2;
  counters.material_mm3 = 1.5;
  auto named = namedCounters(counters);
  EXPECT_DOUBLE_EQ(named.at("mode.1.state.11"), 20.0) << "Production, Held";
  named["mode.9.state.2"] = 5.0;  // a mode that is no longer there
  const UnitCounters back = countersOf(named, standardModes());
  EXPECT_DOUBLE_EQ(totalTime(back), 20.0);
  EXPECT_DOUBLE_EQ(timeIn(back, kProduction, UnitState::Held), 20.0);
  EXPECT_EQ(back.parts, 7U);
  EXPECT_EQ(back.defective, 2U);
  EXPECT_DOUBLE_EQ(back.material_mm3, 1.5);
}

TEST(UnitCounters, GiveEffectiveness) {
  UnitCounters counters;
  counters = counted(counters, kProduction, UnitState::Execute, 80.0);
  counters = counted(counters, kProduction, UnitState::Held, 20.0);
  counters = counted(counters, kManual, UnitState::Execute, 1000.0);
  counters.parts = 4;
  counters.defective = 1;
  const Effectiveness found = effectiveness(counters, 60.0);
  EXPECT_DOUBLE_EQ(found.availability, 0.8);
  EXPECT_DOUBLE_EQ(found.performance, 0.75);
  EXPECT_DOUBLE_EQ(found.quality, 0.75);
  EXPECT_DOUBLE_EQ(found.overall(), 0.45);
  EXPECT_DOUBLE_EQ(effectiveness(UnitCounters{}, 60.0).overall(), 0.0);
}

}  // namespace
}  // namespace lamina
