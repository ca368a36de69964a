// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/orient_toolpath.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/layer_error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/orientation/lead_and_tilt.hpp"
#include "lamina/orientation/no_spin.hpp"
#include "lamina/orientation/orientation_limits.hpp"
#include "lamina/orientation/orientation_report.hpp"
#include "lamina/orientation/orientation_settings.hpp"
#include "lamina/orientation/orientation_smoothing.hpp"
#include "lamina/orientation/path_tangents.hpp"
#include "lamina/orientation/wall_following.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "orientation/travel_turn.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

void raise(GreatestAngle& greatest, double value, const WaypointIndex& at) {
  if (value > greatest.value) greatest = {value, at};
}

double turnDeg(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  return toDegrees(from.angularDistance(to));
}

void addPath(OrientationReport& report, const Path& path, WaypointIndex at) {
  const std::vector<Eigen::Quaterniond>& values = path.orientation.values();
  for (at.waypoint = 0; at.waypoint < values.size(); ++at.waypoint)
    raise(report.lean_deg, leanDeg(toolAxisOf(values[at.waypoint])), at);
  if (path.orientation.isCommon()) return;
  GreatestAngle& per_mm = path.role == PathRole::Travel ? report.travel_deg_per_mm : report.turn_deg_per_mm;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    at.waypoint = path.motionEnd(m);
    const double turn = turnDeg(values[m], values[at.waypoint]);
    const double length = (path.points[at.waypoint] - path.points[m]).norm();
    raise(report.step_deg, turn, at);
    if (length > 0.0) raise(per_mm, turn / length, at);
  }
}

/// The greatest lean and turns of a toolpath; limits are not known here.
OrientationReport measuredTurns(const Toolpath& toolpath) {
  OrientationReport report;
  const Path* before = nullptr;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l) {
    const std::vector<Path>& paths = toolpath.layers[l].paths;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      if (before != nullptr)
        raise(report.step_deg, turnDeg(endOrientation(*before), startOrientation(paths[p])), {l, p, 0});
      addPath(report, paths[p], {l, p, 0});
      before = &paths[p];
    }
  }
  return report;
}

/// The orientation of one run and what happened on the way to it.
struct RunOrientation {
  AlongPath<Eigen::Quaterniond> orientation;
  std::vector<LimitHit> limits_hit;  ///< `worst` without layer and path
  std::size_t waypoints_without_wall = 0;
};

constexpr double kSame = 1e-12;       // between components of unit vectors and quaternions
constexpr double kChangedDeg = 1e-6;  // a tool axis that a limit moved by less was not limited

/// One tool axis per waypoint, or a single one for all of them.
using ToolAxes = std::vector<Point3>;

bool isWall(PathRole role) { return kindOf(role) == RoleKind::Wall; }

ToolAxes givenToolAxes(const Path& run) {
  ToolAxes tool_axes;
  tool_axes.reserve(run.orientation.values().size());
  for (const Eigen::Quaterniond& value : run.orientation.values())
    tool_axes.push_back(toolAxisOf(value.normalized()));
  return tool_axes;
}

Point3 fixedToolAxis(const FixedDirection& fixed) {
  const double lean = toRadians(fixed.lean_deg);
  const double heading = toRadians(fixed.heading_deg);
  if (lean == 0.0) return -Point3::UnitZ();
  return {-std::sin(lean) * std::cos(heading), -std::sin(lean) * std::sin(heading), -std::cos(lean)};
}

ToolAxes leaned(ToolAxes tool_axes, const Path& run, const OrientationSettings& settings) {
  if (settings.lead_deg == 0.0 && settings.tilt_deg == 0.0) return tool_axes;
  const std::vector<Point3> tangents = pathTangents(run);
  if (tangents.empty()) return tool_axes;
  tool_axes.resize(run.points.size(), tool_axes.front());
  for (std::size_t i = 0; i < tool_axes.size(); ++i)
    tool_axes[i] = withLeadAndTilt(tool_axes[i], tangents[i], settings.lead_deg, settings.tilt_deg);
  return tool_axes;
}

/// What a limit wanted and gave at each waypoint, gathered into one entry per run.
class HitCount {
 public:
  explicit HitCount(OrientationLimit limit) { hit_.limit = limit; }

  void add(std::size_t waypoint, double wanted_deg, double given_deg) {
    ++hit_.waypoints;
    if (hit_.waypoints > 1 && wanted_deg - given_deg <= hit_.wanted_deg - hit_.given_deg) return;
    hit_.worst.waypoint = waypoint;
    hit_.wanted_deg = wanted_deg;
    hit_.given_deg = given_deg;
  }
  void appendTo(std::vector<LimitHit>& hits) const {
    if (hit_.waypoints > 0) hits.push_back(hit_);
  }

 private:
  LimitHit hit_;
};

ToolAxes leanLimited(ToolAxes tool_axes, double max_deg, std::vector<LimitHit>& hits, std::size_t waypoints) {
  HitCount count(OrientationLimit::Lean);
  const std::size_t each =
      waypoints / tool_axes.size();  // waypoints per tool axis: all of them if it is common
  for (std::size_t i = 0; i < tool_axes.size(); ++i) {
    const double wanted = leanDeg(tool_axes[i]);
    if (wanted <= max_deg + kChangedDeg) continue;
    tool_axes[i] = withLeanLimit(tool_axes[i], max_deg);
    for (std::size_t k = 0; k < each; ++k) count.add(i + k, wanted, max_deg);
  }
  count.appendTo(hits);
  return tool_axes;
}

