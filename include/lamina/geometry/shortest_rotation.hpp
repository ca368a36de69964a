// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The rotation by the least angle that takes direction `from` to direction `to`, of any lengths but zero.
/// About some axis at a right angle to both where they are opposite.
Eigen::Quaterniond shortestRotation(const Point3& from, const Point3& to);

}  // namespace lamina
