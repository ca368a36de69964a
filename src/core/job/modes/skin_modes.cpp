// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/skin_modes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

constexpr double kLevelDeg = 1.0;
constexpr double kSteepDeg = 45.0;
constexpr double kLeastGentleShare = 0.05;   // of the surface, from which steps are worth avoiding
constexpr double kMostHangingShare = 0.05;   // of the surface, facing down above the bed
constexpr double kUpright = 0.02;            // n_z of walls
constexpr double kLeastFollowedShare = 0.5;  // of the gentle upper side, from which bent layers pay

/// How much of a part's surface slopes gently.
struct GentleSlopes {
  double area_mm2 = 0.0;      // of the whole surface
  double gentle_mm2 = 0.0;    // facing up or down
  double upper_mm2 = 0.0;     // of it, facing up
  double followed_mm2 = 0.0;  // of that, flatter than bent layers may become
  double hanging_mm2 = 0.0;   // facing down, and not on the bed
};

GentleSlopes gentleSlopes(const Mesh& mesh, double max_slope_deg, double layer_height_mm) {
  GentleSlopes slopes;
  const double on_bed = boundingBox(mesh).low.z() + layer_height_mm;
  for (const Triangle& corner : mesh.triangles) {
    const Point3& a = mesh.vertices[corner[0]];
    const Point3 cross = (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a);
    const double doubled = cross.norm();
    slopes.area_mm2 += 0.5 * doubled;
    const double highest = std::max({a.z(), mesh.vertices[corner[1]].z(), mesh.vertices[corner[2]].z()});
    if (cross.z() < -kUpright * doubled && highest > on_bed) slopes.hanging_mm2 += 0.5 * doubled;
    const double slope_deg = toDegrees(std::atan2(cross.head<2>().norm(), std::abs(cross.z())));
    if (slope_deg < kLevelDeg || slope_deg > kSteepDeg) continue;
    slopes.gentle_mm2 += 0.5 * doubled;
    if (cross.z() < 0.0) continue;
    slopes.upper_mm2 += 0.5 * doubled;
    if (slope_deg <= max_slope_deg) slopes.followed_mm2 += 0.5 * doubled;
  }
  return slopes;
}

std::string percent(double part, double whole) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", whole > 0.0 ? 100.0 * part / whole : 0.0);
  return text;
}

}  // namespace

std::vector<ModeChoice> modesForSkins(const Mesh& mesh, const JobSettings& settings, Nozzle nozzle) {
  const GentleSlopes slopes =
      gentleSlopes(mesh, settings.height_field.max_slope_deg, settings.slicing.layer_height_mm);
  if (slopes.gentle_mm2 < kLeastGentleShare * slopes.area_mm2) return {};
  const std::string gentle =
      percent(slopes.gentle_mm2, slopes.area_mm2) + " of the surface slopes gently (1 to 45 deg from level)";
  std::vector<ModeChoice> modes;
  if (nozzle == Nozzle::Tilting && slopes.hanging_mm2 <= kMostHangingShare * slopes.area_mm2)
    modes.push_back({"curved", gentle + ", and the nozzle may tilt"});
  if (slopes.followed_mm2 >= kLeastFollowedShare * slopes.upper_mm2 && slopes.followed_mm2 > 0.0)
    modes.push_back({"heightfield", gentle + ", and bent layers can follow " +
                                        percent(slopes.followed_mm2, slopes.upper_mm2) +
                                        " of what of it faces up"});
  return modes;
}

}  // namespace lamina
