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

// Regions given to these functions must not overlap themselves or each other, and neither do those that are
// returned: outlines wind round each point once or not at all. Call `unite` first on outlines that may
// overlap; `difference` and `intersection` alone take overlapping regions, as their union. Where outlines
// meet, the functions round to a grid of 1e-5 mm: results lie within that of the exact ones. They give the
// same regions for the same input, refuse points farther than 10 m from the origin with InvalidInput, and
// islands inside holes become regions of their own.

/// The union of the outlines by the nonzero rule: all points of which the winding number is not 0.
Regions unite(const std::vector<Polygon>& polygons);

/// The regions grown by `delta_mm`, or shrunk if it is negative: parts narrower than twice that vanish. The
/// join applies to convex corners when growing and to reflex ones when shrinking; the others stay sharp.
Regions offset(const Regions& regions, double delta_mm, Join join = Join::Mitre);

/// Where `regions` is and `subtracted` is not.
Regions difference(const Regions& regions, const Regions& subtracted);

/// The pieces of lines that lie in regions, each ending on the outline where its line leaves the regions. A
/// piece may run against the direction of its line.
std::vector<Polyline> clipped(const std::vector<Polyline>& lines, const Regions& regions);

/// Where both `a` and `b` are.
Regions intersection(const Regions& a, const Regions& b);

}  // namespace lamina
