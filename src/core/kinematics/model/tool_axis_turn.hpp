// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <boost/container/static_vector.hpp>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The rotary joints of a machine as they turn its tool axis: one or two axes, that next to the bed first.
/// The tool axis is R(axis 0, angle 0) R(axis 1, angle 1) at_zero. All of unit length [bed frame].
struct ToolAxisTurner {
  std::vector<Point3> axes;          ///< with the joints at zero; two are not parallel
  Point3 at_zero = Point3::UnitZ();  ///< tool axis with the joints at zero; not along the last axis
};

/// Angles of two joints; that of a second one is 0 where there is one only [rad].
struct ToolAxisTurn {
  int branch =
      0;  ///< 0 or 1: on which side of the plane of both axes the tool axis stands, seen from the first
  Eigen::Vector2d angles = Eigen::Vector2d::Zero();  ///< in (-pi, pi]; one that is free is the `near` one
};

using ToolAxisTurns = boost::container::static_vector<ToolAxisTurn, 2>;

/// All angles that turn the tool axis to a direction (subproblems 1 and 2 of [Paden1986]). Where the
/// direction lies on the first of two axes, that joint is free and keeps its value of `near`; both branches
/// are the same there and at the rim of what can be reached.
/// @param wanted  of unit length [bed frame]
/// @return empty if the tool axis cannot come nearer than 0.01 deg
ToolAxisTurns toolAxisTurns(const ToolAxisTurner& turner, const Point3& wanted, const Eigen::Vector2d& near);

/// The tool axis [bed frame].
Point3 toolAxisAt(const ToolAxisTurner& turner, const Eigen::Vector2d& angles);

/// Least sine of what vanishes where two joints turn the tool axis along one line only: of the tool axis to
/// the first axis, and of the second joint's way to the plane of both axes. 1 with fewer joints.
double toolAxisMargin(const ToolAxisTurner& turner, const Eigen::Vector2d& angles);

/// Sine of the angle between two directions of unit length.
double sineBetween(const Point3& a, const Point3& b);

}  // namespace lamina
