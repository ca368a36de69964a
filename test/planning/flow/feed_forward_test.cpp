// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lamina/planning/flow/flow.hpp"
#include "lamina/toolpath/timing.hpp"

namespace lamina {
namespace {

constexpr Bead kDepositedBead = {0.4, 0.2};

/// A straight run of 40 mm at the first feed and 120 mm at the second.
Toolpath speedStep(double first_mm_s = 20.0, double second_mm_s = 60.0) {
  Toolpath toolpath;
  toolpath.layers = {{0.2, 0.2, {}}};
  double x = 0.0;
  for (const auto& [length_mm, feed] : {std::pair(40.0, first_mm_s), std::pair(120.0, second_mm_s)}) {
    Path path;
    path.points = {{x, 0, 0.2}, {x + length_mm, 0, 0.2}};
    path.bead = kDepositedBead;
    path.feed_mm_s = feed;
    toolpath.layers[0].paths.push_back(path);
    x += length_mm;
  }
  return toolpath;
}

MotionLimits atOnce() {
  MotionLimits limits;
  limits.acceleration_mm_s2 = 1e8;
  return limits;
}

FlowSettings lagging(double lag_s, double dead_time_s = 0.0) {
  FlowSettings settings;
  settings.lag_s = lag_s;
  settings.dead_time_s = dead_time_s;
  return settings;
}

struct DepositedPlace {
  double time_s;
  double x_mm;
  double speed_mm_s;
  double error;  ///< of the bead's section, relative
};

/// What a nozzle lays that follows by a lag of 0.1 s what is pushed that long before.
std::vector<DepositedPlace> simulated(const Toolpath& toolpath, const MotionLimits& limits,
                                      double dead_time_s = 0.0) {
  const double lag_s = 0.1;
  const double step_s = 2e-5;
  const std::size_t delay = static_cast<std::size_t>(std::llround(dead_time_s / step_s));
  const double wanted = crossSection(kDepositedBead);
  std::vector<double> pushed;
  std::vector<DepositedPlace> places;
  double flow = 0.0;
  ToolpathPlayer player(toolpath, limits);
  for (std::size_t i = 0; !player.isFinished(); ++i) {
    const double time_s = (static_cast<double>(i) + 0.5) * step_s;
    const NozzleSample sample = player.at(time_s);
    const Path& path = toolpath.layers[0].paths[sample.heading_for.path];
    pushed.push_back(crossSection(path.bead.at(sample.heading_for.waypoint)) * sample.speed_mm_s);
    const double arriving = i >= delay ? pushed[i - delay] : 0.0;
    flow += step_s / lag_s * (arriving - flow);
    if (sample.speed_mm_s > 1.0)
      places.push_back(
          {time_s, sample.position.x(), sample.speed_mm_s, flow / sample.speed_mm_s / wanted - 1.0});
  }
  return places;
}

double errorAt(const std::vector<DepositedPlace>& places, double time_s) {
  const auto later = [](const DepositedPlace& place, double time) { return place.time_s < time; };
  return std::lower_bound(places.begin(), places.end(), time_s, later)->error;
}

double worstBetween(const std::vector<DepositedPlace>& places, double from_mm, double to_mm) {
  double worst = 0.0;
  for (const DepositedPlace& place : places)
    if (place.x_mm > from_mm && place.x_mm < to_mm) worst = std::max(worst, std::abs(place.error));
  return worst;
}

TEST(FeedForwardLag, IsTwoThirdsOfABeadWithout) {
  const std::vector<DepositedPlace> places = simulated(speedStep(), atOnce());
  // The step is at 2 s; by then the start is forgotten but for exp(-20).
  EXPECT_NEAR(errorAt(places, 2.0005), -2.0 / 3.0, 0.01);
  for (int i = 1; i <= 99; ++i) {
    const double after_s = 0.02 * i;
    EXPECT_NEAR(errorAt(places, 2.0 + after_s), -2.0 / 3.0 * std::exp(-after_s / 0.1), 1e-3) << after_s;
  }
}

TEST(FeedForwardLag, IsMadeUpForWithinAHundredthOfABead) {
  const MotionLimits limits;
  Toolpath toolpath = speedStep();
  EXPECT_GT(worstBetween(simulated(toolpath, limits), 40.0, 150.0), 0.5);
  const FeedForward result = feedForward(toolpath, lagging(0.1), limits, 1.0);
  validate(toolpath);
  EXPECT_EQ(result.runs, 1U) << "paths that join are one run";
  const std::vector<DepositedPlace> places = simulated(toolpath, limits);
  // All along, but for where none can be pulled back, which is reported: braking from 60 mm/s takes 1.2 mm.
  // The nozzle is filled in the shortest pieces there are, of 0.02 mm.
  EXPECT_NEAR(result.unmet_mm, 60.0 * 60.0 / 2.0 / 1500.0, 0.01);
  EXPECT_LT(worstBetween(places, 0.06, 160.0 - result.unmet_mm), 0.01);
}

/// A piece of the run, what leaves the nozzle as it begins and ends, as a share of what is planned.
struct DepositedPiece {
  double from_mm;
  double to_mm;
  double share_from;
  double share_to;

