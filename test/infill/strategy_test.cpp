// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/strategy.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/fill_requests.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::requestOf;
using test::reversed;

/// Centre lines may leave the region by this much: the grid of outlines, and rounding [mm].
constexpr double kInsideTolerance = 1e-4;
/// Turns of solid fills cut notches of the border that lie between two lines, in pitches.
constexpr double kNotch = 0.2;

bool isInside(const std::vector<Polygon>& borders, const Point2& point, const InfillRequest& request) {
  const double tolerance = isSolid(request) ? kNotch * request.pitch_mm : kInsideTolerance;
  return contains(borders, point) || test::distanceToOutline(borders, point) < tolerance;
}

/// Points of a bead no farther apart than `step` [mm], or the drops: between those nothing is deposited.
std::vector<Point2> sampled(const FillPath& path, double step) {
  if (path.deposit == Deposit::Drops) return path.points;
  std::vector<Point2> points;
  const std::size_t motions = path.points.size() - (path.is_closed ? 0 : 1);
  for (std::size_t i = 0; i < motions; ++i) {
    const Point2& a = path.points[i];
    const Point2 along = path.points[(i + 1) % path.points.size()] - a;
    const int count = 1 + static_cast<int>(along.norm() / step);
    for (int k = 0; k <= count; ++k) points.emplace_back(a + along * k / count);
  }
  return points;
}

double distanceToPaths(const std::vector<FillPath>& paths, const Point2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const FillPath& path : paths)
    for (const Point2& sample : sampled(path, 0.05)) nearest = std::min(nearest, (sample - point).norm());
  return nearest;
}

/// How far a place may be from the paths, in spacings: lines lie less than two spacings off a contour, drops
/// a spacing apart on both, and cells between lines in three directions are three across. Void filling is a
/// step of its own.
double reachOf(const std::string& strategy) {
  if (infillStrategy(strategy).deposit == Deposit::Drops) return std::hypot(1.0, 0.5);
  const bool has_cells = strategy == "cubic" || strategy == "honeycomb" || strategy == "triangles";
  return has_cells ? 1.5 : 1.0;
}

Regions strategyRandomRegions(Random& random) {
  return unite({test::star(random, {0, 0}, 5.0, 12.0, 24), reversed(test::star(random, {0, 0}, 1.0, 3.0, 12)),
                test::star(random, {30, 5}, 2.0, 6.0, 9)});
}

InfillRequest randomRequest(Random& random) {
  const double spacing = random.uniform(0.3, 3.0);
  const double angle = random.uniform(-7.0, 7.0);
  return random.below(2) == 0 ? requestOf(spacing, angle) : test::solidRequestOf(spacing, angle);
}

/// What every strategy promises.
class EveryStrategy : public testing::TestWithParam<std::string> {
 protected:
  std::vector<FillPath> fill(const Regions& regions, const InfillRequest& request) const {
    return infillStrategy(GetParam()).fill(regions, request);
  }
  bool isSingleWall() const { return infillStrategy(GetParam()).link == LayerLink::Rising; }
};

TEST_P(EveryStrategy, StaysInsideTheRegion) {
  EXPECT_TRUE(rc::check("random regions", [this] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions = strategyRandomRegions(random);
    const std::vector<Polygon> borders = outlines(regions);
    const InfillRequest request = randomRequest(random);
    for (const FillPath& path : fill(regions, request)) {
      RC_ASSERT(path.points.size() >= (path.deposit == Deposit::Drops ? 1U : 2U));
      for (const Point2& point : sampled(path, 0.2))
        RC_ASSERT(point.allFinite() && isInside(borders, point, request));
    }
  }));
}

TEST_P(EveryStrategy, GivesTheSamePathsForTheSameRegion) {
  Random random(7);
  const Regions regions = strategyRandomRegions(random);
  for (const InfillRequest& request : {requestOf(0.9, 0.4), test::solidRequestOf(0.9, 0.4)}) {
    const std::vector<FillPath> once = fill(regions, request);
    const std::vector<FillPath> again = fill(regions, request);
    ASSERT_EQ(once.size(), again.size());
    for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].points, again[i].points);
  }
}

TEST_P(EveryStrategy, GivesNoPathWithoutARegion) {
  EXPECT_TRUE(fill({}, {}).empty());
  EXPECT_TRUE(fill({Region{}}, {}).empty());
}

TEST_P(EveryStrategy, CoversARingWithinItsSpacing) {
  if (isSingleWall()) GTEST_SKIP() << "a single wall covers the border only";
  const Regions ring = {{circle({2, 3}, 12, 90), {reversed(circle({2, 3}, 5, 60))}}};
  const InfillRequest request = requestOf(1.5, 0.3);
  const std::vector<FillPath> paths = fill(ring, request);
  const std::vector<Polygon> borders = outlines(ring);
  const double reach = reachOf(GetParam());
  Random random(11);
  for (int i = 0; i < 500; ++i) {
    const Point2 point(random.uniform(-10, 14), random.uniform(-9, 15));
    if (contains(borders, point)) {
      // Lines that keep half a pitch off the border are that much farther from it.
      EXPECT_LT(distanceToPaths(paths, point), reach * request.spacing_mm + 0.5 * request.pitch_mm);
    }
  }
}

TEST_P(EveryStrategy, RefusesASpacingOfNothing) {
  if (isSingleWall()) GTEST_SKIP() << "a single wall has no spacing";
  EXPECT_THROW(fill({{rectangle(0, 0, 10, 10), {}}}, requestOf(0.0, 0.0)), InvalidInput);
  EXPECT_THROW(fill({{rectangle(0, 0, 10, 10), {}}}, requestOf(1e-300, 0.0)), InvalidInput);
}

INSTANTIATE_TEST_SUITE_P(Infill, EveryStrategy, testing::ValuesIn(infillStrategyNames()),
                         [](const testing::TestParamInfo<std::string>& strategy) { return strategy.param; });

TEST(InfillStrategy, OfAnUnknownNameIsRefusedNamingTheChoices) {
  try {
    infillStrategy("spaghetti");
    FAIL() << "nothing thrown";
  } catch (const InvalidConfig& error) {
    for (const std::string& name : infillStrategyNames())
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lamina
