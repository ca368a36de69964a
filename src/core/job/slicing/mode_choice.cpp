// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/slicing/mode_choice.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "lamina/base/angle.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/verification/overhang/overhang_angle.hpp"

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

/// Machines hold their nozzle still; poses are for any head, and a robot turns it.
bool maySteer(const SliceJob& job) {
  switch (programRunner(job.output)) {
    case ProgramRunner::OtherRobot:
      return true;
    case ProgramRunner::RapidRobot:
      return job.settings.program.rapid.variant == RapidVariant::Powder5Axes;
    case ProgramRunner::Machine:
      break;
  }
  return std::filesystem::path(job.output).extension() == ".csv";
}

/// Where no setting names the mode.
std::vector<ModeChoice> modesBySurface(const Mesh& mesh, const SliceJob& job) {
  const JobSettings& settings = job.settings;
  const GentleSlopes slopes =
      gentleSlopes(mesh, settings.height_field.max_slope_deg, settings.slicing.layer_height_mm);
  const std::string gentle =
      percent(slopes.gentle_mm2, slopes.area_mm2) + " of the surface slopes gently (1 to 45 deg from level)";
  if (slopes.gentle_mm2 < kLeastGentleShare * slopes.area_mm2)
    return {{"planar", gentle + ", too little for curved layers to pay"}};
  std::vector<ModeChoice> modes;
  const bool lies_on_bed = slopes.hanging_mm2 <= kMostHangingShare * slopes.area_mm2;
  if (maySteer(job) && lies_on_bed)
    modes.push_back({"curved", gentle + ", and the output is poses, so that the nozzle may tilt"});
  if (slopes.followed_mm2 >= kLeastFollowedShare * slopes.upper_mm2 && slopes.followed_mm2 > 0.0)
    modes.push_back({"heightfield", gentle + ", and bent layers can follow " +
                                        percent(slopes.followed_mm2, slopes.upper_mm2) +
                                        " of what of it faces up"});
  const std::string hanging = lies_on_bed ? ""
                                          : ", and curved layers would begin in the air, for " +
                                                percent(slopes.hanging_mm2, slopes.area_mm2) +
                                                " of the surface faces down above the bed";
  modes.push_back({"planar", gentle + ", but bent layers cannot follow it" + hanging});
  return modes;
}

}  // namespace

std::vector<ModeChoice> modesFor(const Mesh& mesh, const SliceJob& job) {
  const JobSettings& settings = job.settings;
  if (!settings.conformal.base.empty()) return {{"conformal", "conformal.base is set"}};
  if (settings.slicing.plane.angle_deg != 0.0) return {{"inclined", "slicing.plane.angle_deg is not 0"}};
  if (!isLoneWall(settings.planning)) return modesBySurface(mesh, job);
  const OverhangAngle lean = overhangAngle(
      mesh, Point3::UnitZ(), {settings.planning.bead.width_mm, settings.slicing.layer_height_mm});
  std::vector<ModeChoice> modes;
  if (lean.greatest_rad > 0.0 && maySteer(job))
    modes.push_back({"adapted", "a lone wall is asked for, and it leans outwards"});
  modes.push_back({"planar", "a lone wall is asked for, and layers are not adapted to it"});
  return modes;
}

}  // namespace lamina
