// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

struct SectionValue {
  double value = 0.0;
  Point2 gradient = Point2::Zero();  ///< in the plane [1/mm]
};

/// The section of the gyroid sin x cos y + sin y cos z + sin z cos x = 0 by a plane. The gyroid has a cubic
/// cell of the given size and is turned by an angle about the part's z.
class GyroidSection {
 public:
  /// @param part_from_plan  pose in the part of the plan's plane z = 0
  GyroidSection(const Eigen::Isometry3d& part_from_plan, double cell_mm, double angle_rad);

  /// Value of the equation's left side at a point: 0 on the surface, within about -1.5 to 1.5 elsewhere.
  double value(const Point2& point) const;
  SectionValue valueAndSlope(const Point2& point) const;
  /// Whether the plane is level in the part.
  bool isLevel() const;
  /// The arguments x, y and z of the equation at a point.
  Point3 phases(const Point2& point) const { return origin_ + along_ * point; }
  double phasesPerMillimetre() const { return along_.col(0).norm(); }
  /// The point of a level section at which x and y of the equation have these values.
  Point2 atPhases(const Point2& phases) const;
  /// The values at points a step apart along x, beginning at `from`.
  std::vector<double> row(const Point2& from, double step_mm, std::size_t count) const;

 private:
  Eigen::Matrix<double, 3, 2> along_;  ///< phases per mm along x and y of the plan
  Point3 origin_;                      ///< phases at the origin of the plan
};

}  // namespace lamina
