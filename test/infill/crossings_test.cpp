// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/fill_requests.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

struct Motion {
  Point2 from;
  Point2 to;
};

std::vector<Motion> motionsOf(const std::vector<FillPath>& paths) {
  std::vector<Motion> motions;
  for (const FillPath& path : paths)
    for (std::size_t i = path.is_closed ? 0 : 1; i < path.points.size(); ++i)
      motions.push_back({path.points[i == 0 ? path.points.size() - 1 : i - 1], path.points[i]});
  return motions;
}

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Whether the motions cross at a point inside both, farther than `slack` from the ends of each.
bool areCrossing(const Motion& a, const Motion& b, double slack) {
  const Point2 along_a = a.to - a.from;
  const Point2 along_b = b.to - b.from;
  const double area = cross(along_a, along_b);
  if (std::abs(area) < 1e-9) return false;
  const double at_a = cross(b.from - a.from, along_b) / area;
  const double at_b = cross(b.from - a.from, along_a) / area;
  const double slack_a = slack / along_a.norm();
  const double slack_b = slack / along_b.norm();
  return at_a > slack_a && at_a < 1.0 - slack_a && at_b > slack_b && at_b < 1.0 - slack_b;
}

/// Drops lay nothing between them.
std::vector<std::string> strategiesOfBeads() {
  std::vector<std::string> names;
  for (const std::string& name : infillStrategyNames())
    if (infillStrategy(name).deposit == Deposit::Bead) names.push_back(name);
  return names;
}

/// Lines in several directions cross each other by their nature.
bool laysLinesAcross(const std::string& name) {
  return name == "grid" || name == "triangles" || name == "cubic";
}

/// Whose solid form is the zigzag, which stands here itself.
bool isZigzagIfSolid(const std::string& name) { return name == "honeycomb" || name == "gyroid"; }

class EveryBead : public testing::TestWithParam<std::string> {};

TEST_P(EveryBead, CrossesItselfNowhere) {
  if (laysLinesAcross(GetParam())) GTEST_SKIP() << "lays lines across each other";
  const InfillStrategy strategy = infillStrategy(GetParam());
  EXPECT_TRUE(rc::check("random regions", [&strategy] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions = unite({test::star(random, {0, 0}, 5.0, 12.0, 24),
                                   test::reversed(test::star(random, {0, 0}, 1.0, 3.0, 12))});
    const double spacing = random.uniform(0.6, 3.0);
    const double angle = random.uniform(-7.0, 7.0);
    const InfillRequest request = random.below(2) == 0 || isZigzagIfSolid(GetParam())
                                      ? test::requestOf(spacing, angle)
                                      : test::solidRequestOf(spacing, angle);
    const std::vector<Motion> motions = motionsOf(strategy.fill(regions, request));
    for (std::size_t i = 0; i < motions.size(); ++i)
      for (std::size_t j = i + 1; j < motions.size(); ++j)
        RC_ASSERT(!areCrossing(motions[i], motions[j], 0.5 * request.pitch_mm));
  }));
}

INSTANTIATE_TEST_SUITE_P(Infill, EveryBead, testing::ValuesIn(strategiesOfBeads()),
                         [](const testing::TestParamInfo<std::string>& strategy) { return strategy.param; });

}  // namespace
}  // namespace lamina
