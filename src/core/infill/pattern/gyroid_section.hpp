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

/// A plane cut through the gyroid sin x cos y + sin y cos z + sin z cos x = 0, its cubic cell of that size,
/// the pattern turned by the angle about the part's z.
class GyroidSection {
 public:
  /// @param part_from_plan  where the plane z = 0 of the plan lies in the part
  GyroidSection(const Eigen::Isometry3d& part_from_plan, double cell_mm, double angle_rad);

  /// 0 on the surface; about -1.5 to 1.5 elsewhere.
  double value(const Point2& point) const;
  SectionValue valueAndSlope(const Point2& point) const;
  /// Whether the plane is level in the part.
  bool isLevel() const;
  /// x, y and z of the equation there.
  Point3 phases(const Point2& point) const { return origin_ + along_ * point; }
  double phasesPerMillimetre() const { return along_.col(0).norm(); }
  /// Where a level section has these x and y.
  Point2 atPhases(const Point2& phases) const;
  /// The values at points from there on, a step apart along x.
  std::vector<double> row(const Point2& from, double step_mm, std::size_t count) const;

 private:
  Eigen::Matrix<double, 3, 2> along_;  ///< phases per mm along x and y of the plan
  Point3 origin_;                      ///< phases where the plan has its origin
};

}  // namespace lamina
