// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/profile_reading.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <limits>

#include "lamina/base/random.hpp"
#include "lamina/control/height_loop.hpp"
#include "support/control_layers.hpp"
#include "support/measured_layers.hpp"

namespace lamina {
namespace {

constexpr Bead kWireBead{3.0, 1.5};
constexpr double kNoise = 0.02;
constexpr double kCorrelation = 0.2;
constexpr std::size_t kBeads = 4;

/// What is wrong with a sensor.
struct SensorFaults {
  double spray = 0.0;
  double mirrors = 0.0;
  double dropouts = 0.0;
};

/// Height errors of each bead, by way, and a sensor that is not ideal.
struct Scene {
  test::MeasuredLayer measured = test::inclinedLayer(0.0, kBeads, kWireBead);
  std::function<double(std::size_t, double)> error = [](std::size_t, double) { return 0.0; };
  double noise_mm = 0.0;
  SensorFaults faults;
};

/// A profile across all beads, points 0.1 mm apart; errors of the points of one bead correlate.
SensorProfile profileAt(const Scene& scene, double way, Random& random) {
  const test::MeasuredLayer& measured = scene.measured;
  SensorProfile profile;
  profile.toolpath_from_sensor = test::sensorOver(measured, kBeads / 2, way);
  const Eigen::Isometry3d sensor_from_toolpath = profile.toolpath_from_sensor.inverse();
  for (std::size_t bead = 0; bead < kBeads; ++bead) {
    const double common = std::sqrt(kCorrelation) * random.normal(0.0, 1.0);
    for (int k = -14; k <= 14; ++k) {
      const double noise = common + std::sqrt(1.0 - kCorrelation) * random.normal(0.0, 1.0);
      const double error = scene.error(bead, way) + scene.noise_mm * noise;
      Point3 point = sensor_from_toolpath * measured.place(bead, way, 0.1 * k, error);
      if (random.uniform(0.0, 1.0) < scene.faults.dropouts) continue;
      if (random.uniform(0.0, 1.0) < scene.faults.spray)
        point *= 1.0 + (random.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0) * random.uniform(0.5, 5.0) / 60.0;
      profile.points.push_back(point);
      if (random.uniform(0.0, 1.0) < scene.faults.mirrors)
        profile.points.push_back(point * (1.0 + random.uniform(2.0, 6.0) / 60.0));
    }
  }
  return profile;
}

CellAtlas atlasOver(const test::MeasuredLayer& measured) {
  CellAtlas atlas;
  atlas.add(std::make_shared<const LayerCells>(test::cellsOf(measured)));
  return atlas;
}

void expectEqual(const ProfileReadings& a, const ProfileReadings& b) {
  ASSERT_EQ(a.readings.size(), b.readings.size());
  for (std::size_t i = 0; i < a.readings.size(); ++i) {
    EXPECT_EQ(a.readings[i].layer, b.readings[i].layer);
    EXPECT_EQ(a.readings[i].cell, b.readings[i].cell);
    EXPECT_EQ(a.readings[i].reading.points, b.readings[i].reading.points);
    EXPECT_EQ(a.readings[i].reading.error_mm, b.readings[i].reading.error_mm);
    EXPECT_EQ(a.readings[i].reading.sigma_mm, b.readings[i].reading.sigma_mm);
  }
}

TEST(ReadProfile, IsExactWithoutNoiseOnLayersOfAnyShape) {
  for (const test::MeasuredLayer& measured : test::measuredLayers(kBeads, kWireBead)) {
    Scene scene;
    scene.measured = measured;
    scene.error = [](std::size_t bead, double) { return 0.1 * double(bead) - 0.2; };
    const CellAtlas atlas = atlasOver(measured);
    Random random(1);
    const ProfileReadings read = readProfile(profileAt(scene, 0.31, random), atlas, {}, {});
    ASSERT_EQ(read.readings.size(), kBeads) << measured.name;
    // The sphere falls off beside the middle of a bead: by a third of (0.5 mm)² / 100 mm in the mean.
    const double round = measured.name == "sphere" ? 0.001 : 1e-6;
    for (std::size_t bead = 0; bead < kBeads; ++bead) {
      EXPECT_NEAR(read.readings[bead].reading.error_mm, scene.error(bead, 0.0), round) << measured.name;
      EXPECT_GE(read.readings[bead].reading.points, 9) << "a third of 29, but for rounding";
      EXPECT_LE(read.readings[bead].reading.points, 11);
    }
    EXPECT_EQ(read.counts.accounted(), read.counts.received);
  }
}

/// What the estimate of each cell is off after one profile over it, and how surprised it is.
struct Trial {
  double mean_off = 0.0;
  double surprise = 0.0;
};

Trial tried(Scene scene, std::size_t profiles_per_cell) {
  Random random(7);
  const CellAtlas atlas = atlasOver(scene.measured);
  const LayerCells& cells = *atlas.cellsOf(0);
  const double spread = 0.02;
  std::vector<CellEstimate> estimates(cells.size(), CellEstimate(0.0, 1e-6, 1.0));
  std::vector<double> truth;
  for (CellEstimate& estimate : estimates) {
    estimate.lay({kWireBead.height_mm, 0.0, 0.0}, spread);
    truth.push_back(random.normal(0.0, spread * kWireBead.height_mm));
  }
  std::vector<bool> is_read(cells.size());
  Trial trial;
  double readings = 0.0;
  const std::size_t count = cells.runs[0].count;
  scene.error = [&](std::size_t bead, double way) {
    const CellRun& run = cells.runs[bead];
    return truth[run.first + static_cast<std::size_t>(way * static_cast<double>(run.count))];
  };
  for (std::size_t i = 0; i < count * profiles_per_cell; ++i) {
    const double way = (double(i) + 0.5) / double(count * profiles_per_cell);
    const auto read = readProfile(profileAt(scene, way, random), atlas, {{0, &estimates}}, {});
    for (const LayerReading& one : read.readings) {
      trial.surprise += estimates[one.cell].see(one.reading, kCorrelation).surprise;
      is_read[one.cell] = true;
      readings += 1.0;
    }
  }
  double off = 0.0;
  double seen = 0.0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!is_read[c]) continue;
    off += std::abs(estimates[c].error() - truth[c]);
    seen += 1.0;
  }
  EXPECT_GT(seen, 0.6 * double(cells.size()));
  return {off / seen, trial.surprise / readings};
}

