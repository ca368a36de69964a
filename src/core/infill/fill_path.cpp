// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/fill_path.hpp"

#include <algorithm>
#include <iterator>

namespace lamina {

const Point2& lastPoint(const FillPath& path) {
  return path.is_closed ? path.points.front() : path.points.back();
}

FillPath reversed(FillPath path) {
  std::reverse(path.points.begin(), path.points.end());
  // A width belongs to the motion that ends at its point: the motion back ends one point earlier.
  if (!path.width_mm.empty()) std::reverse(path.width_mm.begin() + 1, path.width_mm.end());
  return path;
}

void appendTo(std::vector<FillPath>& runs, std::vector<FillPath> more) {
  runs.insert(runs.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace lamina
