// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "infill/contour_loop.hpp"
#include "lamina/geometry/polygon.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// The contours that fill one connected region, parallel to its border and to each other. A node holds the
/// loops that lie side by side between those of its parent and its children; the root holds none.
struct ContourTree {
  std::vector<std::size_t> parents;  ///< of each node; 0 for the root, which is the first
  std::vector<ContourLoop> loops;    ///< from the outside in: those of a node after those of its parent
};

/// Contours half a pitch inside the border and then a spacing apart from each other.
ContourTree contourTree(const Region& region, const InfillRequest& request);

}  // namespace lamina
