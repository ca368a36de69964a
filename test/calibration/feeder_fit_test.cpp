// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/feeder_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lamina/base/error.hpp"
#include "recorded_cell.hpp"

namespace lamina {
namespace {

/// A feeder by its dead time and first-order lag.
struct LateFeeder {
  double dead_time_s = 0.0;
  double lag_s = 0.0;
};

/// The relative amount along a bead, integrated in small steps of time: lag y' = u(t - dead time) - y.
std::vector<double> deposited(const FeederSteps& steps, const LateFeeder& feeder, double speed_mm_s,
                              const std::vector<double>& along_mm) {
  constexpr double kStep = 1e-4;
  const double piece_s = (steps.beads[0].end - steps.beads[0].start).norm() /
                         static_cast<double>(steps.amount.size()) / speed_mm_s;
  std::vector<double> amounts;
  double amount = steps.amount[0];
  double time = 0.0;
  for (const double along : along_mm) {
    for (; time < along / speed_mm_s; time += kStep) {
      const double commanded_s = std::max(0.0, time - feeder.dead_time_s);
      const auto piece = std::min(steps.amount.size() - 1, static_cast<std::size_t>(commanded_s / piece_s));
      amount += (steps.amount[piece] - amount) * (feeder.lag_s > 0.0 ? kStep / feeder.lag_s : 1.0);
    }
    amounts.push_back(amount);
  }
  return amounts;
}

std::vector<BeadCrossSections> sections(const FeederSteps& steps, const LateFeeder& feeder, double shift_mm,
                                        double noise) {
  Random random(5);
  std::vector<BeadCrossSections> beads;
  for (int b = 0; b < 2; ++b) {
    BeadCrossSections bead;
    std::vector<double> at;
    for (double along = 1.0; along < 149.0; along += 0.5) {
      bead.along_mm.push_back(along);
      at.push_back(along - (b == 0 ? shift_mm : -shift_mm));
    }
    for (const double amount : deposited(steps, feeder, 10.0, at))
      bead.area_mm2.push_back((0.22 + 0.01 * b) * amount * (1.0 + random.normal(0.0, noise)));
    beads.push_back(bead);
  }
  return beads;
}

TEST(FeederFit, FindsDeadTimeAndLag) {
  const FeederSteps steps = feederSteps({});
  for (const double dead_time : {0.0, 0.2, 0.75, 1.5})
    for (const double lag : {0.0, 0.1, 0.4}) {
      const FeederFit fit = fitFeeder(steps, sections(steps, LateFeeder{dead_time, lag}, 0.7, 0.01), 10.0);
      EXPECT_NEAR(fit.dead_time_s, dead_time, 0.02) << lag;
      EXPECT_NEAR(fit.lag_s, lag, 0.03) << dead_time;
      EXPECT_NEAR(fit.shift_mm, 0.7, 0.1);
      EXPECT_NEAR(fit.gain, 1.0, 0.05);
      EXPECT_LT(fit.dead_time_spread_s, 0.05);
    }
}

TEST(FeederFit, FindsThemInAScan) {
  CalibrationSettings settings;
  const FeederSteps steps = feederSteps(settings);
  std::vector<double> along;
  for (double at = 0.0; at <= 150.0; at += 0.25) along.push_back(at);
  const std::vector<double> amount = deposited(steps, {0.6, 0.3}, 10.0, along);
  test::RecordedCell cell;
  cell.noise_mm = 0.01;
  cell.points = 281;
  cell.profile_s = 0.02;
  cell.surface = [&](const Point2& at) {
    for (const CalibrationBead& bead : steps.beads) {
      const Point2 direction = (bead.end - bead.start).normalized();
      const double place = (at - bead.start).dot(direction);
      const double t = std::abs(at.x() - bead.start.x()) / 0.5;
      if (t < 1.0 && place >= 0.0 && place < 150.0)
        return 0.4 * amount[static_cast<std::size_t>(place / 0.25)] * (1.0 - t * t);
    }
    return 0.0;
  };
  const test::LinearMotion motion({75.0, 20.0, 2.0}, {{{75.0, 180.0, 2.0}, 20.0}});
  const auto beads = beadSections(test::record(cell, motion), test::nominalSensor(), 0.0, steps);
  ASSERT_EQ(beads.size(), 2u);
  const double area = 0.4 * 1.0 * 2.0 / 3.0;  // of a parabola 1 mm wide
  EXPECT_NEAR(beads[0].area_mm2[10], area, 0.02 * area);
  const FeederFit fit = fitFeeder(steps, beads, 10.0);
  EXPECT_NEAR(fit.dead_time_s, 0.6, 0.04);
  EXPECT_NEAR(fit.lag_s, 0.3, 0.04);
}

TEST(FeederFit, OfBeadsThatDoNotFollowIsRefused) {
  const FeederSteps steps = feederSteps({});
  std::vector<BeadCrossSections> beads = sections(steps, {0.2, 0.1}, 0.0, 0.01);
  for (BeadCrossSections& bead : beads)
    for (double& area : bead.area_mm2) area = 0.22;
  EXPECT_THROW(fitFeeder(steps, beads, 10.0), InvalidInput);
  beads[1] = {};
  EXPECT_THROW(fitFeeder(steps, beads, 10.0), InvalidInput);
}

}  // namespace
}  // namespace lamina
