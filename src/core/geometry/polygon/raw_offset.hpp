// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The outline with each edge moved by `delta` to its right (outwards, for material on the left), before what
/// overlaps is cleared away: the area wound round at least once is the offset area. Corners that open are
/// mitred, and cut off square where the tip would lie farther than twice the offset. Corners that close are
/// cut where the moved edges meet if both edges are long enough for that; where they are not, the outline
/// doubles back over the old corner, which winds backwards round what it must not enclose.
/// Fewer than three distinct points give nothing.
Polygon rawOffset(const Polygon& polygon, double delta);

}  // namespace lamina
