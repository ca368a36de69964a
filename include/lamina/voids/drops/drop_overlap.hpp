// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Definition of the overlap of two drops of one diameter [Sobreviela2014, section 4.1].
enum class OverlapDefinition {
  Linear,  ///< share of the diameter: 1 - distance / diameter
  Area,    ///< share of the area of a disc that is covered by both
};

/// Overlap of two drops, from 0 (no overlap) to 1 (coincident).
/// @param relative_distance  distance of their centres in diameters, not negative
double overlapAt(double relative_distance, OverlapDefinition definition);

/// The inverse of `overlapAt`: distance of the centres, in diameters, at which drops have an overlap; 1 for
/// an overlap of 0.
/// @throws InvalidInput if the overlap is outside of [0, 1]
double distanceOfOverlap(double overlap, OverlapDefinition definition);

}  // namespace lamina
