// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "lamina/kinematics/arm/arm_cell.hpp"

namespace lamina {

/// Whether a frame of tool or bed that a program states equals that of the cell, within 0.01 mm and 1e-5 rad,
/// which is more than the rounding of typed numbers.
bool isSameCellFrame(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b);

/// The frame as text for messages: "(x, y, z) mm, w x y z ...".
std::string shownCellFrame(const Eigen::Isometry3d& frame);

/// Whether two loads are equal within the precision of programs: 1 g, their centres within 0.002 mm.
bool isSameLoad(const ToolLoad& one, const ToolLoad& other);

/// The load as text for messages: "2.5 kg with its centre at (0, 0, 100) mm".
std::string shownLoad(const ToolLoad& load);

}  // namespace lamina
