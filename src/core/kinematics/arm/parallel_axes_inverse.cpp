// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/arm/arm_axes.hpp"
#include "kinematics/arm/newton_refinement.hpp"

namespace lamina {
namespace {

constexpr double kMostGap = 0.5;          // mm: between axes 5 and 6
constexpr double kLeastLink = 1.0;        // mm: of an arm that is one
constexpr double kRoundedReach = 1e-7;    // of a cosine that Newton's method makes good
constexpr double kExactReach = 1e-10;     // of one that only rounding brings beyond 1
constexpr double kInLineWrist = 1e-10;    // sine: axis 6 along axis 4
constexpr double kExactGeometry = 1e-11;  // rad, and m

/// An arm whose axes 2, 3 and 4 are parallel and at a right angle to 1, and whose axes 5 and 6 meet. The
/// point where they meet is moved along the normal of the plane of axes 2 to 4 by axis 1 alone, and the
/// direction of axis 6 by axes 1 and 5 alone; what is left is a triangle in the plane.
struct ParallelAxesArm {
  explicit ParallelAxesArm(const ArmAxes& at_zero)
      : axes(at_zero), plane(axes, axes[3].point), wrist(nearest(axes[5], axes[4])) {
    mark = plane.normal().unitOrthogonal();
    fourth_sense = axes[3].direction.dot(plane.normal()) > 0.0 ? 1.0 : -1.0;
    is_exact = deviation() < kExactGeometry;
  }

  double deviation() const {
    const auto tilt = [&](std::size_t a, std::size_t b) {
      return axes[a].direction.cross(axes[b].direction).norm();
    };
    return std::max({tilt(1, 2), tilt(2, 3), std::abs(axes[0].direction.dot(axes[1].direction)),
                     1e-3 * gapBetween(axes[4], axes[5])});
  }

  double reach() const { return is_exact ? kExactReach : kRoundedReach; }

  ArmAxes axes;
  ArmPlane plane;
  Point3 wrist;  ///< where axes 5 and 6 meet
  Point3 mark;   ///< a direction in the plane, by which its turn is seen
  double fourth_sense = 1.0;
  bool is_exact = true;
};

Turn reversed(const Turn& turn) { return {turn.x(), -turn.y()}; }

Point3 turnedAbout(const Screw& axis, const Turn& turn, const Point3& point) {
  return axis.point + turned(point - axis.point, axis.direction, turn);
}

/// Finds the solutions of one pose.
class ParallelAxesSolver {
 public:
  /// @param moved  from where the nozzle is with all joints at zero to where it is wanted
  ParallelAxesSolver(const ParallelAxesArm& arm, const Eigen::Isometry3d& moved, const ArmValues& near)
      : arm_(arm), moved_(moved), near_(near) {}

  ArmSolutions all() {
    const TwoTurns firsts = arm_.plane.firstTurns(moved_ * arm_.wrist, arm_.wrist);
    if (firsts.excess > arm_.reach()) return {};
    for (const Turn& first : firsts.turns) addWrists(first);
    std::sort(found_.begin(), found_.end(),
              [](const ArmSolution& a, const ArmSolution& b) { return a.branch < b.branch; });
    return found_;
  }

 private:
  /// Turns of axes 1, 5 and 6.
  struct Outer {
    Turn first;
    Turn fifth;
    Turn sixth;
    int branch = 0;
  };

  void addWrists(const Turn& first) {
    const Point3& normal = arm_.plane.normal();
    const Point3& fifth = arm_.axes[4].direction;
    const Point3& sixth = arm_.axes[5].direction;
    const Point3 wrist = arm_.plane.turnedBack(moved_ * arm_.wrist, first) - arm_.axes[0].point;
    const int shoulder = normal.cross(arm_.plane.first()).dot(wrist) < 0.0 ? 4 : 0;
    // The normal as it stands, seen by what the nozzle carries.
    const Point3 seen = moved_.linear().transpose() * turned(normal, arm_.plane.first(), first);
    const double along = normal.dot(fifth) * fifth.dot(sixth);
    const TwoTurns fifths =
        turnsWith(normal.dot(sixth) - along, normal.dot(fifth.cross(sixth)), seen.dot(sixth) - along);
    if (fifths.excess > kRoundedReach) return;
    for (const Turn& turn : fifths.turns) {
      const Turn last = turnBetween(seen, turned(normal, fifth, reversed(turn)), sixth);
      const double size = last.norm();
      const double triple = arm_.fourth_sense * fifth.dot(normal.cross(turned(sixth, fifth, turn)));
      addElbows({first, turn, size > kInLineWrist ? Turn(last / size) : turnOf(near_[5]),
                 shoulder + (triple < 0.0 ? 1 : 0)});
    }
  }

