// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "infill/contour/contour_loop.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// The contours that fill one connected region, parallel to its border and to each other. A node holds the
/// loops that lie side by side between those of its parent and its children; the root holds none.
struct ContourTree {
  std::vector<std::size_t> parents;  ///< of each node; 0 for the root, which is the first
  std::vector<ContourLoop> loops;    ///< from the outside in: those of a node after those of its parent
  std::vector<Polygon> border;       ///< of the region that the loops fill
};

/// What contours of a solid fill leave: too narrow for a further one with a bead's room inside.
struct NarrowRest {
  Region area;
  std::size_t parent = 0;  ///< node whose loops lie round it, or the root
};

/// A tree of which the narrow rests are not filled yet.
struct OpenContourTree {
  ContourTree tree;
  std::vector<NarrowRest> rests;
};

/// @throws InvalidInput if the spacing of contours is not positive, or so small that there would be more than
/// 100000
void requireContourSpacing(const Region& region, double spacing_mm);

/// Contours half a pitch inside the border and then a spacing apart from each other.
OpenContourTree openContourTree(const Region& region, const InfillRequest& request);

/// The same, with loops in the narrow rests as well (`narrowLoops`).
ContourTree contourTree(const Region& region, const InfillRequest& request);

}  // namespace lamina
