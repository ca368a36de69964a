// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina::test {

/// Points on a random walk at one height, at least 0.1 mm apart.
inline std::vector<Point3> randomWalk(Random& random, const Point3& start) {
  std::vector<Point3> points{start};
  const std::size_t count = 2 + random.below(8);
  while (points.size() < count) {
    const double angle = random.uniform(0.0, 2.0 * M_PI);
    const double length = random.uniform(0.1, 20.0);
    points.push_back(points.back() + length * Point3(std::cos(angle), std::sin(angle), 0.0));
  }
  return points;
}

inline Path randomTravel(Random& random, const Point3& from, const Point3& to) {
  Path path;
  path.role = PathRole::Travel;
  path.points = {from, Point3(from.x(), from.y(), to.z() + random.uniform(0.1, 1.0)), to};
  path.feed_mm_s = random.uniform(50.0, 200.0);
  path.process.is_retracted = random.below(2) == 0;
  return path;
}

inline Path randomDeposition(Random& random, const Point3& start, double height_mm) {
  Path path;
  path.role = static_cast<PathRole>(random.below(5));
  path.points = randomWalk(random, start);
  path.is_closed = path.points.size() > 2 && random.below(2) == 0;
  std::vector<Bead> beads;
  std::vector<double> feeds;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    beads.push_back({random.uniform(0.25, 1.0), height_mm});
    feeds.push_back(random.uniform(5.0, 100.0));
  }
  path.bead = random.below(3) == 0 ? AlongPath<Bead>(beads) : AlongPath<Bead>(beads.front());
  path.feed_mm_s = random.below(3) == 0 ? AlongPath<double>(feeds) : AlongPath<double>(feeds.front());
  return path;
}

/// A valid planar toolpath with every role, open and closed paths that follow travels or one another, common
/// and varying beads and feeds, and retractions. Never two travels in a row.
inline Toolpath randomToolpath(std::uint64_t seed) {
  Random random(seed);
  Toolpath toolpath;
  toolpath.part_name = "random";
  Point3 nozzle(random.uniform(-50, 50), random.uniform(-50, 50), 0.0);
  const std::size_t layers = 1 + random.below(4);
  for (std::size_t l = 0; l < layers; ++l) {
    const double height_mm = random.uniform(0.1, 0.4);
    ToolpathLayer layer{nozzle.z() + height_mm, height_mm, {}};
    bool is_travelling = true;
    for (std::size_t count = 1 + random.below(6); count > 0; --count) {
      const Point3 start(random.uniform(-50, 50), random.uniform(-50, 50), layer.z_mm);
      if (is_travelling) layer.paths.push_back(randomTravel(random, nozzle, start));
      layer.paths.push_back(randomDeposition(random, is_travelling ? start : nozzle, height_mm));
      nozzle = layer.paths.back().lastPoint();
      is_travelling = random.below(4) != 0;
    }
    toolpath.layers.push_back(std::move(layer));
  }
  return toolpath;
}

}  // namespace lamina::test
