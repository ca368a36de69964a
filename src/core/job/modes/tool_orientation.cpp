// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/tool_orientation.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/toolpath/waypoint_text.hpp"

namespace lamina {
namespace {

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
                limit == OrientationLimit::Lean ? "max_lean_deg" : "max_turn_deg_per_mm", runs,
                toText(worst->worst).c_str(), worst->wanted_deg, worst->given_deg);
  notes.emplace_back(text);
}

}  // namespace

bool changesOrientation(const OrientationSettings& settings) {
  const OrientationSettings as_sliced;
  return settings.mode != OrientationMode::LayerNormal || settings.lead_deg != 0.0 ||
         settings.tilt_deg != 0.0 || settings.smoothing_window != 1 || settings.heading_deg != 0.0 ||
         settings.limits.max_lean_deg != as_sliced.limits.max_lean_deg ||
         settings.limits.max_turn_deg_per_mm != as_sliced.limits.max_turn_deg_per_mm;
}

void requireNearNormal(const Toolpath& as_sliced, const Toolpath& oriented,
                       const OrientationSettings& settings) {
  const auto tool_axis = [](const Path& path, std::size_t w) {
    return Point3(path.orientation.at(w) * Point3::UnitZ());
  };
  double greatest = 0.0;
  WaypointIndex place;
  for (std::size_t l = 0; l < as_sliced.layers.size(); ++l)
    for (std::size_t p = 0; p < as_sliced.layers[l].paths.size(); ++p) {
      const Path& before = as_sliced.layers[l].paths[p];
      if (before.role == PathRole::Travel) continue;
      for (std::size_t w = 0; w < before.points.size(); ++w) {
        const Point3 normal = tool_axis(before, w);
        const Point3 held = tool_axis(oriented.layers[l].paths[p], w);
        const double angle = toDegrees(std::atan2(normal.cross(held).norm(), normal.dot(held)));
        if (angle <= greatest) continue;
        greatest = angle;
        place = {l, p, w};
      }
    }
  if (greatest <= settings.limits.max_off_normal_deg + 1e-6) return;
  char text[256];
  std::snprintf(text, sizeof text,
                "the nozzle would be held %.1f deg off the layer's normal at %s; expected at most %.4g deg "
                "(orientation.max_off_normal_deg): it would run into what is deposited",
                greatest, toText(place).c_str(), settings.limits.max_off_normal_deg);
  throw InvalidInput(text);
}

std::vector<std::string> notesOn(const OrientationReport& report) {
  std::vector<std::string> notes;
  addLimit(report, OrientationLimit::Lean, notes);
  addLimit(report, OrientationLimit::Turn, notes);
  if (report.waypoints_without_wall > 0)
    notes.push_back("orientation.mode wall found no wall across the path at " +
                    std::to_string(report.waypoints_without_wall) +
                    " waypoints of walls; their neighbours' tool axes stand there");
  return notes;
}

}  // namespace lamina
