// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/travel.hpp"

#include <algorithm>

#include "planning/travel/retraction.hpp"

namespace lamina {

std::optional<Path> makeTravel(const Point3& from, const Point3& to, const TravelSettings& settings,
                               TravelOver over) {
  if (from == to) return std::nullopt;
  Path path;
  path.role = PathRole::Travel;
  path.feed_mm_s = settings.feed_mm_s;
  path.process.is_retracted = isRetracted((to - from).head<2>().norm(), over, settings);
  const double z = std::max(from.z(), to.z()) + (path.process.is_retracted ? settings.hop_mm : 0.0);
  path.points.reserve(4);
  for (const Point3& point : {from, Point3(from.x(), from.y(), z), Point3(to.x(), to.y(), z), to})
    if (path.points.empty() || path.points.back() != point) path.points.push_back(point);
  return path;
}

TravelMaker levelTravels(const TravelSettings& settings) {
  return [settings](const Path& from, const Path& to, std::size_t) {
    return makeTravel(from.lastPoint(), to.firstPoint(), settings);
  };
}

}  // namespace lamina
