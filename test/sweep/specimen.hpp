// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina::test {

inline Path bead(std::vector<Point3> points, const Bead& bead) {
  Path path;
  path.points = std::move(points);
  path.bead = bead;
  path.feed_mm_s = 30.0;
  return path;
}

inline Path ring(std::vector<Point3> points, const Bead& section) {
  Path path = bead(std::move(points), section);
  path.is_closed = true;
  return path;
}

/// Paths in layers of those nozzle heights.
template <class PathsAt>
Toolpath layered(const std::vector<double>& z_mm, const PathsAt& paths_at) {
  Toolpath toolpath;
  double below_mm = 0.0;
  for (std::size_t l = 0; l < z_mm.size(); ++l) {
    toolpath.layers.push_back({z_mm[l], z_mm[l] - below_mm, paths_at(l, z_mm[l], z_mm[l] - below_mm)});
    below_mm = z_mm[l];
  }
  return toolpath;
}

/// Solid bending specimen of 40 x 5 mm as [Vega2023, figure 22] begins it: rings 0.5 mm apart.
inline Toolpath concentricSpecimen(int layers, double height_mm, double width_mm) {
  std::vector<double> z_mm;
  for (int l = 1; l <= layers; ++l) z_mm.push_back(l * height_mm);
  return layered(z_mm, [width_mm](std::size_t, double z, double h) {
    std::vector<Path> paths;
    for (int i = 0; i < 5; ++i) {
      const double in = 2.0 + 0.5 * i, x = 43.5 - in, y = 8.5 - in;
      paths.push_back(ring({{in, in, z}, {x, in, z}, {x, y, z}, {in, y, z}}, {width_mm, h}));
    }
    return paths;
  });
}

/// Cylinder of 10 mm diameter, 23 layers up to 6.95 mm: a wall and lines across by turns, spaced as Slic3r
/// does for a density, that end where the wall begins.
inline Toolpath cylinder(double density) {
  std::vector<double> z_mm = {0.35};
  while (z_mm.size() < 23) z_mm.push_back(z_mm.back() + 0.3);
  return layered(z_mm, [density](std::size_t l, double z, double h) {
    const Bead wall = {0.44, h}, line = {0.48, h};
    std::vector<Point3> circle;
    constexpr int kCorners = 72;
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2.0 * M_PI * i / kCorners;
      circle.emplace_back(4.78 * std::cos(angle), 4.78 * std::sin(angle), z);
    }
    std::vector<Path> paths = {ring(circle, wall)};
    const double spacing = (line.width_mm - h * (1.0 - M_PI / 4.0)) / density;
    const double inner = 4.78 - 0.22;
    for (double at = -inner + spacing / 2; at < inner; at += spacing) {
      const double edge = std::abs(at) + line.width_mm / 2;
      if (edge > 0.98 * inner) continue;
      const double reach = std::sqrt(inner * inner - edge * edge);
      paths.push_back(l % 2 == 0 ? bead({{-reach, at, z}, {reach, at, z}}, line)
                                 : bead({{at, -reach, z}, {at, reach, z}}, line));
    }
    return paths;
  });
}

}  // namespace lamina::test
