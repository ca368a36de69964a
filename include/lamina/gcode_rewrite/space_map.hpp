// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// What a map preserves.
enum class MapKind {
  Isometry,  ///< lengths; E and F stay
  Affine,    ///< straight lines, not lengths
  Curved,    ///< neither; straight motions are divided
};

/// An invertible map of space. Other maps than those below can be added by deriving from this class; calls
/// may come from any thread and must not have side effects.
class SpaceMap {
 public:
  virtual ~SpaceMap() = default;
  virtual Point3 map(const Point3& point) const = 0;      ///< [mm] to [mm]
  virtual Point3 inverse(const Point3& point) const = 0;  ///< undoes `map`
  virtual MapKind kind() const { return MapKind::Curved; }
  /// Volume after the map over volume before, near the point; by finite differences unless overridden.
  virtual double volumeRatio(const Point3& point) const;
};

/// An affine map: a matrix and a translation.
class AffineMap final : public SpaceMap {
 public:
  /// @throws InvalidInput if a value is not finite, or the matrix cannot be inverted accurately (condition of
  ///   1e6 or more)
  explicit AffineMap(const Eigen::Affine3d& to_mapped);

  Point3 map(const Point3& point) const override {
    return to_mapped_.linear() * point + to_mapped_.translation();
  }
  Point3 inverse(const Point3& point) const override {
    return from_mapped_.linear() * point + from_mapped_.translation();
  }
  MapKind kind() const override { return kind_; }
  double volumeRatio(const Point3& /*point*/) const override { return volume_ratio_; }
  const Eigen::Affine3d& matrix() const { return to_mapped_; }

 private:
  Eigen::Affine3d to_mapped_;
  Eigen::Affine3d from_mapped_;
  MapKind kind_ = MapKind::Affine;
  double volume_ratio_ = 1.0;
};

/// The map that applies `before` first, then `after`.
AffineMap operator*(const AffineMap& after, const AffineMap& before);

/// Right-handed rotation about an axis through the origin.
/// @param axis  direction of the axis, of any length
/// @throws InvalidInput if the axis is not longer than 1e-9
AffineMap rotation(const Point3& axis, double angle_deg);

/// Scaling along x, y, z from the origin.
/// @throws InvalidInput as `AffineMap`, for instance if a factor is 0
AffineMap scaling(const Point3& factors);

/// Shear that moves points along one axis in proportion to their coordinate along another: p[moved] += factor
/// * p[along].
/// @throws InvalidInput if the axes are equal or not of 0, 1, 2
AffineMap shear(int moved, int along, double factor);

/// From upright coordinates to the axes of a belt printer: y' = z / sin a along the gantry, which is inclined
/// to the belt by the angle a; z' = z cot a - y along the belt, which carries the part on towards +y. The
/// part keeps its shape; only its coordinates change.
/// @param gantry_deg  angle a between gantry and belt, in [15, 90]
/// @throws InvalidInput if the angle is out of bounds
AffineMap beltAxes(double gantry_deg);

}  // namespace lamina
