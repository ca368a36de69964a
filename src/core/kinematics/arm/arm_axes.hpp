// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "kinematics/arm/arm_inverse.hpp"
#include "kinematics/arm/turn.hpp"

namespace lamina {

/// Axes of an arm [bed frame].
using ArmAxes = std::array<Screw, 6>;

ArmAxes axesAtZero(const SerialChain& arm);
ArmAxes axesAt(const SerialChain& arm, const ArmValues& values);

/// Whether axes have one direction, or opposite ones, within 1e-3 rad: more than the rounding of any
/// description.
bool areParallel(const Screw& a, const Screw& b);
bool areAtRightAngle(const Screw& a, const Screw& b);

/// The point of an axis nearest to another, which is no parallel.
Point3 nearest(const Screw& on, const Screw& to);

/// How far apart axes are that are no parallels [mm].
double gapBetween(const Screw& a, const Screw& b);

/// Sine of a point off axis 1, seen from the height of axis 2, to the front; 1 if axis 2 is a parallel of 1.
double shoulderSine(const ArmAxes& axes, const Point3& wrist);

/// Sines of an arm of any geometry; 1 where one is not defined:
/// shoulder if axis 2 is no parallel of axis 1, by the point of axis 5 that is nearest to axis 6;
/// elbow if axes 2 and 3 are parallel, by axis 4, or where it is nearest to axis 5 if it is no parallel of 3;
/// wrist as the triple product of axes 4, 5 and 6.
ArmSines generalSines(const ArmAxes& axes);

/// The first three joints of an arm whose axis 2 is at a right angle to 1, and 3 a parallel of 2: axis 1
/// turns a plane in which axes 2 and 3 carry two links.
class ArmPlane {
 public:
  /// @param end  of the second link, all joints at zero [mm, bed frame]
  ArmPlane(const ArmAxes& axes, const Point3& end);

  const Point3& first() const { return axis_; }
  const Point3& normal() const { return normal_; }

  /// Turns of axis 1 with which a point, carried by it, has a place along the plane's normal that another has
  /// with all joints at zero.
  TwoTurns firstTurns(const Point3& point, const Point3& at_zero) const;

  /// A point turned back by axis 1.
  Point3 turnedBack(const Point3& point, const Turn& first) const;

  /// The two ways to bring the end to a point of the plane. Out of reach, both are the one that comes
  /// nearest.
  struct Way {
    Turn second;  ///< of axis 2 about the normal
    Turn third;   ///< of axis 3 about the normal, over axis 2
  };
  struct Ways {
    std::array<Way, 2> ways;
    double excess = 0.0;  ///< of the cosine between the links over 1
  };
  Ways waysTo(const Point3& point) const;

  /// Value of axis 2 or 3, counted about its own direction.
  double secondValue(const Way& way) const { return angleOf(way.second); }
  double thirdValue(const Way& way) const { return sense_ * angleOf(way.third); }

  double upper() const { return upper_mm_; }
  double fore() const { return fore_mm_; }

 private:
  Point2 inPlane(const Point3& vector) const { return {u_.dot(vector), v_.dot(vector)}; }

  Point3 centre_;  // on axis 1
  Point3 axis_;    // of axis 1
  Point3 normal_;  // axis 2
  Point3 u_;
  Point3 v_;
  Point3 shoulder_;        // on axis 2
  double upper_mm_ = 0.0;  // axis 2 to axis 3
  double fore_mm_ = 0.0;   // axis 3 to the end
  Turn upper_at_zero_;     // direction from axis 2 to axis 3
  Turn bent_at_zero_;      // of the second link from the first
  double sense_ = 1.0;     // of axis 3 about the normal
};

}  // namespace lamina
