// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/straightened.hpp"

#include <utility>
#include <vector>

#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/simplify.hpp"

namespace lamina {

Region straightened(Region region, double tolerance_mm) {
  const std::vector<Polygon> whole = outlines({region});
  const std::vector<Polygon> simple = simplify(whole, tolerance_mm);
  if (simple == whole) return region;
  Regions straight = unite(simple);
  return straight.size() == 1 ? std::move(straight.front()) : std::move(region);
}

}  // namespace lamina
