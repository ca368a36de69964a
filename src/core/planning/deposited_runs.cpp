// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/deposited_runs.hpp"

#include <algorithm>
#include <utility>

#include "geometry/polygon/inside.hpp"

namespace lamina {

double areaMissed(const Regions& regions, const std::vector<Path>& paths, std::size_t before) {
  if (regions.size() == 1 && paths.size() > before) return 0.0;
  double missed = 0.0;
  for (const Region& region : regions) {
    const std::vector<Polygon> borders = outlines({region});
    const auto goes_inside = [&](const Path& path) {
      return path.role != PathRole::Travel &&
             std::any_of(path.points.begin(), path.points.end(),
                         [&](const Point3& point) { return contains(borders, point.head<2>()); });
    };
    if (std::none_of(paths.begin() + static_cast<std::ptrdiff_t>(before), paths.end(), goes_inside))
      missed += area({region});
  }
  return missed;
}

std::vector<RunEnds> endsOf(const std::vector<FillPath>& runs) {
  std::vector<RunEnds> ends;
  ends.reserve(runs.size());
  for (const FillPath& run : runs) ends.push_back({run.points.front(), lastPoint(run)});
  return ends;
}

std::vector<FillPath> inOrder(std::vector<FillPath> runs, RunOrder order, const Point2& from) {
  if (order == RunOrder::AsGiven) return runs;
  std::vector<FillPath> ordered;
  ordered.reserve(runs.size());
  for (const OrderedRun& next : orderRuns(endsOf(runs), from)) {
    FillPath& run = runs[next.run];
    ordered.push_back(next.is_reversed ? reversed(std::move(run)) : std::move(run));
  }
  return ordered;
}

std::vector<RunEnds> endsOf(const std::vector<Polygon>& loops) {
  std::vector<RunEnds> ends;
  ends.reserve(loops.size());
  for (const Polygon& loop : loops) ends.push_back({loop.front(), loop.front()});
  return ends;
}

std::vector<RunEnds> fillsSince(const std::vector<Path>& paths, std::size_t before) {
  std::vector<RunEnds> ends;
  for (std::size_t i = before; i < paths.size(); ++i)
    if (kindOf(paths[i].role) == RoleKind::Infill)
      ends.push_back({paths[i].firstPoint().head<2>(), paths[i].lastPoint().head<2>()});
  return ends;
}

Refilling refillingSince(const std::vector<Path>& paths, std::size_t before) {
  Refilling refilling;
  for (std::size_t i = before; i < paths.size(); ++i) {
    if (paths[i].role == PathRole::Travel) continue;
    ++refilling.runs;
    refilling.deposited_mm3 += depositedVolume(paths[i]);
  }
  return refilling;
}

}  // namespace lamina
