// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <boost/container/static_vector.hpp>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// How the rotary joints of a machine turn its tool axis, or those of a table turn the direction that is up
/// over its bed: one or two axes, the one next to the bed first. The direction is R(axis 0, angle 0) R(axis
/// 1, angle 1) at_zero. All are of unit length [bed frame].
struct ToolAxisTurner {
  std::vector<Point3> axes;          ///< with all joints at zero; two axes are not parallel
  Point3 at_zero = Point3::UnitZ();  ///< the direction with all joints at zero; not along the last axis
};

/// Angles of the joints that give a direction [rad]; the second one is 0 if there is one joint only.
struct ToolAxisTurn {
  /// 0 or 1: the side of the plane of both axes on which the direction lies after the second joint's rotation
  /// only.
  int branch = 0;
  /// In (-pi, pi]; that of a free joint is its value in `near`.
  Eigen::Vector2d angles = Eigen::Vector2d::Zero();
};

using ToolAxisTurns = boost::container::static_vector<ToolAxisTurn, 2>;

/// Sine of the angle between two directions of unit length.
double sineBetween(const Point3& a, const Point3& b);

/// Angle in (-pi, pi] by which a rotation about the axis brings direction `from` nearest to direction `to`
/// (subproblem 1 of [Paden1986]).
double angleAbout(const Point3& axis, const Point3& from, const Point3& to);

/// All angles that turn the direction to `wanted` (subproblems 1 and 2 of [Paden1986]). If `wanted` is along
/// the first of two axes, that joint is free and keeps its value in `near`; both branches are equal there,
/// and at the edge of the reachable directions.
/// @param wanted  of unit length [bed frame]
/// @return empty if the direction cannot come nearer than 0.01 deg
ToolAxisTurns toolAxisTurns(const ToolAxisTurner& turner, const Point3& wanted, const Eigen::Vector2d& near);

/// Least of the sines that vanish at singularities, where both joints move the direction along the same line:
/// that of the angle between the direction and the first axis, and that of the second joint's angle from the
/// plane of both axes. 1 if there are fewer than two joints.
double toolAxisMargin(const ToolAxisTurner& turner, const Eigen::Vector2d& angles);

}  // namespace lamina
