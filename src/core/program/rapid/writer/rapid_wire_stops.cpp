// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/writer/rapid_wire_stops.hpp"

#include <algorithm>

#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

/// Of the run whose last path this is, from its end backwards.
RapidWireStop stopBefore(const std::vector<RapidPath>& paths, std::size_t last, double stop_s) {
  RapidWireStop stop;
  double left_s = stop_s;
  for (std::size_t p = last + 1; p-- > 0;) {
    const RapidPath& path = paths[p];
    for (std::size_t motion = path.path->motionCount(); motion-- > 0;) {
      const double feed_mm_s = path.path->feed_mm_s.at(path.path->motionEnd(motion));
      const double length_mm = motionLength(*path.path, motion);
      stop = {{p, motion + path.turnCount()}, std::min(length_mm, left_s * feed_mm_s)};
      if (left_s * feed_mm_s <= length_mm) return stop;
      left_s -= length_mm / feed_mm_s;
    }
    if (path.switches_on) break;
  }
  return stop;
}

}  // namespace

std::vector<RapidWireStop> rapidWireStops(const std::vector<RapidPath>& paths, double stop_s) {
  std::vector<RapidWireStop> stops;
  stops.reserve(static_cast<std::size_t>(
      std::count_if(paths.begin(), paths.end(), [](const RapidPath& path) { return path.switches_off; })));
  for (std::size_t p = 0; p < paths.size(); ++p)
    if (paths[p].switches_off) stops.push_back(stopBefore(paths, p, stop_s));
  return stops;
}

}  // namespace lamina
