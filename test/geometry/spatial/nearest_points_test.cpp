// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/spatial/nearest_points.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace lamina {
namespace {

/// Points of a lattice, so that many are equally near, and some stand twice.
std::vector<Point3> anyPoints(int most) {
  std::vector<Point3> points(static_cast<std::size_t>(*rc::gen::inRange(1, most)));
  for (Point3& point : points)
    for (Eigen::Index axis = 0; axis < 3; ++axis) point[axis] = *rc::gen::inRange(-5, 6);
  return points;
}

TEST(NearestPoints, AreThoseThatLookingAtAllFinds) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Point3> points = anyPoints(120);
    const Point3 place = anyPoints(2).front() / 2.0;
    std::vector<std::pair<double, std::uint32_t>> all;
    all.reserve(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) all.emplace_back((points[i] - place).squaredNorm(), i);
    std::sort(all.begin(), all.end());
    const auto count = static_cast<std::size_t>(*rc::gen::inRange(0, 12));
    const std::vector<NearPoint> found = NearestPoints(points).nearest(place, count);
    RC_ASSERT(found.size() == std::min(count, points.size()));
    for (std::size_t i = 0; i < found.size(); ++i) {
      RC_ASSERT(found[i].squared == all[i].first);
      RC_ASSERT(found[i].index == all[i].second);
    }
  }));
}

TEST(NearestPoints, AreNoneOfNone) { EXPECT_TRUE(NearestPoints({}).nearest({1, 2, 3}, 4).empty()); }

}  // namespace
}  // namespace lamina
