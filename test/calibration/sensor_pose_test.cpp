// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/sensor_pose.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/calibration/hand_eye.hpp"
#include "recorded_cell.hpp"

namespace lamina {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kNoiseMm = 0.02;

Eigen::Isometry3d turnedAndMoved(const Eigen::Isometry3d& pose, const Point3& by_mm, const Point3& turn_deg) {
  Eigen::Isometry3d moved = pose;
  moved.translation() += by_mm;
  if (turn_deg.norm() > 0.0)
    moved.linear() = Eigen::AngleAxisd(turn_deg.norm() * kDegree, turn_deg.normalized()).toRotationMatrix() *
                     pose.linear();
  return moved;
}

/// The sensor 5 mm and 3 deg off where it is thought to be.
Eigen::Isometry3d offSensor() {
  return turnedAndMoved(test::nominalSensor(), 5.0 * Point3(0.6, -0.5, 0.4).normalized(),
                        3.0 * Point3(0.5, -0.6, 0.7).normalized());
}

double turnBetween(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return Eigen::AngleAxisd(Eigen::Matrix3d(a.linear().transpose() * b.linear())).angle() / kDegree;
}

void expectFound(const SensorPoseFit& fit, const Eigen::Isometry3d& truth) {
  EXPECT_EQ(directionsNotFound(fit), "");
  EXPECT_LT((fit.nozzle_from_sensor.translation() - truth.translation()).norm(), 0.05);
  EXPECT_LT(turnBetween(fit.nozzle_from_sensor, truth), 0.05);
}

/// A head that tilts about x and y over a place, at several heights, and shakes a little there.
Eigen::Isometry3d tiltedHead(double time_s) {
  static const std::vector<Point3> kTilts = {{0, 0, 0},   {18, 0, 0},  {-18, 0, 0},  {0, 18, 0},
                                             {0, -18, 0}, {13, 13, 0}, {-13, 13, 30}};
  const std::size_t step = std::min(kTilts.size() * 3 - 1, static_cast<std::size_t>(time_s / 0.5));
  const Point3& tilt = kTilts[step % kTilts.size()];
  const std::size_t height = step / kTilts.size();
  Eigen::Isometry3d pose =
      test::nozzleAt({100.0 + 2.0 * std::sin(time_s), 100.0, 5.0 + 7.0 * static_cast<double>(height)});
  return pose *
         Eigen::AngleAxisd(tilt.norm() * kDegree, tilt.norm() > 0 ? tilt.normalized() : Point3::UnitX());
}

/// Back and forth along y in swaths, at heights.
test::LinearMotion scans(const Point2& middle, const Point2& half, const std::vector<double>& heights) {
  std::vector<test::LinearMotion::Way> ways;
  for (const double z : heights)
    for (int i = 0; i < 3; ++i) {
      const double x = middle.x() - 25.0 + (i - 1) * half.x();
      const double sense = i % 2 == 0 ? 1.0 : -1.0;
      ways.push_back({{x, middle.y() - sense * half.y(), z}, 60.0});
      ways.push_back({{x, middle.y() + sense * half.y(), z}, 20.0});
    }
  return {{middle.x(), middle.y(), heights[0]}, ways};
}

CrossTarget cross() {
  CalibrationSettings settings;
  return {crossBeads(settings), settings.bead_width_mm, settings.bead_height_mm};
}

/// Round beads on the bed. Plain numbers, since it is asked a million times and tests are hardly optimised.
double crossHeight(const CrossTarget& target, const Point2& at) {
  double height = 0.0;
  for (const CalibrationBead& bead : target.beads) {
    const double along[] = {bead.end[0] - bead.start[0], bead.end[1] - bead.start[1]};
    const double from[] = {at[0] - bead.start[0], at[1] - bead.start[1]};
    const double part =
        (from[0] * along[0] + from[1] * along[1]) / (along[0] * along[0] + along[1] * along[1]);
    const double foot = part < 0.0 ? 0.0 : part > 1.0 ? 1.0 : part;
    const double across[] = {from[0] - foot * along[0], from[1] - foot * along[1]};
    const double radius = 0.5 * target.bead_width_mm;
    const double t = (across[0] * across[0] + across[1] * across[1]) / (radius * radius);
    if (t >= 1.0) continue;
    const double bead_height = target.bead_height_mm * std::sqrt(1.0 - t);
    if (bead_height > height) height = bead_height;
  }
  return height;
}

test::RecordedCell noisyCell(const Eigen::Isometry3d& sensor) {
  test::RecordedCell cell;
  cell.nozzle_from_sensor = sensor;
  cell.noise_mm = kNoiseMm;
  cell.points = 141;
  return cell;
}

TEST(SensorPose, IsFoundByPairsOfPosesInClosedForm) {
  const Eigen::Isometry3d truth = offSensor();
  Eigen::Isometry3d bed_from_body =
      turnedAndMoved(Eigen::Isometry3d::Identity(), {120, 90, 10}, {10, 20, 40});
  std::vector<BodySight> sights;
  for (int i = 0; i < 12; ++i) {
    const Eigen::Isometry3d nozzle =
        turnedAndMoved(test::nozzleAt({100.0 + 3 * i, 100.0 - 5 * i, 20.0 + i}), Point3::Zero(),
                       {20.0 * std::sin(i), 15.0 * std::cos(2 * i), 10.0 * i});
    sights.push_back({nozzle, (nozzle * truth).inverse() * bed_from_body});
  }
  const HandEyeFit exact = fitHandEye(sights);
  EXPECT_LT((exact.nozzle_from_sensor.matrix() - truth.matrix()).norm(), 1e-9);
  EXPECT_LT(exact.rms_mm, 1e-9);
  Random random(3);
  const auto noise = [&](double sigma) {
    return Point3(random.normal(0, sigma), random.normal(0, sigma), random.normal(0, sigma));
  };
  for (BodySight& sight : sights)
    sight.sensor_from_body = turnedAndMoved(sight.sensor_from_body, noise(kNoiseMm), noise(0.02));
  const HandEyeFit noisy = fitHandEye(sights);
  EXPECT_LT((noisy.nozzle_from_sensor.translation() - truth.translation()).norm(), 0.05);
  EXPECT_LT(turnBetween(noisy.nozzle_from_sensor, truth), 0.05);
  EXPECT_GT(noisy.rms_mm, 0.005);
}

TEST(SensorPose, ByPairsNeedsTurnsAboutTwoAxes) {
  std::vector<BodySight> sights;
  for (int i = 0; i < 5; ++i) {
    const Eigen::Isometry3d nozzle =
        turnedAndMoved(test::nozzleAt({100.0 + i, 0, 0}), Point3::Zero(), {0, 0, 20.0 * i});
    sights.push_back({nozzle, (nozzle * offSensor()).inverse()});
  }
  try {
    fitHandEye(sights);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("one axis"), std::string::npos) << error.what();
  }
  for (BodySight& sight : sights) sight = sights.front();
  EXPECT_THROW(fitHandEye(sights), InvalidInput);
  sights.resize(2);
  EXPECT_THROW(fitHandEye(sights), InvalidInput);
}