  void addElbows(const Outer& outer) {
    const auto beforeWrist = [&](const Point3& direction) {
      return turned(turned(direction, arm_.axes[4].direction, reversed(outer.fifth)), arm_.axes[5].direction,
                    reversed(outer.sixth));
    };
    const Point3 fourth_before =
        turnedAbout(arm_.axes[5], reversed(outer.sixth),
                    turnedAbout(arm_.axes[4], reversed(outer.fifth), arm_.axes[3].point));
    const ArmPlane::Ways ways = arm_.plane.waysTo(arm_.plane.turnedBack(moved_ * fourth_before, outer.first));
    if (ways.excess > arm_.reach()) return;
    const Point3 mark =
        turned(moved_.linear() * beforeWrist(arm_.mark), arm_.plane.first(), reversed(outer.first));
    const Turn all = turnBetween(arm_.mark, mark, arm_.plane.normal());
    for (std::size_t i = 0; i < 2; ++i) {
      const ArmPlane::Way& way = ways.ways[i];
      ArmSolution solution;
      solution.branch = outer.branch + (i == 0 ? 0 : 2);
      solution.values << angleOf(outer.first), arm_.plane.secondValue(way), arm_.plane.thirdValue(way),
          arm_.fourth_sense * angleOf(difference(all, sum(way.second, way.third))), angleOf(outer.fifth),
          angleOf(outer.sixth);
      found_.push_back(solution);
    }
  }

  const ParallelAxesArm& arm_;
  const Eigen::Isometry3d& moved_;
  const ArmValues& near_;
  ArmSolutions found_;
};

class ParallelAxesInverse : public ArmInverse {
 public:
  explicit ParallelAxesInverse(const SerialChain& arm)
      : arm_(arm),
        geometry_(axesAtZero(arm)),
        nozzle_from_bed_at_zero_(arm.bed_from_nozzle_at_zero.inverse()) {}

  ArmSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle, const ArmValues& near) const override {
    const Eigen::Isometry3d moved = bed_from_nozzle * nozzle_from_bed_at_zero_;
    const ArmSolutions found = ParallelAxesSolver(geometry_, moved, near).all();
    return geometry_.is_exact ? wrappedValues(found) : refined(arm_, bed_from_nozzle, found);
  }

  ArmSines sines(const ArmValues& values) const override { return generalSines(axesAt(arm_, values)); }

  double singularityMargin(const ArmValues& values) const override {
    const ArmSines at = sines(values);
    return std::min({std::abs(at.shoulder), std::abs(at.elbow), std::abs(at.wrist)});
  }

 private:
  SerialChain arm_;
  ParallelAxesArm geometry_;
  Eigen::Isometry3d nozzle_from_bed_at_zero_;
};

}  // namespace

std::unique_ptr<const ArmInverse> parallelAxesInverse(const SerialChain& arm) {
  const ArmAxes axes = axesAtZero(arm);
  if (!areAtRightAngle(axes[0], axes[1]) || !areParallel(axes[1], axes[2]) ||
      !areParallel(axes[2], axes[3]) || areParallel(axes[3], axes[4]) || areParallel(axes[4], axes[5]) ||
      gapBetween(axes[4], axes[5]) > kMostGap)
    return nullptr;
  const ArmPlane plane(axes, axes[3].point);
  if (plane.upper() < kLeastLink || plane.fore() < kLeastLink) return nullptr;
  return std::make_unique<ParallelAxesInverse>(arm);
}

}  // namespace lamina
