// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace lamina {

/// What a turn of 1 rad counts as [mm].
inline constexpr double kTurnLever = 1e3;

/// The motion from one pose to another: tip [mm], turn [mm at the lever].
Eigen::Matrix<double, 6, 1> poseDifference(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to);

}  // namespace lamina
