// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/time_offset.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lamina/base/error.hpp"
#include "recorded_cell.hpp"

namespace lamina {
namespace {

using test::bobbing;

constexpr double kOffsets[] = {-0.25, -0.0317, 0.0, 0.08, 0.1234, 0.5};
constexpr double kFewOffsets[] = {-0.25, 0.0317, 0.5};  // by passes, a search takes seconds

test::RecordedCell spoilt(double offset_s, std::uint64_t seed) {
  test::RecordedCell cell;
  cell.offset_s = offset_s;
  cell.jitter_s = 0.002;
  cell.noise_mm = 0.02;
  cell.seed = seed;
  return cell;
}

/// There and back along y over the middle of the sensor's sight.
test::LinearMotion thereAndBack(int passes, double half_mm, double speed_mm_s) {
  std::vector<test::LinearMotion::Way> ways;
  for (int i = 0; i < passes; ++i) ways.push_back({{75.0, i % 2 == 0 ? half_mm : -half_mm, 2.0}, speed_mm_s});
  return {{75.0, -half_mm, 2.0}, ways};
}

/// Swaths along y, each to the right of the one before.
test::LinearMotion swaths(int count, double half_mm, double pitch_mm, double speed_mm_s) {
  std::vector<test::LinearMotion::Way> ways;
  for (int i = 0; i < count; ++i) {
    const double x = 60.0 + i * pitch_mm;
    const double sense = i % 2 == 0 ? 1.0 : -1.0;
    if (i > 0) ways.push_back({{x, -sense * half_mm, 2.0}, speed_mm_s});
    ways.push_back({{x, sense * half_mm, 2.0}, speed_mm_s});
  }
  return {{60.0, -half_mm, 2.0}, ways};
}

/// Beads and lumps, the same nowhere.
double relief(const Point2& at) {
  return 0.3 + 0.1 * std::sin(1.7 * at.y() + 0.3 * at.x()) + 0.15 * std::sin(0.31 * at.y() - 0.2 * at.x()) +
         0.05 * std::cos(0.9 * at.x());
}

TEST(TimeOffset, IsFoundByBobbing) {
  CalibrationSettings settings;
  for (const double offset : kOffsets) {
    const test::LinearMotion motion = bobbing(settings);
    const TimeOffset found = offsetByBobbing(test::record(spoilt(offset, 7), motion), 0.6);
    EXPECT_NEAR(found.offset_s, offset, 0.001);
    EXPECT_LT(found.spread_s, 0.0005);
    EXPECT_NEAR(found.offset_s, offset, 5.0 * found.spread_s + 1e-4);
    EXPECT_EQ(found.pieces_s.size(), 10u);
    EXPECT_LT(found.scatter_s, 0.001);
  }
}

TEST(TimeOffset, ByBobbingNeedsNoPoseOfTheSensor) {
  test::RecordedCell cell = spoilt(0.1, 3);
  cell.nozzle_from_sensor.rotate(Eigen::AngleAxisd(0.1, Point3(1, 2, 3).normalized()));
  const TimeOffset found = offsetByBobbing(test::record(cell, bobbing({})), 0.6);
  EXPECT_NEAR(found.offset_s, 0.1, 0.001);
}

TEST(TimeOffset, ByBobbingIsFoundWithoutThePointsThatTheSensorMissed) {
  SensorRecording recording = test::record(spoilt(0.1, 3), bobbing({}));
  std::size_t every_ninth = 0;
  for (RecordedProfile& profile : recording.profiles)
    for (Point3& point : profile.points)
      if (++every_ninth % 9 == 0 && every_ninth % 4000 < 2000) point.setZero();
  recording.profiles = profilesFromCsv(toCsv(recording.profiles), "profiles.csv");
  EXPECT_NEAR(offsetByBobbing(recording, 0.6).offset_s, 0.1, 0.001);
}

/// Nothing is taken to lie straight over what is missing.
TEST(TimeOffset, ByBobbingIsFoundBesideGaps) {
  const SensorRecording whole = test::record(spoilt(0.1, 3), bobbing({}));
  const double begin_s = whole.profiles.front().time_s;
  const auto without = [&](double from_s, double to_s) {
    SensorRecording recording = whole;
    auto& profiles = recording.profiles;
    profiles.erase(std::remove_if(profiles.begin(), profiles.end(),
                                  [&](const RecordedProfile& profile) {
                                    const double time_s = profile.time_s - begin_s;
                                    return time_s > from_s && time_s < to_s;
                                  }),
                   profiles.end());
    return recording;
  };
  for (const double length_s : {0.1, 0.3, 2.0}) {
    const TimeOffset found = offsetByBobbing(without(5.0, 5.0 + length_s), 0.6);
    EXPECT_NEAR(found.offset_s, 0.1, 0.0005) << length_s;
    EXPECT_LT(found.spread_s, 0.0005) << length_s;
  }
  try {
    offsetByBobbing(without(1.5, 8.5), 0.6);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("gaps"), std::string::npos) << error.what();
  }
}

TEST(TimeOffset, ByBobbingIsFoundBesideProfilesOfOtherTimes) {
  SensorRecording recording = test::record(spoilt(0.1, 3), bobbing({}));
  const std::size_t profiles = recording.profiles.size();
  recording.profiles.insert(recording.profiles.begin(), {0.0, {Point3(0, 0, 60)}});
  recording.profiles.push_back({9e8, {Point3(0, 0, 60)}});
  const TimeOffset found = offsetByBobbing(recording, 0.6);
  EXPECT_NEAR(found.offset_s, 0.1, 0.001);
  EXPECT_EQ(found.profiles, profiles);
  try {
    offsetByBobbing({recording.poses, {recording.profiles.back()}}, 0.6);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("one clock"), std::string::npos) << error.what();
  }
}

