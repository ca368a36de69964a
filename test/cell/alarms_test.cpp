// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/cell/active_alarms.hpp"
#include "lamina/cell/alarm_table.hpp"

namespace lamina {
namespace {

TEST(AlarmTable, IsInTheOrderOfItsNumbersWithTextsForAll) {
  int last = 0;
  for (const AlarmKind& kind : alarmTable()) {
    EXPECT_GT(kind.id, last);
    last = kind.id;
    EXPECT_NE(std::string(kind.title), "");
    EXPECT_NE(std::string(kind.remedy), "");
  }
}

TEST(AlarmTable, HasTheCategoriesThatAreSpecified) {
  const std::string expected =
      "1001I 1002I 1010A 1201S 1202S 1203S 1204S 1205S 1206S 1207T 1208H 2101H 2102W 2103W 2201H 2202A 2203A "
      "2204A 3101A "
      "3102A 3103A "
      "3104A "
      "3105A 3106A 3201H 3202H 3203H 3204H 4101A 4102W 4103A 4104H 4105A 4106A 5101H 5102H 5103W 5104A 5105A "
      "5106H "
      "5107H ";
  std::string found;
  for (const AlarmKind& kind : alarmTable())
    if (kind.id < 6000) found += std::to_string(kind.id) + letterOf(kind.category) + ' ';
  EXPECT_EQ(found, expected);
}

// The machine was stopped amid what it had accepted: to resume the job where it was is refused.
TEST(AlarmTable, SaysHowTheRestOfAnEndedStreamersJobIsPrinted) {
  EXPECT_NE(std::string(alarmKind(2202).remedy).find("lamina resume"), std::string::npos);
}

TEST(AlarmTable, RefusesWhatItDoesNotHave) {
  EXPECT_EQ(alarmKind(3104).category, AlarmCategory::Abort);
  EXPECT_THROW(alarmKind(3107), InvalidInput);
  EXPECT_THROW(alarmKind(0), InvalidInput);
}

TEST(AlarmTable, IsWrittenForAPlc) {
  const std::string csv = alarmTableCsv();
  EXPECT_NE(csv.find("\n3104,A,\"heater fault\",\"Look at heater"), std::string::npos);
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), alarmTable().size() + 1);
}

TEST(ActiveAlarms, DropAWarningWhenItsCauseIsGone) {
  ActiveAlarms alarms;
  alarms.raise(8003, 6.0, "", 1.0);
  EXPECT_EQ(alarms.gravest(), AlarmCategory::Warning);
  alarms.end(8003, 2.0);
  EXPECT_TRUE(alarms.all().empty());
}

TEST(ActiveAlarms, KeepAHoldUntilItIsGoneAndAcknowledgedInEitherOrder) {
  ActiveAlarms alarms;
  alarms.raise(3202, 20.0, "", 1.0);
  alarms.acknowledge(3202, "anna", 2.0);
  EXPECT_EQ(alarms.all().size(), 1U);
  alarms.end(3202, 3.0);
  EXPECT_TRUE(alarms.all().empty());
  alarms.raise(3202, 20.0, "", 4.0);
  alarms.end(3202, 5.0);
  EXPECT_EQ(alarms.all().size(), 1U);
  EXPECT_FALSE(alarms.gravest()) << "its cause is gone";
  alarms.acknowledge(3202, "anna", 6.0);
  EXPECT_TRUE(alarms.all().empty());
}

TEST(ActiveAlarms, AskAgainForAnAcknowledgedAlarmThatComesBack) {
  ActiveAlarms alarms;
  alarms.raise(3202, 20.0, "", 1.0);
  alarms.acknowledge(3202, "anna", 2.0);
  EXPECT_EQ(alarms.raise(3202, 25.0, "", 9.0), ActiveAlarms::Raised::Again);
  ASSERT_EQ(alarms.all().size(), 1U);
  EXPECT_FALSE(alarms.all().front().acknowledged_s);
  EXPECT_DOUBLE_EQ(alarms.all().front().value, 25.0);
  EXPECT_DOUBLE_EQ(alarms.all().front().raised_s, 1.0);
}