TEST(ReadProfile, IsWithinHalfTheNoise) {
  for (const test::MeasuredLayer& measured : test::measuredLayers(kBeads, kWireBead)) {
    Scene scene;
    scene.measured = measured;
    scene.noise_mm = kNoise;
    const Trial trial = tried(scene, 1);
    EXPECT_LE(trial.mean_off, 0.5 * kNoise) << measured.name;
    EXPECT_GT(trial.surprise, 0.8) << measured.name;
    EXPECT_LT(trial.surprise, 1.25) << measured.name;
  }
}

TEST(ReadProfile, IsHardlyWorseWithSprayMirrorsAndDropouts) {
  for (const test::MeasuredLayer& measured : test::measuredLayers(kBeads, kWireBead)) {
    Scene scene;
    scene.measured = measured;
    scene.noise_mm = kNoise;
    scene.faults = {0.02, 0.005, 0.10};
    EXPECT_LE(tried(scene, 1).mean_off, 0.6 * kNoise) << measured.name;
  }
}

/// What a loop knows of a layer's errors once it was scanned.
std::vector<double> known(const Scene& scene, HeightLoop& loop, std::size_t profiles, double from = 0.0,
                          double to = 1.0) {
  Random random(9);
  CellAtlas atlas;
  atlas.add(std::make_shared<const LayerCells>(loop.cells()));
  for (std::size_t i = 0; i < profiles; ++i) {
    const double way = from + (to - from) * (double(i) + 0.5) / double(profiles);
    const auto read = readProfile(profileAt(scene, way, random), atlas, {{0, &loop.estimates()}}, {});
    EXPECT_EQ(read.counts.accounted(), read.counts.received);
    for (const LayerReading& one : read.readings) loop.see(one.cell, one.reading);
    loop.endCloud();
  }
  return loop.knowledge().error_mm;
}