TEST(TimeOffset, ByBobbingIsRefusedInAnotherUnit) {
  for (const double unit : {1e-3, 1e3}) {
    SensorRecording recording = test::record(spoilt(0.1, 3), bobbing({}));
    for (RecordedProfile& profile : recording.profiles)
      for (Point3& point : profile.points) point *= unit;
    try {
      offsetByBobbing(recording, 0.6);
      FAIL() << unit;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find("are the clouds in metres"), std::string::npos)
          << error.what();
    }
  }
}

TEST(TimeOffset, ThatDriftsIsReportedAsDrift) {
  SensorRecording recording = test::record(spoilt(0.0, 5), bobbing({}));
  for (RecordedProfile& profile : recording.profiles)
    profile.time_s += 0.1 + 0.001 * (profile.time_s - 1000.0);  // 60 ms per minute
  const TimeOffset found = offsetByBobbing(recording, 0.6);
  EXPECT_NEAR(found.drift_s_per_min, 0.06, 0.01);
}

TEST(TimeOffset, OfMotionThatRepeatsItselfIsRefused) {
  CalibrationSettings settings;
  settings.bob_low_hz = settings.bob_high_hz = 4.0;
  try {
    offsetByBobbing(test::record(spoilt(0.1, 2), bobbing(settings)), 0.6);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("repeats itself"), std::string::npos) << error.what();
  }
}

TEST(TimeOffset, IsRefusedWhereNothingShowsIt) {
  const SensorRecording recording = test::record(spoilt(0.1, 2), bobbing({}));
  EXPECT_THROW(offsetByBobbing({recording.poses, {}}, 0.6), InvalidInput);
  EXPECT_THROW(offsetByBobbing({{}, recording.profiles}, 0.6), InvalidInput);
  EXPECT_THROW(offsetByBobbing(recording, 0.05), InvalidInput);  // beyond the search
  const SensorRecording still = test::record(spoilt(0.1, 2), thereAndBack(2, 50.0, 20.0));
  EXPECT_THROW(offsetByBobbing(still, 0.6), InvalidInput);
  SensorRecording apart = recording;
  for (RecordedProfile& profile : apart.profiles) profile.time_s += 1e9;
  EXPECT_THROW(offsetByBobbing(apart, 0.6), InvalidInput);
}

