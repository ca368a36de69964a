// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/tool_centre.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

const Point3 kTip(12.0, -7.0, 250.0);
const Point3 kTouched(900.0, 150.0, 400.0);

/// A flange that is tilted about a horizontal axis, its tip on the point.
FlangePose touching(double tilt_deg, double axis_deg, const Point3& error = Point3::Zero()) {
  const double axis = toRadians(axis_deg);
  FlangePose pose;
  pose.base_from_flange.linear() =
      Eigen::AngleAxisd(toRadians(tilt_deg), Point3(std::cos(axis), std::sin(axis), 0.0)).toRotationMatrix();
  pose.base_from_flange.translation() = kTouched - pose.base_from_flange.linear() * kTip + error;
  return pose;
}

std::vector<FlangePose> tiltedAllRound(int count, double tilt_deg) {
  std::vector<FlangePose> poses;
  poses.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) poses.push_back(touching(tilt_deg, 360.0 * i / count));
  return poses;
}

std::string tipRefusal(const std::vector<FlangePose>& poses) {
  try {
    fitToolCentre(poses);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(ToolCentre, IsFoundFromExactTouches) {
  const ToolCentreFit fit = fitToolCentre(tiltedAllRound(4, 30.0));
  EXPECT_LT((fit.flange_from_tip - kTip).norm(), 1e-9);
  EXPECT_LT((fit.base_from_point - kTouched).norm(), 1e-9);
  EXPECT_LT(fit.rms_mm, 1e-9);
  EXPECT_TRUE(fit.outlying.empty());
}

// The mean of four turns by 30 deg about x, -x, y and -y is diag(0.933, 0.933, 0.866): four touches hold
// 4 (1 - 0.933²) and 4 (1 - 0.866²) of x and z, whose deviations are 1.39 and 1.00 of that of a touch.
TEST(ToolCentre, SpreadIsThatOfTheTouchesThroughTheTilts) {
  std::vector<FlangePose> poses = tiltedAllRound(4, 30.0);
  for (std::size_t i = 0; i < poses.size(); ++i)
    poses[i].base_from_flange.translation() += Point3(i % 2 == 0 ? 0.1 : -0.1, 0.05, i < 2 ? 0.1 : -0.1);
  const ToolCentreFit fit = fitToolCentre(poses);
  double squared = 0.0;
  for (const double distance : fit.distances_mm) squared += distance * distance;
  const double deviation = std::sqrt(squared / 6.0);  // of 12 coordinates, 6 unknowns
  ASSERT_GT(deviation, 0.01);
  EXPECT_NEAR(fit.spread_mm.x() / deviation, 1.39, 0.005);
  EXPECT_NEAR(fit.spread_mm.y() / deviation, 1.39, 0.005);
  EXPECT_NEAR(fit.spread_mm.z() / deviation, 1.00, 0.005);
}

TEST(ToolCentre, ScattersAsItsSpreadSaysWithoutBias) {
  std::mt19937 numbers(19);
  std::normal_distribution<double> noise(0.0, 0.1);
  const int trials = 1000;
  Point3 sum = Point3::Zero();
  Point3 squared = Point3::Zero();
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<FlangePose> poses = tiltedAllRound(6, 45.0);
    for (FlangePose& pose : poses)
      pose.base_from_flange.translation() += Point3(noise(numbers), noise(numbers), noise(numbers));
    const Point3 off = fitToolCentre(poses).flange_from_tip - kTip;
    sum += off / trials;
    squared += off.cwiseProduct(off) / trials;
  }
  // 6 (1 - 0.8536²) = 1.628 and 6 (1 - 0.7071²) = 3.
  EXPECT_NEAR(std::sqrt(squared.x()), 0.1 / std::sqrt(1.628), 0.008);
  EXPECT_NEAR(std::sqrt(squared.y()), 0.1 / std::sqrt(1.628), 0.008);
  EXPECT_NEAR(std::sqrt(squared.z()), 0.1 / std::sqrt(3.0), 0.006);
  EXPECT_LT(sum.norm(), 0.015);
}

TEST(ToolCentre, NamesATouchThatContradictsTheOthers) {
  std::mt19937 numbers(20);
  std::normal_distribution<double> noise(0.0, 0.1);
  std::vector<FlangePose> poses = tiltedAllRound(8, 40.0);
  for (FlangePose& pose : poses)
    pose.base_from_flange.translation() += Point3(noise(numbers), noise(numbers), noise(numbers));
  EXPECT_TRUE(fitToolCentre(poses).outlying.empty());
  poses[5].base_from_flange.translation() += Point3(0.0, 3.0, 0.0);
  EXPECT_EQ(fitToolCentre(poses).outlying, std::vector<std::size_t>{5});
}

TEST(ToolCentre, IsRefusedWithoutTurns) {
  EXPECT_NE(tipRefusal(tiltedAllRound(3, 30.0)).find("in 3 poses; expected at least 4"), std::string::npos);
  const std::vector<FlangePose> parallel(4, touching(20.0, 0.0));
  EXPECT_NE(tipRefusal(parallel).find("expected at least 0.1"), std::string::npos) << tipRefusal(parallel);
  // Turned about one axis alone, here x, the tip may lie anywhere along it.
  const std::vector<FlangePose> one_axis = {touching(0.0, 0.0), touching(30.0, 0.0), touching(60.0, 0.0),
                                            touching(90.0, 0.0)};
  EXPECT_NE(tipRefusal(one_axis).find("(1, 0, 0)"), std::string::npos) << tipRefusal(one_axis);
}

TEST(ToolCentre, PosesAreReadWithQuaternionsOrAngles) {
  const std::vector<FlangePose> by_angles =
      flangePosesFromCsv("x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg\n1,2,3,0,90,0\n4,5,6,90,0,90\n", "a.csv");
  ASSERT_EQ(by_angles.size(), 2U);
  EXPECT_EQ(by_angles[1].line, 3U);
  EXPECT_LT((by_angles[0].base_from_flange * Point3(0, 0, 10) - Point3(11, 2, 3)).norm(), 1e-12);
  // y turns to z about x, and stays there about z; x turns to y.
  EXPECT_LT((by_angles[1].base_from_flange * Point3(10, 20, 0) - Point3(4, 15, 26)).norm(), 1e-12);
  const std::vector<FlangePose> by_quaternions =
      flangePosesFromCsv("qw,qx,qy,qz,x_mm,y_mm,z_mm\n0,1,0,0,1,2,3\n", "q.csv");
  EXPECT_LT((by_quaternions[0].base_from_flange * Point3(0, 0, 10) - Point3(1, 2, -7)).norm(), 1e-12);
  EXPECT_THROW(flangePosesFromCsv("x_mm,y_mm,z_mm\n1,2,3\n", "n.csv"), InvalidInput);
  EXPECT_THROW(flangePosesFromCsv("qw,qx,qy,qz,x_mm,y_mm,z_mm\n0,2,0,0,1,2,3\n", "l.csv"), InvalidInput);
}

}  // namespace
}  // namespace lamina
