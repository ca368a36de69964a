// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/job_watch.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "startup/large_gantry.hpp"

namespace lamina {
namespace {

FirmwareReply text(const std::string& line) {
  FirmwareReply reply;
  reply.text = line;
  return reply;
}

/// A job on the large gantry: its bed at 90 degC, kept within 88 to 92, four zones under 40 kPa, axes homed.
class WatchedJob : public testing::Test {
 protected:
  void report(double bed_c, std::optional<double> target_c) {
    FirmwareReply reply;
    reply.temperatures = ReportedTemperatures{};
    reply.temperatures->bed_c = bed_c;
    reply.temperatures->bed_target_c = target_c;
    now_s_ += 1.0;
    watch_.onReply(reply, now_s_);
  }
  void reportFor(double seconds, double bed_c, std::optional<double> target_c) {
    for (const double until_s = now_s_ + seconds; now_s_ < until_s;) report(bed_c, target_c);
  }
  void say(const std::string& line) { watch_.onReply(text(line), now_s_); }
  void reportZones(double of_the_third_kpa) {
    for (int zone = 1; zone <= 4; ++zone)
      say("zone " + std::to_string(zone) + ": " + std::to_string(zone == 3 ? of_the_third_kpa : 12.0) +
          " kPa");
  }
  std::string found() const {
    std::string names;
    for (const JobLoss& loss : watch_.losses()) names += "BVHD"[static_cast<int>(loss.what)];
    return names;
  }
  std::string reason() const { return watch_.losses().empty() ? "" : watch_.losses().front().reason; }

