// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/arm/arm_inverse.hpp"
#include "kinematics/arm/turn.hpp"

namespace lamina {

/// The six axes of an arm [bed frame].
using ArmAxes = std::array<Screw, 6>;

ArmAxes axesAtZero(const SerialChain& arm);
ArmAxes axesAt(const SerialChain& arm, const ArmValues& values);

/// Whether two axes have the same or opposite directions within 1e-3 rad, which is more than the rounding in
/// any description.
bool areParallel(const Screw& a, const Screw& b);
bool areAtRightAngle(const Screw& a, const Screw& b);

/// The point of axis `on` that is nearest to axis `to` [mm]; the two must not be parallel.
Point3 nearest(const Screw& on, const Screw& to);

/// Distance between two axes that are not parallel [mm].
double gapBetween(const Screw& a, const Screw& b);

/// Sine of the angle at axis 2 between the direction of axis 1 and the wrist centre, seen along axis 2:
/// positive if the wrist is in front of axis 1. 1 if axes 1 and 2 are parallel.
double shoulderSine(const ArmAxes& axes, const Point3& wrist);

/// Sines that vanish at the singularities of an arm of any geometry; an undefined sine is 1. The shoulder
/// sine is defined if axes 1 and 2 are not parallel; it refers to the point of axis 5 nearest to axis 6. The
/// elbow sine is defined if axes 2 and 3 are parallel; it refers to axis 4 or, if axis 4 is parallel to
/// neither axis 3 nor axis 5, to the point of axis 4 nearest to axis 5. The wrist sine is the triple product
/// of axes 4, 5 and 6.
ArmSines generalSines(const ArmAxes& axes);

/// The first three joints of an arm whose axis 2 is at a right angle to axis 1, and whose axis 3 is parallel
/// to axis 2. Axis 1 turns a plane in which axes 2 and 3 move two links.
class ArmPlane {
 public:
  /// @param end  end of the second link with all joints at zero [mm, bed frame]
  ArmPlane(const ArmAxes& axes, const Point3& end);

  const Point3& first() const { return axis_; }
  const Point3& normal() const { return normal_; }

  /// The two rotations of axis 1 by which `point`, carried by that axis, gets the same coordinate along the
  /// plane's normal as `at_zero` has with all joints at zero.
  TwoTurns firstTurns(const Point3& point, const Point3& at_zero) const;

  /// A point rotated by the inverse of a rotation of axis 1.
  Point3 turnedBack(const Point3& point, const Turn& first) const;

  /// The two postures (elbow on either side) that bring the end of the second link to a point of the plane.
  /// If the point is out of reach, both are the posture that comes nearest to it.
  struct Way {
    Turn second;  ///< of axis 2 about the normal
    Turn third;   ///< of axis 3 about the normal, over axis 2
  };
  struct Ways {
    std::array<Way, 2> ways;
    /// Excess over 1 of the absolute cosine that the angle between the links would need; positive if out of
    /// reach.
    double excess = 0.0;
  };
  Ways waysTo(const Point3& point) const;

  /// The combined rotations of axes 2 and 3 in both postures, to a target in the plane seen from axis 2
  /// (`inPlane`), and the excess: as by `waysTo`, but in a fraction of the time.
  struct Bends {
    std::array<Turn, 2> both;
    double excess = 0.0;
  };
  Bends bendsTo(const Point2& target) const {
    const double square = target.squaredNorm();
    const double links = upper_mm_ * upper_mm_ + fore_mm_ * fore_mm_;
    const double twice = 2.0 * upper_mm_ * fore_mm_;
    const double wanted = (square - links) / twice;
    const double cosine = std::clamp(wanted, -1.0, 1.0);
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    const double size = std::sqrt(square * (links + twice * cosine));
    Turn way(1.0, 0.0);
    Turn bent(cosine, sine);
    if (size > 0.0) {
      way = difference(target / size, upper_at_zero_);
      // The rotation from the stretched arm to its second link, times its length.
      bent = {upper_mm_ * cosine + fore_mm_, upper_mm_ * sine};
    }
    way = difference(way, bent_at_zero_);
    return {{sum(way, bent), difference(way, bent)}, std::abs(wanted) - 1.0};
  }

  Point2 inPlane(const Point3& vector) const { return {u_.dot(vector), v_.dot(vector)}; }
  const Point3& centre() const { return centre_; }
  const Point3& shoulder() const { return shoulder_; }

  /// Value of joint 2 or 3 in a posture [rad], counted about the joint's own direction.
  double secondValue(const Way& way) const { return angleOf(way.second); }
  double thirdValue(const Way& way) const { return sense_ * angleOf(way.third); }

  double upper() const { return upper_mm_; }
  double fore() const { return fore_mm_; }

 private:
  Point3 centre_;  // on axis 1
  Point3 axis_;    // direction of axis 1
  Point3 normal_;  // axis 2
  Point3 u_;
  Point3 v_;
  Point3 shoulder_;        // on axis 2
  double upper_mm_ = 0.0;  // axis 2 to axis 3
  double fore_mm_ = 0.0;   // axis 3 to the end
  Turn upper_at_zero_;     // direction from axis 2 to axis 3
  Turn bent_at_zero_;      // rotation of the second link from the first
  double sense_ = 1.0;     // 1 or -1: sense of axis 3 about the normal
};

}  // namespace lamina
