// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/trajectory_driver/report_watch.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

const ros::Time kBegin(1000.0);

ros::Time after(double seconds) { return kBegin + ros::Duration(seconds); }

ReportWatch watch(SilenceBy by) {
  TrackingLimits limits;
  limits.silence_by = by;
  return ReportWatch(limits, 60.0, kBegin);
}

/// Looks every 20 ms.
std::optional<std::string> lookAllTheTime(ReportWatch& watch, double from_s, double to_s) {
  for (int i = 0; from_s + 0.02 * i <= to_s; ++i)
    if (auto silence = watch.look(after(from_s + 0.02 * i))) return silence;
  return std::nullopt;
}

TEST(ReportWatch, ByArrivalASilentControllerIsNoticedAfterTheLimit) {
  ReportWatch of = watch(SilenceBy::Arrival);
  EXPECT_FALSE(lookAllTheTime(of, 0.0, 0.99));
  of.hear(after(0.99), after(0.99));
  EXPECT_FALSE(lookAllTheTime(of, 1.0, 1.97));
  const auto silence = lookAllTheTime(of, 1.98, 2.1);
  ASSERT_TRUE(silence);
  EXPECT_NE(silence->find("silent"), std::string::npos) << *silence;
}

TEST(ReportWatch, HearsStampsThatNoClockGives) {
  const ros::Time garbled(4294967295, 0);
  ReportWatch by_arrival = watch(SilenceBy::Arrival);
  by_arrival.hear(after(0.1), after(0.1));
  by_arrival.hear(garbled, after(0.2));
  EXPECT_FALSE(by_arrival.look(after(0.3))) << "it is not silent";
  ReportWatch by_stamps = watch(SilenceBy::Stamps);
  by_stamps.hear(after(0.1), after(0.1));
  by_stamps.hear(garbled, after(0.2));
  EXPECT_TRUE(by_stamps.look(after(0.3)));
}

TEST(ReportWatch, ByArrivalADriverThatDidNotRunItselfDoesNotBlameTheController) {
  ReportWatch of = watch(SilenceBy::Arrival);
  of.hear(after(0.1), after(0.1));
  EXPECT_FALSE(of.look(after(3.1))) << "it was away for 3 s";
  of.hear(after(3.1), after(3.12));
  EXPECT_FALSE(lookAllTheTime(of, 3.14, 4.1));
}

TEST(ReportWatch, BeforeTheBeginningNothingIsExpected) {
  ReportWatch of = watch(SilenceBy::Arrival);
  EXPECT_FALSE(lookAllTheTime(of, -5.0, 0.9));
}

TEST(ReportWatch, ByStampsReportsMayComeLateButNotBeLeftOut) {
  ReportWatch of = watch(SilenceBy::Stamps);
  of.hear(after(0.1), after(0.1));
  EXPECT_FALSE(lookAllTheTime(of, 0.12, 8.0)) << "a slow host";
  for (int i = 1; i <= 300; ++i) of.hear(after(0.1 + 0.02 * i), after(8.0));
  EXPECT_FALSE(of.look(after(8.02)));
  of.hear(after(6.1 + 1.03), after(8.04));
  const auto silence = of.look(after(8.06));
  ASSERT_TRUE(silence);
  EXPECT_NE(silence->find("apart"), std::string::npos) << *silence;
}

TEST(ReportWatch, ByStampsALostConnectionIsNoticed) {
  ReportWatch of = watch(SilenceBy::Stamps);
  EXPECT_FALSE(lookAllTheTime(of, 0.0, 59.9));
  EXPECT_TRUE(lookAllTheTime(of, 59.92, 60.2));
}

TEST(ReportWatch, APauseIsNoGap) {
  for (const SilenceBy by : {SilenceBy::Arrival, SilenceBy::Stamps}) {
    ReportWatch of = watch(by);
    of.hear(after(0.1), after(0.1));
    lookAllTheTime(of, 0.1, 100.0);
    of.restart(after(100.0));
    EXPECT_FALSE(of.look(after(100.02)));
    of.hear(after(100.04), after(100.04));
    EXPECT_FALSE(of.look(after(100.06)));
  }
}

}  // namespace
}  // namespace lamina
