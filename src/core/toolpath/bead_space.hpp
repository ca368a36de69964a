// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The direction away from the layer below at a waypoint, against the tool axis; of unit length [part frame].
inline Point3 upAt(const Path& path, std::size_t waypoint) {
  return -(path.orientation.at(waypoint) * Point3::UnitZ());
}

/// The middle of a bead's cross-section. The nozzle tip moves along the top of the bead: the middle lies half
/// the height below the tip.
/// @param tip  in any frame [mm]
/// @param up   away from the layer below, of unit length, in the same frame
inline Point3 sectionMiddle(const Point3& tip, double height_mm, const Point3& up) {
  return tip - 0.5 * height_mm * up;
}

/// The outline of a bead's cross-section: straight lines and half circles. The circles are at the sides of a
/// bead that is wider than high, otherwise at its bottom and top.
struct SectionOutline {
  /// Half the length of its horizontal lines; 0 if the bead is higher than wide.
  double flat_across_mm = 0.0;
  double flat_up_mm = 0.0;  ///< half the length of its vertical lines; 0 if the bead is wider than high
  double radius_mm = 0.0;
};

inline SectionOutline sectionOutline(const Bead& bead) {
  const double radius_mm = 0.5 * std::min(bead.width_mm, bead.height_mm);
  return {0.5 * bead.width_mm - radius_mm, 0.5 * bead.height_mm - radius_mm, radius_mm};
}

/// Axes of a bead as columns: along it, across it, and the component of the layer's normal perpendicular to
/// the first. The last axis of a drop, which has no direction along, is the normal.
inline Eigen::Matrix3d beadAxes(const Point3& along, const Point3& normal) {
  constexpr double kUpright = 1e-6;  // sine of the angle to the normal below which a bead goes along it
  Point3 across = normal.cross(along);
  if (across.norm() < kUpright * along.norm() || along.isZero()) across = normal.unitOrthogonal();
  across.normalize();
  const Point3 x = along.isZero() ? across.cross(normal) : Point3(along.normalized());
  Eigen::Matrix3d axes;
  axes << x, across, x.cross(across);
  return axes;
}

}  // namespace lamina