HeightLoop loopOver(const test::MeasuredLayer& measured) {
  HeightLoop loop(LoopSettings{}, measured.normal);
  loop.beginLayer(test::cellsOf(measured));
  loop.lay(loop.correction(LoopState::Identifying));
  return loop;
}

TEST(ReadProfile, MovesNoMapByOutliers) {
  for (const test::MeasuredLayer& measured : test::measuredLayers(kBeads, kWireBead)) {
    Scene clean;
    clean.measured = measured;
    clean.noise_mm = kNoise;
    Scene faulty = clean;
    faulty.faults = {0.02, 0.005, 0.10};
    HeightLoop with = loopOver(measured);
    HeightLoop without = loopOver(measured);
    const auto cells = test::cellsOf(measured).runs[0].count;
    const auto a = known(clean, without, 3 * cells);
    const auto b = known(faulty, with, 3 * cells);
    for (std::size_t c = 0; c < a.size(); ++c) EXPECT_NEAR(a[c], b[c], 0.1 * kWireBead.height_mm);
  }
}

TEST(ReadProfile, LetsALumpBeBelievedWithinThreeProfiles) {
  for (const test::MeasuredLayer& measured : test::measuredLayers(kBeads, kWireBead)) {
    Scene scene;
    scene.measured = measured;
    scene.noise_mm = kNoise;
    HeightLoop loop = loopOver(measured);
    const auto cells = double(test::cellsOf(measured).runs[1].count);
    const std::size_t seen = loop.cells().runs[1].first + std::size_t(0.5 * cells);
    // One layer too high, over the width of a bead.
    const double half = 0.5 * kWireBead.width_mm / loop.cells().runs[1].length_mm;
    scene.error = [half](std::size_t bead, double way) {
      return bead == 1 && std::abs(way - 0.5) < half ? -kWireBead.height_mm : 0.0;
    };
    const double first = (std::floor(0.5 * cells) + 0.2) / cells;
    const auto error = known(scene, loop, 3, first, first + 0.5 / cells);
    EXPECT_NEAR(error[seen], -kWireBead.height_mm, 0.05) << measured.name;
  }
}

TEST(ReadProfile, CountsEachPointUnderTheCauseThatKeptIt) {
  const test::MeasuredLayer measured = test::inclinedLayer(0.0, 1, kWireBead);
  const CellAtlas atlas = atlasOver(measured);
  SensorProfile profile;
  profile.toolpath_from_sensor = test::sensorOver(measured, 0, 0.5);
  const double none = std::numeric_limits<double>::quiet_NaN();
  profile.points = {{-9, 0, 60},   {0, 0, 0},     {none, 0, 60}, {-3, 0, 200},  {-2, 0, 60},
                    {-1.0, 0, 60}, {-0.3, 0, 60}, {-0.2, 0, 60}, {-0.1, 0, 57}, {0, 0, 60},
                    {0.1, 0, 60},  {0.2, 0, 60},  {0.3, 0, 60},  {9, 0, 60}};
  SightSettings settings;
  settings.trim_points = 1;
  settings.least_depth_mm = 50;
  settings.greatest_depth_mm = 70;
  const ProfileReadings read = readProfile(profile, atlas, {}, settings);
  EXPECT_EQ(read.counts.received, 14U);
  EXPECT_EQ(read.counts.trimmed, 2U);
  EXPECT_EQ(read.counts.not_finite, 2U);
  EXPECT_EQ(read.counts.outside_window, 1U);
  EXPECT_EQ(read.counts.spray, 1U);
  EXPECT_EQ(read.counts.off_path, 1U) << "at -2 mm";
  EXPECT_EQ(read.counts.beside_crown, 1U) << "at -1 mm";
  EXPECT_EQ(read.counts.used, 6U);
  EXPECT_EQ(read.counts.accounted(), 14U);
}

