// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/tool_axis_turner.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

constexpr double kToolAxisTolerance = toRadians(0.01);  // far below what a head is built to
constexpr double kOnAxis = 1e-10;                       // sine: less than any pose is known to

/// A direction as seen along an axis. The part across it is kept beside that along it, since near the axis
/// the cosine no longer determines the angle.
struct AxisView {
  double along;
  Eigen::Vector2d across;
};

/// Frame of two axes: the first, what of the second stands across it, and the normal of both.
struct AxisFrame {
  explicit AxisFrame(const Point3& first, const Point3& second)
      : axis(first), normal(first.cross(second).normalized()), side(normal.cross(first)) {}
  AxisView view(const Point3& direction) const {
    return {direction.dot(axis), {direction.dot(side), direction.dot(normal)}};
  }
  Point3 direction(const AxisView& view) const {
    return view.along * axis + view.across.x() * side + view.across.y() * normal;
  }

  Point3 axis;
  Point3 normal;
  Point3 side;
};

double angleOf(const Eigen::Vector2d& direction) { return std::atan2(direction.y(), direction.x()); }

/// Of unit length: the chord of so small an angle is the angle.
bool isNear(const Point3& a, const Point3& b) {
  return (a - b).squaredNorm() <= kToolAxisTolerance * kToolAxisTolerance;
}

Point3 turned(const Point3& direction, const Point3& axis, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return c * direction + s * axis.cross(direction) + ((1.0 - c) * axis.dot(direction)) * axis;
}

/// Part along `side` of the tool axis between both turns: its height over the second axis is that at zero,
/// its height over the first that of the wanted one.
double sidePart(const ToolAxisTurner& turner, double along, double across) {
  const double cosine = turner.axes[0].dot(turner.axes[1]);
  const double height = turner.at_zero.dot(turner.axes[1]);
  // height - along * cosine, where 1 - |along| is known better than along.
  const double sense = along < 0.0 ? -1.0 : 1.0;
  const double short_of_axis = across * across / (1.0 + std::abs(along));
  return (height - sense * cosine + sense * short_of_axis * cosine) /
         sineBetween(turner.axes[0], turner.axes[1]);
}

/// Both ways by two turns (subproblem 2).
ToolAxisTurns turnsOfTwo(const ToolAxisTurner& turner, const Point3& wanted, double near_first) {
  const AxisFrame frame(turner.axes[0], turner.axes[1]);
  const AxisView seen = frame.view(wanted);
  const double across = seen.across.norm();
  const double side = std::clamp(sidePart(turner, seen.along, across), -across, across);
  const double off_plane = std::sqrt((across - side) * (across + side));
  ToolAxisTurns turns;
  for (const int branch : {0, 1}) {
    const AxisView between{seen.along, {side, branch == 0 ? off_plane : -off_plane}};
    const double first =
        across < kOnAxis ? near_first : wrappedRadians(angleOf(seen.across) - angleOf(between.across));
    const double second = angleAbout(turner.axes[1], turner.at_zero, frame.direction(between));
    turns.push_back({branch, {first, second}});
  }
  return turns;
}

/// The tool axis [bed frame].
Point3 toolAxisAt(const ToolAxisTurner& turner, const Eigen::Vector2d& angles) {
  Point3 tool_axis = turner.at_zero;
  for (std::size_t j = turner.axes.size(); j-- > 0;)
    tool_axis = turned(tool_axis, turner.axes[j], angles[static_cast<Eigen::Index>(j)]);
  return tool_axis;
}

}  // namespace

double sineBetween(const Point3& a, const Point3& b) { return a.cross(b).norm(); }

double angleAbout(const Point3& axis, const Point3& from, const Point3& to) {
  const Point3 start = from - axis.dot(from) * axis;
  return wrappedRadians(std::atan2(axis.dot(start.cross(to)), start.dot(to)));
}

ToolAxisTurns toolAxisTurns(const ToolAxisTurner& turner, const Point3& wanted, const Eigen::Vector2d& near) {
  ToolAxisTurns turns(1);
  if (turner.axes.size() == 1) turns[0].angles[0] = angleAbout(turner.axes[0], turner.at_zero, wanted);
  if (turner.axes.size() == 2) turns = turnsOfTwo(turner, wanted, near[0]);
  const auto misses = [&](const ToolAxisTurn& turn) {
    return !isNear(toolAxisAt(turner, turn.angles), wanted);
  };
  // Where a joint is free both branches are the same, and planning asks for many values of it.
  if (turns.size() == 2 && turns[0].angles == turns[1].angles)
    return misses(turns[0]) ? ToolAxisTurns() : turns;
  turns.erase(std::remove_if(turns.begin(), turns.end(), misses), turns.end());
  return turns;
}

double toolAxisMargin(const ToolAxisTurner& turner, const Eigen::Vector2d& angles) {
  if (turner.axes.size() < 2) return 1.0;
  const Point3 between = turned(turner.at_zero, turner.axes[1], angles[1]);
  const Point3 normal = turner.axes[0].cross(turner.axes[1]).normalized();
  const double off_plane = std::abs(between.dot(normal)) / sineBetween(turner.at_zero, turner.axes[1]);
  return std::min(sineBetween(between, turner.axes[0]), std::min(off_plane, 1.0));
}

}  // namespace lamina
