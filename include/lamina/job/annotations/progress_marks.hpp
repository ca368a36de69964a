// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Adds code that gives the machine the hundredths of the time that are over and the minutes that are left:
/// before the motion in which that is, at the beginning and at the end. A toolpath without motion stays as it
/// is.
/// @param dialect  by its name (`gcodeDialects`)
/// @throws InvalidConfig if the dialect has no word for it
void addProgressMarks(Toolpath& toolpath, const std::string& dialect, const MotionLimits& limits);

}  // namespace lamina
