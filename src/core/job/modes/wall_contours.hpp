// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The contour of a layer from its outer-wall loops: the area inside an odd number of loops, grown by half a
/// bead. An outer wall whose ends are within a bead width of each other counts as a loop. The contour of a
/// layer without loops is empty.
Regions wallContour(const ToolpathLayer& layer);

/// The contour of each layer of a program.
/// @throws InvalidInput if no layer has a loop
std::vector<Regions> wallContours(const Toolpath& program);

}  // namespace lamina
