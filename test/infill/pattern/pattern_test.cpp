// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lamina/infill/strategy.hpp"
#include "support/fill_requests.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

/// Of beads 0.4 mm wide in layers of 0.2 mm.
const double kPatternPitch = 0.4 - (1.0 - M_PI / 4.0) * 0.2;
constexpr double kLayer = 0.2;
constexpr double kSide = 60.0;

const std::vector<std::string> kPatterns{"cubic", "grid", "gyroid", "honeycomb", "triangles"};

InfillRequest unlinked(double density, double height_mm) {
  InfillRequest request = test::requestOf(kPatternPitch / density, 0.3);
  request.pitch_mm = kPatternPitch;
  request.links = {LineLink::None, 0.0};
  request.part_from_plan = Eigen::Translation3d(0.0, 0.0, height_mm);
  return request;
}

double patternLength(const std::vector<FillPath>& paths) {
  double sum = 0.0;
  for (const FillPath& path : paths) sum += path.is_closed ? perimeter(path.points) : length(path.points);
  return sum;
}

/// The area that centre lines may cover: half a bead at the border belongs to no line.
double filledShare(const std::string& strategy, double density, double height_mm) {
  const double border = 0.5 * kPatternPitch;
  const Regions square{{test::rectangle(-border, -border, kSide + border, kSide + border), {}}};
  const auto paths = infillStrategy(strategy).fill(square, unlinked(density, height_mm));
  return patternLength(paths) * kPatternPitch / (kSide * kSide);
}

class EveryPattern : public testing::TestWithParam<std::string> {};

/// 300 layers of a cube of 60 mm hold density * 60³ mm³ of infill: one layer in five is deposited here.
TEST_P(EveryPattern, FillsTheShareOfACubeThatTheDensitySays) {
  for (const double density : {0.15, 0.3}) {
    double sum = 0.0;
    int count = 0;
    for (double height = kLayer; height <= kSide; height += 5.0 * kLayer, ++count)
      sum += filledShare(GetParam(), density, height);
    EXPECT_NEAR(sum / count / density, 1.0, 0.03) << density;
  }
}

TEST_P(EveryPattern, LiesTheSameInLayersThatAreTurned) {
  const Regions plate{{test::rectangle(0, 0, 20, 15), {}}};
  InfillRequest request = unlinked(0.3, 1.0);
  const auto first = infillStrategy(GetParam()).fill(plate, request);
  request.turn_rad = 0.5 * M_PI;
  request.angle_rad += request.turn_rad;
  const auto turned = infillStrategy(GetParam()).fill(plate, request);
  ASSERT_EQ(first.size(), turned.size());
  EXPECT_NEAR(patternLength(first), patternLength(turned), 1e-6);
}

TEST_P(EveryPattern, IsAZigzagWhereItIsSolid) {
  const Regions plate{{test::rectangle(0, 0, 20, 15), {}}};
  const InfillRequest request = test::solidRequestOf(0.4, 0.3);
  const auto solid = infillStrategy(GetParam()).fill(plate, request);
  const auto zigzag = infillStrategy("zigzag").fill(plate, request);
  ASSERT_EQ(solid.size(), zigzag.size());
  for (std::size_t i = 0; i < solid.size(); ++i) EXPECT_EQ(solid[i].points, zigzag[i].points);
}

TEST_P(EveryPattern, TakesFewRunsIfEndsAreJoined) {
  const Regions plate{{test::rectangle(0, 0, kSide, kSide), {}}};
  InfillRequest request = unlinked(0.15, 1.0);
  const std::size_t apart = infillStrategy(GetParam()).fill(plate, request).size();
  request.links = {};
  const std::size_t joined = infillStrategy(GetParam()).fill(plate, request).size();
  EXPECT_GE(apart, 20U);
  EXPECT_LE(joined, 6U);
}

INSTANTIATE_TEST_SUITE_P(Infill, EveryPattern, testing::ValuesIn(kPatterns),
                         [](const testing::TestParamInfo<std::string>& strategy) { return strategy.param; });

/// Lines of a family lie 3 spacings apart and go aside by 1 / sqrt 2 of the rise: after a rise of 3 sqrt 2
/// spacings they lie as before, after half of that between.
TEST(Cubic, RepeatsAfterADiagonalOfItsCubes) {
  const Regions plate{{test::rectangle(0, 0, 40, 40), {}}};
  const double spacing = kPatternPitch / 0.3;
  const auto pointsAt = [&](double height) {
    std::vector<Point2> points;
    for (const FillPath& path : infillStrategy("cubic").fill(plate, unlinked(0.3, height)))
      points.insert(points.end(), path.points.begin(), path.points.end());
    return points;
  };
  const std::vector<Point2> first = pointsAt(1.0);
  const std::vector<Point2> repeated = pointsAt(1.0 + 3.0 * M_SQRT2 * spacing);
  ASSERT_EQ(first.size(), repeated.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_LT((first[i] - repeated[i]).norm(), 1e-6);
  const std::vector<Point2> next = pointsAt(1.2);
  EXPECT_GT((first.front() - next.front()).norm(), 0.2 * M_SQRT1_2 - 1e-6);
}

TEST(Triangles, MeetInPointsOfThreeLines) {
  InfillRequest request = unlinked(0.15, 0.0);
  request.angle_rad = 0.0;
  const Regions plate{{test::rectangle(-20, -20, 20, 20), {}}};
  std::size_t through_origin = 0;
  for (const FillPath& path : infillStrategy("triangles").fill(plate, request)) {
    ASSERT_EQ(path.points.size(), 2U);
    const Point2 along = (path.points[1] - path.points[0]).normalized();
    const Point2 from = path.points[0];
    if (std::abs(along.x() * from.y() - along.y() * from.x()) < 1e-9) ++through_origin;
  }
  EXPECT_EQ(through_origin, 3U);
}

/// Rows side by side: nowhere nearer than a pitch, and exactly that along one edge in three.
TEST(Honeycomb, LaysTwoBeadsSideBySideOnOneEdgeInThree) {
  InfillRequest request = unlinked(0.3, 0.0);
  request.angle_rad = 0.0;
  const Regions plate{{test::rectangle(-15, -15, 15, 15), {}}};
  const auto rows = infillStrategy("honeycomb").fill(plate, request);
  const double s = request.spacing_mm;
  const double flat_to_flat = (4.0 * s + std::sqrt(16.0 * s * s - 12.0 * kPatternPitch * s)) / 3.0;
  double level = 0.0;
  double all = 0.0;
  for (const FillPath& row : rows)
    for (std::size_t i = 1; i < row.points.size(); ++i) {
      const Point2 motion = row.points[i] - row.points[i - 1];
      all += motion.norm();
      if (std::abs(motion.y()) > 1e-9) {
        EXPECT_NEAR(std::abs(motion.y() / motion.x()), std::sqrt(3.0), 1e-6);
        continue;
      }
      level += motion.norm();
      const double row_y = std::abs(std::remainder(row.points[i].y(), 0.5 * flat_to_flat));
      EXPECT_NEAR(row_y, 0.5 * kPatternPitch, 1e-9);
    }
  const double edge = flat_to_flat / std::sqrt(3.0);
  const double expected =
      (edge + kPatternPitch / std::sqrt(3.0)) / (2.0 * edge - kPatternPitch / std::sqrt(3.0));
  EXPECT_NEAR(level / all, expected, 0.02);
}

}  // namespace
}  // namespace lamina
