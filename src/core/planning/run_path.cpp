// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/run_path.hpp"

#include <utility>

namespace lamina {

AlongPath<Bead> beadsOf(const std::vector<double>& width_mm, double area_per_width, double height_mm) {
  std::vector<Bead> beads;
  beads.reserve(width_mm.size());
  for (const double width : width_mm) beads.push_back(beadOfArea(width * area_per_width, height_mm));
  return AlongPath<Bead>(std::move(beads));
}

Path withFlow(Path path, double factor) {
  if (factor == 1.0 || path.role == PathRole::Travel) return path;
  std::vector<Bead> beads = path.bead.values();
  for (Bead& bead : beads) bead = beadOfArea(factor * crossSection(bead), bead.height_mm);
  path.bead = AlongPath<Bead>(std::move(beads));
  return path;
}

Path pathAlong(const FillPath& run, AlongPath<Bead> bead, double z_mm, double feed_mm_s) {
  Path path;
  path.role = run.role;
  path.is_closed = run.is_closed;
  path.deposit = run.deposit;
  path.points.reserve(run.points.size());
  for (const Point2& point : run.points) path.points.emplace_back(point.x(), point.y(), z_mm);
  path.bead = std::move(bead);
  path.feed_mm_s = feed_mm_s;
  return path;
}

}  // namespace lamina
