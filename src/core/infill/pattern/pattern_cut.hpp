// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "infill/hilbert/outline_links.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Curves of a pattern before they are cut to a region [mm].
struct PatternCurves {
  std::vector<Polyline> open;   ///< with both ends outside the region
  std::vector<Polygon> closed;  ///< inside, outside or across the region
};

/// The parts of a pattern that are inside a region.
struct PatternPieces {
  std::vector<RunOnOutlines> open;  ///< with each end on an outline
  std::vector<Polygon> closed;      ///< whole loops
};

/// The pieces of curves that are inside outlines, curve by curve. Takes time linear in the points of the
/// curves if few edges are near each. A curve that meets the outlines such that rounding decides what is
/// inside is cut as if it were shifted by 1e-7 mm.
/// @param outlines  outlines of regions, with material to the left of each edge
PatternPieces cutToOutlines(const PatternCurves& curves, const std::vector<Polygon>& outlines);

}  // namespace lamina