  double length() const { return to_mm - from_mm; }
};

/// What a nozzle that lags by 0.1 s lays in a run whose speeds change at once, in closed form: along a piece
/// of one section S at a speed v, q tends to S v as exp(-t / 0.1 s). In between it lies between its ends.
std::vector<DepositedPiece> depositedAtOnce(const Toolpath& toolpath) {
  std::vector<DepositedPiece> pieces;
  double flow = 0.0;
  for (const Path& path : toolpath.layers[0].paths) {
    const double speed_mm_s = path.feed_mm_s.at(0);
    const double planned = crossSection(kDepositedBead) * speed_mm_s;
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const double from_mm = path.points[m].x();
      const double to_mm = path.points[m + 1].x();
      const double before = flow;
      const double pushed = crossSection(path.bead.at(m + 1)) * speed_mm_s;
      flow = pushed + (before - pushed) * std::exp(-(to_mm - from_mm) / speed_mm_s / 0.1);
      pieces.push_back({from_mm, to_mm, before / planned, flow / planned});
    }
  }
  return pieces;
}

// An impulse fills the store at a jump. It is pushed along one piece, of 0.02 mm or 0.5 ms, 0.03 mm at 60
// mm/s: there alone the bead is not within a hundredth.
TEST(FeedForwardLag, IsMadeUpForAtAStepOfSpeed) {
  Toolpath toolpath = speedStep();
  feedForward(toolpath, lagging(0.1), atOnce(), 1.0);
  validate(toolpath);
  const std::vector<DepositedPiece> pieces = depositedAtOnce(toolpath);
  ASSERT_EQ(pieces.size(), 5U) << "each path's first piece and the rest, and one at the end";
  for (const std::size_t filled : {0U, 2U}) {
    EXPECT_LT(pieces[filled].length(), 0.031);
    EXPECT_NEAR(pieces[filled].share_to, 1.0, 0.01) << filled;
    EXPECT_NEAR(pieces[filled + 1].share_to, 1.0, 0.01) << filled;
  }
  EXPECT_NEAR(pieces[2].from_mm, 40.0, 1e-9);
  EXPECT_NEAR(pieces[2].share_from, 1.0 / 3.0, 0.01);
  EXPECT_LT(pieces[4].length(), 0.031);
}

TEST(FeedForwardLag, LeavesNoStoreToBePulledBackFromAShortPieceOnly) {
  Toolpath toolpath = speedStep(60.0, 20.0);
  const FeedForward result = feedForward(toolpath, lagging(0.1), atOnce(), 1.0);
  validate(toolpath);
  // 40 of 60 mm/s are to leave the store at 40 mm, 20 mm/s at the end, each within 0.03 mm.
  const double stored = 0.1 * 60.0 * crossSection(kDepositedBead);
  EXPECT_NEAR(result.unmet_mm3, stored, 0.01 * stored);
  EXPECT_LT(result.unmet_mm, 0.07);
  const std::vector<DepositedPiece> pieces = depositedAtOnce(toolpath);
  ASSERT_EQ(pieces.size(), 5U) << "one at the start and before each slower speed, and what lies between";
  EXPECT_NEAR(pieces[0].share_to, 1.0, 0.01);
  EXPECT_NEAR(pieces[1].share_to, 1.0, 0.01);
  EXPECT_NEAR(pieces[1].to_mm, 40.0, 0.031);
}

// From 20 to 21 mm/s at 1500 mm/s² takes 0.014 mm, less than a piece.
TEST(FeedForwardLag, IsMadeUpForAtAChangeShorterThanAPiece) {
  Toolpath toolpath = speedStep(20.0, 21.0);
  feedForward(toolpath, lagging(0.1), MotionLimits(), 1.0);
  const std::vector<DepositedPlace> places = simulated(toolpath, MotionLimits());
  EXPECT_LT(worstBetween(places, 39.0, 40.0), 1e-3);
  EXPECT_LT(worstBetween(places, 40.05, 159.8), 1e-3);
}

TEST(FeedForwardLag, IsMadeUpForWithADeadTime) {
  const MotionLimits limits;
  Toolpath toolpath = speedStep();
  feedForward(toolpath, lagging(0.1, 0.05), limits, 1.0);
  validate(toolpath);
  const std::vector<DepositedPlace> places = simulated(toolpath, limits, 0.05);
  // Nothing arrives within the first 0.05 s, 1 mm; what was late in filling the nozzle is deposited on top
  // then.
  EXPECT_LT(worstBetween(places, 1.05, 158.7), 0.04);
  EXPECT_LT(worstBetween(places, 4.0, 158.7), 0.01);
}

TEST(FeedForwardLag, PushesMoreByWhatIsStored) {
  Toolpath toolpath = speedStep();
  const double planned = totals(toolpath).deposited_mm3;
  const FeedForward result = feedForward(toolpath, lagging(0.1), MotionLimits(), 1.0);
  // Braking asks for what is stored to be pulled back, and none of it can be: at 60 mm/s, all of it.
  const double stored = 0.1 * 60.0 * crossSection(kDepositedBead);
  EXPECT_NEAR(totals(toolpath).deposited_mm3, planned + result.unmet_mm3, 1e-6);
  EXPECT_NEAR(result.unmet_mm3, stored, 0.3 * stored);
  EXPECT_NEAR(result.unmet_mm, 60.0 * 60.0 / 2.0 / 1500.0, 0.1);
}

TEST(FeedForwardLag, IsClippedToTheGreatestFlow) {
  Toolpath toolpath = speedStep();
  FlowSettings settings = lagging(0.1);
  settings.greatest_mm3_s = 6.0;
  const FeedForward result = feedForward(toolpath, settings, MotionLimits(), 1.0);
  // 4.28 mm³/s at 60 mm/s, and 10.7 mm³/s more while the nozzle is accelerated by 1500 mm/s².
  EXPECT_GT(result.unmet_mm3, 0.1);
  // A piece that begins at rest holds the mean of what is pushed along it.
  ToolpathPlayer player(toolpath, MotionLimits());
  for (double time_s = 0.0; !player.isFinished(); time_s += 1e-3) {
    const NozzleSample sample = player.at(time_s);
    const Bead bead = toolpath.layers[0].paths[sample.heading_for.path].bead.at(sample.heading_for.waypoint);
    EXPECT_LT(crossSection(bead) * sample.speed_mm_s, 6.0 * 2.01) << time_s;
  }
}

TEST(FeedForwardLag, OfZeroChangesNothing) {
  Toolpath toolpath = speedStep();
  const std::string id = toolpathId(toolpath);
  EXPECT_EQ(feedForward(toolpath, lagging(0.0), MotionLimits(), 1.0).runs, 0U);
  EXPECT_EQ(toolpathId(toolpath), id);
}

}  // namespace
}  // namespace lamina
