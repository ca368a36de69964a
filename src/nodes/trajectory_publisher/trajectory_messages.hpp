// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Path.h>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The waypoints in the part frame, in order, without those nearer than `spacing_mm` to the one before; first
/// and last of each layer always. Header without stamp.
nav_msgs::Path nozzlePath(const Toolpath& toolpath, double spacing_mm);

}  // namespace lamina
