// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/inclined_layers.hpp"

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "base/decimals.hpp"
#include "geometry/space_vectors.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/slicing/planar/layer_plane.hpp"
#include "lamina/toolpath/layer_frame.hpp"

namespace lamina {
namespace {

constexpr double kToolAxisTolerance = toRadians(0.01);  // as that of reach
constexpr int kShownDigits = 4;                         // of numbers in messages

std::string text(const Point3& direction) {
  char coordinates[96];
  std::snprintf(coordinates, sizeof coordinates, "(%.3f, %.3f, %.3f)", direction.x(), direction.y(),
                direction.z());
  return coordinates;
}

/// The settings that give layers with this tool axis along their normal.
std::string planeOf(const Point3& tool_axis) {
  // Adding 0 makes -0 a 0.
  const double angle = std::atan2(tool_axis.head<2>().norm(), -tool_axis.z());
  return "slicing.plane.angle_deg " + significantText(angle * kDegreesPerRadian, kShownDigits) +
         " and slicing.plane.axis_heading_deg " +
         significantText(std::atan2(-tool_axis.x(), tool_axis.y()) * kDegreesPerRadian + 0.0, kShownDigits);
}

}  // namespace

BedPlane bedBelow(const PlaneSettings& plane, const Eigen::Isometry3d& bed_from_part) {
  const Point3 up = bed_from_part.linear().transpose() * Point3::UnitZ();
  return {partFromLayers(plane).conjugate() * up, -bed_from_part.translation().z()};
}

Toolpath inPartFrame(Toolpath planned, const PlaneSettings& plane) {
  if (plane.angle_deg == 0.0) return planned;
  Toolpath toolpath = turned(std::move(planned), partFromLayers(plane));
  return plane.tool_axis == ToolAxis::Down ? withNozzle(std::move(toolpath), nozzleDown()) : toolpath;
}

void requireToolAxis(const PlaneSettings& plane, const BuildSpace& space) {
  const Point3 own = toolAxis(space);
  const Point3 level = -Point3::UnitZ();
  const Point3 wanted = plane.tool_axis == ToolAxis::Down ? level : Point3(partFromLayers(plane) * level);
  if (angleBetween(own, wanted) <= kToolAxisTolerance) return;
  const bool is_upright = angleBetween(own, level) <= kToolAxisTolerance;
  throw Unreachable(
      "slicing.plane of " + significantText(plane.angle_deg, kShownDigits) + " deg about " +
      significantText(plane.axis_heading_deg, kShownDigits) + " deg needs the tool axis along " +
      text(wanted) + "; the head of " + space.name + " holds it along " + text(own) + ", for " +
      (is_upright ? "slicing.plane.angle_deg 0 or slicing.plane.tool_axis 'down'" : planeOf(own)));
}

}  // namespace lamina
