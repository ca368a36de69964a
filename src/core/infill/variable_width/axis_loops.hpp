// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/medial_axis/medial_axis.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// Closed runs along both sides of an axis, halfway to the border and half the local thickness wide: around
/// the outside of each connected axis, and along the inside of each hole that it encloses. At a tip the run
/// turns in a half circle, or extends into the corners beside the tip as far as its bead has room in the
/// region.
std::vector<FillPath> axisLoops(const MedialAxis& axis, const Region& region);

}  // namespace lamina
