// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A bounding box, and an interval along the layers' normal, the only direction in which inclined layers are
/// thin [mm, bed frame].
struct Extents {
  Box3 box;
  double low_normal = std::numeric_limits<double>::infinity();
  double high_normal = -std::numeric_limits<double>::infinity();

  void include(const Extents& other) {
    box.low = box.low.cwiseMin(other.box.low);
    box.high = box.high.cwiseMax(other.box.high);
    low_normal = std::min(low_normal, other.low_normal);
    high_normal = std::max(high_normal, other.high_normal);
  }

  bool meets(const Extents& other) const {
    return low_normal <= other.high_normal && other.low_normal <= high_normal &&
           (box.low.array() <= other.box.high.array()).all() &&
           (other.box.low.array() <= box.high.array()).all();
  }
};

/// An oriented bounding box [mm, bed frame]: tighter than `Extents` around a tilted body.
struct TurnedBox {
  Point3 middle = Point3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< unit vectors of its axes, as columns
  Point3 half = Point3::Zero();                        ///< half lengths along these axes

  /// Whether no plane across one of this box's own axes separates the two boxes. True whenever they meet, and
  /// sometimes when they do not.
  bool meets(const Box3& box) const {
    const Point3 reach = 0.5 * (box.high - box.low);
    const Point3 way = 0.5 * (box.high + box.low) - middle;
    for (int i = 0; i < 3; ++i)
      if (std::abs(axes.col(i).dot(way)) > half[i] + axes.col(i).cwiseAbs().dot(reach)) return false;
    return true;
  }
};

}  // namespace lamina