/// What a driver sends for points that it misses stands at no depth, or at a negative one.
TEST(ReadProfile, LeavesOutWhatIsNearerThanTheWindowWithoutAFarEnd) {
  const test::MeasuredLayer measured = test::inclinedLayer(0.0, 1, kWireBead);
  const CellAtlas atlas = atlasOver(measured);
  SensorProfile profile;
  profile.toolpath_from_sensor = test::sensorOver(measured, 0, 0.5);
  profile.points = {{-0.3, 0, 60}, {-0.2, 0, 0}, {-0.1, 0, -999}, {0, 0, 60}, {0.1, 0, 60}};
  SightSettings settings;
  EXPECT_EQ(readProfile(profile, atlas, {}, settings).counts.outside_window, 0U);
  settings.least_depth_mm = 10;
  const ProfileReadings read = readProfile(profile, atlas, {}, settings);
  EXPECT_EQ(read.counts.outside_window, 2U);
  EXPECT_EQ(read.counts.used, 3U);
}

TEST(ReadProfile, KeepsThreePointsInARowThatAgree) {
  const test::MeasuredLayer measured = test::inclinedLayer(0.0, 1, kWireBead);
  const CellAtlas atlas = atlasOver(measured);
  SensorProfile profile;
  profile.toolpath_from_sensor = test::sensorOver(measured, 0, 0.5);
  for (int i = -14; i <= 14; ++i) profile.points.emplace_back(0.1 * i, 0.0, std::abs(i) <= 1 ? 59.0 : 60.0);
  EXPECT_EQ(readProfile(profile, atlas, {}, {}).counts.spray, 0U);
  profile.points[13].z() = 60.0;
  EXPECT_EQ(readProfile(profile, atlas, {}, {}).counts.spray, 2U);
}

TEST(ReadProfile, KeepsTheReturnThatAgreesWithWhatIsExpected) {
  const test::MeasuredLayer measured = test::inclinedLayer(0.0, 1, kWireBead);
  const CellAtlas atlas = atlasOver(measured);
  SensorProfile profile;
  profile.toolpath_from_sensor = test::sensorOver(measured, 0, 0.5);
  for (int i = -14; i <= 14; ++i) {
    const Point3 top(0.1 * i, 0.0, 60.0);
    if (i == 2) profile.points.emplace_back(top * 60.4 / 60.0);
    profile.points.push_back(top);
  }
  const ProfileReadings read = readProfile(profile, atlas, {}, {});
  EXPECT_EQ(read.counts.mirrored, 1U);
  ASSERT_EQ(read.readings.size(), 1U);
  EXPECT_NEAR(read.readings[0].reading.error_mm, 0.0, 1e-6);
}

/// A driver that has no depth for the end of its line leaves it at that of the sensor, or behind it.
TEST(ReadProfile, KnowsMirrorsOfAProfileWithAPointOfNoDepth) {
  const test::MeasuredLayer measured = test::inclinedLayer(0.0, 1, kWireBead);
  const CellAtlas atlas = atlasOver(measured);
  for (const double depth : {0.0, -5.0}) {
    SensorProfile profile;
    profile.toolpath_from_sensor = test::sensorOver(measured, 0, 0.5);
    profile.points.emplace_back(-1.5, 0.0, depth);
    for (int i = -14; i <= 14; ++i) {
      const Point3 top(0.1 * i, 0.0, 60.0);
      if (i == 2) profile.points.emplace_back(top * 60.4 / 60.0);
      profile.points.push_back(top);
    }
    const ProfileReadings read = readProfile(profile, atlas, {}, {});
    EXPECT_EQ(read.counts.mirrored, 1U) << depth;
    ASSERT_EQ(read.readings.size(), 1U) << depth;
    EXPECT_NEAR(read.readings[0].reading.error_mm, 0.0, 1e-6) << depth;
  }
}