TEST(TimeOffset, IsFoundByAnEdgeThereAndBack) {
  for (const double offset : kFewOffsets) {
    test::RecordedCell cell = spoilt(offset, 11);
    cell.surface = [](const Point2& at) { return at.y() + 0.2 * (at.x() - 100.0) > 0.0 ? 0.5 : 0.0; };
    PassComparison comparison;
    comparison.nozzle_from_sensor = test::nominalSensor();
    const TimeOffset found = offsetByPasses(test::record(cell, thereAndBack(8, 20.0, 20.0)), comparison);
    EXPECT_NEAR(found.offset_s, offset, 0.001);
    EXPECT_EQ(found.pieces_s.size(), 7u);
    EXPECT_LT(found.spread_s, 0.001);
    EXPECT_TRUE(found.is_skew_separable);
  }
}

TEST(TimeOffset, IsFoundByTheOverlapOfSwaths) {
  for (const double offset : kFewOffsets) {
    test::RecordedCell cell = spoilt(offset, 13);
    cell.surface = relief;
    PassComparison comparison;
    comparison.nozzle_from_sensor = test::nominalSensor();
    const SensorRecording recording = test::record(cell, swaths(5, 60.0, 28.0 * 0.95, 40.0));
    const TimeOffset found = offsetByPasses(recording, comparison);
    EXPECT_NEAR(found.offset_s, offset, 0.002);
    EXPECT_EQ(found.pieces_s.size(), 4u);
  }
}

TEST(TimeOffset, ByOverlapIsFreeOfATurnedLine) {
  test::RecordedCell cell = spoilt(0.08, 17);
  cell.surface = relief;
  cell.nozzle_from_sensor.rotate(Eigen::AngleAxisd(0.01, Point3::UnitZ()));
  PassComparison comparison;
  comparison.nozzle_from_sensor = test::nominalSensor();
  const TimeOffset found = offsetByPasses(test::record(cell, swaths(5, 60.0, 28.0 * 0.95, 40.0)), comparison);
  EXPECT_NEAR(found.offset_s, 0.08, 0.002);
  EXPECT_NEAR(std::abs(found.skew_deg), 0.01 * 180.0 / M_PI, 0.1);
  EXPECT_TRUE(found.is_skew_separable);
}

TEST(TimeOffset, ByPassesIsRefusedOnEvenGround) {
  PassComparison comparison;
  comparison.nozzle_from_sensor = test::nominalSensor();
  EXPECT_THROW(offsetByPasses(test::record(spoilt(0.1, 1), thereAndBack(4, 20.0, 20.0)), comparison),
               InvalidInput);
  EXPECT_THROW(offsetByPasses(test::record(spoilt(0.1, 1), bobbing({})), comparison), InvalidInput);
}

TEST(TimeOffset, IsFoundOrRefusedWhateverIsRecorded) {
  EXPECT_TRUE(rc::check("numbers of any size", [] {
    SensorRecording recording;
    double time = *rc::gen::element(0.0, 1e9, -1e300, 1e17);
    const int count = *rc::gen::inRange(0, 30);
    for (int i = 0; i < count; ++i) {
      time += *rc::gen::element(0.0, 0.001, 1.0, 1e12);
      recording.poses.push_back({time, test::nozzleAt({*rc::gen::element(0.0, 5.0, 1e300), 1.0 * i, 2.0})});
      recording.profiles.push_back({time + *rc::gen::element(0.0, 0.1, -1e15),
                                    std::vector<Point3>(static_cast<std::size_t>(*rc::gen::inRange(0, 4)),
                                                        Point3(*rc::gen::element(0.0, -1e300), 0.0, 60.0))});
    }
    const auto tried = [&](auto&& find) {
      try {
        RC_ASSERT(std::isfinite(find().offset_s));
      } catch (const InvalidInput&) {
      }
    };
    tried([&] { return offsetByBobbing(recording, 0.6); });
    tried([&] { return offsetByPasses(recording, {}); });
  }));
}

}  // namespace
}  // namespace lamina
