// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/run_path.hpp"

#include <utility>

#include "planning/bridges/bridged_areas.hpp"
#include "planning/skins/ironing.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {

AlongPath<Bead> beadsOf(const std::vector<double>& width_mm, double area_per_width, double height_mm) {
  std::vector<Bead> beads;
  beads.reserve(width_mm.size());
  for (const double width : width_mm) beads.push_back(beadOfArea(width * area_per_width, height_mm));
  return AlongPath<Bead>(std::move(beads));
}

AlongPath<Bead> beadsAlong(const FillPath& run, const PlanSettings& settings, const Bead& nominal,
                           double pitch_mm) {
  if (run.deposit == Deposit::Drops) return Bead{settings.fill.drops.diameter_mm, nominal.height_mm};
  if (run.role == PathRole::Bridge) return threadBead(settings.bridges, nominal);
  if (run.role == PathRole::Ironing) return ironingBead(settings.ironing, nominal.height_mm);
  if (run.width_mm.empty()) return nominal;
  return beadsOf(run.width_mm, crossSection(nominal) / pitch_mm, nominal.height_mm);
}

Path withFlow(Path path, double factor) {
  if (factor == 1.0 || path.role == PathRole::Travel) return path;
  std::vector<Bead> beads = path.bead.values();
  for (Bead& bead : beads) bead = beadOfArea(factor * crossSection(bead), bead.height_mm);
  path.bead = AlongPath<Bead>(std::move(beads));
  return path;
}

ToolpathLayer withoutFlow(ToolpathLayer layer, double factor) {
  for (Path& path : layer.paths)
    if (isPartOfPart(path)) path = withFlow(std::move(path), 1.0 / factor);
  return layer;
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
