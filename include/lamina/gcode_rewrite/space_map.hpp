// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// What a map leaves alone.
enum class MapKind {
  Isometry,  ///< lengths, and so E and F
  Affine,    ///< straightness of lines
  Curved,    ///< neither: straight motions are divided
};

/// An invertible map of space. Derive from it to plug in any other than those below; all calls may come from
/// any thread and must be free of side effects.
class SpaceMap {
 public:
  virtual ~SpaceMap() = default;
  virtual Point3 map(const Point3& point) const = 0;      ///< [mm] to [mm]
  virtual Point3 inverse(const Point3& point) const = 0;  ///< undoes `map`
  virtual MapKind kind() const { return MapKind::Curved; }
  /// Volume after over volume before, near the point; by differences unless overridden.
  virtual double volumeRatio(const Point3& point) const;
};

/// A matrix and a translation.
class AffineMap final : public SpaceMap {
 public:
  /// @throws InvalidInput if it holds what is not finite, or is not invertible (condition above 1e6)
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

/// First `before`, then `after`.
AffineMap operator*(const AffineMap& after, const AffineMap& before);

/// Right-handed about an axis through the origin (Rodrigues).
/// @param axis  of any length
/// @throws InvalidInput if the axis is shorter than 1e-9
AffineMap rotation(const Point3& axis, double angle_deg);

/// @throws InvalidInput if a factor is 0
AffineMap scaling(const Point3& factors);

/// Moves points along one axis in proportion to where they are along another: p[moved] += factor * p[along].
/// @throws InvalidInput if the axes are equal or not of 0, 1, 2
AffineMap shear(int moved, int along, double factor);

/// From upright space to the axes of a belt printer: y runs up the gantry, which leans over the belt by the
/// angle, z is the belt, which carries the part on towards +y: y' = z / sin a, z' = z cot a - y. The part
/// keeps its shape; only its coordinates change.
/// @param gantry_deg  between gantry and belt, in [15, 90]
/// @throws InvalidInput if the angle is out of bounds
AffineMap beltAxes(double gantry_deg);

}  // namespace lamina
