// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/external_axis_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <random>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

const Point3 kAxis = Point3(2.0, -1.0, 2.0) / 3.0;
const Point3 kCentre(1600.0, -40.0, 700.0);
const Point3 kOnPlate = 200.0 * Point3(1.0, 2.0, 0.0).normalized();  // mm, at right angles to the axis

/// A mark 200 mm off the axis, the plate at an angle; its zero is anywhere.
AxisTouch turnedTo(double angle_deg, const Point3& error = Point3::Zero()) {
  return {angle_deg, kCentre + Eigen::AngleAxisd(toRadians(angle_deg + 17.0), kAxis) * kOnPlate + error, 0};
}

std::vector<AxisTouch> allRound(int count) {
  std::vector<AxisTouch> touches;
  for (int i = 0; i < count; ++i) touches.push_back(turnedTo(-180.0 + 360.0 * i / count));
  return touches;
}

double angleBetween(const Point3& a, const Point3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

std::string axisRefusal(const std::function<void()>& fit) {
  try {
    fit();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(TurningAxis, IsFoundFromTouchesAtThreeAngles) {
  const TurningAxisFit fit = fitTurningAxis({turnedTo(-30.0), turnedTo(0.0), turnedTo(45.0)});
  EXPECT_LT((fit.direction - kAxis).norm(), 1e-9);
  EXPECT_LT((fit.centre - kCentre).norm(), 1e-6);
  EXPECT_NEAR(fit.radius_mm, 200.0, 1e-6);
  EXPECT_LT(fit.rms_mm, 1e-6);
}

TEST(TurningAxis, PointsTheOtherWayWhereTheControllerCountsTheOtherWay) {
  std::vector<AxisTouch> touches = allRound(5);
  for (AxisTouch& touch : touches) touch.value = -touch.value;
  const TurningAxisFit fit = fitTurningAxis(touches);
  EXPECT_LT((fit.direction + kAxis).norm(), 1e-9);
  EXPECT_LT((fit.centre - kCentre).norm(), 1e-6);
}

// A full turn: 2 σ / (r sqrt n) of the direction, sqrt 2 σ / sqrt n of the place of the axis.
TEST(TurningAxis, ScattersAsItsSpreadsSayWithoutBias) {
  std::mt19937 numbers(23);
  std::normal_distribution<double> noise(0.0, 0.1);
  const int trials = 1000;
  const int count = 12;
  double squared_turn = 0.0;
  double squared_way = 0.0;
  double said_turn_deg = 0.0;
  double said_way_mm = 0.0;
  Point3 sum = Point3::Zero();
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<AxisTouch> touches = allRound(count);
    for (AxisTouch& touch : touches) touch.base += Point3(noise(numbers), noise(numbers), noise(numbers));
    const TurningAxisFit fit = fitTurningAxis(touches);
    const Point3 off = fit.centre - kCentre;
    squared_turn += std::pow(angleBetween(fit.direction, kAxis), 2) / trials;
    squared_way += (off - kAxis * kAxis.dot(off)).squaredNorm() / trials;
    said_turn_deg += fit.direction_spread_deg / trials;
    said_way_mm += fit.centre_spread_mm / trials;
    sum += off / trials;
  }
  const double turn_deg = toDegrees(2.0 * 0.1 / (200.0 * std::sqrt(12.0)));
  const double way_mm = std::sqrt(2.0) * 0.1 / std::sqrt(12.0);
  EXPECT_NEAR(toDegrees(std::sqrt(squared_turn)) / turn_deg, 1.0, 0.1);
  EXPECT_NEAR(std::sqrt(squared_way) / way_mm, 1.0, 0.1);
  EXPECT_NEAR(said_turn_deg / turn_deg, 1.0, 0.1);
  EXPECT_NEAR(said_way_mm / way_mm, 1.0, 0.1);
  EXPECT_LT(sum.norm(), 0.005);
}

TEST(TurningAxis, NamesATouchThatContradictsTheOthers) {
  std::mt19937 numbers(24);
  std::normal_distribution<double> noise(0.0, 0.05);
  std::vector<AxisTouch> touches = allRound(8);
  for (AxisTouch& touch : touches) touch.base += Point3(noise(numbers), noise(numbers), noise(numbers));
  EXPECT_TRUE(fitTurningAxis(touches).outlying.empty());
  touches[3].value += 2.0;  // deg: 7 mm on the circle, which no circle alone would show
  EXPECT_EQ(fitTurningAxis(touches).outlying, std::vector<std::size_t>{3});
}

TEST(TurningAxis, IsRefusedWhereTouchesDoNotDetermineIt) {
  const auto refusal = [](const std::vector<AxisTouch>& touches) {
    return axisRefusal([&] { fitTurningAxis(touches); });
  };
  EXPECT_NE(
      refusal({turnedTo(0.0), turnedTo(90.0)}).find("at 2 values of the positioner; expected at least 3"),
      std::string::npos);
  // An arc of 4 deg on 200 mm is 0.1 mm high.
  const std::string narrow = refusal({turnedTo(0.0), turnedTo(2.0), turnedTo(4.0)});
  EXPECT_NE(narrow.find("mm of one line; expected at least 1 mm"), std::string::npos) << narrow;
  EXPECT_NE(refusal({turnedTo(10.0), turnedTo(370.0), turnedTo(10.0)}).find("one line"), std::string::npos);
}

/// A mark in the room seen from a base that a rail carries along 0.6, 0.8, 0.
AxisTouch carriedTo(double rail_mm, const Point3& error = Point3::Zero()) {
  return {rail_mm, Point3(900.0, 100.0, 300.0) - rail_mm * Point3(0.6, 0.8, 0.0) + error, 0};
}

TEST(Rail, CarriesTheRobotAgainstTheWayOfAMark) {
  const RailFit fit = fitRail({carriedTo(0.0), carriedTo(500.0), carriedTo(1200.0)});
  EXPECT_LT((fit.direction - Point3(0.6, 0.8, 0.0)).norm(), 1e-9);
  EXPECT_NEAR(fit.way_per_value, 1.0, 1e-12);
  EXPECT_LT(fit.rms_mm, 1e-9);
}

TEST(Rail, ScattersAsItsSpreadSays) {
  std::mt19937 numbers(25);
  std::normal_distribution<double> noise(0.0, 0.1);
  const int trials = 1000;
  double squared = 0.0;
  double said_deg = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<AxisTouch> touches;
    for (int i = 0; i < 5; ++i)
      touches.push_back(carriedTo(250.0 * i, Point3(noise(numbers), noise(numbers), noise(numbers))));
    const RailFit fit = fitRail(touches);
    squared += std::pow(angleBetween(fit.direction, Point3(0.6, 0.8, 0.0)), 2) / trials;
    said_deg += fit.direction_spread_deg / trials;
  }
  // Values -500, -250, 0, 250, 500 about their middle: squares sum to 625000; two directions aside.
  const double expected_deg = toDegrees(std::sqrt(2.0) * 0.1 / std::sqrt(625000.0));
  EXPECT_NEAR(toDegrees(std::sqrt(squared)) / expected_deg, 1.0, 0.1);
  EXPECT_NEAR(said_deg / expected_deg, 1.0, 0.1);
}

TEST(Rail, NamesAValueThatContradictsTheOthers) {
  std::mt19937 numbers(26);
  std::normal_distribution<double> noise(0.0, 0.05);
  std::vector<AxisTouch> touches;
  for (int i = 0; i < 6; ++i)
    touches.push_back(carriedTo(250.0 * i, Point3(noise(numbers), noise(numbers), noise(numbers))));
  EXPECT_TRUE(fitRail(touches).outlying.empty());
  touches[2].value += 3.0;
  EXPECT_EQ(fitRail(touches).outlying, std::vector<std::size_t>{2});
}

TEST(Rail, IsRefusedWhereTheMarkDoesNotMoveWithIt) {
  const auto refusal = [](const std::vector<AxisTouch>& touches) {
    return axisRefusal([&] { fitRail(touches); });
  };
  const Point3 still(1, 2, 3);
  EXPECT_NE(refusal({{0.0, still, 2}, {500.0, still, 3}, {900.0, still, 4}})
                .find("moves by 0 mm for each millimetre of the rail; expected about 1"),
            std::string::npos);
  EXPECT_NE(refusal({carriedTo(0.0), carriedTo(500.0)}).find("at 2 values of the rail"), std::string::npos);
  EXPECT_NE(refusal({carriedTo(7.0), carriedTo(7.0), carriedTo(7.1)}).find("the values of the rail span"),
            std::string::npos);
}

TEST(AxisTouches, AreReadWithTheValueOfTheirAxis) {
  const std::vector<AxisTouch> touches =
      axisTouchesFromCsv("angle_deg,x_mm,y_mm,z_mm\n# first\n30,1,2,3\n", "angle_deg", "t.csv");
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_EQ(touches[0].value, 30.0);
  EXPECT_EQ(touches[0].base, Point3(1, 2, 3));
  EXPECT_EQ(touches[0].line, 3U);
  EXPECT_THROW(axisTouchesFromCsv("angle_deg,x_mm,y_mm,z_mm\n", "rail_mm", "t.csv"), InvalidInput);
}

}  // namespace
}  // namespace lamina
