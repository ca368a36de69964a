// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The nozzle's frame about a tool axis that does not spin ([Flores2018, figures 44 to 46], for any heading):
/// with the heading u = (cos a, sin a, 0) and v = z x u, the nozzle's x is perpendicular to the tool axis and
/// to v, and points along u wherever the tool axis points down. The frame changes continuously with the tool
/// axis, also past the horizontal. Heading 0 gives `nozzleDown()` for a vertical tool axis, 180 the w 0, x 0,
/// y 1, z 0 of [Flores2018].
///
/// @param tool_axis  of unit length [part frame]
/// @return part_from_nozzle, of unit length; its scalar product with that of a vertical tool axis is not
///   negative
/// @throws InvalidInput if the tool axis lies along v within 1e-6, where there is no such frame
Eigen::Quaterniond noSpinFrame(const Point3& tool_axis, double heading_deg);

/// The frames along a run. Where the tool axis lies along v, the nozzle's x is as near as possible to that at
/// the waypoint before, or, if all tool axes before lie along v, to that at the waypoint after. Successive
/// quaternions have no negative scalar product.
///
/// @param tool_axes  one or more, of unit length
/// @throws InvalidInput if all of them lie along v
std::vector<Eigen::Quaterniond> noSpinFrames(const std::vector<Point3>& tool_axes, double heading_deg);

/// The direction of the tool axis: z of the nozzle.
inline Point3 toolAxisOf(const Eigen::Quaterniond& part_from_nozzle) {
  return part_from_nozzle * Point3::UnitZ();
}

/// The quaternion with the sign that brings it nearer to another one; both signs are the same rotation.
inline Eigen::Quaterniond signedLike(const Eigen::Quaterniond& value, const Eigen::Quaterniond& other) {
  return value.dot(other) < 0.0 ? Eigen::Quaterniond(-value.coeffs()) : value;
}

}  // namespace lamina
