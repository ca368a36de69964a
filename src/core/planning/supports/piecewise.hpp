// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

// The operations of the same purpose on regions, piece by piece: a piece whose outlines meet no others is
// kept or left out as it is, and only the rest is clipped. The same areas; pieces that are clipped come last.

/// Where `regions` is and `subtracted` is not.
Regions differenceByPieces(const Regions& regions, const Regions& subtracted);

/// What is grown by a distance: no less than with round corners, no more than with mitred ones.
Regions grownByPieces(const Regions& regions, double distance_mm);

/// Whether a disc of that radius has room in a region; false also where that is not found at once.
bool surelyHasRoom(const Region& region, double radius_mm);

/// The regions in groups: those whose boxes come within a distance of each other, of others of the group, or
/// that have a hole no wider than it; and those that stand alone.
struct NeighbouringRegions {
  Regions near;
  Regions alone;
};
NeighbouringRegions neighbouring(const Regions& regions, double distance_mm);

}  // namespace lamina
