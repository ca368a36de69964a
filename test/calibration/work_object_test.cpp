// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/work_object.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

Eigen::Isometry3d placed() {
  Eigen::Isometry3d base_from_object = Eigen::Isometry3d::Identity();
  base_from_object.linear() =
      Eigen::AngleAxisd(toRadians(30.0), Point3(1.0, 2.0, 2.0) / 3.0).toRotationMatrix();
  base_from_object.translation() = Point3(1200.0, -300.0, 450.0);
  return base_from_object;
}

TouchedPoint touched(const Point3& object) { return {placed() * object, object, 0}; }

std::vector<TouchedPoint> cornersOfABox() {
  return {touched({0, 0, 0}),   touched({200, 0, 0}), touched({200, 100, 0}),
          touched({0, 100, 0}), touched({0, 0, 50}),  touched({200, 100, 50})};
}

std::string objectRefusal(const std::vector<TouchedPoint>& points) {
  try {
    fitWorkObject(points);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(WorkObject, IsSpannedByThreePoints) {
  const std::array<Point3, 3> points = {Point3(100, 50, 10), Point3(300, 50, 10), Point3(180, 120, 10)};
  const Eigen::Isometry3d foot = workObjectOfAxes(points, ObjectOrigin::Foot);
  EXPECT_TRUE(foot.translation().isApprox(Point3(180, 50, 10), 1e-12));
  EXPECT_TRUE(foot.linear().isApprox(Eigen::Matrix3d::Identity(), 1e-12));
  const Eigen::Isometry3d first = workObjectOfAxes(points, ObjectOrigin::First);
  EXPECT_TRUE(first.translation().isApprox(points[0], 1e-12));
  // With the third point on the other side the object lies upside down.
  const Eigen::Isometry3d below =
      workObjectOfAxes({points[0], points[1], Point3(180, -20, 10)}, ObjectOrigin::First);
  EXPECT_TRUE(below.linear().col(2).isApprox(Point3(0, 0, -1), 1e-12));
}

TEST(WorkObject, OfThreePointsOnOneLineIsRefused) {
  EXPECT_THROW(workObjectOfAxes({Point3(0, 0, 0), Point3(0.5, 0, 0), Point3(0, 90, 0)}, ObjectOrigin::Foot),
               InvalidInput);
  EXPECT_THROW(workObjectOfAxes({Point3(0, 0, 0), Point3(90, 0, 0), Point3(45, 0.5, 0)}, ObjectOrigin::Foot),
               InvalidInput);
}

TEST(WorkObject, IsFoundFromKnownPoints) {
  const WorkObjectFit fit = fitWorkObject(cornersOfABox());
  EXPECT_LT((fit.base_from_object.matrix() - placed().matrix()).norm(), 1e-9);
  EXPECT_LT(fit.rms_mm, 1e-9);
  EXPECT_TRUE(fit.outlying.empty());
}

TEST(WorkObject, OfPointsInOnePlaneIsNoReflection) {
  std::vector<TouchedPoint> points = cornersOfABox();
  points.resize(4);
  EXPECT_LT((fitWorkObject(points).base_from_object.matrix() - placed().matrix()).norm(), 1e-9);
}

TEST(WorkObject, NamesAPointThatContradictsTheOthers) {
  std::mt19937 numbers(21);
  std::normal_distribution<double> noise(0.0, 0.05);
  std::vector<TouchedPoint> points = cornersOfABox();
  for (TouchedPoint& point : points) point.base += Point3(noise(numbers), noise(numbers), noise(numbers));
  const WorkObjectFit good = fitWorkObject(points);
  EXPECT_TRUE(good.outlying.empty());
  EXPECT_LT((good.base_from_object.translation() - placed().translation()).norm(), 0.2);
  points[2].base += Point3(2.0, 0.0, 0.0);
  EXPECT_EQ(fitWorkObject(points).outlying, std::vector<std::size_t>{2});
}

TEST(WorkObject, IsRefusedWherePointsDoNotDetermineIt) {
  EXPECT_NE(objectRefusal({touched({0, 0, 0}), touched({1, 0, 0})}).find("at 2 points; expected at least 3"),
            std::string::npos);
  EXPECT_NE(
      objectRefusal({touched({0, 0, 0}), touched({100, 0, 0}), touched({200, 0.5, 0})}).find("of one line"),
      std::string::npos);
  EXPECT_NE(objectRefusal({touched({0, 0, 0}), touched({9, 0, 0}), {Point3(1, 2, 3), std::nullopt, 4}})
                .find("line 4 states no point of the object"),
            std::string::npos);
}

TEST(WorkObject, PointsAreReadWithWhatIsKnownOfThem) {
  const std::vector<TouchedPoint> touches = touchedPointsFromCsv("x_mm,y_mm,z_mm\n# X1\n1,2,3\n", "t.csv");
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_EQ(touches[0].base, Point3(1, 2, 3));
  EXPECT_EQ(touches[0].line, 3U);
  EXPECT_FALSE(touches[0].object);
  const std::vector<TouchedPoint> known =
      touchedPointsFromCsv("object_x_mm,object_y_mm,object_z_mm,x_mm,y_mm,z_mm\n1,2,3,4,5,6\n", "known.csv");
  ASSERT_TRUE(known.at(0).object);
  EXPECT_EQ(*known[0].object, Point3(1, 2, 3));
  EXPECT_EQ(known[0].base, Point3(4, 5, 6));
  EXPECT_THROW(touchedPointsFromCsv("x_mm,y_mm,z_mm,object_x_mm\n1,2,3,4\n", "half.csv"), InvalidInput);
}

}  // namespace
}  // namespace lamina
