// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/profile_sensor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kStandOff = 60.0;

Eigen::Isometry3d lookingDown(const Point3& position) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = position;
  pose.linear() = Eigen::AngleAxisd(M_PI, Point3::UnitX()).toRotationMatrix();
  return pose;
}

HeightMap plate(double height) {
  return HeightMap(heightGrid({Point2(0, 0), Point2(100, 100)}, 0.5), height);
}

ProfileSensorSettings quiet() {
  ProfileSensorSettings settings;
  settings.noise_mm = 0.0;
  return settings;
}

TEST(ProfileSensor, SeesAFlatPlateAtItsDistance) {
  const auto points = ProfileSensor(quiet()).measure(plate(3.0), lookingDown({50, 50, 3.0 + kStandOff}));
  ASSERT_EQ(points.size(), 300u);
  for (const Point3& point : points) EXPECT_NEAR(point.z(), kStandOff, 1e-9);
  EXPECT_NEAR(points.front().x(), -15.0, 1e-9);
  EXPECT_NEAR(points.back().x(), 15.0, 1e-9);
  EXPECT_DOUBLE_EQ(points.front().y(), 0.0);
}

TEST(ProfileSensor, PointsLieOnTheSurfaceFromATiltedPose) {
  Eigen::Isometry3d pose = lookingDown({50, 50, 55});
  pose.rotate(Eigen::AngleAxisd(0.3, Point3(1, 2, 0.5).normalized()));
  const auto points = ProfileSensor(quiet()).measure(plate(2.0), pose);
  ASSERT_GT(points.size(), 200u);
  for (const Point3& point : points) EXPECT_NEAR((pose * point).z(), 2.0, 1e-9);
}

TEST(ProfileSensor, WhatIsOutOfRangeOrUnknownIsMissing) {
  ProfileSensor sensor(quiet());
  EXPECT_TRUE(sensor.measure(plate(0.0), lookingDown({50, 50, 81})).empty());
  EXPECT_TRUE(sensor.measure(plate(0.0), lookingDown({50, 50, 39})).empty());
  EXPECT_TRUE(sensor.measure(plate(HeightMap::kUnknown), lookingDown({50, 50, 60})).empty());
  const auto half = sensor.measure(plate(0.0), lookingDown({0, 50, 60}));
  EXPECT_NEAR(static_cast<double>(half.size()), 150.0, 1.0);
}

TEST(ProfileSensor, AStepCastsAShadow) {
  HeightMap map = plate(0.0);
  for (std::size_t cell = 0; cell < map.grid().cellCount(); ++cell)
    if (map.grid().centre(cell).x() > 55.0) map.set(cell, 15.0);
  for (const Point3& point : ProfileSensor(quiet()).measure(map, lookingDown({50, 50, 60}))) {
    const Point3 hit = lookingDown({50, 50, 60}) * point;
    // On the bed before the step, on its side, or on its top.
    EXPECT_TRUE(hit.x() < 55.0 + 1e-9 || std::abs(hit.z() - 15.0) < 1e-9) << hit.transpose();
    EXPECT_TRUE(hit.x() > 55.0 - 1e-9 || std::abs(hit.z()) < 1e-9) << hit.transpose();
  }
}

TEST(ProfileSensor, KnowingTheHighestPointChangesNothing) {
  HeightMap map = plate(0.0);
  for (std::size_t cell = 0; cell < map.grid().cellCount(); cell += 3) map.set(cell, 0.1 * (cell % 120));
  Eigen::Isometry3d pose = lookingDown({50, 50, 65});
  pose.rotate(Eigen::AngleAxisd(0.2, Point3(1, 2, 0.5).normalized()));
  const auto plain = ProfileSensor(quiet()).measure(map, pose);
  const auto bounded = ProfileSensor(quiet()).measure(map, pose, 12.0);
  ASSERT_EQ(plain.size(), bounded.size());
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_LT((plain[i] - bounded[i]).norm(), 1e-9);
}

TEST(ProfileSensor, NoiseHasItsDeviationAndIsRepeatable) {
  ProfileSensorSettings settings = quiet();
  settings.noise_mm = 0.05;
  settings.points = 20000;
  const auto points = ProfileSensor(settings).measure(plate(0.0), lookingDown({50, 50, 60}));
  double sum = 0.0, squares = 0.0;
  for (const Point3& point : points) {
    sum += point.z() - kStandOff;
    squares += std::pow(point.z() - kStandOff, 2);
  }
  EXPECT_LE(std::abs(sum / 20000), 3 * 0.05 / std::sqrt(20000.0));
  EXPECT_NEAR(std::sqrt(squares / 20000), 0.05, 0.002);
  EXPECT_EQ(points, ProfileSensor(settings).measure(plate(0.0), lookingDown({50, 50, 60})));
}

/// Points of a plate 3 mm high, from 60 mm above it.
std::vector<Point3> ofPlate(const ProfileSensorSettings& settings, double now_s = 0.0) {
  return ProfileSensor(settings).measure(plate(3.0), lookingDown({50, 50, 3.0 + kStandOff}), 3.0, now_s);
}

