// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

// Operations on regions, piece by piece: a piece whose outlines meet no others is kept or left out unchanged,
// and only the rest is clipped. Areas equal those of the operations on all regions at once; clipped pieces
// come last.

/// `regions` without `subtracted`.
Regions differenceByPieces(const Regions& regions, const Regions& subtracted);

/// The regions grown by a distance, to at least the area with round corners and at most the area with mitred
/// ones.
Regions grownByPieces(const Regions& regions, double distance_mm);

/// Whether a disc of that radius certainly fits into a region. False if finding out would take a longer
/// search.
bool surelyHasRoom(const Region& region, double radius_mm);

/// Regions divided by their distance from each other.
struct NeighbouringRegions {
  /// Regions whose bounding box is within the distance of another region's box, or with a hole no wider than
  /// the distance.
  Regions near;
  Regions alone;  ///< all others
};
/// Divides regions.
NeighbouringRegions neighbouring(const Regions& regions, double distance_mm);

}  // namespace lamina
