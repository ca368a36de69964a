// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/orientation/orientation_report.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The greatest tilt and turns of a toolpath; limits are not known here.
OrientationReport measuredTurns(const Toolpath& toolpath);

}  // namespace lamina
