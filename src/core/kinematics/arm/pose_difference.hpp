// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace lamina {

/// Lever arm by which rotations are converted to lengths [mm/rad].
inline constexpr double kTurnLever = 1e3;

/// The motion from one pose to another: translation of the tip [mm], rotation vector times `kTurnLever` [mm].
Eigen::Matrix<double, 6, 1> poseDifference(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to);

}  // namespace lamina
