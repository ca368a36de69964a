// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/build_aids.hpp"

#include <utility>

#include "planning/order/near_origin.hpp"

namespace lamina {

LayerAids moved(LayerAids aids, const Point2& by) {
  for (AidRuns& group : aids) {
    std::vector<FillPath> runs = *group.runs;
    for (FillPath& run : runs)
      for (Point2& point : run.points) point += by;
    group.runs = std::make_shared<const std::vector<FillPath>>(std::move(runs));
    if (group.area) group.area = std::make_shared<const Regions>(moved(*group.area, by));
  }
  return aids;
}

double depositedVolume(const AidRuns& aids) {
  double length_mm = 0.0;
  for (const FillPath& run : *aids.runs)
    length_mm += run.is_closed ? perimeter(run.points) : length(run.points);
  return length_mm * crossSection(aids.bead);
}

}  // namespace lamina
