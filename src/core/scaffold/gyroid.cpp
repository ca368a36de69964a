// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scaffold/gyroid.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "infill/pattern/gyroid_graphs.hpp"
#include "scaffold/convex_clip.hpp"

namespace lamina {
namespace {

constexpr int kSegments = 64;  ///< of a curve along a period

}  // namespace

std::vector<Polyline> gyroidLines(const GyroidSlice& slice, const Polygon& outline) {
  const double unit = slice.period_mm / (2.0 * M_PI);
  const Eigen::Rotation2Dd turn(slice.angle_rad);
  double radius = 0.0;
  for (const Point2& corner : outline) radius = std::max(radius, corner.norm());
  const GyroidGraphs graphs(slice.z_mm / unit);
  const int periods = static_cast<int>(std::ceil(radius / slice.period_mm)) + 1;
  std::vector<Polyline> lines;
  for (int shift = -periods; shift <= periods; ++shift)
    for (const int branch : {-1, 1}) {
      Polyline graph;
      for (int s = -periods * kSegments; s <= periods * kSegments; ++s) {
        const double t = 2.0 * M_PI * s / kSegments;
        const double v = graphs.at(t, branch) + 2.0 * M_PI * shift;
        graph.push_back(turn * (unit * (graphs.isOverX() ? Point2(t, v) : Point2(v, t))));
      }
      std::vector<Polyline> inside = clippedToConvex(graph, outline);
      if (lines.size() % 2 != 0) {
        std::reverse(inside.begin(), inside.end());
        for (Polyline& line : inside) std::reverse(line.begin(), line.end());
      }
      std::move(inside.begin(), inside.end(), std::back_inserter(lines));
    }
  return lines;
}

}  // namespace lamina
