// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// What the overlap of two drops of one diameter is a share of [Sobreviela2014, section 4.1].
enum class OverlapDefinition {
  Linear,  ///< of the diameter: 1 - distance / diameter
  Area,    ///< of the disc: the lens in which both lie
};

/// Overlap of two drops, from 0 (apart) to 1 (at one place).
/// @param relative_distance  of their centres, in diameters, not negative
double overlapAt(double relative_distance, OverlapDefinition definition);

/// Distance of the centres in diameters at which drops overlap by that much: 1 for 0, and 0 for 1.
/// @throws InvalidInput if the overlap is not within 0 and 1
double distanceOfOverlap(double overlap, OverlapDefinition definition);

}  // namespace lamina
