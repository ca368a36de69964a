// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A section of the zigzag of [Flores2018] in the raster frame: passes along x, from left to right, from
/// below.
struct GridSection {
  std::vector<Polyline> passes;    ///< of two points, or one; curves have more
  std::optional<Point2> below;     ///< one point more before the first pass, or after it
  std::optional<Point2> above;     ///< the same at the last pass
  bool is_bordered_below = false;  ///< by a perimeter and not by another section
  bool is_bordered_above = false;
};

/// The zigzag of metal deposition [Flores2018, figures 47 to 51]: of the nodes of a square grid inside the
/// perimeter those whose eight neighbours are inside too, row by row, each run of them one pass; passes that
/// follow each other without a second one beside them make a section. Sections are in the documented order:
/// those of the first crossings of their rows from below, then those of the second, and so on.
///
/// @param perimeter  outlines in the raster frame [mm]
/// @param distance_mm  between nodes
/// @param node  one of the grid's nodes, in the raster frame
std::vector<GridSection> gridSections(const std::vector<Polygon>& perimeter, double distance_mm,
                                      const Point2& node);

}  // namespace lamina
