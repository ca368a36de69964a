// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// How an offset outline goes round a corner that it moves away from.
enum class Join {
  Mitre,  ///< edges are prolonged until they meet; cut off square where that is farther than twice the offset
  Round,  ///< an arc, true within 0.005 mm
};

// Regions given to these functions must not overlap themselves or each other, and regions returned do not
// either: the winding number of every point is 0 or 1. Call `unite` first on outlines that may overlap; only
// `difference` and `intersection` accept overlapping regions, as their union. Where outlines meet, results
// are rounded to a grid of 1e-5 mm, and lie within that distance of the exact ones. The same input gives the
// same regions. Points farther than 10 m from the origin are refused with InvalidInput. Islands inside holes
// become regions of their own.

/// The union of the outlines by the nonzero rule: all points whose winding number is not 0.
Regions unite(const std::vector<Polygon>& polygons);

/// The regions grown by `delta_mm`, or shrunk if it is negative: parts narrower than twice the distance
/// vanish. The join applies to convex corners when growing and to reflex corners when shrinking; all others
/// stay sharp.
Regions offset(const Regions& regions, double delta_mm, Join join = Join::Mitre);

/// The parts of `regions` that are outside `subtracted`.
Regions difference(const Regions& regions, const Regions& subtracted);

/// The pieces of lines that lie in regions, each ending on the outline where its line leaves the regions. A
/// piece may run against the direction of its line.
std::vector<Polyline> clipped(const std::vector<Polyline>& lines, const Regions& regions);

/// The parts that are in both `a` and `b`.
Regions intersection(const Regions& a, const Regions& b);

}  // namespace lamina
