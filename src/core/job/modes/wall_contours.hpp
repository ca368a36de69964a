// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The contour of each layer as the outer-wall loops of a program show it: what lies inside of an odd
/// number of them, grown by half a bead. A wall whose ends are within a bead width of each other is a loop. A
/// layer without any has none.
/// @throws InvalidInput if no layer has any
std::vector<Regions> wallContours(const Toolpath& program);

}  // namespace lamina
