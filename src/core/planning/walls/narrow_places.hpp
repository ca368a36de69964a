// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// An area by its local thickness.
struct SplitArea {
  Regions wide;
  Regions narrow;  ///< without slivers
};

/// Whether the area is thicker than twice the distance everywhere: then shrinking took the same from it all
/// along its border, and no outline vanishes. Only areas are compared, so that it costs next to nothing.
/// @param shrunk         the area shrunk by `distance_mm`
/// @param tolerance_mm2  of what is too narrow
bool isWideEverywhere(const Regions& whole, const Regions& shrunk, double distance_mm, double tolerance_mm2);

/// Reports what is thicker than twice the distance from what is not.
/// @param shrunk     the area shrunk by `distance_mm`
/// @param least_mm2  smaller narrow places are left out
SplitArea splitByThickness(const Regions& whole, const Regions& shrunk, double distance_mm, double least_mm2);

/// Area [mm²] of what is thinner than this; 0 if that is hardly more than corners.
double areaThinnerThan(const Regions& material, double thickness_mm);

}  // namespace lamina
