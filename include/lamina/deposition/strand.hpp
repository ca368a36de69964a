// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace lamina {

/// Radius [mm] of the round strand of that cross-section: sqrt(A / pi).
double strandRadius(double area_mm2);

/// Radius [mm] of the ball of that volume.
double ballRadius(double volume_mm3);

/// What a model held that was deposited with strands of one radius.
struct RadiusTrial {
  double radius_mm = 0.0;
  double volume_mm3 = 0.0;
};

/// Radius with which a model that was tried with others would hold `volume_mm3`: the interpolating polynomial
/// R(V) through the four trials nearest to it in volume, or all if there are fewer. For models that lay a
/// ball per step whatever was there before; `VoxelDeposit` lays the volume it is given and needs none of it.
/// @throws InvalidInput if there are less than two trials or two of the same volume
double calibratedRadius(std::vector<RadiusTrial> trials, double volume_mm3);

}  // namespace lamina
