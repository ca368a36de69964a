// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The rotation by the least angle that takes direction `from` to direction `to`. Both may have any length
/// but zero. If they are opposite, the rotation is about some axis perpendicular to both.
Eigen::Quaterniond shortestRotation(const Point3& from, const Point3& to);

}  // namespace lamina