TEST(ReadProfile, LeavesOutWhatIsSeenFromTheSide) {
  const test::MeasuredLayer measured = test::inclinedLayer(0.0, 1, kWireBead);
  SensorProfile profile;
  const Point3 place = measured.place(0, 0.5, 0.0, 0.0);
  profile.points.assign(1, Point3(0.0, 0.0, 60.0));
  for (const double angle_deg : {69.0, 71.0}) {
    const Eigen::Quaterniond tilt(Eigen::AngleAxisd((180.0 - angle_deg) * M_PI / 180.0, Point3::UnitY()));
    profile.toolpath_from_sensor = Eigen::Isometry3d(tilt);
    profile.toolpath_from_sensor.translation() = place - tilt * profile.points[0];
    const auto read = readProfile(profile, atlasOver(measured), {}, {});
    EXPECT_EQ(read.counts.used, angle_deg < 70.0 ? 1U : 0U);
    EXPECT_EQ(read.counts.grazing, angle_deg < 70.0 ? 0U : 1U);
  }
}

TEST(ReadProfile, ChoosesTheLikelierLayer) {
  CellAtlas atlas;
  std::vector<std::vector<CellEstimate>> estimates;
  for (std::size_t k = 0; k < 2; ++k) {
    atlas.add(
        std::make_shared<const LayerCells>(test::cellsOf(test::inclinedLayer(0.0, 1, kWireBead, k), k)));
    estimates.emplace_back(atlas.cellsOf(k)->size(), CellEstimate(0.0, 0.05, 1.0));
  }
  const std::vector<LayerPrediction> predictions{{0, &estimates[0]}, {1, &estimates[1]}};
  const test::MeasuredLayer newest = test::inclinedLayer(0.0, 1, kWireBead, 1);
  SensorProfile profile;
  profile.toolpath_from_sensor = test::sensorOver(newest, 0, 0.5);
  const auto layerAt = [&](double below_mm) {
    profile.points.assign(1, Point3(0.0, 0.0, 60.0 + below_mm));
    return readProfile(profile, atlas, predictions, {}).readings.at(0).layer;
  };
  EXPECT_EQ(layerAt(0.1), 1U);
  EXPECT_EQ(layerAt(1.4), 0U) << "the bead above is not there yet";
  EXPECT_EQ(layerAt(0.8), 1U) << "off both: for the newest to contest";
}

/// At 60 degrees, of which half the depth and 0.87 of what lies along the climbing line act along the growth.
TEST(PointSigma, IsThePartAlongTheGrowth) {
  const Eigen::Vector3d square(0, 0, -1);
  const Eigen::Vector3d climbing(std::sqrt(0.75), 0, -0.5);
  const Eigen::Vector3d level_line(0, std::sqrt(0.75), -0.5);
  SightSettings settings;
  EXPECT_NEAR(pointSigma(square, settings), 0.02, 1e-12);
  EXPECT_NEAR(pointSigma(climbing, settings), 0.01, 1e-12);
  settings.lateral_sigma_mm = 0.04;
  EXPECT_NEAR(pointSigma(square, settings), 0.02, 1e-12);
  EXPECT_NEAR(pointSigma(climbing, settings), std::sqrt(0.0001 + 0.0012), 1e-12);
  EXPECT_NEAR(pointSigma(level_line, settings), 0.01, 1e-12);
  settings.pose_sigma_mm = 0.1;
  EXPECT_NEAR(pointSigma(square, settings), std::hypot(0.02, 0.1), 1e-12);
}

/// Points of any kind, many of them on the layer.
std::vector<Point3> anyPoints(const test::MeasuredLayer& measured, const Eigen::Isometry3d& sensor,
                              std::size_t count, Random& random) {
  const double odd[] = {std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity(),
                        0.0,
                        1e300,
                        -1e300,
                        1e-310};
  std::vector<Point3> points;
  for (std::size_t i = 0; i < count; ++i) {
    Point3 point = sensor.inverse() * measured.place(random.below(kBeads), random.uniform(0.0, 1.0),
                                                     random.uniform(-2.0, 2.0), random.uniform(-4.0, 4.0));
    if (random.below(10) == 0) point[static_cast<Eigen::Index>(random.below(3))] = odd[random.below(7)];
    if (random.below(50) == 0) point.setZero();
    points.push_back(point);
  }
  return points;
}

