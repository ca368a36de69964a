// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <boost/container/static_vector.hpp>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The rotary joints of a machine as they turn its tool axis, or of a table as they turn what is up over its
/// bed: one or two axes, that next to the bed first.
/// The direction is R(axis 0, angle 0) R(axis 1, angle 1) at_zero. All of unit length [bed frame].
struct ToolAxisTurner {
  std::vector<Point3> axes;          ///< with the joints at zero; two are not parallel
  Point3 at_zero = Point3::UnitZ();  ///< the direction with the joints at zero; not along the last axis
};

/// Angles of two joints; that of a second one is 0 where there is one only [rad].
struct ToolAxisTurn {
  int branch = 0;  ///< 0 or 1: on which side of the plane of both axes the direction stands, from the first
  Eigen::Vector2d angles = Eigen::Vector2d::Zero();  ///< in (-pi, pi]; one that is free is the `near` one
};

using ToolAxisTurns = boost::container::static_vector<ToolAxisTurn, 2>;

/// Sine of the angle between two directions of unit length.
double sineBetween(const Point3& a, const Point3& b);

/// Angle by which a turn about the axis brings one direction nearest to another (subproblem 1 of
/// [Paden1986]), in (-pi, pi].
double angleAbout(const Point3& axis, const Point3& from, const Point3& to);

/// All angles that turn the direction to another (subproblems 1 and 2 of [Paden1986]). Where that lies on the
/// first of two axes, the joint is free and keeps its value of `near`; both branches are the same there and
/// at the rim of what can be reached.
/// @param wanted  of unit length [bed frame]
/// @return empty if the direction cannot come nearer than 0.01 deg
ToolAxisTurns toolAxisTurns(const ToolAxisTurner& turner, const Point3& wanted, const Eigen::Vector2d& near);

/// Least sine of what vanishes where two joints turn the direction along one line only: of the direction to
/// the first axis, and of the second joint's way to the plane of both axes. 1 with fewer joints.
double toolAxisMargin(const ToolAxisTurner& turner, const Eigen::Vector2d& angles);

}  // namespace lamina
