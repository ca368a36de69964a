// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/settled_axis.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "planning/lift/held_along.hpp"
#include "planning/nozzle_frame.hpp"

namespace lamina {
namespace {

double tiltOf(const Point3& axis) { return std::atan2(axis.head<2>().norm(), axis.z()); }

Eigen::Quaterniond settledTurn(const Eigen::Quaterniond& held, double half_rad) {
  const Point3 axis = againstToolAxis(held);
  const double tilt = tiltOf(axis);
  if (tilt <= 0.0 || tilt >= 2.0 * half_rad) return held;
  return nozzleAgainst(settledAxis(axis, half_rad));
}

}  // namespace

Point3 settledAxis(const Point3& axis, double half_rad) {
  const double across = axis.head<2>().norm();
  const double tilt = tiltOf(axis);
  if (tilt >= 2.0 * half_rad) return axis;
  if (tilt <= half_rad) return Point3::UnitZ();
  const double settled = 2.0 * (tilt - half_rad);
  Point3 result;
  result << axis.head<2>() * (std::sin(settled) / across), std::cos(settled);
  return result;
}

void settleAxes(Toolpath& toolpath, double half_rad) {
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths) {
      if (path.orientation.isCommon()) {
        path.orientation = settledTurn(path.orientation.at(0), half_rad);
        continue;
      }
      std::vector<Eigen::Quaterniond> held = path.orientation.values();
      for (Eigen::Quaterniond& each : held) each = settledTurn(each, half_rad);
      path.orientation = heldAlong(std::move(held));
    }
}

}  // namespace lamina
