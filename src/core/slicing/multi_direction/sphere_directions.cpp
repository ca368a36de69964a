// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/multi_direction/sphere_directions.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace lamina {
namespace {

constexpr double kSameAngle = 1e-9;
using Corner = std::array<std::int64_t, 3>;

std::vector<Point3> icosahedron() {
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Point3> corners;
  for (const double one : {-1.0, 1.0})
    for (const double other : {-golden, golden}) {
      corners.emplace_back(0.0, one, other);
      corners.emplace_back(one, other, 0.0);
      corners.emplace_back(other, 0.0, one);
    }
  return corners;
}

Corner keyOfDirection(const Point3& direction) {
  constexpr double kGrid = 1e6;
  return {std::llround(direction.x() * kGrid), std::llround(direction.y() * kGrid),
          std::llround(direction.z() * kGrid)};
}

/// Sides of the icosahedron of edge 2.
bool isSide(const Point3& a, const Point3& b) { return std::abs((a - b).squaredNorm() - 4.0) < 1e-6; }

}  // namespace

std::vector<Point3> sphereDirections(int count, double max_tilt_rad) {
  int parts = 2;
  while (5 * parts * parts + 1 < count) parts += 2;
  const std::vector<Point3> corners = icosahedron();
  std::map<Corner, Point3> found;
  const auto add = [&](const Point3& at) {
    const Point3 direction = at.normalized();
    const double tilt = std::atan2(direction.head<2>().norm(), direction.z());
    if (tilt <= max_tilt_rad + kSameAngle) found.emplace(keyOfDirection(direction), direction);
  };
  for (std::size_t a = 0; a < corners.size(); ++a)
    for (std::size_t b = a + 1; b < corners.size(); ++b)
      for (std::size_t c = b + 1; c < corners.size(); ++c) {
        if (!isSide(corners[a], corners[b]) || !isSide(corners[b], corners[c]) ||
            !isSide(corners[a], corners[c]))
          continue;
        for (int i = 0; i <= parts; ++i)
          for (int j = 0; i + j <= parts; ++j)
            add(i * corners[a] + j * corners[b] + (parts - i - j) * corners[c]);
      }
  std::vector<Point3> directions;
  directions.reserve(found.size());
  for (const auto& [key, direction] : found) directions.push_back(direction);
  return directions;
}

}  // namespace lamina