void requireSound(const ProfileReadings& read, const CellAtlas& atlas) {
  RC_ASSERT(read.counts.accounted() == read.counts.received);
  std::uint64_t used = 0;
  for (std::size_t i = 0; i < read.readings.size(); ++i) {
    const LayerReading& one = read.readings[i];
    RC_ASSERT(one.cell < atlas.cellsOf(one.layer)->size());
    RC_ASSERT(std::isfinite(one.reading.error_mm) && one.reading.sigma_mm > 0.0 && one.reading.points > 0);
    used += static_cast<std::uint64_t>(one.reading.points);
    if (i == 0) continue;
    const LayerReading& last = read.readings[i - 1];
    RC_ASSERT(std::make_pair(last.layer, last.cell) < std::make_pair(one.layer, one.cell));
  }
  RC_ASSERT(used == read.counts.used);
}

TEST(ReadProfile, IsSoundForAnyCloudAndTheSameWhenItIsTurnedRound) {
  EXPECT_TRUE(rc::check([] {
    const auto layers = test::measuredLayers(kBeads, kWireBead);
    const auto& measured = layers[*rc::gen::inRange<std::size_t>(0, layers.size())];
    const CellAtlas atlas = atlasOver(measured);
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    SensorProfile profile;
    profile.toolpath_from_sensor = test::sensorOver(measured, 2, 0.5);
    profile.points = anyPoints(measured, profile.toolpath_from_sensor, *rc::gen::inRange(0, 400), random);
    SightSettings settings;
    settings.trim_points = *rc::gen::inRange(0, 5);
    settings.greatest_depth_mm = *rc::gen::element(0.0, 62.0);
    const ProfileReadings read = readProfile(profile, atlas, {}, settings);
    requireSound(read, atlas);
    std::reverse(profile.points.begin(), profile.points.end());
    expectEqual(read, readProfile(profile, atlas, {}, settings));
  }));
}

TEST(ReadProfile, ReadsAMillionPoints) {
  const test::MeasuredLayer measured = test::inclinedLayer(45.0, kBeads, kWireBead);
  const CellAtlas atlas = atlasOver(measured);
  Random random(2);
  SensorProfile profile;
  profile.toolpath_from_sensor = test::sensorOver(measured, 2, 0.5);
  profile.points = anyPoints(measured, profile.toolpath_from_sensor, 1000000, random);
  const ProfileReadings read = readProfile(profile, atlas, {}, {});
  EXPECT_EQ(read.counts.accounted(), 1000000U);
}

TEST(ReadProfile, ReadsNothingWhereThereIsNothing) {
  const ProfileReadings none = readProfile({}, CellAtlas(), {}, {});
  EXPECT_TRUE(none.readings.empty());
  EXPECT_EQ(none.counts.accounted(), 0U);
  SensorProfile profile;
  profile.points.assign(9, Point3(0, 0, 60));
  EXPECT_EQ(readProfile(profile, CellAtlas(), {}, {}).counts.off_path, 9U);
}

/// A sensor that rises by 0.03 mm, and goes 5 mm ahead, within the deviation of its stamps.
TEST(ReadProfile, CountsInHowFarTheSensorMovesWhileItsStampsAreUnsure) {
  const auto sigmaWith = [](const Eigen::Vector3d& way) {
    const Scene scene;
    const CellAtlas atlas = atlasOver(scene.measured);
    Random random(1);
    SensorProfile profile = profileAt(scene, 0.31, random);
    profile.stamp_sigma_mm = way;
    SightSettings settings;
    settings.sigma_mm = 0.04;
    return readProfile(profile, atlas, {}, settings).readings.at(0).reading.sigma_mm;
  };
  EXPECT_NEAR(sigmaWith({0, 0, 0}), 0.04, 1e-6);
  EXPECT_NEAR(sigmaWith({5, 0, 0}), 0.04, 1e-6);
  EXPECT_NEAR(sigmaWith({5, 0, 0.03}), 0.05, 1e-6);
}

}  // namespace
}  // namespace lamina