TEST(ProfileSensor, NoiseIsThatOfASensorWithoutDefects) {
  ProfileSensorSettings settings;
  const auto plain = ofPlate(settings);
  settings.bias_mm = 0.25;
  const auto shifted = ofPlate(settings);
  ASSERT_EQ(plain.size(), shifted.size());
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_EQ(shifted[i].z(), plain[i].z() + 0.25);
  settings.bias_mm = 0.0;
  settings.spray_rate = 0.1;
  const auto sprayed = ofPlate(settings);
  std::size_t same = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) same += sprayed[i] == plain[i] ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(same), 270.0, 20.0);
}

TEST(ProfileSensor, NoiseCorrelatesAsStated) {
  ProfileSensorSettings settings;
  settings.noise_mm = 0.05;
  settings.noise_correlation = 0.6;
  settings.points = 20000;
  const auto points = ofPlate(settings);
  double squares = 0.0;
  double products = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    squares += std::pow(points[i].z() - kStandOff, 2);
    products += (points[i].z() - kStandOff) * (points[i - 1].z() - kStandOff);
  }
  EXPECT_NEAR(std::sqrt(squares / 20000), 0.05, 0.003);
  EXPECT_NEAR(products / squares, 0.6, 0.03);
}

TEST(ProfileSensor, DefectsHaveTheirRates) {
  ProfileSensorSettings settings = quiet();
  settings.points = 20000;
  settings.spray_rate = 0.02;
  std::size_t above = 0;
  for (const Point3& point : ofPlate(settings)) above += point.z() < kStandOff - 1e-9 ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(above), 400.0, 80.0);
  settings.spray_rate = 0.0;
  settings.dropout_rate = 0.1;
  EXPECT_NEAR(static_cast<double>(ofPlate(settings).size()), 18000.0, 200.0);
  settings.dropout_rate = 0.0;
  settings.mirror_rate = 0.01;
  const auto mirrored = ofPlate(settings);
  EXPECT_NEAR(static_cast<double>(mirrored.size()), 20200.0, 60.0);
  for (std::size_t i = 1; i < mirrored.size(); ++i) {
    if (mirrored[i].z() <= kStandOff + 1e-9) continue;
    EXPECT_NEAR(mirrored[i].x() / mirrored[i].z(), mirrored[i - 1].x() / mirrored[i - 1].z(), 1e-9)
        << "in the column of the point before";
  }
}

TEST(ProfileSensor, DriftsByTheHourAndStampsLate) {
  ProfileSensorSettings settings = quiet();
  settings.drift_mm_h = 0.1;
  EXPECT_NEAR(ofPlate(settings, 1800.0).front().z(), kStandOff + 0.05, 1e-9);
  EXPECT_EQ(ProfileSensor(quiet()).stampError(), 0.0);
  settings.time_offset_s = 0.08;
  EXPECT_EQ(ProfileSensor(settings).stampError(), 0.08);
  settings.stamp_jitter_s = 0.001;
  ProfileSensor sensor(settings);
  double squares = 0.0;
  for (int i = 0; i < 5000; ++i) squares += std::pow(sensor.stampError() - 0.08, 2) / 5000;
  EXPECT_NEAR(std::sqrt(squares), 0.001, 0.00005);
}

/// Knocked 1 mm along its line and 0.5 mm up its beam, it shows a plate 0.5 mm farther away, and a step at
/// x = 55 at 54.
TEST(ProfileSensor, ShowsTheWorldShiftedOnceItHasMoved) {
  ProfileSensorSettings settings = quiet();
  settings.moved_mm = {1.0, 0.0, -0.5};
  settings.moved_at_s = 100.0;
  EXPECT_EQ(ofPlate(settings, 99.0).front(), ofPlate(quiet(), 99.0).front());
  EXPECT_NEAR(ofPlate(settings, 100.0).front().z(), kStandOff + 0.5, 1e-9);
  HeightMap step = plate(3.0);
  for (std::size_t cell = 0; cell < step.grid().cellCount(); ++cell)
    if (step.grid().centre(cell).x() > 55.0) step.set(cell, 4.0);
  const auto edgeAt = [&](double now_s) {
    const Eigen::Isometry3d pose = lookingDown({50, 50, 3.0 + kStandOff});
    const auto points = ProfileSensor(settings).measure(step, pose, 4.0, now_s);
    for (const Point3& point : points)
      if (point.z() < points.front().z() - 0.5) return (pose * point).x();
    return 0.0;
  };
  EXPECT_NEAR(edgeAt(0.0), 55.0, 0.11);
  EXPECT_NEAR(edgeAt(200.0), 54.0, 0.11);
}

TEST(ProfileSensor, RefusesARangeThatStartsBehindIt) {
  ProfileSensorSettings settings;
  settings.range_mm = 130.0;
  EXPECT_THROW(ProfileSensor{settings}, InvalidConfig);
}

}  // namespace
}  // namespace lamina
