// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "infill/contour/contour_loop.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// The contours that fill one connected region, parallel to its border and to each other, as a tree. A node
/// holds the loops side by side that lie between those of its parent and those of its children; the root
/// holds none.
struct ContourTree {
  std::vector<std::size_t> parents;  ///< parent of each node; 0 for the root, which is node 0
  std::vector<ContourLoop> loops;    ///< from the outside inwards: loops of a node after those of its parent
  std::vector<Polygon> border;       ///< of the region that the loops fill
};

/// A region that the contours of a solid fill leave over, too narrow for a further contour with room for its
/// bead.
struct NarrowRest {
  Region area;
  std::size_t parent = 0;  ///< node whose loops surround it, or the root
};

/// A contour tree whose narrow rests are not filled yet.
struct OpenContourTree {
  ContourTree tree;
  std::vector<NarrowRest> rests;
};

/// Refuses a spacing of contours that is not positive, or so small that there would be more than 100000 of
/// them.
/// @throws InvalidInput
void requireContourSpacing(const Region& region, double spacing_mm);

/// Contours half a pitch inside the border, and further ones at the given spacing inside each other.
OpenContourTree openContourTree(const Region& region, const InfillRequest& request);

/// `openContourTree` with loops in the narrow rests too (`narrowLoops`).
ContourTree contourTree(const Region& region, const InfillRequest& request);

}  // namespace lamina
