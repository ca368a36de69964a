// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/lead_and_tilt.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "lamina/base/angle.hpp"

namespace lamina {

Point3 withLeadAndTilt(const Point3& tool_axis, const Point3& tangent, double lead_deg, double tilt_deg) {
  constexpr double kAlong = 1e-9;  // sine of the angle between tool axis and tangent
  const Point3 left = tangent.cross(tool_axis);
  if (left.norm() < kAlong) return tool_axis;
  const Point3 led = Eigen::AngleAxisd(lead_deg * kDegree, left.normalized()) * tool_axis;
  return (Eigen::AngleAxisd(-tilt_deg * kDegree, tangent) * led).normalized();
}

}  // namespace lamina
