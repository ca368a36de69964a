// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_place.hpp"

#include <gtest/gtest.h>

#include "streaming/firmware/grbl/grbl_standstill.hpp"
#include "streaming/firmware/grbl/grbl_starvation.hpp"

namespace lamina {
namespace {

GrblReport at(double x) {
  GrblReport report;
  report.state = GrblState::Run;
  report.machine_position = GrblAxes{x, 0.0, 0.0};
  return report;
}

TEST(GrblPlace, IsKnownOnceTheOffsetWasReported) {
  GrblPlace place;
  EXPECT_TRUE(place.follow(at(5.0)));
  EXPECT_FALSE(place.work());
  GrblReport with_offset = at(5.0);
  with_offset.work_offset = GrblAxes{2.0, 0.0, -1.0};
  EXPECT_FALSE(place.follow(with_offset)) << "it has not moved";
  EXPECT_EQ(place.work(), (GrblAxes{3.0, 0.0, 1.0}));
  EXPECT_TRUE(place.follow(at(6.0)));
  EXPECT_EQ(place.work(), (GrblAxes{4.0, 0.0, 1.0}));
  place.forgetWork();
  EXPECT_FALSE(place.work());
  place.learn(at(7.0));
  EXPECT_EQ(place.work(), (GrblAxes{5.0, 0.0, 1.0}));
}

TEST(GrblStandstill, TakesTwoReportsApart) {
  GrblStandstill standstill;
  EXPECT_FALSE(standstill.isCertainAt(1.0));
  EXPECT_FALSE(standstill.isCertainAt(1.04));
  EXPECT_TRUE(standstill.isCertainAt(1.06));
  standstill.restart();
  EXPECT_FALSE(standstill.isCertainAt(1.2));
}

TEST(GrblStarvation, CountsAnEmptyQueueOnce) {
  GrblStarvation starvation;
  GrblReport report = at(1.0);
  report.free_blocks = 14;
  starvation.see(report, 15, 4, 1.0);
  EXPECT_EQ(starvation.starvation().count, 0U);
  report.free_blocks = 15;
  starvation.see(report, 15, 5, 2.0);
  starvation.see(report, 15, 6, 2.5);
  EXPECT_EQ(starvation.starvation().count, 1U);
  EXPECT_EQ(starvation.starvation().longest_s, 0.5);
  EXPECT_EQ(starvation.starvation().line, 6U);
  starvation.end();
  report.state = GrblState::Idle;
  starvation.see(report, 0, 9, 3.0);
  EXPECT_EQ(starvation.starvation().count, 2U);
  EXPECT_EQ(starvation.starvation().line, 6U) << "of the longest";
}

}  // namespace
}  // namespace lamina
