// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/sweep/sweep.hpp"

namespace lamina {

/// The interval of a straight line that is inside a convex solid.
struct Stretch {
  double from = 0.0;  ///< coordinate along the line [mm]
  double to = 0.0;    ///< coordinate along the line [mm]
};

/// A convex piece of a swept bead: a prism with a stadium as its profile, cut by two planes, or the stadium
/// revolved about its vertical axis (a joint). Its middle line is half a bead height below the nozzle tip.
class BeadSolid {
 public:
  /// A plane at which a prism ends.
  struct End {
    Point3 point = Point3::Zero();    ///< intersection of plane and middle line [mm]
    Point3 normal = Point3::UnitX();  ///< outwards, of unit length
  };

  /// A prism.
  /// @param up  upward direction of the profile, of unit length; need not be normal to the middle line
  static BeadSolid prism(const End& start, const End& end, const Point3& up, const Bead& bead);
  /// A joint.
  /// @param up  axis of revolution, of unit length
  static BeadSolid joint(const Point3& middle, const Point3& up, const Bead& bead);

  /// Signed distance of a point from the surface [mm], positive inside. It is exact near the round sides and
  /// near the ends; near the edges between them its magnitude is too small.
  double depth(const Point3& point) const;
  /// The interval of the line through (0, y, z) along x that is inside; nothing if there is none.
  std::optional<Stretch> alongX(double y, double z) const;
  /// Vector from the middle of the start to that of the end; zero for a joint.
  Point3 length() const { return is_joint_ ? Point3(Point3::Zero()) : Point3(end_.point - start_.point); }

  /// Bounding box.
  Box3 box() const;
  /// Boxes that together contain the solid, each the box of a piece of at most `longest_mm`.
  std::vector<Box3> stretchBoxes(double longest_mm) const;
  /// The solid rotated about the z axis of the part.
  BeadSolid turned(double angle_rad) const;

 private:
  std::optional<Stretch> prismAlongX(const Point3& on_line) const;
  std::optional<Stretch> jointAlongX(const Point3& on_line) const;
  std::optional<Stretch> searchAlongX(const Point3& on_line) const;
  double sectionDistance(double across, double height) const;
  void includeEnd(const End& end, Box3& box) const;

  bool is_joint_ = false;
  End start_, end_;           ///< for a joint, the point of `start_` is the middle
  Point3 along_, side_, up_;  ///< orthonormal axes of the prism
  double flat_across_ = 0.0;  ///< half the straight length of the profile's outline, sideways
  double flat_up_ = 0.0;      ///< half the straight length upwards, of a profile that is higher than wide
  double radius_ = 0.0;       ///< of the round parts of the profile
};

/// The solids whose union is that of the sweeps: a prism for each line, and joints at corners if `corners` is
/// Revolved. Neighbouring lines of a sweep end at the plane that bisects their angle (a mitre). If the
/// direction changes by more than 154 degrees they end flat, with a joint between them, since a mitre would
/// extend far beyond the corner.
std::vector<BeadSolid> beadSolids(const std::vector<Sweep>& sweeps, CornerStrategy corners);

}  // namespace lamina
