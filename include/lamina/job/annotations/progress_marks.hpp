// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Adds G-code that reports progress to the machine: the percentage of the printing time that has passed and
/// the minutes that are left. There is one line for each percent from 0 to 99, before the motion during which
/// it is reached, and one for 100 at the end. A toolpath that takes no time stays as it is.
/// @param dialect  name of a G-code dialect (`gcodeDialects`)
/// @param limits   limits for the estimate of the time
/// @throws InvalidConfig if the dialect has no command for it
void addProgressMarks(Toolpath& toolpath, const std::string& dialect, const MotionLimits& limits);

}  // namespace lamina