TEST(ActiveAlarms, TellAFloodOnceASecondAndCountIt) {
  ActiveAlarms alarms;
  int reported = 0;
  for (int i = 0; i < 100; ++i)
    reported += alarms.raise(4102, i, "", 0.05 * i) != ActiveAlarms::Raised::Flooding;
  EXPECT_EQ(reported, 5);
  EXPECT_EQ(alarms.all().front().times, 100U);
}

TEST(ActiveAlarms, TellOfOneThatCameBackWithinASecondOnceThatIsOver) {
  ActiveAlarms alarms;
  alarms.raise(1204, 0.0, "", 1.0);
  alarms.end(1204, 1.3);
  EXPECT_EQ(alarms.raise(1204, 0.0, "", 1.6), ActiveAlarms::Raised::Flooding);
  EXPECT_EQ(alarms.raise(1204, 0.0, "", 1.8), ActiveAlarms::Raised::Flooding);
  EXPECT_TRUE(alarms.takeReturned(1.9).empty());
  const auto returned = alarms.takeReturned(2.0);
  ASSERT_EQ(returned.size(), 1U);
  EXPECT_DOUBLE_EQ(returned[0].raised_s, 1.6);
  EXPECT_TRUE(alarms.takeReturned(5.0).empty());
  alarms.raise(1204, 0.0, "", 5.0);
  alarms.end(1204, 5.2);
  alarms.raise(1204, 0.0, "", 5.4);
  alarms.end(1204, 5.6);
  EXPECT_TRUE(alarms.takeReturned(6.5).empty()) << "it is gone again";
  alarms.raise(4102, 0.0, "", 7.0);
  alarms.raise(4102, 0.0, "", 7.5);
  EXPECT_TRUE(alarms.takeReturned(9.0).empty()) << "a repeated event is counted";
}

TEST(ActiveAlarms, TellOfOneThatWasAcknowledgedAndCameBackWithinTheSecond) {
  ActiveAlarms alarms;
  alarms.raise(3202, 20.0, "", 1.0);
  alarms.acknowledge(3202, "anna", 1.2);
  alarms.raise(3202, 25.0, "", 1.4);
  const auto returned = alarms.takeReturned(2.5);
  ASSERT_EQ(returned.size(), 1U) << "it asks to be acknowledged again";
  EXPECT_DOUBLE_EQ(returned[0].value, 25.0);
}

TEST(ActiveAlarms, TellOfAnEventThatHoldsAgainWithinTheSecondOfItsAcknowledgement) {
  ActiveAlarms alarms;
  EXPECT_EQ(alarms.raise(6110, 0.0, "2 mm", 1.0), ActiveAlarms::Raised::Anew);
  alarms.acknowledge(6110, "Mia", 1.3);
  EXPECT_TRUE(alarms.all().empty());
  EXPECT_EQ(alarms.raise(6110, 0.0, "3 mm", 1.6), ActiveAlarms::Raised::Flooding);
  const auto returned = alarms.takeReturned(2.1);
  ASSERT_EQ(returned.size(), 1U);
  EXPECT_EQ(returned[0].message, "3 mm");
  EXPECT_DOUBLE_EQ(returned[0].raised_s, 1.6);
  EXPECT_TRUE(alarms.takeReturned(4.0).empty());
  alarms.raise(6110, 0.0, "4 mm", 5.0);
  alarms.raise(6110, 0.0, "4 mm", 5.5);
  EXPECT_TRUE(alarms.takeReturned(7.0).empty()) << "nobody acknowledged it in between";
}

TEST(ActiveAlarms, ForgetEventsThatNobodyHasToAcknowledge) {
  ActiveAlarms alarms;
  alarms.raise(4102, 0.0, "", 1.0);
  alarms.raise(3104, 0.0, "", 1.0);
  alarms.raise(8003, 0.0, "", 1.0);
  alarms.forgetEvents();
  std::set<int> left;
  for (const ActiveAlarm& alarm : alarms.all()) left.insert(alarm.id);
  EXPECT_EQ(left, (std::set<int>{3104, 8003}));
}

}  // namespace
}  // namespace lamina
