// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/sweep/sweep.hpp"

namespace lamina {

/// Where a straight line is inside something convex.
struct Stretch {
  double from = 0.0;
  double to = 0.0;
};

/// A convex piece of a swept bead: a stadium prism between two planes, or the stadium revolved about its
/// upright axis. Its middle is half a bead height below the nozzle's tip.
class BeadSolid {
 public:
  /// A plane that ends a prism.
  struct End {
    Point3 point = Point3::Zero();    ///< on the plane and on the middle line [mm]
    Point3 normal = Point3::UnitX();  ///< outwards, unit
  };

  /// @param up  unit; need not be normal to the line
  static BeadSolid prism(const End& start, const End& end, const Point3& up, const Bead& bead);
  static BeadSolid joint(const Point3& middle, const Point3& up, const Bead& bead);

  /// How far inside a point lies [mm]; negative outside. Exact next to the round side and next to the ends,
  /// less than the distance near the edges between them.
  double depth(const Point3& point) const;
  /// The part of the line through (0, y, z) along x that is inside.
  std::optional<Stretch> alongX(double y, double z) const;
  /// From the middle of its start to that of its end; zero for a joint.
  Point3 length() const { return is_joint_ ? Point3(Point3::Zero()) : Point3(end_.point - start_.point); }
  /// Smallest box.
  Box3 box() const;
  /// Boxes that hold it together, of stretches at most that long.
  std::vector<Box3> stretchBoxes(double longest_mm) const;
  /// Turned by that angle about z of the part.
  BeadSolid turned(double angle_rad) const;

 private:
  std::optional<Stretch> prismAlongX(const Point3& on_line) const;
  std::optional<Stretch> jointAlongX(const Point3& on_line) const;
  std::optional<Stretch> searchAlongX(const Point3& on_line) const;
  double sectionDistance(double across, double height) const;
  void includeEnd(const End& end, Box3& box) const;

  bool is_joint_ = false;
  End start_, end_;           ///< a joint has its middle in the start
  Point3 along_, side_, up_;  ///< of the prism, orthonormal
  double flat_across_ = 0.0;  ///< half of the straight part of the profile's outline, sideways
  double flat_up_ = 0.0;      ///< and upwards, of one that is higher than wide
  double radius_ = 0.0;       ///< of the profile's round part
};

/// The solids whose union the sweeps are: a prism for each line, and joints where `corners` is Revolved.
/// Neighbouring lines of a sweep end at the plane that halves their angle; where they turn back by more than
/// 154 degrees they end flat with a joint between them, as a mitre would reach far beyond the corner.
std::vector<BeadSolid> beadSolids(const std::vector<Sweep>& sweeps, CornerStrategy corners);

}  // namespace lamina
