// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/cell_findings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "lamina/base/error.hpp"
#include "recorded_cell.hpp"

namespace lamina {
namespace {

const Eigen::Isometry3d kAnywhere = Eigen::Isometry3d::Identity();

std::string whyRefused(const std::function<void()>& find) {
  try {
    find();
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(CellFindings, NameTheMethodsThatThereAre) {
  const std::string time = whyRefused([] { findTime({}, "bob", kAnywhere, {}, ""); });
  EXPECT_NE(time.find("'bob'; expected one of bobbing, edge, overlap"), std::string::npos) << time;
  EXPECT_EQ(whyRefused([] { timeMethod("bob"); }), time);
  EXPECT_EQ(timeMethod(""), "bobbing");
  EXPECT_EQ(timeMethod("overlap"), "overlap");
  const std::string place = whyRefused([] { sensorTarget("pairs", {}, {}); });
  EXPECT_NE(place.find("'pairs'; expected one of cross, bed, plane, pyramid"), std::string::npos) << place;
}

TEST(CellFindings, AreOverTheCrossWithoutAMethod) {
  EXPECT_TRUE(std::holds_alternative<CrossTarget>(sensorTarget("", {}, {})));
  EXPECT_TRUE(std::get<PlaneTarget>(sensorTarget("bed", {}, {})).is_bed);
  EXPECT_FALSE(std::get<PlaneTarget>(sensorTarget("plane", {}, {})).is_bed);
}

TEST(CellFindings, TakeAPyramidAsFarAsItIsKnown) {
  const auto unknown = std::get<PyramidTarget>(sensorTarget("pyramid", {}, {}));
  EXPECT_FALSE(unknown.is_place_known);
  EXPECT_FALSE(unknown.is_top_known);
  const KnownPyramid known{{30.0, 12.0, 8.0}, {90.0, 80.0}, {9.5}};
  const auto target = std::get<PyramidTarget>(sensorTarget("pyramid", known, {}));
  EXPECT_EQ(target.base_mm, 30.0);
  EXPECT_TRUE(target.is_place_known && target.is_top_known);
  EXPECT_EQ(target.bed_from_pyramid.translation(), Point3(90.0, 80.0, 1.5));
}

TEST(CellFindings, RefuseAPyramidThatIsNone) {
  const KnownPyramid flawed[] = {
      {{30.0, 12.0}, {}, {}}, {{12.0, 30.0, 8.0}, {}, {}}, {{}, {90.0}, {}}, {{}, {}, {1.0, 2.0}}};
  for (const KnownPyramid& pyramid : flawed)
    EXPECT_THROW(sensorTarget("pyramid", pyramid, {}), InvalidConfig);
}

TEST(CellFindings, RefuseAPyramidThatIsNotFinite) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const KnownPyramid flawed[] = {{{bad, 12.0, 8.0}, {}, {}}, {{}, {90.0, bad}, {}}, {{}, {}, {-bad}}};
    for (const KnownPyramid& pyramid : flawed) {
      const std::string why = whyRefused([&] { sensorTarget("pyramid", pyramid, {}); });
      EXPECT_NE(why.find("expected a finite one"), std::string::npos) << why;
    }
  }
}

constexpr double kKnownOffset = 0.08;  // s

test::RecordedCell lateCell() {
  test::RecordedCell cell;
  cell.offset_s = kKnownOffset;
  cell.noise_mm = 0.01;
  return cell;
}

TEST(CellFindings, TellTheTimeOffsetByBobbing) {
  const CalibrationSettings settings;
  const SensorRecording recording = test::record(lateCell(), test::bobbing(settings));
  for (const char* const method : {"", "bobbing"}) {
    const FoundTime found = findTime(recording, method, kAnywhere, settings, "2026-11-23T12:00:00Z");
    EXPECT_NEAR(found.time.offset_s, kKnownOffset, 0.001);
    EXPECT_EQ(found.time.offset_s, found.fit.offset_s);
    EXPECT_EQ(found.time.spread_s, found.fit.spread_s);
    EXPECT_EQ(found.time.scatter_s, found.fit.scatter_s);
    EXPECT_EQ(found.time.drift_s_per_min, found.fit.drift_s_per_min);
    EXPECT_EQ(found.time.origin.method, "bobbing");
    EXPECT_EQ(found.time.origin.date, "2026-11-23T12:00:00Z");
  }
}

TEST(CellFindings, TellTheTimeOffsetByAnEdge) {
  test::RecordedCell cell = lateCell();
  cell.surface = [](const Point2& at) { return at.y() + 0.2 * (at.x() - 100.0) > 0.0 ? 0.5 : 0.0; };
  std::vector<test::LinearMotion::Way> ways;
  for (int i = 0; i < 4; ++i) ways.push_back({{75.0, i % 2 == 0 ? 20.0 : -20.0, 2.0}, 20.0});
  const SensorRecording recording = test::record(cell, {{75.0, -20.0, 2.0}, ways});
  const FoundTime found = findTime(recording, "edge", test::nominalSensor(), {}, "");
  EXPECT_NEAR(found.time.offset_s, kKnownOffset, 0.001);
  EXPECT_EQ(found.time.origin.method, "edge");
}

/// A head that nods and sways over a level bed.
Eigen::Isometry3d rockingHead(double time_s) {
  const double nod = 0.25 * std::sin(1.3 * time_s);
  const double sway = 0.25 * std::sin(0.9 * time_s + 1.0);
  return test::nozzleAt({100.0, 100.0, 12.0 + 6.0 * std::sin(0.4 * time_s)}) *
         Eigen::AngleAxisd(nod, Point3::UnitX()) * Eigen::AngleAxisd(sway, Point3::UnitY());
}

TEST(CellFindings, TellThePlaceOfASensorThatIsLate) {
  test::RecordedCell cell = lateCell();
  cell.nozzle_from_sensor.translation() += Point3(1.5, -1.0, 0.8);
  const SensorRecording recording = test::record(cell, rockingHead, 20.0);
  const CalibrationSettings settings;
  const FoundPose found = findPose({{sensorTarget("bed", {}, settings), recording}}, test::nominalSensor(),
                                   kKnownOffset, settings, {"bed", "2026-11-23T12:00:00Z"});
  EXPECT_EQ(found.pose.not_found, "");
  EXPECT_TRUE(found.not_observable.empty());
  const Point3 off = found.pose.nozzle_from_sensor.translation() - cell.nozzle_from_sensor.translation();
  EXPECT_LT(off.norm(), 0.05);
  EXPECT_EQ(found.pose.spread.size(), 6U);
  EXPECT_EQ(found.pose.origin.method, "bed");
  const FoundPose without_offset = findPose({{sensorTarget("bed", {}, settings), recording}},
                                            test::nominalSensor(), 0.0, settings, {"bed", ""});
  EXPECT_GT(without_offset.fit.rms_mm, 5.0 * found.fit.rms_mm) << "the offset counts";
}

/// A head at rest: what is seen says nothing, and must not replace what was found before.
TEST(CellFindings, RefuseAPlaceOfWhichNothingIsFound) {
  const test::RecordedCell cell = lateCell();
  const auto at_rest = [](double) { return test::nozzleAt({100.0, 100.0, 12.0}); };
  const SensorRecording recording = test::record(cell, at_rest, 5.0);
  const CalibrationSettings settings;
  const std::string why = whyRefused([&] {
    findPose({{sensorTarget("plane", {}, settings), recording}}, test::nominalSensor(), kKnownOffset,
             settings, {"plane", "2026-11-23T12:00:00Z"});
  });
  EXPECT_NE(why.find("none of the six directions"), std::string::npos) << why;
  EXPECT_NE(why.find("0.05 mm or 0.05 deg"), std::string::npos) << why;
}

/// The bare bed, seen from a head that does not tilt: nothing is found of x, y and the turn about z.
TEST(CellFindings, KnowWhatTheyKeepAsWellAsItWasKnown) {
  FoundPose found;
  found.fit.is_kept = {true, true, false, false, false, true};
  found.pose.spread = {0.0, 0.0, 0.002, 0.01, 0.02, 0.0};
  found.pose.not_found = "x, y, turn about z";
  EXPECT_EQ(withFormer(found, std::nullopt).not_found, "x, y, turn about z");
  CalibratedPose cross;
  cross.spread = {0.03, 0.04, 0.05, 0.3, 0.3, 0.0};
  const CalibratedPose both = withFormer(found, cross);
  EXPECT_EQ(both.spread, std::vector<double>({0.03, 0.04, 0.002, 0.01, 0.02, 0.0}));
  EXPECT_EQ(both.not_found, "turn about z");
}

TEST(CellFindings, TellTheDeadTimeOfAFeeder) {
  constexpr double kDead = 0.6;
  const CalibrationSettings settings;
  const FeederSteps steps = feederSteps(settings);
  test::RecordedCell cell = lateCell();
  cell.points = 281;
  cell.profile_s = 0.02;
  cell.surface = [&](const Point2& at) {
    for (const CalibrationBead& bead : steps.beads) {
      const double length = (bead.end - bead.start).norm();
      const double place = (at - bead.start).dot(bead.end - bead.start) / length;
      const double aside = std::abs(at.x() - bead.start.x()) / 0.5;
      if (aside >= 1.0 || place < 0.0 || place >= length) continue;
      const double commanded = std::max(0.0, place - kDead * settings.feeder_mm_s);
      const auto piece =
          static_cast<std::size_t>(commanded / length * static_cast<double>(steps.amount.size()));
      return 0.4 * steps.amount[piece] * (1.0 - aside * aside);
    }
    return 0.0;
  };
  const test::LinearMotion motion({75.0, 20.0, 2.0}, {{{75.0, 180.0, 2.0}, 20.0}});
  const FoundFeeder found = findFeeder(test::record(cell, motion), test::nominalSensor(), kKnownOffset,
                                       settings, "2026-11-23T12:00:00Z");
  EXPECT_NEAR(found.feeder.dead_time_s, kDead, 0.04);
  EXPECT_NEAR(found.feeder.lag_s, 0.0, 0.04);
  EXPECT_EQ(found.feeder.origin.method, "bead");
  EXPECT_EQ(found.feeder.dead_time_spread_s, found.fit.dead_time_spread_s);
}

TEST(CellFindings, TakeTheTimeOffsetOfACalibration) {
  Calibration cell;
  EXPECT_EQ(timeOffsetOf(cell), 0.0);
  cell.time = CalibratedTime{kKnownOffset, 1e-4, 0.0, 0.0, {}};
  EXPECT_EQ(timeOffsetOf(cell), kKnownOffset);
}

TEST(CellFindings, AreStatedInWords) {
  FoundTime time;
  time.fit.offset_s = 0.0805;
  time.fit.spread_s = 0.00025;
  time.fit.profiles = 1200;
  time.time.origin.method = "overlap";
  const std::vector<std::string> of_time = inWords(time);
  ASSERT_EQ(of_time.size(), 4U);
  EXPECT_EQ(of_time[0], "time offset 80.500 ms by overlap: true time is the stamp less that");
  EXPECT_NE(of_time[2].find("over 1200 profiles"), std::string::npos) << of_time[2];
  EXPECT_EQ(of_time[3].rfind("caution", 0), 0U) << of_time[3];
  time.fit.is_skew_separable = true;
  EXPECT_EQ(inWords(time).size(), 3U);

  FoundPose pose;
  pose.pose.nozzle_from_sensor = test::nominalSensor();
  pose.pose.origin.method = "bed";
  pose.not_observable = {"x: moves nothing"};
  const std::vector<std::string> of_pose = inWords(pose);
  ASSERT_EQ(of_pose.size(), 4U);
  EXPECT_EQ(of_pose[0], "sensor      at 25.000, 0.000, -60.000 mm of the nozzle, by bed");
  EXPECT_EQ(of_pose[3], "kept        x: moves nothing");

  FoundFeeder feeder;
  feeder.fit.dead_time_s = 0.25;
  feeder.fit.dead_time_spread_s = 0.01;
  feeder.fit.rms = 0.05;
  feeder.fit.sections = 300;
  const std::vector<std::string> of_feeder = inWords(feeder);
  ASSERT_EQ(of_feeder.size(), 4U);
  EXPECT_EQ(of_feeder[0], "dead time   0.250 s, spread 0.010 s");
  EXPECT_EQ(of_feeder[2].rfind("sections    300, 5.00 % rms off", 0), 0U) << of_feeder[2];
}

}  // namespace
}  // namespace lamina
