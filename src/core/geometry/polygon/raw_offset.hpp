// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The outline with each edge moved by `delta` to its right (outwards, as material is on the left), before
/// overlaps are removed: the offset area has winding numbers of at least one. Corners that open are mitred,
/// or cut off square if the tip would lie farther than twice the offset. Corners that close are cut at the
/// point where the moved edges meet, if both are long enough; otherwise the outline doubles back over the old
/// corner, so that area which must not be enclosed is wound in reverse. Fewer than three distinct points give
/// an empty polygon.
/// @param delta  [mm]; negative moves edges to their left, inwards
Polygon rawOffset(const Polygon& polygon, double delta);

}  // namespace lamina
