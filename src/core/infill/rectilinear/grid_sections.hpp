// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A section of the zigzag of [Flores2018] in the raster frame: passes along x from left to right, ordered
/// from below.
struct GridSection {
  std::vector<Polyline> passes;    ///< of two points, or of one; curves have more
  std::optional<Point2> below;     ///< an additional point before the first pass, or after it
  std::optional<Point2> above;     ///< an additional point at the last pass
  bool is_bordered_below = false;  ///< whether a perimeter, not another section, lies below
  bool is_bordered_above = false;
};

/// The zigzag of metal deposition [Flores2018, figures 47 to 51]. A square grid is laid over the perimeter,
/// and those nodes inside are used whose eight neighbours are inside too. In each row every sequence of such
/// nodes is a pass; passes that follow each other without a second one beside them form a section. Sections
/// are in the documented order: first the sections with the first sequences of their rows, from below, then
/// those with the second, and so on.
///
/// @param perimeter  outlines in the raster frame [mm]
/// @param distance_mm  distance of nodes
/// @param node  position of one node of the grid, in the raster frame
std::vector<GridSection> gridSections(const std::vector<Polygon>& perimeter, double distance_mm,
                                      const Point2& node);

}  // namespace lamina
