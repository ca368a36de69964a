// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/wall_following.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "lamina/orientation/no_spin.hpp"
#include "lamina/orientation/path_tangents.hpp"

namespace lamina {
namespace {

constexpr double kLeastAcross = 0.5;  // part of the wall's normal that is across the path

/// The tool axis across the path at one waypoint, none if the wall does not run along the path there.
std::optional<Point3> toolAxisInWall(const Point3& tangent, const Point3& wall_normal, const Point3& given) {
  const Point3 level = tangent - tangent.dot(given) * given;
  const double length = level.norm();
  if (length < 1e-6) return std::nullopt;
  const Point3 along = level / length;
  const Point3 tool_axis = along.cross(wall_normal);
  const double across = tool_axis.norm();
  if (across < kLeastAcross) return std::nullopt;
  return Point3((tool_axis.dot(given) < 0.0 ? -1.0 / across : 1.0 / across) * tool_axis);
}

}  // namespace

WallToolAxes wallFollowingToolAxes(const Path& path, const WallNormals& walls) {
  const std::size_t count = path.points.size();
  const std::vector<Point3> tangents = pathTangents(path);
  std::vector<std::optional<Point3>> found(count);
  WallToolAxes result;
  for (std::size_t i = 0; i < count && !tangents.empty(); ++i)
    found[i] = toolAxisInWall(tangents[i], walls.at(path.points[i]), toolAxisOf(path.orientation.at(i)));
  for (const auto& tool_axis : found) result.waypoints_without_wall += tool_axis ? 0 : 1;
  const auto first =
      std::find_if(found.begin(), found.end(), [](const auto& tool_axis) { return tool_axis.has_value(); });
  for (std::size_t i = 0; i < count; ++i) {
    if (found[i])
      result.tool_axes.push_back(*found[i]);
    else if (!result.tool_axes.empty() && first != found.end())
      result.tool_axes.push_back(result.tool_axes.back());
    else
      result.tool_axes.push_back(first != found.end() ? **first : toolAxisOf(path.orientation.at(i)));
  }
  return result;
}

}  // namespace lamina
