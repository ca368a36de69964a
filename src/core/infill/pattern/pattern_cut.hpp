// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "infill/hilbert/outline_links.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Curves of a pattern before they are cut to a region [mm].
struct PatternCurves {
  std::vector<Polyline> open;   ///< both ends lie outside the region
  std::vector<Polygon> closed;  ///< anywhere
};

/// What of a pattern lies inside a region.
struct PatternPieces {
  std::vector<RunOnOutlines> open;  ///< each end on an outline
  std::vector<Polygon> closed;      ///< whole loops
};

/// The pieces of curves inside outlines, curve by curve. Time is linear in the points of the curves, with few
/// edges near each; a curve that meets the outlines so that rounding decides what is inside is cut where it
/// would lie 1e-7 mm aside.
/// @param outlines  of regions: material lies to the left of each edge
PatternPieces cutToOutlines(const PatternCurves& curves, const std::vector<Polygon>& outlines);

}  // namespace lamina
