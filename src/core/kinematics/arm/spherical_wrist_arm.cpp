// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/spherical_wrist_arm.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/arm/turn.hpp"

namespace lamina {
namespace {

constexpr double kOnAxis = 1e-7;             // mm: below what results are held to
constexpr double kInLine = 1e-10;            // rad
constexpr double kStretch = 1e-10;           // by how much rounding brings the cosine of an elbow beyond 1
constexpr double kExactDescription = 1e-11;  // rad and mm: of a description without rounded numbers

/// In (-pi, pi], of an angle less than a turn beyond.
double wrapped(double angle) {
  if (angle > M_PI) return angle - 2.0 * M_PI;
  return angle <= -M_PI ? angle + 2.0 * M_PI : angle;
}

/// Angles of axis 1 and the arm's plane for one side of the shoulder.
struct Side {
  Turn first;
  double x = 0.0;  ///< of the wrist, in the arm's plane
};

/// Finds the solutions of one pose. A joint's angle is never computed twice from the pose: what follows is
/// computed from the angles before it, so that the rounding of one near a singularity is made good by the
/// next.
class Solver {
 public:
  Solver(const SphericalWristArm& arm, const Eigen::Isometry3d& base_from_wrist, const ArmValues& near)
      : arm_(arm), target_(base_from_wrist), near_(near) {
    // The real arm may reach by as much further as it deviates, where the solutions are refined then.
    if (arm.deviation > kExactDescription)
      loose_mm_ = 3.0 * arm.deviation * (1.0 + arm.upper_mm + arm.fore_mm);
  }

  ArmSolutions all() {
    const double x = target_.translation().x();
    const double y = target_.translation().y();
    const double distance = std::hypot(x, y);
    if (distance < std::abs(arm_.side_mm) - kOnAxis - loose_mm_) return {};
    if (distance < kOnAxis) {
      const Turn kept = turnOf(near_[0]);
      addElbows({kept, 0.0}, 0);
      addElbows({kept, 0.0}, 4);
      return found_;
    }
    const double side = arm_.side_mm;
    const double squared_reach = (distance - side) * (distance + side);
    const double reach = std::sqrt(loose_mm_ > 0.0 ? std::abs(squared_reach) : std::max(0.0, squared_reach));
    const double square = distance * distance;
    addElbows({Turn(x * reach + y * side, y * reach - x * side) / square, reach}, 0);
    addElbows({Turn(y * side - x * reach, -y * reach - x * side) / square, -reach}, 4);
    return found_;
  }

 private:
  double value(int axis, double angle) const {
    return wrapped(arm_.sense[axis] * wrapped(angle - arm_.zero[axis]));
  }

  void addElbows(const Side& side, int branch) {
    const Point2 wrist(target_.translation().z(), side.x - arm_.shoulder_mm);
    const double square = wrist.squaredNorm();
    const double upper = arm_.upper_mm;
    const double fore = arm_.fore_mm;
    double cosine = (square - upper * upper - fore * fore) / (2.0 * upper * fore);
    const double beyond = std::abs(cosine) - 1.0;
    if (beyond > kStretch + loose_mm_ * (upper + fore) / (upper * fore)) return;
    // Bent as far to either side as it lacks, since no refinement leaves a straight elbow.
    if (beyond > kStretch) cosine = std::copysign(1.0 - beyond, cosine);
    cosine = std::clamp(cosine, -1.0, 1.0);
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    const Eigen::Matrix3d turned = turnedBack(side.first);
    const double first = wrapped(angleOf(side.first));
    const double elbow = std::atan2(sine, cosine);
    for (const double sign : {1.0, -1.0}) {
      ArmSolution solution;
      solution.branch = branch + (sign > 0.0 ? 0 : 2);
      solution.values[0] = first;
      solution.values[2] = value(2, sign * elbow);
      const Turn bent(cosine, sign * sine);
      const Turn upper_arm = upperArm(wrist, square, bent);
      solution.values[1] = value(1, angleOf(upper_arm));
      addWrists(solution, turned, sum(upper_arm, bent));
    }
  }

