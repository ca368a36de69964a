// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/part/belt_travels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/scan_height.hpp"
#include "toolpath/layer_time.hpp"

namespace lamina {
namespace {

constexpr double kSameDirection = 1.75e-4;  // sine: 0.01 deg, as machines are accepted
constexpr double kSamePoint = 1e-9;         // mm
constexpr double kScanHeight = 1e-3;        // mm

/// Directions in which a waypoint can be moved between layers [part frame].
struct BeltFrame {
  Point3 normal = Point3::Zero();     ///< of the layers, of unit length
  Point3 direction = Point3::Zero();  ///< by the belt alone, for a height of 1 along the normal
};

/// None if the belt moves within layers too, or if there is none.
std::optional<BeltFrame> beltFrame(const BuildSpace& space, const Eigen::Isometry3d& bed_from_part,
                                   const Point3& normal) {
  const auto endless = std::find(space.is_endless.begin(), space.is_endless.end(), true);
  if (endless == space.is_endless.end()) return std::nullopt;
  const auto belt = static_cast<Eigen::Index>(endless - space.is_endless.begin());
  const Eigen::Affine3d axes_from_part = space.bed_from_axes.inverse() * bed_from_part;
  const Point3 value = axes_from_part.linear().row(belt).transpose();
  if (value.normalized().cross(normal).norm() > kSameDirection) return std::nullopt;
  const Point3 direction = bed_from_part.linear().transpose() * space.bed_from_axes.linear().col(belt);
  return BeltFrame{normal, direction / direction.dot(normal)};
}

/// Whether the nozzle stays somewhere on the way, rather than at its ends.
bool waitsOnWay(const Path& path) {
  return std::any_of(path.events.begin(), path.events.end(), [&path](const PathEvent& placed) {
    return placed.motion > 0 && placed.motion < path.motionCount();
  });
}

bool isUniform(const Path& path) {
  return path.orientation.isCommon() && path.bead.isCommon() && path.feed_mm_s.isCommon() &&
         std::all_of(path.values.begin(), path.values.end(),
                     [](const ProcessValue& value) { return value.value.isCommon(); });
}

/// Without motions of no length. Both ends stay, and events stay at their points.
void dropRests(Path& path) {
  if (!isUniform(path)) return;
  for (std::size_t i = 1; i < path.points.size() && path.points.size() > 2;) {
    if ((path.points[i] - path.points[i - 1]).norm() > kSamePoint) {
      ++i;
      continue;
    }
    const std::size_t dropped = i + 1 < path.points.size() ? i : i - 1;
    path.points.erase(path.points.begin() + static_cast<std::ptrdiff_t>(dropped));
    for (PathEvent& placed : path.events)
      if (placed.motion >= i) --placed.motion;
  }
}

/// Whether the path goes at the height from which its layer is scanned.
bool scans(const Path& path, const ToolpathLayer& layer, double clearance_mm, const Point3& normal) {
  const double height = scanHeight(layer, clearance_mm);
  return std::any_of(path.points.begin(), path.points.end(),
                     [&](const Point3& point) { return std::abs(normal.dot(point) - height) < kScanHeight; });
}

double timeOf(Path path, const MotionLimits& limits) {
  path.events.clear();
  return layerTime({0.0, 0.0, {std::move(path)}}, limits);
}

/// What a way is shorter it waits longer.
void waitLonger(Path& path, double before_s, const MotionLimits& limits) {
  for (PathEvent& placed : path.events)
    if (auto* const dwell = std::get_if<Dwell>(&placed.event)) {
      dwell->duration_s = std::max(0.0, dwell->duration_s + before_s - timeOf(path, limits));
      return;
    }
}

bool dwells(const Path& path) {
  return std::any_of(path.events.begin(), path.events.end(),
                     [](const PathEvent& placed) { return std::holds_alternative<Dwell>(placed.event); });
}

/// Leads ways between beads.
class BeltWays {
 public:
  BeltWays(const BeltFrame& frame, const MotionLimits& limits) : frame_(frame), limits_(limits) {}

  /// @param way  from one bead to the next
  void lead(const std::vector<Path*>& way) const {
    const double start = heightOf(way.front()->firstPoint());
    const double end = heightOf(way.back()->lastPoint());
    const Limits within{std::min(start, end), std::max(start, end)};
    const bool waits =
        std::any_of(way.begin(), way.end(), [](const Path* path) { return waitsOnWay(*path); });
    const Point3 direction = waits ? frame_.direction : frame_.normal;
    double reached = start;
    for (Path* const path : way) {
      std::vector<Point3> led = path->points;
      const std::size_t count = led.size() - (path == way.back() ? 1 : 0);
      for (std::size_t i = 0; i < count; ++i) {
        const double height = heightOf(led[i]);
        reached = std::clamp(std::max(reached, height), within.low, within.high);
        if (std::abs(reached - height) > kSamePoint) led[i] += (reached - height) * direction;
      }
      if (led != path->points) replace(*path, std::move(led));
    }
  }

 private:
  /// Heights of the ends of a way.
  struct Limits {
    double low = 0.0;
    double high = 0.0;
  };

  double heightOf(const Point3& point) const { return frame_.normal.dot(point); }

  void replace(Path& path, std::vector<Point3> led) const {
    const double before_s = dwells(path) ? timeOf(path, limits_) : 0.0;
    path.points = std::move(led);
    dropRests(path);
    if (dwells(path)) waitLonger(path, before_s, limits_);
  }

  const BeltFrame& frame_;
  const MotionLimits& limits_;
};

}  // namespace

void keepBeltForward(Toolpath& toolpath, const BuildSpace& space, const Eigen::Isometry3d& bed_from_part,
                     const MotionLimits& limits, std::optional<double> scan_clearance_mm) {
  const std::optional<BeltFrame> frame = beltFrame(space, bed_from_part, layerNormal(toolpath));
  if (!frame || !hasPlaneLayers(toolpath)) return;
  const BeltWays ways(*frame, limits);
  std::vector<Path*> way;
  bool is_led = false;  // not before the first bead, and not where the sensor stands off
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths) {
      if (path.role == PathRole::Travel) {
        is_led &= !scan_clearance_mm || !scans(path, layer, *scan_clearance_mm, frame->normal);
        way.push_back(&path);
        continue;
      }
      if (is_led && !way.empty()) ways.lead(way);
      way.clear();
      is_led = true;
    }
}

}  // namespace lamina