ToolAxes turnLimited(ToolAxes tool_axes, const Path& run, double max_deg_per_mm,
                     std::vector<LimitHit>& hits) {
  if (max_deg_per_mm == 0.0 || tool_axes.size() < 2) return tool_axes;
  ToolAxes given = withTurnLimit(tool_axes, motionLengths(run), max_deg_per_mm);
  HitCount count(OrientationLimit::Turn);
  for (std::size_t i = 0; i < tool_axes.size(); ++i) {
    if (angleDeg(tool_axes[i], given[i]) <= kChangedDeg) continue;
    const std::size_t before = i > 0 ? i - 1 : run.is_closed ? tool_axes.size() - 1 : 0;
    count.add(i, angleDeg(tool_axes[before], tool_axes[i]), angleDeg(given[before], given[i]));
  }
  count.appendTo(hits);
  return given;
}

AlongPath<Eigen::Quaterniond> heldAlong(const ToolAxes& tool_axes, double heading_deg) {
  if (tool_axes.size() == 1) return noSpinFrame(tool_axes.front(), heading_deg);
  std::vector<Eigen::Quaterniond> frames = noSpinFrames(tool_axes, heading_deg);
  const auto differs = [&](const Eigen::Quaterniond& frame) {
    return (frame.coeffs() - frames.front().coeffs()).cwiseAbs().maxCoeff() > kSame;
  };
  if (std::none_of(frames.begin(), frames.end(), differs)) return frames.front();
  return AlongPath<Eigen::Quaterniond>(std::move(frames));
}

/// @param walls  of the part, in mode wall; null otherwise
RunOrientation runOrientation(const Path& run, const OrientationSettings& settings,
                              const WallNormals* walls) {
  RunOrientation result;
  ToolAxes tool_axes;
  if (settings.mode == OrientationMode::Fixed) {
    tool_axes = {fixedToolAxis(settings.fixed)};
  } else if (walls != nullptr && isWall(run.role)) {
    WallToolAxes following = wallFollowingToolAxes(run, *walls);
    tool_axes = std::move(following.tool_axes);
    result.waypoints_without_wall = following.waypoints_without_wall;
  } else {
    tool_axes = givenToolAxes(run);
  }
  tool_axes = leaned(std::move(tool_axes), run, settings);
  tool_axes =
      smoothedToolAxes(tool_axes, run.is_closed ? Course::Closed : Course::Open, settings.smoothing_window);
  tool_axes =
      leanLimited(std::move(tool_axes), settings.limits.max_lean_deg, result.limits_hit, run.points.size());
  tool_axes = turnLimited(std::move(tool_axes), run, settings.limits.max_turn_deg_per_mm, result.limits_hit);
  result.orientation = heldAlong(tool_axes, settings.heading_deg);
  return result;
}

/// What orienting one layer found.
struct LayerFindings {
  std::vector<LimitHit> limits_hit;
  std::size_t waypoints_without_wall = 0;
};

RunOrientation orientedAt(const std::string& place, const Path& run, const OrientationSettings& settings,
                          const WallNormals* walls) {
  try {
    return runOrientation(run, settings, walls);
  } catch (...) {
    rethrowAt(place);
  }
}

LayerFindings orientLayer(ToolpathLayer& layer, std::size_t number, const OrientationSettings& settings,
                          const WallNormals* walls) {
  LayerFindings findings;
  for (std::size_t p = 0; p < layer.paths.size(); ++p) {
    Path& path = layer.paths[p];
    if (path.role == PathRole::Travel) continue;
    RunOrientation run = orientedAt(pathPlace(number, layer.z_mm, p), path, settings, walls);
    path.orientation = std::move(run.orientation);
    findings.waypoints_without_wall += run.waypoints_without_wall;
    for (LimitHit& hit : run.limits_hit) {
      hit.worst.layer = number;
      hit.worst.path = p;
      findings.limits_hit.push_back(hit);
    }
  }
  return findings;
}

}  // namespace

OrientedToolpath orientToolpath(Toolpath toolpath, const OrientationSettings& settings, const Mesh& part,
                                Progress& progress) {
  requireConsistent(settings);
  std::optional<WallNormals> walls;
  if (settings.mode == OrientationMode::Wall)
    walls.emplace(part, layerNormal(toolpath), settings.wall.max_lean_deg);
  std::vector<LayerFindings> findings(toolpath.layers.size());
  parallelFor(
      findings.size(),
      [&](std::size_t l) {
        findings[l] = orientLayer(toolpath.layers[l], l, settings, walls ? &*walls : nullptr);
      },
      progress, "orient");
  OrientedToolpath result;
  result.toolpath = withTravelsOriented(std::move(toolpath));
  result.report = measuredTurns(result.toolpath);
  for (const LayerFindings& layer : findings) {
    result.report.limits_hit.insert(result.report.limits_hit.end(), layer.limits_hit.begin(),
                                    layer.limits_hit.end());
    result.report.waypoints_without_wall += layer.waypoints_without_wall;
  }
  return result;
}

}  // namespace lamina
