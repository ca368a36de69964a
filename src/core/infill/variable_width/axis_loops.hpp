// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/medial_axis/medial_axis.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// Closed runs along both sides of an axis, halfway to the border and half the thickness wide: round the
/// outside of each connected axis, and inside of each hole that it closes round. Round a tip the run turns by
/// a half circle, or as far into the corners beside it as its bead finds room in the region.
std::vector<FillPath> axisLoops(const MedialAxis& axis, const Region& region);

}  // namespace lamina