TEST(SensorPose, IsFoundByAPlaneInManyPoses) {
  test::RecordedCell cell = noisyCell(offSensor());
  cell.surface = [](const Point2& at) { return 1.0 + 0.02 * at.x() - 0.01 * at.y(); };
  const SensorRecording recording = test::record(cell, tiltedHead, 10.4);
  const SensorPoseFit fit = fitSensorPose({{PlaneTarget{}, recording}}, test::nominalSensor(), {});
  expectFound(fit, offSensor());
  EXPECT_NEAR(fit.rms_mm, kNoiseMm, 0.005);
}

TEST(SensorPose, ByAPlaneWithoutTiltsIsLargelyKept) {
  test::RecordedCell cell = noisyCell(offSensor());
  const SensorRecording recording = test::record(cell, scans({100, 100}, {20, 30}, {2.0, 8.0}));
  const SensorPoseSettings settings;
  const SensorPoseFit fit = fitSensorPose({{PlaneTarget{}, recording}}, test::nominalSensor(), settings);
  EXPECT_TRUE(fit.is_kept[0]);
  EXPECT_TRUE(fit.is_kept[1]);
  EXPECT_TRUE(fit.is_kept[2]);
  EXPECT_NEAR(fit.nozzle_from_sensor.translation().x(), test::nominalSensor().translation().x(), 1e-12);
  const std::vector<std::string> reported = observability(fit, settings);
  EXPECT_GE(reported.size(), 3u);
  EXPECT_NE(reported[0].find("x of the nozzle is not observable"), std::string::npos) << reported[0];
  EXPECT_GE(fit.directions[0].singular_value, fit.directions[5].singular_value);
}

