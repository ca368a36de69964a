// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/spatial/point_grid.hpp"
#include "lamina/voids/beads/void_class.hpp"
#include "lamina/voids/beads/void_points.hpp"
#include "lamina/voids/drops/drop_layer.hpp"

namespace lamina {

/// Reports the class of voids by the drops around them [Sobreviela2014, chapter 3].
class VoidKinds {
 public:
  VoidKinds(const DropLayer& layer, const std::vector<DropContour>& contours);

  /// With infill on one side and a contour on the other R1, or D1 if it is dense; with infill alone
  /// `Between`. With contours alone C1 if it is one that has no other inside, C2 if they follow an outline
  /// and a hole, C4 within two diameters of a corner of a contour below 60 degrees, otherwise C3.
  VoidClass kindOf(const std::vector<VoidPoint>& points) const;

 private:
  bool isInCorner(const std::vector<VoidPoint>& points) const;
  VoidClass kindOfContours(const std::vector<std::size_t>& contours,
                           const std::vector<VoidPoint>& points) const;

  const DropLayer& layer_;
  const std::vector<DropContour>& contours_;
  PointGrid drops_;
  PointGrid corners_;  ///< of contours, sharper than 60 degrees
  std::vector<DropRole> role_of_drop_;
  std::vector<std::size_t> contour_of_drop_;
};

}  // namespace lamina
