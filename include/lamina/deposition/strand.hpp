// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace lamina {

/// Radius [mm] of a round strand with that cross-section: sqrt(A / pi).
double strandRadius(double area_mm2);

/// Radius [mm] of a ball with that volume.
double ballRadius(double volume_mm3);

/// The volume of a model that was deposited with strands of one radius.
struct RadiusTrial {
  double radius_mm = 0.0;
  double volume_mm3 = 0.0;
};

/// The radius with which a model would have the volume `volume_mm3`, by trials with other radii: the
/// interpolating polynomial R(V) through the four trials nearest to it in volume, or through all if there are
/// fewer. Meant for models that deposit a ball per step regardless of existing material; `VoxelDeposit`
/// deposits the volume that it is given and needs no such radius.
/// @throws InvalidInput if there are fewer than two trials, or two of the same volume
double calibratedRadius(std::vector<RadiusTrial> trials, double volume_mm3);

}  // namespace lamina
