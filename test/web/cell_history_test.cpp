// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/cell_history.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/web/rate_limit.hpp"

namespace lamina::test {
namespace {

TEST(CellHistory, ReportsWhatHasChanged) {
  CellHistory history;
  CellSnapshot seen;
  history.observe(seen, {0.0, 100.0});
  EXPECT_TRUE(history.events().empty()) << "nothing was heard yet";
  seen.heard_s = 0.0;
  seen.unit.state = UnitState::Idle;
  history.observe(seen, {1.0, 101.0});
  seen.queue.push_back({3, "part", "", "", "", JobState::NotAllowedToStart, "anna", ""});
  history.observe(seen, {2.0, 102.0});
  seen.queue[0].state = JobState::AllowedToStart;
  seen.alarms.push_back({1001, "I", "held by the operator", "", "by anna", true, false, "", 1});
  history.observe(seen, {3.0, 103.0});
  seen.alarms[0].is_acknowledged = true;
  seen.alarms[0].acknowledged_by = "anna";
  seen.unit.state = UnitState::Held;
  seen.unit.sequence = 1;
  seen.unit.stop_reason = 1001;
  seen.unit.stop_message = "by anna";
  history.observe(seen, {4.0, 104.0});
  seen.alarms.clear();
  seen.queue.clear();
  seen.startup.push_back({"heat_bed", "DONE", "", 60.0, "degC", ""});
  seen.loop = ShownLoop{"COASTING", "no sight", 3, 0};
  history.observe(seen, {5.0, 105.0});
  std::vector<std::string> texts;
  for (const CellEvent& event : history.events()) texts.push_back(event.text);
  EXPECT_EQ(texts, (std::vector<std::string>{
                       "Idle", "job 3 part put into the queue by anna", "1001 held by the operator: by anna",
                       "job 3 part is AllowedToStart", "Held: by anna",
                       "1001 held by the operator acknowledged by anna", "1001 held by the operator is over",
                       "job 3 part has left the queue", "COASTING: no sight", "heat_bed is DONE"}));
  EXPECT_EQ(history.samples().size(), 5U);
}

TEST(CellHistory, DrawsNoTemperatureThatIsNoLongerReported) {
  CellHistory history;
  CellSnapshot seen;
  seen.heard_s = 0.0;
  seen.machine_heard_s = 0.0;
  seen.machine.nozzle_degc = 210.0;
  seen.machine.bed_degc = 60.0;
  for (int second = 1; second <= 8; ++second)
    history.observe(seen, {static_cast<double>(second), 100.0 + second});
  ASSERT_EQ(history.samples().size(), 8U);
  EXPECT_EQ(history.samples()[4].nozzle_degc, 210.0) << "5 s after the report";
  EXPECT_TRUE(std::isnan(history.samples()[5].nozzle_degc));
  EXPECT_TRUE(std::isnan(history.samples()[7].bed_degc));
}

TEST(CellHistory, KeepsTenMinutesOfFiguresAndTheLastEvents) {
  CellHistory history;
  CellSnapshot seen;
  seen.heard_s = 0.0;
  for (int tenth = 0; tenth < 20000; ++tenth) {
    seen.unit.sequence = static_cast<std::uint32_t>(tenth / 10);
    history.observe(seen, {tenth / 10.0, tenth / 10.0});
  }
  EXPECT_EQ(history.samples().size(), 600U);
  EXPECT_EQ(history.events().size(), 500U);
  EXPECT_EQ(history.events().back().number, 2000U);
}

TEST(RateLimit, GivesABurstAndThenItsRate) {
  RateLimit limit({2.0, 4.0});
  int taken = 0;
  for (int i = 0; i < 10; ++i) taken += limit.take("a", 0.0) ? 1 : 0;
  EXPECT_EQ(taken, 4);
  EXPECT_TRUE(limit.take("b", 0.0));
  for (int i = 0; i < 10; ++i) taken += limit.take("a", 1.0) ? 1 : 0;
  EXPECT_EQ(taken, 6);
  for (int i = 0; i < 5000; ++i) limit.take("source " + std::to_string(i), 2.0);
  EXPECT_TRUE(limit.take("a", 100.0));
}

}  // namespace
}  // namespace lamina::test