TEST(SensorPose, IsFoundByATouchedPyramid) {
  PyramidTarget target;
  target.bed_from_pyramid.translation() = Point3(100.0, 100.0, 0.0);
  target.is_place_known = target.is_top_known = true;
  test::RecordedCell cell = noisyCell(offSensor());
  cell.surface = [&](const Point2& at) {
    const Point2 from = (at - Point2(100, 100)).cwiseAbs();
    const double slope = target.height_mm / (0.5 * (target.base_mm - target.top_mm));
    return std::min(target.height_mm, std::max(0.0, (0.5 * target.base_mm - from.maxCoeff()) * slope));
  };
  const SensorRecording recording = test::record(cell, scans({100, 100}, {15, 35}, {12.0, 20.0}));
  const SensorPoseFit fit = fitSensorPose({{target, recording}}, test::nominalSensor(), {});
  expectFound(fit, offSensor());
  target.is_top_known = false;
  const SensorPoseFit untouched = fitSensorPose({{target, recording}}, test::nominalSensor(), {});
  EXPECT_EQ(directionsNotFound(untouched), "z");
  EXPECT_LT(turnBetween(untouched.nozzle_from_sensor, offSensor()), 0.05);
}

TEST(SensorPose, IsFoundByAPrintedCross) {
  const CrossTarget target = cross();
  test::RecordedCell cell = noisyCell(offSensor());
  cell.surface = [&](const Point2& at) { return crossHeight(target, at); };
  const SensorRecording recording = test::record(cell, scans({100, 100}, {20, 40}, {2.0, 14.0}));
  expectFound(fitSensorPose({{target, recording}}, test::nominalSensor(), {}), offSensor());
}

TEST(SensorPose, ByACrossAtOneHeightKeepsATiltThatLooksLikeAShift) {
  const CrossTarget target = cross();
  const Eigen::Isometry3d truth = turnedAndMoved(test::nominalSensor(), {3, -3, 2}, {0, 0, 3});
  test::RecordedCell cell = noisyCell(truth);
  cell.surface = [&](const Point2& at) { return crossHeight(target, at); };
  const SensorRecording recording = test::record(cell, scans({100, 100}, {20, 40}, {2.0}));
  const SensorPoseSettings settings;
  const SensorPoseFit fit = fitSensorPose({{target, recording}}, test::nominalSensor(), settings);
  EXPECT_EQ(directionsNotFound(fit), "turn about x");
  EXPECT_LT((fit.nozzle_from_sensor.translation() - truth.translation()).norm(), 0.05);
  EXPECT_LT(turnBetween(fit.nozzle_from_sensor, truth), 0.05);
  ASSERT_EQ(observability(fit, settings).size(), 1u);
  EXPECT_NE(observability(fit, settings)[0].find('y'), std::string::npos) << observability(fit, settings)[0];
}

TEST(SensorPose, WithoutACrossIsRefused) {
  test::RecordedCell cell = noisyCell(test::nominalSensor());
  const SensorRecording bare = test::record(cell, scans({100, 100}, {20, 40}, {2.0}));
  EXPECT_THROW(fitSensorPose({{cross(), bare}}, test::nominalSensor(), {}), InvalidInput);
  EXPECT_THROW(fitSensorPose({}, test::nominalSensor(), {}), InvalidInput);
  EXPECT_THROW(fitSensorPose({{PlaneTarget{}, {bare.poses, {}}}}, test::nominalSensor(), {}), InvalidInput);
}

}  // namespace
}  // namespace lamina
