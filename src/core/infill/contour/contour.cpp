// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/contour.hpp"

#include <iterator>
#include <utility>

#include "infill/contour/contour_tree.hpp"
#include "infill/contour/joined_loop.hpp"

namespace lamina {

std::vector<FillPath> contour(const Regions& regions, const InfillRequest& request) {
  std::vector<FillPath> joined_loops;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const ContourTree tree = contourTree(regions[i], request);
    LoopGraph net = loopsOf(tree);
    joinLoops(net, tree, request, i);
    std::vector<FillPath> lines = net.lines();
    std::move(lines.begin(), lines.end(), std::back_inserter(joined_loops));
  }
  return joined_loops;
}

}  // namespace lamina