  /// Where a wrist folded onto the shoulder leaves it free, it stays.
  Turn upperArm(const Point2& wrist, double square, const Turn& bent) const {
    if (square < kOnAxis * kOnAxis) return turnOf(arm_.zero[1] + arm_.sense[1] * near_[1]);
    const Point2 arm(arm_.upper_mm + arm_.fore_mm * bent.x(), arm_.fore_mm * bent.y());
    return difference(wrist, arm).normalized();
  }

  /// The wrist's axes, turned back by axis 1.
  Eigen::Matrix3d turnedBack(const Turn& first) const {
    Eigen::Matrix3d turned = target_.linear();
    turned.row(0) = first.x() * target_.linear().row(0) + first.y() * target_.linear().row(1);
    turned.row(1) = first.x() * target_.linear().row(1) - first.y() * target_.linear().row(0);
    return turned;
  }

  void addWrists(const ArmSolution& solution, const Eigen::Matrix3d& turned, const Turn& forearm) {
    Eigen::Matrix3d fore_from_wrist = turned;
    fore_from_wrist.row(0) = forearm.x() * turned.row(0) - forearm.y() * turned.row(2);
    fore_from_wrist.row(2) = forearm.y() * turned.row(0) + forearm.x() * turned.row(2);
    const Eigen::Matrix3d wrist = arm_.fore_from_wrist4.transpose() * fore_from_wrist;
    const Point2 off_line = wrist.block<2, 1>(0, 2);
    const double sine = off_line.norm();
    const bool is_free = sine < kInLine;
    addWrist(solution, wrist, is_free ? turnOf(near_[3]) : Turn(off_line / sine));
    addFlipped(is_free);
  }

  void addWrist(ArmSolution solution, const Eigen::Matrix3d& wrist, const Turn& fourth) {
    const double c = fourth.x();
    const double s = fourth.y();
    solution.values[3] = wrapped(angleOf(fourth));
    solution.values[4] = value(4, std::atan2(c * wrist(0, 2) + s * wrist(1, 2), wrist(2, 2)));
    solution.values[5] =
        wrapped(std::atan2(c * wrist(1, 0) - s * wrist(0, 0), c * wrist(1, 1) - s * wrist(0, 1)));
    found_.push_back(solution);
  }

  void addFlipped(bool is_free) {
    ArmSolution flipped = found_.back();
    flipped.branch += 1;
    if (!is_free) {
      flipped.values[3] = wrapped(flipped.values[3] + M_PI);
      flipped.values[4] = value(4, wrapped(-flipped.values[4] - arm_.zero[4]));
      flipped.values[5] = wrapped(flipped.values[5] + M_PI);
    }
    found_.push_back(flipped);
  }

  const SphericalWristArm& arm_;
  const Eigen::Isometry3d& target_;
  const ArmValues& near_;
  double loose_mm_ = 0.0;
  ArmSolutions found_;
};

}  // namespace

ArmSolutions solutions(const SphericalWristArm& arm, const Eigen::Isometry3d& bed_from_nozzle,
                       const ArmValues& near) {
  const Eigen::Isometry3d base_from_wrist = arm.base_from_bed * bed_from_nozzle * arm.nozzle_from_wrist;
  return Solver(arm, base_from_wrist, near).all();
}

ArmSines singularSines(const SphericalWristArm& arm, const ArmValues& values) {
  const ArmValues angles = arm.zero + arm.sense.cwiseProduct(values);
  const double forearm = angles[1] + angles[2];
  const double x = arm.shoulder_mm + arm.upper_mm * std::sin(angles[1]) + arm.fore_mm * std::sin(forearm);
  const double z = arm.upper_mm * std::cos(angles[1]) + arm.fore_mm * std::cos(forearm);
  const double distance = std::hypot(x, z);
  return {distance > 0.0 ? x / distance : 0.0, std::sin(angles[2]), std::sin(angles[4])};
}

}  // namespace lamina
