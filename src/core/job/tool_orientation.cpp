// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/tool_orientation.hpp"

#include <cmath>
#include <cstdio>

namespace lamina {
namespace {

std::string textOf(const WaypointPlace& place) {
  return "layer " + std::to_string(place.layer) + ", path " + std::to_string(place.path) + ", waypoint " +
         std::to_string(place.waypoint);
}

/// One sentence for all runs that a limit changed, with the one that was changed most.
void addLimit(const OrientationReport& report, OrientationLimit limit, std::vector<std::string>& notes) {
  const LimitHit* worst = nullptr;
  std::size_t runs = 0;
  for (const LimitHit& hit : report.limits_hit) {
    if (hit.limit != limit) continue;
    ++runs;
    const bool is_worse = worst == nullptr || std::abs(hit.wanted_deg - hit.given_deg) >
                                                  std::abs(worst->wanted_deg - worst->given_deg);
    if (is_worse) worst = &hit;
  }
  if (worst == nullptr) return;
  char text[256];
  std::snprintf(text, sizeof text,
                "orientation.%s changed %zu runs, most at %s: %.2f deg wanted, %.2f deg given",
                limit == OrientationLimit::Tilt ? "max_tilt_deg" : "max_turn_deg_per_mm", runs,
                textOf(worst->worst).c_str(), worst->wanted_deg, worst->given_deg);
  notes.emplace_back(text);
}

}  // namespace

bool changesOrientation(const OrientationSettings& settings) {
  const OrientationSettings as_sliced;
  return settings.mode != OrientationMode::LayerNormal || settings.lead_deg != 0.0 ||
         settings.tilt_deg != 0.0 || settings.smoothing_window != 1 || settings.heading_deg != 0.0 ||
         settings.limits.max_tilt_deg != as_sliced.limits.max_tilt_deg ||
         settings.limits.max_turn_deg_per_mm != as_sliced.limits.max_turn_deg_per_mm;
}

std::vector<std::string> notesOn(const OrientationReport& report) {
  std::vector<std::string> notes;
  addLimit(report, OrientationLimit::Tilt, notes);
  addLimit(report, OrientationLimit::Turn, notes);
  if (report.waypoints_without_wall > 0)
    notes.push_back("orientation.mode wall found no wall across the path at " +
                    std::to_string(report.waypoints_without_wall) +
                    " waypoints of walls; their neighbours' jets stand there");
  return notes;
}

}  // namespace lamina
