// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// What perimeters leave of an area, and what they leave it to.
struct PerimeterFill {
  std::vector<FillPath> runs;  ///< closed perimeters, and beads where the area is too narrow for them
  Regions
      links;  ///< the area inside, shrunk by half the narrowest bead of a solid raster (`variableWidthRuns`)
};

/// Perimeters side by side from the border of an area inwards. Where it is too narrow for them, and for a
/// narrowest bead between them, beads along its medial axis fill it instead, joined to a perimeter where they
/// end beside it.
PerimeterFill layPerimeters(const Regions& area, int count, const InfillRequest& request);

}  // namespace lamina