  StartupSettings settings_ = test::largeGantry();
  JobWatch watch_{settings_, WatchedLines::OfTheProgram};
  double now_s_ = 0.0;
};

TEST_F(WatchedJob, HasLostNothingWhileAllIsAsItWas) {
  EXPECT_EQ(found(), "") << "nothing was reported";
  reportFor(100.0, 89.0, 90.0);
  reportZones(12.0);
  say("homed:XYZ");
  EXPECT_EQ(found(), "");
}

TEST_F(WatchedJob, ReadsCommandsWithoutBlanks) {
  report(90.0, 90.0);
  watch_.onSent("M140S60");
  reportFor(10.0, 75.0, 60.0);
  EXPECT_EQ(found(), "") << reason();
}

TEST_F(WatchedJob, LosesItsBedWhenItGetsColdUnderItsTarget) {
  report(90.0, 90.0);
  report(87.0, 90.0);
  EXPECT_EQ(found(), "") << "one report may be noise";
  reportFor(5.0, 87.0, 90.0);
  EXPECT_EQ(found(), "B");
  EXPECT_EQ(reason(), "the bed is at 87 degC; expected at least 88 degC");
  EXPECT_EQ(watch_.losses().front().value, 87.0);
  report(88.5, 90.0);
  EXPECT_EQ(found(), "") << "it is warm again";
}

TEST_F(WatchedJob, LosesItsBedWhenSomebodyElseSwitchesItOff) {
  report(90.0, 90.0);
  report(90.0, 0.0);
  EXPECT_EQ(found(), "") << "its line may be on its way";
  reportFor(5.0, 90.0, 0.0);
  EXPECT_EQ(found(), "B");
  EXPECT_EQ(reason(), "the bed's target is 0 degC, which the program has not set; expected 90 degC");
  report(90.0, 90.0);
  EXPECT_EQ(found(), "");
}

TEST_F(WatchedJob, KeepsATargetThatTheProgramHasChanged) {
  report(90.0, 90.0);
  watch_.onSent("M140 S80");
  reportFor(10.0, 90.0, 90.0);  // the line still waits behind others
  for (double bed_c = 90.0; bed_c > 79.0; bed_c -= 0.1) report(bed_c, 80.0);
  EXPECT_EQ(found(), "") << "it cools as it should";
  reportFor(60.0, 79.0, 80.0);
  EXPECT_EQ(found(), "");
  reportFor(10.0, 77.0, 80.0);
  EXPECT_EQ(found(), "B") << "and then below its new target";
}

TEST_F(WatchedJob, KeepsATargetThatIsReportedBeforeItsLineCountsAsSent) {
  report(90.0, 90.0);
  report(90.0, 100.0);
  watch_.onSent("M190 S100");
  EXPECT_EQ(found(), "");
  for (double bed_c = 90.0; bed_c < 100.0; bed_c += 0.1) report(bed_c, 100.0);
  EXPECT_EQ(found(), "");
  reportFor(10.0, 95.0, 100.0);
  EXPECT_EQ(found(), "B") << "it is kept from then on";
}

TEST_F(WatchedJob, TakesAForeignTargetBackThatItsProgramSetsLate) {
  reportFor(10.0, 90.0, 100.0);
  EXPECT_EQ(found(), "B");
  watch_.onSent("M190 S100");
  EXPECT_EQ(found(), "");
}

TEST_F(WatchedJob, LetsABedHeatToANewTarget) {
  watch_.onSent("M190 S110");
  for (double bed_c = 90.0; bed_c < 109.0; bed_c += 0.05) report(bed_c, 110.0);
  EXPECT_EQ(found(), "");
  reportFor(10.0, 109.0, 110.0);
  reportFor(10.0, 105.0, 110.0);
  EXPECT_EQ(found(), "B");
}

TEST_F(WatchedJob, LosesABedThatNeverReachesItsNewTarget) {
  watch_.onSent("M140 S110");
  report(90.0, 110.0);
  reportFor(settings_.bed_timeout_min * 60.0 - 10.0, 95.0, 110.0);
  EXPECT_EQ(found(), "");
  reportFor(20.0, 95.0, 110.0);
  EXPECT_EQ(found(), "B");
}

TEST_F(WatchedJob, IsNotSurprisedByAProgramThatSwitchesAllOffAtItsEnd) {
  report(90.0, 90.0);
  reportZones(12.0);
  say("homed:XYZ");
  for (const char* command :
       {"M104 S0", "M140 S0", "M42 P1 S0", "M42 P2 S0", "M42 P3 S0", "M42 P4 S0", "M84"})
    watch_.onSent(command);
  for (double bed_c = 90.0; bed_c > 30.0; bed_c -= 0.5) report(bed_c, 0.0);
  reportZones(101.0);
  say("homed:");
  say("echo:Home XYZ First");
  EXPECT_EQ(found(), "");
}

TEST_F(WatchedJob, LosesTheVacuumOfAZone) {
  reportZones(12.0);
  EXPECT_EQ(found(), "");
  reportZones(70.0);
  EXPECT_EQ(found(), "V");
  EXPECT_EQ(reason(), "zone 3 is at 70 kPa; expected under 40 kPa");
  reportZones(12.0);
  EXPECT_EQ(found(), "");
}

TEST_F(WatchedJob, LosesItsHoming) {
  say("homed:XY");
  EXPECT_EQ(found(), "H");
  say("homed:XYZ");
  EXPECT_EQ(found(), "");
  say("echo:Home XYZ First");
  EXPECT_EQ(found(), "H");
  watch_.onSent("G28");
  EXPECT_EQ(found(), "") << "the program homes anew";
}

TEST_F(WatchedJob, WatchesTheAxesThatAProgramHasNotLetGo) {
  watch_.onSent("M84 Z");
  say("homed:XY");
  EXPECT_EQ(found(), "");
  say("homed:Y");
  EXPECT_EQ(found(), "H");
}

TEST_F(WatchedJob, TakesATargetOfAMacroForTheProgramsOwn) {
  watch_.onSent("START_PRINT BED=70");
  for (double bed_c = 90.0; bed_c > 69.0; bed_c -= 0.5) report(bed_c, 70.0);
  EXPECT_EQ(found(), "");
  reportFor(10.0, 60.0, 70.0);
  EXPECT_EQ(found(), "B") << "but keeps it";
}

TEST_F(WatchedJob, JudgesByWhatWasSentWhereNoTargetIsReported) {
  reportFor(10.0, 87.0, std::nullopt);
  EXPECT_EQ(found(), "B");
  watch_.onSent("M140 S0");
  reportFor(10.0, 60.0, std::nullopt);
  EXPECT_EQ(found(), "");
}

TEST_F(WatchedJob, OfLinesThatMayBeReplacedKeepsTheBedOnly) {
  JobWatch watch(settings_, WatchedLines::MayBeReplaced);
  FirmwareReply reply;
  reply.temperatures = ReportedTemperatures{};
  reply.temperatures->bed_c = 90.0;
  reply.temperatures->bed_target_c = 0.0;
  watch.onReply(reply, 1.0);
  watch.onReply(text("homed:"), 1.0);
  EXPECT_TRUE(watch.losses().empty()) << "it may be the new lines' end";
  reply.temperatures->bed_target_c = 90.0;
  watch.onReply(reply, 2.0);
  reply.temperatures->bed_c = 80.0;
  watch.onReply(reply, 3.0);
  watch.onReply(reply, 9.0);
  ASSERT_EQ(watch.losses().size(), 1U);
  EXPECT_EQ(watch.losses()[0].what, KeptCondition::Bed);
}

TEST_F(WatchedJob, WatchesNothingThatIsNotInTheSequence) {
  settings_.sequence = "power_on";
  settings_.after = {};
  JobWatch watch(settings_, WatchedLines::OfTheProgram);
  watch.onReply(text("homed:"), 1.0);
  FirmwareReply reply;
  reply.temperatures = ReportedTemperatures{};
  reply.temperatures->bed_c = 20.0;
  reply.temperatures->bed_target_c = 0.0;
  for (double now_s = 1.0; now_s < 20.0; ++now_s) watch.onReply(reply, now_s);
  EXPECT_TRUE(watch.losses().empty());
}

/// A bed that follows its target at 1 K a second, whatever the program sets and when.
RC_GTEST_PROP(WatchedJobProperty, NoTargetOfTheProgramIsALossOfABedThatFollows, ()) {
  JobWatch watch(test::largeGantry(), WatchedLines::OfTheProgram);
  double bed_c = 90.0;
  double target_c = 90.0;
  std::deque<std::pair<double, double>> queue;  // when a target that was sent is set
  double now_s = 0.0;
  const auto targets = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 12));
  for (const int asked : targets) {
    const double asked_c = 10.0 * asked;
    watch.onSent("M140 S" + std::to_string(10 * asked));
    queue.emplace_back(now_s + *rc::gen::inRange(0, 30), asked_c);
    for (int i = *rc::gen::inRange(1, 60); i > 0; --i) {
      now_s += 1.0;
      while (!queue.empty() && queue.front().first <= now_s) {
        target_c = queue.front().second;
        queue.pop_front();
      }
      bed_c += std::clamp(std::max(target_c, 20.0) - bed_c, -1.0, 1.0);
      FirmwareReply reply;
      reply.temperatures = ReportedTemperatures{};
      reply.temperatures->bed_c = bed_c;
      reply.temperatures->bed_target_c = target_c;
      watch.onReply(reply, now_s);
      RC_ASSERT(watch.losses().empty());
    }
  }
}

}  // namespace
}  // namespace lamina
